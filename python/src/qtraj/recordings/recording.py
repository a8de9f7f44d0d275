"""A recording: orientations with their times, and what a file has beside them."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np


class RecordingError(ValueError):
    """A file that cannot be read as what it is taken for: ``file:line: reason``."""

    def __init__(self, path: str | Path, line: int | None, reason: str) -> None:
        super().__init__(f"{path}:{line}: {reason}" if line is not None else f"{path}: {reason}")
        self.path = str(path)
        self.line = line


@dataclass(frozen=True, eq=False)
class Recording:
    """Orientations of one body.

    Attributes
    ----------
    times : ndarray, shape (n,)
        s, as the file has them, or since the first stamp where these are whole nanoseconds.
    q : ndarray, shape (n, 4)
        ``w x y z``, body to world, as the file has them: norms and signs are left alone.
    positions : ndarray, shape (n, 3), or None
    nanoseconds : ndarray of int64, shape (n,), or None
        Stamps of the file, exact, since the epoch of the format.
    omega : ndarray, shape (n, 3), or None
        Angular velocities, rad/s, in the frame that ``frame`` names.
    frame : {"body", "world"} or None
    tangents : tuple of two ndarrays, shape (n, 4), or None
        dq/dt before and after each key, of cubic glTF channels.
    method : str or None
        The interpolation that the file prescribes, by the name that Trajectory has for it.
    name : str
        Of the track in the file.
    """

    times: np.ndarray
    q: np.ndarray
    positions: np.ndarray | None = None
    nanoseconds: np.ndarray | None = None
    omega: np.ndarray | None = None
    frame: str | None = None
    tangents: tuple[np.ndarray, np.ndarray] | None = None
    method: str | None = None
    name: str = ""

    def __len__(self) -> int:
        return len(self.times)

    def stamps(self) -> np.ndarray:
        """Whole nanoseconds: those of the file, or those nearest to its seconds."""
        if self.nanoseconds is not None:
            return self.nanoseconds
        return np.rint(self.times * 1e9).astype(np.int64)


def from_stamps(stamps: Any, q: np.ndarray, **more: Any) -> Recording:
    """A recording of whole nanoseconds."""
    from .. import seconds_from_ns

    stamps = np.asarray(stamps, np.int64)
    return Recording(seconds_from_ns(stamps) if len(stamps) else np.zeros(0), q, nanoseconds=stamps, **more)


def conjugated(recording: Recording) -> Recording:
    """The same of a file that takes world to body."""
    from dataclasses import replace

    return replace(recording, q=recording.q * [1.0, -1.0, -1.0, -1.0])


def ordered(rows: np.ndarray, order: str) -> np.ndarray:
    """Quaternions in a named order as ``w x y z``."""
    return np.roll(rows, 1, axis=-1) if order == "xyzw" else rows
