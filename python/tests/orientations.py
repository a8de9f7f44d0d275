"""Orientations made up, and angles between them, without the package."""

from __future__ import annotations

import numpy as np


def orientations(rng: np.random.Generator, *shape: int) -> np.ndarray:
    """Unit quaternions w x y z, evenly distributed."""
    q = rng.normal(size=(*shape, 4))
    return q / np.linalg.norm(q, axis=-1, keepdims=True)


def walk(rng: np.random.Generator, count: int, step: float = 0.3) -> np.ndarray:
    """Unit quaternions that follow each other by turns of about a step, rad, with continuous signs."""
    q = np.empty((count, 4))
    q[0] = orientations(rng)
    for k in range(1, count):
        q[k] = q[k - 1] + 0.5 * step * rng.normal(size=4)
        q[k] /= np.linalg.norm(q[k])
    return q


def angle_between(a: np.ndarray, b: np.ndarray) -> np.ndarray:
    """Rotation angle, rad, by chords: independent of the package."""
    chord = np.minimum(np.linalg.norm(a - b, axis=-1), np.linalg.norm(a + b, axis=-1))
    return 4 * np.arcsin(np.minimum(chord / 2, 1))
