"""SPICE C-kernels, by spiceypy: the orientations that a CK holds for an object, every pointing of every segment.

A C-matrix takes vectors of the base frame to the body (NAIF, CK Required Reading), and so does the quaternion of
``m2q``: the orientation, body to world, is its conjugate. Times are ephemeris seconds past J2000 where a clock kernel (SCLK)
and leap seconds (LSK) are given with it, else ticks of the spacecraft clock. Rates of the file are in the base frame.
"""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np

from .._optional import optional
from .recording import Recording, RecordingError


def read_ck(path: Path, kernels: list[Path]) -> list[Recording]:
    """All objects of a C-kernel, named by their number; kernels are SCLK and LSK, for seconds."""
    spice = optional("spiceypy", "spice")
    handle = spice.dafopr(str(path))
    try:
        segments = pointings(spice, path, handle)
    finally:
        spice.dafcls(handle)
    with loaded(spice, kernels):
        return [made(spice, number, rows, bool(kernels)) for number, rows in segments.items()]


def pointings(spice: Any, path: Path, handle: int) -> dict[int, list[tuple[float, Any, Any]]]:
    """Ticks, quaternion and rate of each pointing, by object, of segments of type 3."""
    found: dict[int, list[tuple[float, Any, Any]]] = {}
    spice.dafbfs(handle)
    while spice.daffna():
        doubles, whole = spice.dafus(spice.dafgs(124)[:5], 2, 6)
        number, kind, has_rates = int(whole[0]), int(whole[2]), bool(whole[3])
        if kind != 3:
            raise RecordingError(path, None, f"object {number} has a segment of type {kind}; type 3 is read here")
        description = spice.dafgs(124)[:5]
        for record in range(1, spice.cknr03(handle, description) + 1):
            numbers = spice.ckgr03(handle, description, record)
            rate = numbers[5:8] if has_rates else None
            found.setdefault(number, []).append((numbers[0], numbers[1:5], rate))
    return found


class loaded:
    """Kernels that are loaded for a while."""

    def __init__(self, spice: Any, kernels: list[Path]) -> None:
        self.spice, self.kernels = spice, kernels

    def __enter__(self) -> None:
        for kernel in self.kernels:
            self.spice.furnsh(str(kernel))

    def __exit__(self, *error: object) -> None:
        for kernel in self.kernels:
            self.spice.unload(str(kernel))


def made(spice: Any, number: int, rows: list[tuple[float, Any, Any]], in_seconds: bool) -> Recording:
    rows = sorted(rows, key=lambda row: row[0])
    clock = number // 1000
    times = np.array([spice.sct2e(clock, row[0]) if in_seconds else row[0] for row in rows])
    q = np.array([row[1] for row in rows], np.float64) * [1.0, -1.0, -1.0, -1.0]
    omega = np.array([row[2] for row in rows]) if all(row[2] is not None for row in rows) else None
    return Recording(times, q, omega=omega, frame="world" if omega is not None else None, name=str(number))
