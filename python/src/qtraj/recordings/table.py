"""Tables with named columns: CSV, and Parquet by pyarrow.

Columns by name, in any order: a time in seconds (t, time, timestamp, seconds) or in whole nanoseconds (t_ns, ns,
``timestamp [ns]``, ...); quaternions (qw qx qy qz, q_w ..., quat_w ..., w x y z); positions (px py pz, tx ty tz, p_x ...,
or x y z where these are not the quaternion's). A CSV without names has a time and four numbers, whose order must be given.
"""

from __future__ import annotations

import csv
import re
from collections.abc import Iterable
from pathlib import Path
from typing import Any, TextIO

import numpy as np

from .._optional import optional
from .recording import Recording, RecordingError, from_stamps, ordered
from .text import reals, seconds_as_text, whole

QUATERNIONS = [[form.format(c) for c in "wxyz"] for form in ("q{}", "q_{}", "quat_{}", "quat{}", "rot_{}", "orientation_{}", "{}")]
POSITIONS = [[form.format(c) for c in "xyz"] for form in ("p{}", "t{}", "p_{}", "t_{}", "pos_{}", "position_{}", "{}")]
SECONDS = ["t", "time", "timestamp", "seconds", "sec", "s", "t_s", "time_s", "timestamp_s"]
NANOSECONDS = ["t_ns", "ns", "time_ns", "timestamp_ns", "nanoseconds", "stamp_ns"]


def plain(name: str) -> str:
    """A column's name as it is looked up: lower case, the unit behind it as a suffix."""
    name = name.strip().lstrip("#").strip().strip('"').lower()
    name = re.sub(r"\s*[\[(]\s*([a-z/]*)\s*[\])]$", lambda unit: f"_{unit.group(1)}" if unit.group(1) in ("ns", "s") else "", name)
    return re.sub(r"[\s.\-]+", "_", name)


def find(names: list[str], sets: Iterable[list[str]], taken: list[str]) -> list[int] | None:
    """Columns of the first set of names that is there, without those that are taken."""
    for wanted in sets:
        if all(name in names for name in wanted) and not set(wanted) & set(taken):
            return [names.index(name) for name in wanted]
    return None


def columns(path: Path, header: list[str]) -> tuple[int, bool, list[int], list[int] | None]:
    """Columns of the time, whether it counts nanoseconds, of the quaternion and of the position."""
    names = [plain(name) for name in header]
    quaternion = find(names, QUATERNIONS, [])
    told = ", ".join(repr(name.strip()) for name in header)
    if quaternion is None:
        raise RecordingError(path, 1, f"no columns of a quaternion, such as qw, qx, qy, qz, among {told}")
    time = find(names, [[name] for name in SECONDS], [])
    stamp = find(names, [[name] for name in NANOSECONDS], [])
    if time is None and stamp is None:
        raise RecordingError(path, 1, f"no column of times, such as t or t_ns, among {told}")
    position = find(names, POSITIONS, [names[k] for k in quaternion])
    return (stamp or time or [0])[0], stamp is not None, quaternion, position


def delimiter_of(line: str) -> str:
    """The delimiter that a line has most of; blanks where it has none of the others."""
    best = max(",;\t|", key=line.count)
    return best if line.count(best) else " "


def fields_of(line: str, delimiter: str) -> list[str]:
    if delimiter == " ":
        return line.split()
    return next(csv.reader([line], delimiter=delimiter), [])


def read_csv(path: Path, file: TextIO, order: str | None) -> Recording:
    lines = [(number, line.rstrip("\n")) for number, line in enumerate(file, 1) if line.strip()]
    if not lines:
        raise RecordingError(path, None, "the file is empty")
    delimiter = delimiter_of(lines[0][1])
    header = fields_of(lines[0][1], delimiter)
    if any(re.search("[A-Za-z]", field) and field.strip().lower() not in ("nan", "inf", "-inf") and not is_number(field) for field in header):
        time, is_stamp, quaternion, position = columns(path, header)
        lines = lines[1:]
        order = "wxyz"  # by name
    else:
        if order is None:
            raise RecordingError(path, 1, "no names of columns: say order='wxyz' or 'xyzw' (--order)")
        time, is_stamp, quaternion, position = 0, False, [1, 2, 3, 4], None
    lines = [(number, line) for number, line in lines if not line.lstrip().startswith("#")]
    last = max([time, *quaternion, *(position or [])])
    stamps: list[Any] = []
    rows = []
    for number, line in lines:
        fields = fields_of(line, delimiter)
        if len(fields) <= last:
            raise RecordingError(path, number, f"{len(fields)} columns; {last + 1} are needed")
        stamps.append(whole(path, number, fields[time]) if is_stamp else reals(path, number, [fields[time]])[0])
        rows.append(reals(path, number, [fields[k] for k in [*quaternion, *(position or [])]]))
    return made(stamps, np.array(rows, np.float64).reshape(len(rows), -1), is_stamp, order, bool(position))


def is_number(field: str) -> bool:
    try:
        float(field)
    except ValueError:
        return False
    return True


def made(stamps: Any, table: np.ndarray, is_stamp: bool, order: str, has_position: bool) -> Recording:
    """A recording of columns: quaternion, then position."""
    q = ordered(table[:, :4], order) if len(table) else np.zeros((0, 4))
    positions = table[:, 4:7] if has_position else None
    if is_stamp:
        return from_stamps(stamps, q, positions=positions)
    return Recording(np.asarray(stamps, np.float64), q, positions=positions)


def write_csv(file: TextIO, recording: Recording) -> None:
    """Seconds, or whole nanoseconds where the recording has them; then quaternion, position, rates."""
    parts = [recording.q, recording.positions, recording.omega]
    names = ["qw,qx,qy,qz", "px,py,pz", "wx,wy,wz"]
    file.write(",".join(["t_ns" if recording.nanoseconds is not None else "t", *(n for n, part in zip(names, parts, strict=True) if part is not None)]) + "\n")
    times = seconds_as_text(recording) if recording.nanoseconds is None else map(str, recording.nanoseconds.tolist())
    table = np.concatenate([part for part in parts if part is not None], axis=1)
    for time, row in zip(times, table.tolist(), strict=True):
        file.write(",".join([time, *map(repr, row)]) + "\n")


def read_parquet(path: Path, order: str | None) -> Recording:
    parquet = optional("pyarrow.parquet", "arrow")
    data = parquet.read_table(path)
    time, is_stamp, quaternion, position = columns(path, data.schema.names)
    stamps = data.column(time)
    if str(stamps.type).startswith("timestamp"):
        stamps, is_stamp = stamps.cast("timestamp[ns]").cast("int64"), True
    if is_stamp and stamps.null_count:
        raise RecordingError(path, None, f"column {data.schema.names[time]!r} has rows without a time")
    table = np.stack([data.column(k).to_numpy().astype(np.float64) for k in [*quaternion, *(position or [])]], axis=1)
    return made(stamps.to_numpy(), table, is_stamp, "wxyz", bool(position))


def write_parquet(path: Path, recording: Recording) -> None:
    pa, parquet = optional("pyarrow", "arrow"), optional("pyarrow.parquet", "arrow")
    data = {"t_ns": recording.nanoseconds} if recording.nanoseconds is not None else {"t": recording.times}
    for names, part in (("qw qx qy qz", recording.q), ("px py pz", recording.positions), ("wx wy wz", recording.omega)):
        if part is not None:
            data.update(zip(names.split(), part.T, strict=True))
    parquet.write_table(pa.table({name: pa.array(np.ascontiguousarray(column)) for name, column in data.items()}), path)
