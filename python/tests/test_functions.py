"""Functions over rows: values by independent definitions, broadcasting, types, faults."""

from __future__ import annotations

import numpy as np
import pytest
import qtraj
from orientations import angle_between, orientations


def product(a, b):
    """Hamilton product by its definition."""
    w, x, y, z = np.moveaxis(a, -1, 0)
    s, i, j, k = np.moveaxis(b, -1, 0)
    return np.stack(
        [w * s - x * i - y * j - z * k, w * i + x * s + y * k - z * j, w * j - x * k + y * s + z * i,
         w * k + x * j - y * i + z * s], axis=-1)


# Calls with arrays of any leading shape, all of that shape: name, arguments made by a generator, tolerance in float32.
CALLS = {
    "slerp": lambda r, *n: (orientations(r, *n), orientations(r, *n), r.uniform(size=n)),
    "nlerp": lambda r, *n: (orientations(r, *n), orientations(r, *n), r.uniform(size=n)),
    "slerp_between": lambda r, *n: (orientations(r, *n), r.uniform(0, 1, n), orientations(r, *n), r.uniform(2, 3, n), r.uniform(1, 2, n)),
    "nlerp_between": lambda r, *n: (orientations(r, *n), r.uniform(0, 1, n), orientations(r, *n), r.uniform(2, 3, n), r.uniform(1, 2, n)),
    "screw": lambda r, *n: (orientations(r, *n), r.normal(size=(*n, 3)), orientations(r, *n), r.normal(size=(*n, 3)), r.uniform(size=n)),
    "squad_segment": lambda r, *n: (*(orientations(r, *n) for _ in range(4)), r.uniform(size=n)),
    "multiply": lambda r, *n: (orientations(r, *n), orientations(r, *n)),
    "conjugate": lambda r, *n: (orientations(r, *n),),
    "inverse": lambda r, *n: (orientations(r, *n),),
    "norm": lambda r, *n: (r.normal(size=(*n, 4)),),
    "dot": lambda r, *n: (orientations(r, *n), orientations(r, *n)),
    "exp": lambda r, *n: (r.normal(size=(*n, 3)),),
    "log": lambda r, *n: (orientations(r, *n),),
    "power": lambda r, *n: (orientations(r, *n), r.uniform(size=n)),
    "rotate": lambda r, *n: (orientations(r, *n), r.normal(size=(*n, 3))),
    "distance": lambda r, *n: (orientations(r, *n), orientations(r, *n)),
    "angle": lambda r, *n: (orientations(r, *n), orientations(r, *n)),
    "rotation_vector_from_q": lambda r, *n: (orientations(r, *n),),
    "q_from_rotation_vector": lambda r, *n: (r.normal(size=(*n, 3)),),
    "matrix_from_q": lambda r, *n: (orientations(r, *n),),
    "q_from_matrix": lambda r, *n: (qtraj.matrix_from_q(orientations(r, *n)),),
    "wxyz_from_xyzw": lambda r, *n: (orientations(r, *n),),
    "xyzw_from_wxyz": lambda r, *n: (orientations(r, *n),),
    "normalize": lambda r, *n: (r.normal(size=(*n, 4)),),
    "mean_from_moments": lambda r, *n: (qtraj.moments(orientations(r, *n, 3), axis=-1),),
    "derivatives_from_rates": lambda r, *n: (orientations(r, *n), r.normal(size=(*n, 3)), r.normal(size=(*n, 3))),
    "rates_from_derivatives": lambda r, *n: (orientations(r, *n), *r.normal(size=(2, *n, 4))),
}


def call(name, *arguments, **more):
    if name in ("derivatives_from_rates", "rates_from_derivatives"):
        more["frame"] = "body"
    result = getattr(qtraj, name)(*arguments, **more)
    return result if isinstance(result, tuple) else (result,)


def same(a, b):
    for one, other in zip(a, b, strict=True):
        np.testing.assert_array_equal(one, other)


@pytest.mark.parametrize("name", CALLS)
def test_rows_broadcast_and_lie_anywhere(name, rng):
    arguments = CALLS[name](rng, 3, 5)
    whole = call(name, *arguments)
    # row by row
    for i, j in ((0, 0), (1, 4), (2, 2)):
        same(call(name, *(a[i, j] for a in arguments)), (part[i, j] for part in whole))
    # the first argument once for all rows
    once = call(name, arguments[0][:1], *arguments[1:])
    same((part[0] for part in once), (part[0] for part in whole))
    assert [part.shape[0] for part in once] == ([3] * len(once) if len(arguments) > 1 else [1] * len(once))
    # in the order of Fortran, backwards, every other row, byte order, read only
    for change in (np.asfortranarray, lambda a: a[::-1][::1].copy()[::-1], lambda a: np.repeat(a, 2, axis=0)[::2],
                   lambda a: a.astype(a.dtype.newbyteorder()), frozen):
        same(call(name, *(change(a) for a in arguments)), whole)
    same(call(name, *(a.tolist() for a in arguments)), whole)
    empty = call(name, *(a[:0] for a in arguments))
    assert [part.shape for part in empty] == [(0, *part.shape[1:]) for part in whole]


def frozen(array):
    array = array.copy()
    array.flags.writeable = False
    return array


@pytest.mark.parametrize("name", [name for name in CALLS if name != "mean_from_moments"])
def test_float32_gives_float32_and_nearly_the_same(name, rng):
    arguments = CALLS[name](rng, 300)
    double = call(name, *arguments)
    single = call(name, *(a.astype(np.float32) for a in arguments))
    half = call(name, *(a.astype(np.float32).astype(np.float16) for a in arguments)) if name != "q_from_matrix" else double
    for one, other, coarse in zip(single, double, half, strict=True):
        assert one.dtype == np.float32 and coarse.dtype == np.float64
        scale = np.abs(other).max()
        # a nearly opposite pair or a half turn magnifies the rounding of what went in
        assert np.quantile(np.abs(one - other), 0.95) < 3e-6 * scale
    backwards = call(name, *(np.asfortranarray(np.stack([a, a]).astype(np.float32))[0] for a in arguments))
    same(backwards, single)


@pytest.mark.parametrize("name", [name for name in CALLS if name not in ("wxyz_from_xyzw", "xyzw_from_wxyz")])
def test_a_row_at_fault_is_nan_and_no_other(name, rng):
    arguments = CALLS[name](rng, 700)
    whole = call(name, *arguments)
    arguments[0][[137, 500]] = np.nan
    with pytest.warns(RuntimeWarning, match="invalid value encountered in"):
        faulty = call(name, *arguments)
    for one, other in zip(faulty, whole, strict=True):
        bad = np.isnan(one).reshape(700, -1).any(axis=1)
        assert np.flatnonzero(bad).tolist() == [137, 500] and np.isnan(one[137]).all()
        np.testing.assert_array_equal(one[~bad], other[~bad])
    with np.errstate(invalid="raise"), pytest.raises(FloatingPointError):
        call(name, *arguments)
    with np.errstate(invalid="ignore"):
        call(name, *arguments)


@pytest.mark.parametrize("name", [name for name in CALLS if name not in (
    "screw", "q_from_matrix", "derivatives_from_rates", "rates_from_derivatives", "mean_from_moments")])
def test_out_receives_the_result(name, rng):
    arguments = CALLS[name](rng, 50)
    (whole,) = call(name, *arguments)
    out = np.full_like(whole, 7)
    assert getattr(qtraj, name)(*arguments, out=out) is out
    np.testing.assert_array_equal(out, whole)
    # in place, and shifted by a row: NumPy sees to the overlap
    if arguments[0].shape == whole.shape:
        memory = np.concatenate([arguments[0], arguments[0][:1]])
        getattr(qtraj, name)(memory[:-1], *arguments[1:], out=memory[1:])
        np.testing.assert_array_equal(memory[1:], whole)
    with pytest.raises(ValueError, match="[Nn]on-broadcastable|shape|broadcast"):
        getattr(qtraj, name)(*arguments, out=np.empty((3, *whole.shape[1:])))


def test_both_kinds_of_trouble_are_told_wherever_they_lie(rng):
    a = orientations(rng, 1000)
    b = orientations(rng, 1000)
    for invalid, ambiguous in ((3, 900), (900, 3), (500, 501)):
        x, y = a.copy(), b.copy()
        x[invalid] = 0
        y[ambiguous] = -x[ambiguous]
        with pytest.warns(RuntimeWarning, match="invalid"), pytest.warns(qtraj.AmbiguousWarning, match="holds one of them") as caught:
            q = qtraj.slerp(x, y, 0.5, path="as_given")
        assert np.isnan(q).all(axis=1).nonzero()[0].tolist() == [invalid]
        assert caught[-1].filename == __file__


def test_products_inverses_and_turns(rng):
    a, b = orientations(rng, 2, 1000)
    np.testing.assert_allclose(qtraj.multiply(a, b), product(a, b), atol=4e-16)
    np.testing.assert_allclose(qtraj.multiply(a * 3, qtraj.inverse(a * 3)), [[1, 0, 0, 0]] * 1000, atol=5e-16)
    np.testing.assert_array_equal(qtraj.conjugate(a), a * [1, -1, -1, -1])
    np.testing.assert_allclose(qtraj.norm(a * 5), 5, rtol=4e-16)
    np.testing.assert_allclose(qtraj.dot(a, b), (a * b).sum(axis=1), atol=4e-16)
    v = rng.normal(size=(1000, 3))
    turned = product(product(a, np.concatenate([np.zeros((1000, 1)), v], axis=1)), a * [1, -1, -1, -1])[:, 1:]
    np.testing.assert_allclose(qtraj.rotate(a, v), turned, atol=3e-15)
    np.testing.assert_allclose(np.einsum("nij,nj->ni", qtraj.matrix_from_q(a), v), turned, atol=3e-15)
    np.testing.assert_allclose(qtraj.exp(qtraj.log(a)), a, atol=4e-16)
    assert angle_between(qtraj.q_from_rotation_vector(qtraj.rotation_vector_from_q(a)), a).max() < 1e-15
    assert angle_between(qtraj.q_from_matrix(qtraj.matrix_from_q(a)), a).max() < 2e-15
    assert angle_between(qtraj.power(a, 3), product(product(a, a), a)).max() < 1e-14
    np.testing.assert_allclose(qtraj.angle(a, b), angle_between(a, b), atol=1e-14)
    np.testing.assert_allclose(qtraj.distance(a, -a), np.pi)
    np.testing.assert_array_equal(qtraj.wxyz_from_xyzw(qtraj.xyzw_from_wxyz(a)), a)
    dq, ddq = qtraj.derivatives_from_rates(a, v, frame="world")
    omega, alpha = qtraj.rates_from_derivatives(a, dq, ddq, frame="world")
    np.testing.assert_allclose(omega, v, atol=4e-15)
    np.testing.assert_allclose(alpha, 0, atol=2e-14)
    assert np.abs(qtraj.rates_from_derivatives(a, dq, frame="body")[0] - v).max() > 0.1


def test_scalars_are_weak_beside_float32(rng):
    a, b = orientations(rng, 2, 10).astype(np.float32)
    assert qtraj.slerp(a, b, 0.25).dtype == np.float32
    assert qtraj.power(a, 2).dtype == np.float32
    assert qtraj.q_from_matrix(qtraj.matrix_from_q(a)).dtype == np.float32
    assert qtraj.slerp(a, b, np.linspace(0, 1, 10)).dtype == np.float64
    assert qtraj.slerp(a, b.astype(np.float64), 0.25).dtype == np.float64
    stamps = 1.7e9 + np.array([0.0, 1e-3, 2e-3])
    q = qtraj.slerp_between(a[0], stamps[0], b[0], stamps[2], stamps[1])
    assert q.dtype == np.float32
    np.testing.assert_allclose(q, qtraj.slerp(a[0], b[0], 0.5), atol=1e-4)


def test_wrong_arguments_are_refused_by_name(rng):
    q = orientations(rng, 7)
    for wrong, message in (
        (q.T, r"a has the shape \(4, 7\).*pass a.T"),
        (q[:, :3], r"a has the shape \(7, 3\)"),
        (q.astype(complex), "a is of type complex128"),
        (q.astype(np.longdouble), "a is of type"),
        (q.astype(str), "a is of type"),
        (np.ma.array(q, mask=True), "a has masked elements"),
        ({}, "a is of type object"),
    ):
        with pytest.raises(TypeError, match=message):
            qtraj.slerp(wrong, q, 0.5)
    with pytest.raises(ValueError, match="path='long': one of 'shortest', 'as_given'"):
        qtraj.slerp(q, q, 0.5, path="long")
    with pytest.raises(TypeError, match="frame"):
        qtraj.derivatives_from_rates(q, q[:, :3])
    with pytest.raises(ValueError, match="frame='down'"):
        qtraj.derivatives_from_rates(q, q[:, :3], frame="down")
    with pytest.raises(TypeError, match=r"matrix has the shape"):
        qtraj.q_from_matrix(np.zeros((3, 4)))
    with pytest.raises(ValueError, match="limit=-1"):
        qtraj.q_from_matrix(np.eye(3), limit=-1)
    unmasked = np.ma.array(q, mask=False)
    np.testing.assert_array_equal(qtraj.norm(unmasked), qtraj.norm(q))


def test_other_kinds_of_arrays_are_taken(rng):
    from scipy.spatial.transform import Rotation

    q = orientations(rng, 5)
    turned = qtraj.angle(Rotation.from_quat(q[:, [1, 2, 3, 0]]), q)
    assert turned.max() < 1e-15

    class Tensor:
        """All that a tensor of another library need have."""

        def __dlpack__(self, **more):
            return q.__dlpack__(**more)

        def __dlpack_device__(self):
            return q.__dlpack_device__()

    np.testing.assert_array_equal(qtraj.conjugate(Tensor()), q * [1, -1, -1, -1])
    assert qtraj.conjugate([1, 2, 3, 4]).dtype == np.float64
    assert qtraj.norm([[True, False, False, False]]) == 1


def test_matrices_far_from_rotations_are_nan_and_say_how_far():
    matrix = np.eye(3) * 1.0005
    q, away = qtraj.q_from_matrix(matrix, return_distance=True)
    assert away == pytest.approx(0.0005 * np.sqrt(3), rel=1e-6) or away == pytest.approx(0.0005, rel=1e-6)
    np.testing.assert_allclose(q, [1, 0, 0, 0], atol=1e-15)
    with np.errstate(invalid="ignore"):
        assert np.isnan(qtraj.q_from_matrix(np.eye(3) * 1.1)).all()
        limits = qtraj.q_from_matrix(np.stack([np.eye(3) * 1.1] * 2), [1e-3, 0.2])
    assert np.isnan(limits[0]).all() and not np.isnan(limits[1]).any()


def test_means_over_axes(rng):
    centre = orientations(rng, 3)
    noise = qtraj.q_from_rotation_vector(rng.normal(0, 0.1, (3, 50, 2, 3)))
    q = qtraj.multiply(centre[:, None, None], noise) * rng.choice([-1, 1], (3, 50, 2, 1))
    for mean in (qtraj.mean_eigen, qtraj.mean_karcher):
        by_axes = mean(q, axis=(1, 2))
        assert by_axes.shape == (3, 4) and angle_between(by_axes, centre).max() < 0.05
        np.testing.assert_array_equal(by_axes[1], mean(q[1]))
        assert mean(q, axis=0).shape == (50, 2, 4) and mean(q).shape == (4,)
        assert mean(q.astype(np.float32), axis=-1).dtype == np.float32
        weights = rng.uniform(size=(50, 1))
        weighted = mean(q, np.broadcast_to(weights, (3, 50, 2)), axis=(1, 2))
        assert angle_between(mean(q, weights, axis=(1, 2)), weighted).max() == 0
        with pytest.warns(qtraj.AmbiguousWarning):
            mean([[1, 0, 0, 0], [0, 1, 0, 0]])
        with pytest.raises(qtraj.Error, match="1 sample or more"):
            mean(np.zeros((0, 4)))
    _, gap = qtraj.mean_eigen(q[0], return_eigengap=True)
    assert 0.9 < gap < 1
    parts = qtraj.moments(q[0, :20]) + qtraj.moments(q[0, 20:])
    assert angle_between(qtraj.mean_from_moments(parts), qtraj.mean_eigen(q[0])) < 1e-14
    offsets = [0, 10, 10, 50]
    with np.errstate(invalid="ignore"):
        groups = qtraj.batch_mean_eigen(offsets, q[0, :, 0])
    np.testing.assert_array_equal(groups[2], qtraj.mean_eigen(q[0, 10:, 0]))
    assert np.isnan(groups[1]).all()


def test_signs_are_made_continuous_along_any_axis(rng):
    q = orientations(rng, 4, 6, 5)
    for axis in (0, 1, 2, -2, -3):
        out, flips = qtraj.make_continuous(q, axis=axis, return_flips=True)
        lead = np.moveaxis(out, axis % 4 if axis >= 0 else axis, 0)
        assert ((lead[1:] * lead[:-1]).sum(axis=-1) >= 0).all()
        assert flips == (out != q).any(axis=-1).sum() > 0
    with pytest.raises(TypeError, match="axis=3"):
        qtraj.make_continuous(q, axis=3)
    with pytest.raises(TypeError, match="axis=-1"):
        qtraj.make_continuous(q, axis=-1)


def test_tables_as_columns_and_as_rows(rng):
    columns = [rng.normal(size=9) for _ in range(7)]
    rows = qtraj.rows_from_columns(columns)
    np.testing.assert_array_equal(rows, np.stack(columns, axis=1))
    for one, other in zip(qtraj.columns_from_rows(rows), columns, strict=True):
        np.testing.assert_array_equal(one, other)
    assert qtraj.rows_from_columns([column.astype(np.float32) for column in columns]).dtype == np.float32
    with pytest.raises(TypeError, match="one length"):
        qtraj.rows_from_columns([[1.0], [1.0, 2.0]])


def test_diagnostics_of_samples(rng):
    t = np.linspace(0, 2, 201)
    q = qtraj.q_from_rotation_vector(t[:, None] * [0, 0, 1.5])
    times, omega = qtraj.estimate_omega(t, q, frame="body")
    np.testing.assert_allclose(times, (t[1:] + t[:-1]) / 2)
    np.testing.assert_allclose(omega, [[0, 0, 1.5]] * 200, atol=1e-11)
    assert qtraj.estimate_energy(t, q, frame="body") < 1e-15
    assert np.abs(qtraj.estimate_jumps(t, q, [0.5, 1.0], frame="world")).max() < 1e-10
    angle, index = qtraj.keyframe_errors([0.5, 1.004], q[[50, 100]], t, q)
    np.testing.assert_allclose(angle, 0, atol=1e-15)
    assert index.tolist() == [50, 100]
    q[7] = 0
    q[9] *= 3
    t[20] = t[19]
    report = qtraj.check_keys(t, q)
    assert [(k, qtraj.status_name(s)) for k, s in enumerate(report.status) if s] == [(7, "ZERO_NORM"), (20, "TIME_ORDER")]
    assert report.faults == 2 and report.worst_norm_index == 9 and report.worst_norm_error == pytest.approx(2)
    assert report.first_sign_change is None and report.sign_changes == 0
    controls = qtraj.squad_controls(None, orientations(rng, 5))
    assert controls.a.shape == controls.b.shape == (5, 4)


def test_stamps_in_nanoseconds_are_exact():
    ns = np.array([1403715273262142976, 1403715273267142976, 1403715273272142977])
    np.testing.assert_array_equal(qtraj.seconds_from_ns(ns), [0.0, 0.005, 0.010000001])
    np.testing.assert_array_equal(qtraj.seconds_from_ns(ns.view("datetime64[ns]")), [0.0, 0.005, 0.010000001])
    np.testing.assert_array_equal(qtraj.seconds_from_ns(np.array(["2026-12-01T00:00:01", "2026-12-01"], "datetime64[s]")), [0, -1])
    assert qtraj.seconds_from_ns([5], origin=-1)[0] == 6e-9
    with pytest.raises(TypeError, match="whole numbers"):
        qtraj.seconds_from_ns([0.5])
    with pytest.raises(TypeError, match="NaT at 1"):
        qtraj.seconds_from_ns(np.array(["2026-12-01", "NaT"], "datetime64[s]"))
