"""Recordings in files: read, told apart, and written.

``read()`` finds out the format by what the file holds, or takes it by name. Orientations come out ``w x y z``, body to
world; the order of components comes from the format or from ``order=``, and is never guessed.
"""

from __future__ import annotations

import io
import sys
from pathlib import Path
from typing import Any

from . import aem, gltf, ros, spice, table, text
from .recording import Recording, RecordingError, conjugated

__all__ = ["FORMATS", "Recording", "RecordingError", "format_of", "read", "tracks", "write"]

FORMATS = ("tum", "euroc", "kitti", "csv", "parquet", "aem", "bag", "ck", "gltf")
SUFFIXES = {
    ".tum": "tum",
    ".parquet": "parquet",
    ".aem": "aem",
    ".bag": "bag",
    ".db3": "bag",
    ".mcap": "bag",
    ".bc": "ck",
    ".gltf": "gltf",
    ".glb": "gltf",
    ".kitti": "kitti",
}


def format_of(path: Path, start: str | None = None) -> str:
    """The format of a file, by its suffix or its first lines."""
    if path.suffix in SUFFIXES:
        return SUFFIXES[path.suffix]
    if path.is_dir():
        return "bag"
    if start is None:
        with open(path, "rb") as file:
            start = file.read(4096).decode("utf-8", "replace")
    lines = [line for line in start.splitlines() if line.strip()]
    data = [line for line in lines if not line.startswith(("#", "COMMENT"))]
    if start.startswith("PAR1"):
        return "parquet"
    if any(line.startswith("CCSDS_AEM_VERS") for line in lines):
        return "aem"
    if lines and lines[0].startswith("#") and "timestamp [ns]" in lines[0] and "q_RS_w" in lines[0]:
        return "euroc"
    if lines and lines[0].startswith("#") and "tx ty tz qx qy qz qw" in lines[0]:
        return "tum"
    if data and len(data[0].split()) == 12:
        return "kitti"
    if lines:
        return "csv"
    raise RecordingError(path, None, "the file is empty")


def tracks(
    path: str | Path,
    format: str | None = None,
    *,
    order: str | None = None,
    times: str | Path | None = None,
    kernels: list[str | Path] | None = None,
    conjugate: bool = False,
) -> list[Recording]:
    """All recordings of a file: as read(), which takes one of them."""
    if order not in (None, "wxyz", "xyzw"):
        raise ValueError(f"order={order!r}: one of 'wxyz', 'xyzw'")
    if format is not None and format not in FORMATS:
        raise ValueError(f"format={format!r}: one of {', '.join(map(repr, FORMATS))}")
    file, content = Path(path), None
    if str(path) == "-":
        content = sys.stdin.read()
    kind = format or format_of(file, content)
    found = read_as(kind, file, content, order, Path(times) if times else None, [Path(k) for k in kernels or []])
    return [conjugated(recording) for recording in found] if conjugate else found


def read_as(
    kind: str, path: Path, content: str | None, order: str | None, times: Path | None, kernels: list[Path]
) -> list[Recording]:
    if kind == "bag":
        return ros.read_bag(path)
    if kind == "gltf":
        return gltf.read_gltf(path)
    if kind == "ck":
        return spice.read_ck(path, kernels)
    if kind == "parquet":
        return [table.read_parquet(path, order)]
    with io.StringIO(content) if content is not None else open(path, encoding="utf-8", newline="") as file:
        try:
            if kind == "aem":
                return aem.read_aem(path, file)
            if kind == "kitti":
                return [text.read_kitti(path, file, times)]
            if kind == "csv":
                return [table.read_csv(path, file, order)]
            return [{"tum": text.read_tum, "euroc": text.read_euroc}[kind](path, file)]
        except UnicodeDecodeError as wrong:
            raise RecordingError(path, None, f"this is no text: {wrong.reason} at byte {wrong.start}") from None


def read(path: str | Path, format: str | None = None, *, track: str | None = None, **settings: Any) -> Recording:
    """Reads a recording.

    Parameters
    ----------
    path : str or Path
        "-" is standard input.
    format : str, optional
        One of FORMATS; found out unless given.
    track : str, optional
        Which recording of a file that holds several: its name, or the end of it.
    order : {"wxyz", "xyzw"}, optional
        Of components, where nothing in the file says it.
    times : path, optional
        Of the times beside a file of KITTI poses.
    kernels : list of paths, optional
        Clock and leap seconds beside a C-kernel of SPICE.
    conjugate : bool
        The file takes world to body.

    Raises
    ------
    RecordingError
        ``file:line: reason``.
    ImportError
        A package that the format takes, and how to install it.
    """
    found = tracks(path, format, **settings)
    names = ", ".join(repr(recording.name) for recording in found)
    if track is not None:
        matching = [r for r in found if r.name == track] or [r for r in found if r.name.endswith(track)]
        if len(matching) != 1:
            raise RecordingError(path, None, f"{len(matching)} tracks are named {track!r}, of {names}")
        return matching[0]
    if len(found) != 1:
        raise RecordingError(path, None, f"{len(found)} tracks: say which, of {names} (--track)" if found else "nothing is in it")
    return found[0]


def write(path: str | Path, recording: Recording, format: str | None = None) -> None:
    """Writes a recording: to "-", standard output, or to a file, by its suffix or in a format of that name.

    A file is written beside its place and moved there when it is whole. Numbers are written with all their digits.
    """
    writers = {"tum": text.write_tum, "euroc": text.write_euroc, "kitti": text.write_kitti, "csv": table.write_csv, "aem": aem.write_aem}
    target = Path(path)
    kind = format or SUFFIXES.get(target.suffix, "csv")
    if kind == "parquet" and str(path) != "-":
        part = target.with_name(target.name + ".part")
        table.write_parquet(part, recording)
        part.replace(target)
        return
    if kind not in writers:
        raise ValueError(f"format={kind!r} is read only, or needs a file; written are {', '.join(map(repr, [*writers, 'parquet']))}")
    if str(path) == "-":
        writers[kind](sys.stdout, recording)
        return
    part = target.with_name(target.name + ".part")
    try:
        with open(part, "w", encoding="utf-8") as file:
            writers[kind](file, recording)
        part.replace(target)
    finally:
        part.unlink(missing_ok=True)
