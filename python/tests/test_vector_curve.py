"""Vector curves and poses."""

from __future__ import annotations

import pickle

import numpy as np
import pytest
import qtraj
from orientations import walk
from scipy.interpolate import CubicHermiteSpline, CubicSpline

TIMES = np.array([0.0, 1.0, 2.5, 3.0, 4.0, 6.0])


@pytest.fixture
def values(rng):
    return rng.normal(size=(6, 3))


@pytest.mark.parametrize(("ends", "theirs"), [("natural", "natural"), ("not_a_knot", "not-a-knot")])
def test_cubic_is_the_spline_of_scipy(ends, theirs, values):
    t = np.linspace(0, 6, 101)
    spline = CubicSpline(TIMES, values, bc_type=theirs)
    curve = qtraj.VectorCurve(TIMES, values, ends=ends)
    for order in range(3):
        np.testing.assert_allclose(curve(t, order), spline(t, order), atol=1e-12)
    np.testing.assert_allclose(qtraj.cubic_spline(TIMES, values, t, ends=ends), spline(t), atol=1e-13)
    given = qtraj.VectorCurve(TIMES, values, ends=([1.0, 2, 3], "natural"))
    spline = CubicSpline(TIMES, values, bc_type=((1, [1.0, 2, 3]), (2, np.zeros(3))))
    np.testing.assert_allclose(given(t), spline(t), atol=1e-13)


def test_hermite_linear_step_and_quintic(values, rng):
    t = rng.uniform(0, 6, 50)
    first, second = rng.normal(size=(2, 6, 3))
    hermite = qtraj.VectorCurve(TIMES, values, "hermite", first=first)
    np.testing.assert_allclose(hermite(t), CubicHermiteSpline(TIMES, values, first)(t), atol=1e-13)
    linear = qtraj.VectorCurve(TIMES, values, "linear")
    np.testing.assert_allclose(linear(t), np.stack([np.interp(t, TIMES, v) for v in values.T], axis=1), atol=1e-14)
    step = qtraj.VectorCurve(TIMES, values, "step")
    np.testing.assert_array_equal(step(t), values[np.searchsorted(TIMES, t, "right") - 1])
    quintic = qtraj.VectorCurve(TIMES, values, "quintic", first=first, second=second)
    np.testing.assert_allclose(quintic(TIMES, 2), second, atol=1e-11)


def test_shapes_types_and_identity(values):
    curve = qtraj.VectorCurve(TIMES, values)
    assert curve(1.5).shape == (3,) and curve([[1.5]]).shape == (1, 1, 3) and len(curve) == 6
    flat = qtraj.VectorCurve(TIMES, values[:, 0])
    assert flat(1.5).shape == () and flat([1.5, 2.0]).shape == (2,) and flat.keys.shape == (6,)
    np.testing.assert_array_equal(flat(1.5), curve(1.5)[0])
    motion = curve.motion([0.5, 1.5])
    np.testing.assert_array_equal(motion.second, curve([0.5, 1.5], 2))
    assert qtraj.VectorCurve(TIMES, values.astype(np.float32))(1.0).dtype == np.float32
    other = pickle.loads(pickle.dumps(curve))
    assert other == curve and hash(other) == hash(curve) and curve != flat
    assert repr(curve) == "<qtraj.VectorCurve 'cubic' of 6 keys of 3 numbers, 0 s to 6 s>"
    times, samples = curve.uniform(rate=2)
    np.testing.assert_array_equal(samples, curve(times))
    out = np.empty((2, 3))
    assert curve([0.5, 1.0], out=out) is out


def test_faults_are_told(values):
    curve = qtraj.VectorCurve(TIMES, values, longest_gap=1.75)
    with pytest.raises(qtraj.Error, match="outside the keys"):
        curve(6.5)
    with np.errstate(invalid="ignore"):
        assert np.isnan(curve([1.0, 5.0])).any(axis=1).tolist() == [False, True]
    values[3, 1] = np.inf
    with pytest.raises(qtraj.Error) as caught:
        qtraj.VectorCurve(TIMES, values)
    assert (caught.value.name, caught.value.index) == ("NOT_FINITE", 3)
    with pytest.raises(ValueError, match="method='spline': one of 'step', 'linear'"):
        qtraj.VectorCurve(TIMES, values, "spline")
    for wrong in ({"first": np.zeros((5, 3))}, {"ends": ([1.0, 2.0], "natural")}):
        with pytest.raises(TypeError):
            qtraj.VectorCurve(TIMES, np.zeros((6, 3)), **wrong)
    with pytest.raises(TypeError, match="one time for each key"):
        qtraj.VectorCurve(TIMES[:5], np.zeros((6, 3)))


def test_poses_are_both_curves(values, rng):
    turning = qtraj.Trajectory(TIMES, walk(rng, 6))
    moving = qtraj.VectorCurve(TIMES[:-1], values[:-1])
    poses = qtraj.Poses(turning, moving)
    t = rng.uniform(0, 4, (2, 4))
    q, position = poses(t)
    np.testing.assert_array_equal(q, turning(t))
    np.testing.assert_array_equal(position, moving(t))
    motion = poses.motion(t, frame="world")
    np.testing.assert_array_equal(motion.acceleration, moving(t, 2))
    np.testing.assert_array_equal(motion.omega, turning(t, 1, frame="world"))
    assert poses.span == (0.0, 4.0) and poses.trajectory is turning and poses.positions is moving
    assert pickle.loads(pickle.dumps(poses)) == poses
    with pytest.raises(qtraj.Error, match="0.0 to 4.0"):
        poses(5.0)
    with pytest.raises(TypeError, match="dtype="):
        qtraj.Poses(turning, qtraj.VectorCurve(TIMES, values, dtype="float32"))
    with pytest.raises(TypeError):
        qtraj.Poses(None, moving)
