"""The class Trajectory: what it takes, what it gives, and what it says when something is wrong."""

from __future__ import annotations

import copy
import pickle

import numpy as np
import pytest
import qtraj
from orientations import angle_between, orientations, walk

TIMES = np.array([0.0, 1.0, 2.5, 3.0, 4.0, 6.0])


@pytest.fixture
def keys(rng):
    return walk(rng, len(TIMES))


PLAIN = ["step", "slerp", "nlerp", "squad", "log_spline", "rotation_spline"]


@pytest.mark.parametrize("method", PLAIN)
def test_goes_through_its_keys(method, keys):
    curve = qtraj.Trajectory(TIMES, keys, method)
    assert angle_between(curve(TIMES), keys).max() < 1e-14
    assert curve.method == method and len(curve) == 6 and curve.span == (0.0, 6.0)
    np.testing.assert_array_equal(curve.times, TIMES)
    assert angle_between(curve.keys, keys).max() < 1e-14


@pytest.mark.parametrize("shape", [(), (1,), (7,), (0,), (2, 3), (2, 0, 3), (1, 1, 1, 1)])
def test_results_have_the_shape_of_times(shape, keys, rng):
    curve = qtraj.Trajectory(TIMES, keys)
    t = rng.uniform(0, 6, shape)
    assert curve(t).shape == shape + (4,)
    assert curve(t, 1, frame="body").shape == shape + (3,)
    motion = curve.motion(t, frame="world")
    assert [part.shape for part in motion] == [shape + (4,), shape + (3,), shape + (3,)]
    np.testing.assert_array_equal(motion.q, curve(t))
    np.testing.assert_array_equal(motion.omega, curve(t, 1, frame="world"))
    np.testing.assert_array_equal(motion.alpha, curve(t, 2, frame="world"))


def test_a_number_an_array_of_one_and_many_times_have_the_same_bits(keys, rng):
    curve = qtraj.Trajectory(TIMES, keys)
    t = rng.uniform(0, 6, 500)
    many = curve(t)
    for k in range(0, 500, 7):
        np.testing.assert_array_equal(curve(float(t[k])), many[k])
        np.testing.assert_array_equal(curve(t[k]), many[k])
        np.testing.assert_array_equal(curve(t[k : k + 1])[0], many[k])


def test_rates_are_derivatives_in_the_frame_that_is_asked_for(keys):
    curve = qtraj.Trajectory(TIMES, keys)
    t, h = np.linspace(0.1, 5.9, 59) + 0.013, 1e-5
    dq = (curve(t + h) - curve(t - h)) / (2 * h)
    body, world = curve(t, 1, frame="body"), curve(t, 1, frame="world")
    np.testing.assert_allclose(2 * qtraj.multiply(qtraj.conjugate(curve(t)), dq)[:, 1:], body, atol=1e-8)
    np.testing.assert_allclose(2 * qtraj.multiply(dq, qtraj.conjugate(curve(t)))[:, 1:], world, atol=1e-8)
    np.testing.assert_allclose(qtraj.rotate(curve(t), body), world, atol=1e-14)
    for frame in ("body", "world"):
        difference = (curve(t + h, 1, frame=frame) - curve(t - h, 1, frame=frame)) / (2 * h)
        np.testing.assert_allclose(difference, curve(t, 2, frame=frame), atol=1e-6)


def test_a_frame_has_no_default(keys):
    curve = qtraj.Trajectory(TIMES, keys)
    with pytest.raises(TypeError, match="frame is missing: 'body' or 'world'"):
        curve(1.0, 1)
    with pytest.raises(TypeError):
        curve.motion(1.0)
    with pytest.raises(ValueError, match="frame='bdoy': one of 'body', 'world'"):
        curve(1.0, 1, frame="bdoy")
    with pytest.raises(ValueError, match="frame='bdoy'"):
        qtraj.Trajectory(TIMES, keys, frame="bdoy")
    with pytest.raises(ValueError, match="order=3"):
        curve(1.0, 3, frame="body")


def test_given_rates_are_the_rates_at_the_keys(keys, rng):
    omega, alpha = rng.normal(size=(2, 6, 3))
    for frame in ("body", "world"):
        curve = qtraj.Trajectory(TIMES, keys, "hermite", omega=omega, frame=frame)
        np.testing.assert_allclose(curve(TIMES[:-1], 1, frame=frame), omega[:-1], atol=1e-13)
        for method in ("rotation_quintic", "quaternion_quintic"):
            curve = qtraj.Trajectory(TIMES, keys, method, omega=omega, alpha=alpha, frame=frame)
            np.testing.assert_allclose(curve(TIMES, 2, frame=frame), alpha, atol=1e-11)
    curve = qtraj.Trajectory(TIMES, keys, "squad", omega=omega, frame="body", tangents="given")
    np.testing.assert_allclose(curve(TIMES, 1, frame="body")[1:-1], omega[1:-1], atol=1e-12)
    with pytest.raises(TypeError, match="frame is missing"):
        qtraj.Trajectory(TIMES, keys, "hermite", omega=omega)


def test_an_end_may_be_a_rate(keys):
    curve = qtraj.Trajectory(TIMES, keys, "squad", ends=("chord", [0.1, -0.2, 0.3]), frame="body")
    np.testing.assert_allclose(curve(6.0, 1, frame="body"), [0.1, -0.2, 0.3], atol=1e-13)
    still = qtraj.Trajectory(TIMES, keys, ends=[0.0, 0.0, 0.0], frame="world")
    np.testing.assert_allclose(still([0.0, 6.0], 1, frame="world"), 0, atol=1e-13)
    with pytest.raises(ValueError, match="pass the rate itself"):
        qtraj.Trajectory(TIMES, keys, "squad", ends="given")


def test_every_setting_reaches_the_library(keys):
    t = np.linspace(0.05, 5.95, 60)

    def differs(method, **settings):
        return np.abs(qtraj.Trajectory(TIMES, keys, method, **settings)(t) - qtraj.Trajectory(TIMES, keys, method)(t)).max()

    assert differs("rotation_spline", ends="natural") > 1e-4
    assert differs("squad", tangents="mean_velocity") > 1e-6
    assert differs("log_spline", reference=[0.6, 0.8, 0, 0]) > 1e-6
    assert differs("log_spline", reference="mean") > 1e-9
    assert differs("slerp", turns=np.array([1, 0, 0, 0, 0])) > 0.1
    flipped = keys * np.array([1, -1, 1, 1, 1, 1])[:, None]
    along = qtraj.Trajectory(TIMES, flipped, "slerp", turns="as_given")
    assert along.total_angle() > qtraj.Trajectory(TIMES, keys, "slerp").total_angle() + 5
    closed = qtraj.Trajectory(TIMES, keys, period=7.5, extrapolate="periodic", ends="periodic")
    assert len(closed) == 7
    np.testing.assert_allclose(closed(0.25), closed(0.25 + 3 * 7.5), atol=1e-13)


def test_tangents_of_quaternion_hermite_are_arrays(keys, rng):
    before, after = rng.normal(size=(2, 6, 4))
    curve = qtraj.Trajectory(TIMES, keys, "quaternion_hermite", tangents=(before, after))
    s, h = 0.25, TIMES[2] - TIMES[1]
    p = ((2 * s**3 - 3 * s**2 + 1) * keys[1] + h * (s**3 - 2 * s**2 + s) * after[1] + (3 * s**2 - 2 * s**3) * keys[2]
         + h * (s**3 - s**2) * before[2])
    np.testing.assert_allclose(curve(TIMES[1] + s * h), p / np.linalg.norm(p), atol=1e-15)
    np.testing.assert_allclose(curve.unnormalized(TIMES[1] + s * h).p, p, atol=1e-15)
    one = qtraj.Trajectory(TIMES, keys, "quaternion_hermite", tangents=after)
    np.testing.assert_allclose(one.unnormalized(TIMES[1:-1]).dp, after[1:-1], atol=1e-12)


def test_a_time_outside_is_an_exception_unless_it_is_to_be_something_else(keys):
    curve = qtraj.Trajectory(TIMES, keys)
    with pytest.raises(qtraj.Error, match="time 6.5 is outside the keys, 0.0 to 6.0.*extrapolate='hold'") as caught:
        curve([[1.0, 2.0], [6.5, -1.0]])
    assert (caught.value.name, caught.value.status, caught.value.index) == ("TIME_RANGE", 24, 2)
    with pytest.raises(qtraj.Error):
        curve(-1e-9)
    with pytest.raises(qtraj.Error):
        curve.motion(7.0, frame="body")
    held = qtraj.Trajectory(TIMES, keys, extrapolate="hold")
    np.testing.assert_array_equal(held([-5.0, 9.0]), curve.keys[[0, -1]])
    mixed = qtraj.Trajectory(TIMES, keys, extrapolate=("hold", "error"))
    np.testing.assert_array_equal(mixed(-5.0), curve.keys[0])
    with pytest.raises(qtraj.Error):
        mixed(6.1)
    with np.errstate(invalid="ignore"):
        q = qtraj.Trajectory(TIMES, keys, extrapolate="nan")([-1.0, 3.0])
    assert np.isnan(q[0]).all() and not np.isnan(q[1]).any()


def test_what_has_no_value_is_nan_and_errstate_decides(keys):
    curve = qtraj.Trajectory(TIMES, keys, longest_gap=1.75)
    with pytest.warns(RuntimeWarning, match="invalid value encountered in sample"):
        q = curve([1.0, 5.0, 2.0])
    assert np.isnan(q).any(axis=1).tolist() == [False, True, False]
    with np.errstate(invalid="raise"), pytest.raises(FloatingPointError):
        curve(np.nan)
    with np.errstate(invalid="ignore"):
        assert np.isnan(curve.motion([5.0], frame="body").alpha).all()


def test_wrong_words_name_the_right_ones(keys):
    with pytest.raises(ValueError, match="method='squat': one of 'slerp', 'nlerp', 'squad'"):
        qtraj.Trajectory(TIMES, keys, "squat")
    for setting in ("ends", "tangents", "reference", "turns", "extrapolate"):
        with pytest.raises(ValueError, match=f"{setting}='wrong': one of"):
            qtraj.Trajectory(TIMES, keys, **{setting: "wrong"})


def test_data_at_fault_are_named(keys):
    with pytest.raises(qtraj.Error, match="key 3.*Times must increase") as caught:
        qtraj.Trajectory([0, 1, 2, 2, 4, 5], keys)
    assert (caught.value.name, caught.value.index) == ("TIME_ORDER", 3)
    keys[4] = 0
    with pytest.raises(qtraj.Error) as caught:
        qtraj.Trajectory(TIMES, keys)
    assert (caught.value.name, caught.value.index) == ("ZERO_NORM", 4)
    with pytest.raises(qtraj.Error, match="2 keys or more") as caught:
        qtraj.Trajectory([0.0], keys[:1])
    assert caught.value.index is None
    again = pickle.loads(pickle.dumps(caught.value))
    assert (str(again), again.name) == (str(caught.value), "TOO_FEW")


@pytest.mark.parametrize(
    ("times", "q", "message"),
    [
        (range(5), np.zeros((4, 5)), r"q has the shape \(4, 5\), not \(..., 4\); each row is one of four numbers: pass q.T"),
        (range(5), np.zeros((5, 3)), r"q has the shape \(5, 3\)"),
        (range(5), np.zeros(4), r"q has the shape \(4,\), not \(n, 4\)"),
        (range(4), np.zeros((5, 4)), r"times has the shape \(4,\), q \(5, 4\): one time for each key"),
        (range(5), np.zeros((5, 4), complex), "q is of type complex128"),
        (range(5), [["a"] * 4] * 5, "q is of type"),
        (range(5), [[1, 2, 3, 4], [1]], "q is no array"),
        (np.arange(5).astype("datetime64[ns]"), np.zeros((5, 4)), "seconds_from_ns"),
        (range(5), np.ma.array(np.ones((5, 4)), mask=np.eye(5, 4)), "masked elements: fill them"),
        (range(5), None, "q is of type object"),
    ],
)
def test_wrong_arrays_are_a_type_error_before_the_call(times, q, message):
    with pytest.raises(TypeError, match=message):
        qtraj.Trajectory(times, q)


@pytest.mark.parametrize(
    "settings",
    [
        {"turns": [0.5] * 5},
        {"turns": [0] * 4},
        {"turns": np.zeros((5, 1), int)},
        {"turns": [2**40] * 5},
        {"omega": np.zeros((5, 3)), "frame": "body"},
        {"omega": np.zeros((6, 4)), "frame": "body"},
        {"alpha": np.zeros(3), "frame": "body"},
        {"tangents": np.zeros((5, 4))},
        {"tangents": (np.zeros((6, 4)), np.zeros((6, 3)))},
        {"reference": [1, 0, 0]},
        {"ends": ([0, 1], "natural"), "frame": "body"},
        {"dtype": np.int32},
        {"dtype": np.float16},
    ],
)
def test_settings_of_a_wrong_shape_are_a_type_error(settings, keys):
    with pytest.raises(TypeError):
        qtraj.Trajectory(TIMES, keys, **settings)


def test_norms_far_from_one_are_a_warning_that_names_likely_mistakes(keys):
    with pytest.warns(qtraj.NormWarning, match="up to 1 .key 2.*transposed.*scalar_first=False") as caught:
        qtraj.Trajectory(TIMES, keys * np.array([1, 1, 2, 1, 1, 1])[:, None])
    assert caught[0].filename == __file__


def test_xyzw_and_scipy_rotations_are_taken(keys):
    from scipy.spatial.transform import Rotation

    curve = qtraj.Trajectory(TIMES, keys)
    xyzw = keys[:, [1, 2, 3, 0]]
    assert qtraj.Trajectory(TIMES, xyzw, scalar_first=False) == curve
    turned = qtraj.Trajectory(TIMES, Rotation.from_quat(xyzw))
    assert angle_between(turned([0.3, 5.1]), curve([0.3, 5.1])).max() < 1e-14
    assert isinstance(curve.rotation([0.3, 5.1]), Rotation)
    difference = curve.rotation(TIMES) * Rotation.from_quat(xyzw).inv()
    assert difference.magnitude().max() < 1e-14


def test_float32_in_float32_out_unless_asked_otherwise(keys):
    single = qtraj.Trajectory(TIMES, keys.astype(np.float32))
    double = qtraj.Trajectory(TIMES, keys)
    assert single(1.0).dtype == single([1.0]).dtype == single.motion(1.0, frame="body").alpha.dtype == np.float32
    assert single.dtype == np.float32 and double.dtype == np.float64
    np.testing.assert_allclose(single(TIMES), double(TIMES), atol=2e-7)
    assert qtraj.Trajectory(TIMES, keys, dtype="float32")(1.0).dtype == np.float32
    assert qtraj.Trajectory(TIMES, keys.astype(np.float32), dtype=np.float64)(1.0).dtype == np.float64


def test_out_receives_the_result(keys):
    curve = qtraj.Trajectory(TIMES, keys)
    t = np.linspace(0, 6, 9).reshape(3, 3)
    out = np.empty((3, 3, 4))
    assert curve(t, out=out) is out
    np.testing.assert_array_equal(out, curve(t))
    omega = np.empty((3, 3, 3))
    motion = curve.motion(t, frame="body", out=(None, omega, None))
    assert motion.omega is omega
    for wrong in (np.empty((3, 4)), np.empty((3, 3, 4), np.float32), np.empty((3, 3, 8))[..., ::2], [0], np.empty((3, 4, 3)).swapaxes(1, 2)):
        with pytest.raises(TypeError, match="out"):
            curve(t, out=wrong)
    out.flags.writeable = False
    with pytest.raises(TypeError, match="writeable"):
        curve(t, out=out)
    memory = np.zeros(20)
    with pytest.raises(qtraj.Error, match="array of its own") as caught:
        curve(memory[:4], out=memory[2:18].reshape(4, 4))
    assert caught.value.name == "OVERLAP"


def test_uniform_samples(keys):
    curve = qtraj.Trajectory(TIMES, keys)
    times, q = curve.uniform(rate=100)
    assert len(times) == 601 and times[0] == 0 and times[-1] == 6.0
    np.testing.assert_array_equal(q, curve(times))
    np.testing.assert_array_equal(curve.uniform(step=0.01).times, times)
    even = curve.uniform(count=7)
    np.testing.assert_array_equal(even.times, np.arange(7.0))
    np.testing.assert_array_equal(even.values, curve(np.arange(7.0)))
    np.testing.assert_array_equal(curve.uniform(step=-2.0, start=5.0).times, [5.0, 3.0, 1.0])
    for wrong in ({}, {"rate": 1, "step": 1}, {"count": 3, "start": 0.0}):
        with pytest.raises(TypeError):
            curve.uniform(**wrong)
    with pytest.raises(qtraj.Error):
        curve.uniform(step=0.0)
    with pytest.raises(ValueError, match="rate=0: samples a second, above 0"):
        curve.uniform(rate=0)
    for call in (lambda n: curve.uniform(count=n), lambda n: curve.segment_times(n), lambda n: qtraj.even_times(0, 1, n)):
        with pytest.raises(ValueError, match="a whole number of"):
            call(-1)
        with pytest.raises(ValueError, match="memory"):
            call(10**30)
        with pytest.raises(TypeError):
            call(2.5)


def test_curve_diagnostics(keys):
    curve = qtraj.Trajectory(TIMES, keys * np.array([1, -1, 1, 1, -1, 1])[:, None], "squad")
    found = curve.diagnostics
    assert found.sign_flips == 2 and found.worst_norm_error < 1e-15 and 0 < found.least_dot < 1
    t = curve.segment_times(2001)
    assert len(t) == 5 * 2000 + 1 and t[2000] == TIMES[1]
    omega = np.linalg.norm(curve(t, 1, frame="body"), axis=1)
    peak = curve.peak_rates()
    assert peak.omega >= omega.max() - 1e-12 and peak.omega == pytest.approx(omega.max(), rel=1e-5)
    assert 0 <= peak.omega_time <= 6 and 0 <= peak.alpha_time <= 6
    bounds = curve.rate_bounds()
    assert peak.omega <= bounds.omega <= peak.omega * (1 + 2e-6) and peak.alpha <= bounds.alpha * (1 + 1e-10)
    assert curve.total_angle() == pytest.approx(np.trapezoid(omega, t) if hasattr(np, "trapezoid") else np.trapz(omega, t), rel=1e-5)
    assert curve.energy() > 0
    jumps = curve.jumps(frame="body")
    assert jumps.omega.shape == jumps.alpha.shape == (6, 3) and np.abs(jumps.omega[1:-1]).max() < 1e-12
    assert np.abs(jumps.alpha[1:-1]).max() > 1e-6
    spin = qtraj.Trajectory([0, 1], [[1, 0, 0, 0], [0.6, 0, 0, 0.8]], "hermite", omega=np.full((2, 3), 100.0), frame="body")
    assert spin.rate_mismatch().angle > 0.5 and spin.rate_mismatch().step == 0


def test_curves_are_immutable_comparable_and_picklable(keys, rng):
    omega = rng.normal(size=(6, 3))
    curves = [
        qtraj.Trajectory(TIMES, keys),
        qtraj.Trajectory(TIMES, keys, "squad", ends=("chord", [0.0, 0.1, 0.2]), frame="body", extrapolate=("hold", "error")),
        qtraj.Trajectory(TIMES, keys.astype(np.float32), "log_spline", reference=keys[0]),
        qtraj.Trajectory(TIMES, keys, "hermite", omega=omega, frame="world", dtype="float32"),
        qtraj.Trajectory(TIMES, keys, "quaternion_hermite", tangents=(keys, -keys)),
        qtraj.Trajectory(TIMES[:2], keys[:2], "quaternion_hermite", tangents=keys[:2].tolist(), extrapolate=["hold", "hold"]),
        qtraj.Trajectory(TIMES, keys, ends=[[0, 0, 1], [0.0, 1, 0]], frame="world"),
        qtraj.Trajectory(TIMES, keys, "slerp", turns=[0, 1, 0, -1, 0, 0], longest_gap=3, period=8.0, closure=0.1),
    ]
    for one in curves:
        t = np.linspace(*one.span, 50)
        for other in (pickle.loads(pickle.dumps(one)), copy.copy(one), copy.deepcopy(one)):
            assert other == one and hash(other) == hash(one) and repr(other) == repr(one)
            np.testing.assert_array_equal(other(t), one(t))
    for i, one in enumerate(curves):
        assert [one == other for other in curves] == [i == k for k in range(len(curves))]
        assert one != "curve"
        with pytest.raises(AttributeError):
            one.method = "slerp"
        with pytest.raises(AttributeError):
            one.other = 1
    before = curves[0](1.5)
    keys[:] = 1
    np.testing.assert_array_equal(curves[0](1.5), before)
    curves[0].times[:] = 0
    assert curves[0].span == (0.0, 6.0)


def test_repr_tells_what_it_is(keys):
    assert repr(qtraj.Trajectory(TIMES, keys)) == "<qtraj.Trajectory 'rotation_spline' of 6 keys, 0 s to 6 s>"
    text = repr(qtraj.Trajectory(TIMES, keys, "squad", extrapolate="hold", ends=(np.zeros(3), "chord"), frame="body"))
    assert text == ("<qtraj.Trajectory 'squad' of 6 keys, 0 s to 6 s, frame='body', ends=(array(3,), 'chord'), "
                    "extrapolate='hold'>")


def test_many_trajectories_at_shared_times(rng):
    curves = [qtraj.Trajectory(TIMES, walk(rng, 6), method) for method in ("slerp", "squad", "rotation_spline")]
    t = rng.uniform(0, 6, (4, 5))
    q = qtraj.sample_many(curves, t)
    for k, curve in enumerate(curves):
        np.testing.assert_array_equal(q[k], curve(t))
    by_time = qtraj.sample_many(curves, t, rates="body", layout="time_first")
    np.testing.assert_array_equal(by_time.q, np.moveaxis(q, 0, 2))
    np.testing.assert_array_equal(by_time.omega[:, :, 1], curves[1](t, 1, frame="body"))
    assert qtraj.sample_many([], t).shape == (0, 4, 5, 4)
    with pytest.raises(qtraj.Error):
        qtraj.sample_many(curves, [7.0])
    with pytest.raises(TypeError, match="type str"):
        qtraj.sample_many(["a"], t)
    single = qtraj.Trajectory(TIMES, orientations(rng, 6), dtype="float32")
    assert qtraj.sample_many([single], t).dtype == np.float32
    with pytest.raises(TypeError, match="float32 and of float64"):
        qtraj.sample_many([single, *curves], t)


def test_ambiguous_keys_are_an_error_of_the_constructor():
    with pytest.raises(qtraj.Error, match="way round") as caught:
        qtraj.Trajectory([0, 1], [[1, 0, 0, 0], [1, 0, 0, 0]], "slerp", turns=[1])
    assert caught.value.name == "AMBIGUOUS"
