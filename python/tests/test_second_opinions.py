"""The same curves, means and conversions by SciPy."""

from __future__ import annotations

import numpy as np
import pytest
import qtraj
from orientations import angle_between, orientations, walk
from scipy.spatial.transform import Rotation, RotationSpline, Slerp


def wxyz(rotation: Rotation) -> np.ndarray:
    return rotation.as_quat()[..., [3, 0, 1, 2]]


def aligned(q: np.ndarray, other: np.ndarray) -> np.ndarray:
    """q with the signs of the other."""
    return q * np.sign((q * other).sum(axis=-1, keepdims=True))


def test_slerp_is_that_of_scipy(rng):
    times = np.cumsum(rng.uniform(0.1, 1, 200))
    keys = walk(rng, 200)
    t = rng.uniform(times[0], times[-1], 10000)
    theirs = wxyz(Slerp(times, Rotation.from_quat(keys[:, [1, 2, 3, 0]]))(t))
    ours = qtraj.Trajectory(times, keys, "slerp")(t)
    assert np.abs(ours - aligned(theirs, ours)).max() <= 4e-16


def test_slerp_of_pairs_differs_from_scipy_by_rounding_only(rng):
    a, b = orientations(rng, 2, 300)
    b = aligned(b, a)
    for k in range(300):
        theirs = wxyz(Slerp([0, 1], Rotation.from_quat(np.stack([a[k], b[k]])[:, [1, 2, 3, 0]]))([0.3]))[0]
        ours = qtraj.slerp(a[k], b[k], 0.3)
        assert np.abs(ours - aligned(theirs, ours)).max() <= 4e-16


def test_rotation_spline_with_chord_ends_is_that_of_scipy(rng):
    times = np.cumsum(rng.uniform(0.5, 1, 50))
    keys = walk(rng, 50)
    t = np.sort(rng.uniform(times[0], times[-1], 2000))
    theirs = RotationSpline(times, Rotation.from_quat(keys[:, [1, 2, 3, 0]]))
    ours = qtraj.Trajectory(times, keys, ends="chord")
    assert angle_between(ours(t), wxyz(theirs(t))).max() < 1e-8
    # SciPy ends its iteration at a tolerance of 1e-9: where that has converged further, so have the curves
    gentle = walk(rng, 50, step=0.02)
    theirs = RotationSpline(times, Rotation.from_quat(gentle[:, [1, 2, 3, 0]]))
    ours = qtraj.Trajectory(times, gentle, ends="chord")
    assert angle_between(ours(t), wxyz(theirs(t))).max() < 1e-12
    np.testing.assert_allclose(ours(t, 1, frame="body"), theirs(t, 1), atol=1e-11)
    np.testing.assert_allclose(ours(t, 2, frame="body"), theirs(t, 2), atol=1e-9)


def test_conversions_are_those_of_scipy(rng):
    q = orientations(rng, 1000)
    rotation = Rotation.from_quat(q[:, [1, 2, 3, 0]])
    np.testing.assert_allclose(qtraj.rotation_vector_from_q(q), rotation.as_rotvec(), atol=2e-15)
    np.testing.assert_allclose(qtraj.matrix_from_q(q), rotation.as_matrix(), atol=1e-15)
    ours = qtraj.q_from_matrix(rotation.as_matrix())
    assert np.abs(ours - aligned(q, ours)).max() < 1e-15
    v = rng.normal(size=(1000, 3))
    np.testing.assert_allclose(qtraj.rotate(q, v), rotation.apply(v), atol=4e-15)
    np.testing.assert_allclose(qtraj.angle(q[:500], q[500:]), (rotation[:500].inv() * rotation[500:]).magnitude(), atol=4e-15)
    ours = qtraj.power(q, 0.37)
    assert np.abs(np.abs((ours * wxyz(rotation**0.37)).sum(axis=1)) - 1).max() < 1e-15 or (
        # SciPy takes the shorter way round where w < 0
        angle_between(qtraj.power(q * np.sign(q[:, :1]), 0.37), wxyz(rotation**0.37)).max() < 4e-15)


def test_the_mean_is_that_of_scipy(rng):
    q = qtraj.multiply(orientations(rng), qtraj.q_from_rotation_vector(rng.normal(0, 0.3, (200, 3))))
    weights = rng.uniform(size=200)
    theirs = wxyz(Rotation.from_quat(q[:, [1, 2, 3, 0]]).mean(weights))
    assert angle_between(qtraj.mean_eigen(q, weights), theirs) < 1e-14
    assert angle_between(qtraj.mean_karcher(q, weights), theirs) < 0.05


@pytest.mark.parametrize("rate", [1e-9, 1e-3, 1.0])
def test_rates_of_a_spin_are_exact(rate):
    times = np.arange(5.0)
    curve = qtraj.Trajectory(times, qtraj.q_from_rotation_vector(times[:, None] * [0, rate, 0]))
    np.testing.assert_allclose(curve(np.linspace(0, 4, 33), 1, frame="world"), [[0, rate, 0]] * 33, rtol=1e-14, atol=1e-15 * rate)
