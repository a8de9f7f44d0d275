"""Properties that hold for any orientations, by hypothesis."""

from __future__ import annotations

import numpy as np
import pytest
import qtraj
from orientations import angle_between

hypothesis = pytest.importorskip("hypothesis")
from hypothesis import given, settings  # noqa: E402
from hypothesis import strategies as st  # noqa: E402
from hypothesis.extra import numpy as hnp  # noqa: E402

settings.register_profile("package", max_examples=200, deadline=None, derandomize=True)
settings.load_profile("package")

quaternions = hnp.arrays(np.float64, 4, elements=st.floats(-1, 1)).filter(lambda q: np.linalg.norm(q) > 1e-3)
unit = quaternions.map(lambda q: q / np.linalg.norm(q))
vectors = hnp.arrays(np.float64, 3, elements=st.floats(-10, 10))
fractions = st.floats(0, 1)


@given(unit, unit, unit, fractions)
def test_slerp_does_not_depend_on_the_world_frame(a, b, g, fraction):
    hypothesis.assume(abs(a @ b) > 1e-9)
    there = qtraj.slerp(qtraj.multiply(g, a), qtraj.multiply(g, b), fraction)
    assert angle_between(qtraj.multiply(g, qtraj.slerp(a, b, fraction)), there) < 1e-12


@given(unit, unit, fractions)
def test_slerp_is_symmetric_and_of_constant_rate(a, b, fraction):
    hypothesis.assume(abs(a @ b) > 1e-9)
    q = qtraj.slerp(a, b, fraction)
    assert angle_between(q, qtraj.slerp(b, a, 1 - fraction)) < 1e-12
    assert qtraj.angle(a, q) == pytest.approx(fraction * qtraj.angle(a, b), abs=1e-12)


@given(unit)
def test_exponential_and_logarithm_are_inverse(q):
    hypothesis.assume(q[0] > -1 + 1e-9)
    np.testing.assert_allclose(qtraj.exp(qtraj.log(q)), q, atol=1e-15)
    assert angle_between(qtraj.q_from_rotation_vector(qtraj.rotation_vector_from_q(q)), q) < 1e-14
    assert angle_between(qtraj.q_from_matrix(qtraj.matrix_from_q(q)), q) < 1e-14


@given(quaternions, quaternions, quaternions)
def test_products_associate_and_inverses_cancel(a, b, c):
    left, right = qtraj.multiply(qtraj.multiply(a, b), c), qtraj.multiply(a, qtraj.multiply(b, c))
    np.testing.assert_allclose(left, right, atol=1e-14)
    np.testing.assert_allclose(qtraj.multiply(a, qtraj.inverse(a)), [1, 0, 0, 0], atol=1e-15)
    assert qtraj.norm(qtraj.multiply(a, b)) == pytest.approx(qtraj.norm(a) * qtraj.norm(b), rel=1e-14)


@given(unit, vectors)
def test_rotations_keep_lengths_and_are_matrices(q, v):
    turned = qtraj.rotate(q, v)
    assert np.linalg.norm(turned) == pytest.approx(np.linalg.norm(v), rel=1e-14, abs=1e-300)
    np.testing.assert_allclose(turned, qtraj.matrix_from_q(q) @ v, atol=1e-13)


@given(unit, vectors, vectors, st.sampled_from(["body", "world"]))
def test_rates_and_derivatives_are_inverse(q, omega, alpha, frame):
    found = qtraj.rates_from_derivatives(q, *qtraj.derivatives_from_rates(q, omega, alpha, frame=frame), frame=frame)
    np.testing.assert_allclose(found[0], omega, atol=1e-13)
    np.testing.assert_allclose(found[1], alpha, atol=1e-11)


@given(st.integers(2, 12), st.integers(0, 2**32 - 1), st.sampled_from(["slerp", "nlerp", "squad", "rotation_spline", "log_spline"]))
def test_curves_go_through_keys_whatever_their_signs_and_norms(count, seed, method):
    rng = np.random.default_rng(seed)
    times = np.cumsum(rng.uniform(0.1, 2, count))
    keys = qtraj.q_from_rotation_vector(np.cumsum(rng.normal(0, 0.3, (count, 3)), axis=0))
    curve = qtraj.Trajectory(times, keys, method)
    other = qtraj.Trajectory(times, keys * rng.choice([-1, 1], (count, 1)), method)
    t = rng.uniform(times[0], times[-1], 20)
    assert angle_between(curve(times), keys).max() < 1e-13
    assert angle_between(curve(t), other(t)).max() < 1e-13
    np.testing.assert_allclose(curve(t, 1, frame="body"), other(t, 1, frame="body"), atol=1e-10)
