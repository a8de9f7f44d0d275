"""CCSDS Attitude Ephemeris Messages, CCSDS 504.0-B-1 and -B-2: keyword notation, quaternions.

What is the body. A message gives the rotation from frame A to frame B: its quaternion turns coordinates, v_B = q^-1 v_A q,
with q the orientation of B's axes as seen from A (504.0-B-2, annex on conventions: the Euler axis and angle that take the
axes of A to those of B; q = (e sin(phi/2), cos(phi/2))). A vector that is at rest in B has in A the coordinates
v_A = q v_B q^-1: q takes vectors of B to A. So q is body to world as it stands where the body is B; where the body is A,
its conjugate. A body is a frame whose name begins with SC_BODY, or as --conjugate says. Version 1 has ATTITUDE_DIR, A2B
or B2A, which of the two ways the message means, and QUATERNION_TYPE, where the scalar stands, FIRST or LAST; version 2
has the way A to B and the scalar last.
"""

from __future__ import annotations

import re
from pathlib import Path
from typing import TextIO

import numpy as np

from .recording import Recording, RecordingError, from_stamps, ordered
from .text import reals

DAYS_OF_YEAR = re.compile(r"(\d{4})-(\d{3})T(.*)")
EPOCH = re.compile(r"(\d{4})-(\d{2})-(\d{2})T(\d{2}):(\d{2}):(\d{2})(?:\.(\d*))?Z?$")


def stamp_of(path: Path, line: int, text: str) -> int:
    """Nanoseconds since 1970 of a calendar or day-of-year epoch, without leap seconds; exact to the nanosecond."""
    day = DAYS_OF_YEAR.match(text)
    try:
        if day:
            date = np.datetime64(day.group(1), "D") + np.timedelta64(int(day.group(2)) - 1, "D")
            text = f"{date}T{day.group(3)}"
        parts = EPOCH.match(text)
        if parts is None:
            raise ValueError
        if parts.group(6) == "60":
            raise RecordingError(path, line, f"{text} is in a leap second, which no table here knows: leave the row out")
        seconds = np.datetime64(text[:19], "s").astype(np.int64)
    except RecordingError:
        raise
    except ValueError:
        raise RecordingError(path, line, f"{text!r} is no epoch such as 2026-12-01T12:00:00.5 or 2026-335T12:00:00.5") from None
    fraction = (parts.group(7) or "").ljust(9, "0")
    if fraction[9:].strip("0"):
        raise RecordingError(path, line, f"{text!r} is finer than a nanosecond")
    return int(seconds) * 10**9 + int(fraction[:9])


class Segment:
    """One META block and its data."""

    def __init__(self, path: Path, number: int, meta: dict[str, str]) -> None:
        self.path, self.number, self.meta = path, number, meta
        self.stamps: list[int] = []
        self.rows: list[list[float]] = []

    def want(self, key: str, *values: str) -> str:
        value = self.meta.get(key, "").upper()
        if value not in values:
            raise RecordingError(self.path, self.number, f"{key} is {value or 'missing'}; one of {', '.join(values)} is read here")
        return value

    def recording(self, version: float) -> Recording:
        self.want("ATTITUDE_TYPE", "QUATERNION", "QUATERNION/RATE", "QUATERNION/ANGVEL", "QUATERNION/DERIVATIVE")
        order, a_to_b = "xyzw", True
        if version < 2:
            order = {"FIRST": "wxyz", "LAST": "xyzw"}[self.want("QUATERNION_TYPE", "FIRST", "LAST")]
            a_to_b = self.want("ATTITUDE_DIR", "A2B", "B2A") == "A2B"
        bodies = [self.meta.get(f"REF_FRAME_{side}", "").upper().startswith("SC_BODY") for side in "AB"]
        if bodies[0] == bodies[1]:
            raise RecordingError(self.path, self.number, "neither or both of REF_FRAME_A and REF_FRAME_B begin with SC_BODY: "
                                 "which one is the body is not known")
        table = ordered(np.array(self.rows, np.float64).reshape(-1, 4), order)
        if a_to_b != bodies[1]:
            table = table * [1.0, -1.0, -1.0, -1.0]
        return from_stamps(self.stamps, table, name=self.meta.get("OBJECT_NAME", ""))


def read_aem(path: Path, file: TextIO) -> list[Recording]:
    """All segments of a message."""
    version, inside = 0.0, ""
    meta: dict[str, str] = {}
    segments: list[Segment] = []
    for number, line in enumerate(file, 1):
        text = line.strip()
        if not text or text.startswith("COMMENT"):
            continue
        if text in ("META_START", "META_STOP", "DATA_START", "DATA_STOP"):
            inside = text
            if text == "META_START":
                meta = {}
            elif text == "META_STOP":
                segments.append(Segment(path, number, meta))
            continue
        if "=" in text:
            key, value = (part.strip() for part in text.split("=", 1))
            meta[key.upper()] = value
            if key.upper() == "CCSDS_AEM_VERS":
                version = reals(path, number, [value])[0]
        elif inside in ("DATA_START", "META_STOP") and segments:
            fields = text.split()
            if len(fields) < 5:
                raise RecordingError(path, number, f"{len(fields)} columns; an epoch and four numbers are needed")
            segments[-1].stamps.append(stamp_of(path, number, fields[0]))
            segments[-1].rows.append(reals(path, number, fields[1:5]))
        else:
            raise RecordingError(path, number, f"{text!r} is no line of a message in keyword notation")
    if version == 0:
        raise RecordingError(path, 1, "no CCSDS_AEM_VERS: this is no Attitude Ephemeris Message")
    return [segment.recording(version) for segment in segments]


def write_aem(file: TextIO, recording: Recording) -> None:
    """A message of version 2, from EME2000 to the body; stamps are UTC."""
    epochs = [str(stamp) for stamp in recording.stamps().view("datetime64[ns]")]
    first, last = (epochs[0], epochs[-1]) if epochs else ("1970-01-01T00:00:00", "1970-01-01T00:00:00")
    file.write(f"CCSDS_AEM_VERS = 2.0\nCREATION_DATE = {last}\nORIGINATOR = QTRAJ\n\nMETA_START\n"
               f"OBJECT_NAME = {recording.name or 'BODY'}\nOBJECT_ID = {recording.name or 'BODY'}\nREF_FRAME_A = EME2000\n"
               f"REF_FRAME_B = SC_BODY_1\nTIME_SYSTEM = UTC\nSTART_TIME = {first}\nSTOP_TIME = {last}\n"
               "ATTITUDE_TYPE = QUATERNION\nMETA_STOP\n\nDATA_START\n")
    for epoch, q in zip(epochs, recording.q.tolist(), strict=True):
        file.write(f"{epoch} {q[1]!r} {q[2]!r} {q[3]!r} {q[0]!r}\n")
    file.write("DATA_STOP\n")
