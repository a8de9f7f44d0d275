"""Formats of plain rows: TUM, EuRoC and KITTI.

TUM RGB-D: ``timestamp tx ty tz qx qy qz qw``, seconds. EuRoC MAV ground truth: ``timestamp [ns], p x y z, q w x y z, ...``.
KITTI odometry: the first three rows of a 4 by 4 matrix, twelve numbers a line; times in a file of their own, one a line.
"""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path
from typing import TextIO

import numpy as np

from .recording import Recording, RecordingError, from_stamps


def numbered(path: Path, lines: Iterator[str], delimiter: str | None, width: int) -> Iterator[tuple[int, list[str]]]:
    """Fields of the lines that are neither empty nor comments, with the number of the line."""
    for number, line in enumerate(lines, 1):
        if not line.strip() or line.lstrip().startswith("#"):
            continue
        fields = line.split(delimiter)
        if len(fields) < width:
            raise RecordingError(path, number, f"{len(fields)} columns; {width} are needed")
        yield number, fields


def reals(path: Path, number: int, fields: list[str]) -> list[float]:
    try:
        return [float(field) for field in fields]
    except ValueError as wrong:
        raise RecordingError(path, number, str(wrong)) from None


def whole(path: Path, number: int, field: str) -> int:
    try:
        value = int(field)
    except ValueError:
        raise RecordingError(path, number, f"{field.strip()!r} is no whole number of nanoseconds") from None
    if not -(2**63) <= value < 2**63:
        raise RecordingError(path, number, f"{value} is more than 64 bits hold")
    return value


def read_tum(path: Path, file: TextIO) -> Recording:
    rows = [reals(path, number, fields[:8]) for number, fields in numbered(path, file, None, 8)]
    table = np.array(rows, np.float64).reshape(-1, 8)
    return Recording(table[:, 0], table[:, [7, 4, 5, 6]], positions=table[:, 1:4])


def write_tum(file: TextIO, recording: Recording) -> None:
    positions = recording.positions if recording.positions is not None else np.zeros((len(recording), 3))
    file.write("# timestamp tx ty tz qx qy qz qw\n")
    for time, p, q in zip(seconds_as_text(recording), positions.tolist(), recording.q.tolist(), strict=True):
        file.write(f"{time} {p[0]!r} {p[1]!r} {p[2]!r} {q[1]!r} {q[2]!r} {q[3]!r} {q[0]!r}\n")


def seconds_as_text(recording: Recording) -> list[str]:
    """Seconds: of whole nanoseconds with nine decimals, exact, else as short as a double allows."""
    if recording.nanoseconds is None:
        return [repr(time) for time in recording.times.tolist()]
    parts = [(abs(stamp) // 10**9, abs(stamp) % 10**9, "-" if stamp < 0 else "") for stamp in recording.nanoseconds.tolist()]
    return [f"{sign}{seconds}.{rest:09d}" for seconds, rest, sign in parts]


def read_euroc(path: Path, file: TextIO) -> Recording:
    stamps, rows = [], []
    for number, fields in numbered(path, file, ",", 8):
        stamps.append(whole(path, number, fields[0]))
        rows.append(reals(path, number, fields[1:8]))
    table = np.array(rows, np.float64).reshape(-1, 7)
    return from_stamps(stamps, table[:, 3:7], positions=table[:, 0:3])


def write_euroc(file: TextIO, recording: Recording) -> None:
    positions = recording.positions if recording.positions is not None else np.zeros((len(recording), 3))
    file.write("#timestamp [ns],p_RS_R_x [m],p_RS_R_y [m],p_RS_R_z [m],q_RS_w [],q_RS_x [],q_RS_y [],q_RS_z []\n")
    for stamp, p, q in zip(recording.stamps().tolist(), positions.tolist(), recording.q.tolist(), strict=True):
        file.write(",".join([str(stamp), *map(repr, p), *map(repr, q)]) + "\n")


def read_kitti(path: Path, file: TextIO, times: Path | None) -> Recording:
    from .. import q_from_matrix

    if times is None:
        raise RecordingError(path, None, "KITTI poses have no times: pass times=, a file with one a line (--times)")
    rows = [reals(path, number, fields[:12]) for number, fields in numbered(path, file, None, 12)]
    matrix = np.array(rows, np.float64).reshape(-1, 3, 4)
    with open(times, encoding="utf-8") as clock:
        seconds = np.array([reals(times, number, fields[:1])[0] for number, fields in numbered(times, clock, None, 1)])
    if len(seconds) != len(matrix):
        raise RecordingError(times, None, f"{len(seconds)} times for {len(matrix)} poses")
    with np.errstate(invalid="ignore"):
        q = q_from_matrix(matrix[:, :, :3], 2e-3)
    if np.isnan(q).any():
        row = int(np.isnan(q).any(axis=1).argmax())
        raise RecordingError(path, row + 1, "the matrix is far from every rotation")
    return Recording(seconds, q, positions=matrix[:, :, 3])


def write_kitti(file: TextIO, recording: Recording) -> None:
    from .. import matrix_from_q

    positions = recording.positions if recording.positions is not None else np.zeros((len(recording), 3))
    matrix = np.concatenate([matrix_from_q(recording.q), positions[:, :, None]], axis=2)
    for row in matrix.reshape(-1, 12).tolist():
        file.write(" ".join(map(repr, row)) + "\n")
