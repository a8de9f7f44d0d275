"""Functions over rows, with the broadcasting of NumPy: names, checks and documentation over the generalised ufuncs.

Quaternions are rows ``w x y z`` of any norm but 0 and body to world; leading axes broadcast. Results are float32 where all
arrays are, else float64. Rows at fault are NaN, and ``np.errstate(invalid=...)`` decides whether that is a warning, an
exception or nothing.
"""

from __future__ import annotations

import warnings
from typing import Any

import numpy as np

from . import _ufuncs
from ._arrays import quaternions, reals, rows
from ._errors import AmbiguousWarning

PATHS = ("shortest", "as_given")
FRAMES = ("body", "world")


def chosen(ufunc: str, name: str, word: object, words: tuple[str, str]) -> np.ufunc:
    """The ufunc of a word; a ValueError that names the right words for any other."""
    if word is None:
        raise TypeError(f"{name} is missing: {' or '.join(map(repr, words))}")
    if word not in words:
        raise ValueError(f"{name}={word!r}: one of {', '.join(map(repr, words))}")
    return getattr(_ufuncs, f"{ufunc}_{word}")


def scalars(name: str, value: Any) -> Any:
    """Fractions, exponents, limits: a Python number takes the type of the arrays beside it."""
    if type(value) in (float, int):
        return value
    return reals(name, value)


def matrices(name: str, value: Any) -> np.ndarray:
    array = reals(name, value)
    if array.shape[-2:] != (3, 3):
        raise TypeError(f"{name} has the shape {array.shape}, not (..., 3, 3)")
    return array


def call(ufunc: np.ufunc, *arguments: Any, out: Any = None) -> Any:
    """Calls a ufunc in the type of its arrays, and warns where a row was ambiguous."""
    single = all(argument.dtype == np.float32 for argument in arguments if isinstance(argument, np.ndarray))
    if single:
        arguments = tuple(np.float32(a) if not isinstance(a, np.ndarray) else a for a in arguments)
    result = ufunc(*arguments) if out is None else ufunc(*arguments, out=out)
    if _ufuncs.take_ambiguous():
        warnings.warn(
            AmbiguousWarning(f"{ufunc.__name__}: more than one answer is equally right for a row; it holds one of them"),
            stacklevel=3,
        )
    return result


# ---- Pairs ----


def slerp(a: Any, b: Any, fraction: Any, *, path: str = "shortest", out: Any = None) -> Any:
    """Points on the turn from a to b at constant rate.

    Parameters
    ----------
    a, b : array_like, shape (..., 4), or Rotation
        Orientations ``w x y z``.
    fraction : array_like, shape (...)
        0 is a, 1 is b; any other number is between or beyond.
    path : {"shortest", "as_given"}
        To b or -b, whichever is nearer, or to b also where that is the longer way round.
    out : ndarray, optional

    Returns
    -------
    ndarray, shape (..., 4)
        Unit.

    Warns
    -----
    AmbiguousWarning
        "as_given", and b is the opposite of a: the body turns about its own x axis.

    Examples
    --------
    >>> import qtraj
    >>> qtraj.slerp([1, 0, 0, 0], [0, 0, 0, 1], [0, 0.5, 1]).round(3)
    array([[1.   , 0.   , 0.   , 0.   ],
           [0.707, 0.   , 0.   , 0.707],
           [0.   , 0.   , 0.   , 1.   ]])
    """
    ufunc = chosen("slerp", "path", path, PATHS)
    return call(ufunc, quaternions("a", a), quaternions("b", b), scalars("fraction", fraction), out=out)


def nlerp(a: Any, b: Any, fraction: Any, *, path: str = "shortest", out: Any = None) -> Any:
    """Points on the same turn as slerp(), by normalised linear interpolation: at a slightly uneven rate.

    Parameters, result and warnings as of slerp().

    Examples
    --------
    >>> import qtraj
    >>> qtraj.nlerp([1, 0, 0, 0], [0, 0, 0, 1], 0.5).round(3)
    array([0.707, 0.   , 0.   , 0.707])
    """
    ufunc = chosen("nlerp", "path", path, PATHS)
    return call(ufunc, quaternions("a", a), quaternions("b", b), scalars("fraction", fraction), out=out)


def between(ufunc: np.ufunc, a: Any, time_a: Any, b: Any, time_b: Any, time: Any, out: Any) -> Any:
    """Interpolation by times, which are float64 also beside float32."""
    a, b = quaternions("a", a), quaternions("b", b)
    times = [reals(name, t, np.float64) for name, t in (("time_a", time_a), ("time_b", time_b), ("time", time))]
    if a.dtype != b.dtype:
        a, b = a.astype(np.float64), b.astype(np.float64)
    result = ufunc(a, times[0], b, times[1], times[2], out=out)
    if _ufuncs.take_ambiguous():
        warnings.warn(AmbiguousWarning(f"{ufunc.__name__}: a row has more than one right answer"), stacklevel=4)
    return result


def slerp_between(
    a: Any, time_a: Any, b: Any, time_b: Any, time: Any, *, path: str = "shortest", out: Any = None
) -> Any:
    """slerp() between orientations that have times, at a time, s, instead of a fraction.

    Times are float64 also beside quaternions of float32, and are subtracted before they are rounded.

    Examples
    --------
    >>> import qtraj
    >>> qtraj.slerp_between([1, 0, 0, 0], 10.0, [0, 0, 0, 1], 12.0, 11.0).round(3)
    array([0.707, 0.   , 0.   , 0.707])
    """
    return between(chosen("slerp_between", "path", path, PATHS), a, time_a, b, time_b, time, out)


def nlerp_between(
    a: Any, time_a: Any, b: Any, time_b: Any, time: Any, *, path: str = "shortest", out: Any = None
) -> Any:
    """nlerp() between orientations that have times, at a time, s: arguments as of slerp_between().

    Examples
    --------
    >>> import qtraj
    >>> qtraj.nlerp_between([1, 0, 0, 0], 10.0, [0, 0, 0, 1], 12.0, 11.0).round(3)
    array([0.707, 0.   , 0.   , 0.707])
    """
    return between(chosen("nlerp_between", "path", path, PATHS), a, time_a, b, time_b, time, out)


def screw(q_a: Any, p_a: Any, q_b: Any, p_b: Any, fraction: Any) -> tuple[Any, Any]:
    """Poses on the screw motion from a to b: angular and linear rate are constant in the body frame.

    Parameters
    ----------
    q_a, q_b : array_like, shape (..., 4)
        Orientations ``w x y z``, body to world.
    p_a, p_b : array_like, shape (..., 3)
        Positions in the world, in any unit.
    fraction : array_like, shape (...)

    Returns
    -------
    q : ndarray, shape (..., 4)
    position : ndarray, shape (..., 3)

    Warns
    -----
    AmbiguousWarning
        Orientations half a turn apart.

    Examples
    --------
    >>> import qtraj
    >>> q, position = qtraj.screw([1, 0, 0, 0], [1, 0, 0], [1, 0, 0, 1], [0, 1, 0], 0.5)
    >>> position.round(3)
    array([0.707, 0.707, 0.   ])
    """
    return call(
        _ufuncs.screw,
        quaternions("q_a", q_a),
        rows("p_a", p_a, 3),
        quaternions("q_b", q_b),
        rows("p_b", p_b, 3),
        scalars("fraction", fraction),
    )


def squad_segment(q0: Any, q1: Any, a: Any, b: Any, fraction: Any, *, out: Any = None) -> Any:
    """SQUAD from q0 to q1 with inner controls a and b, see squad_controls(); arcs as their signs give them.

    Examples
    --------
    >>> import qtraj
    >>> q = [[1, 0, 0, 0], [0.6, 0, 0, 0.8], [0, 0, 0, 1]]
    >>> controls = qtraj.squad_controls([0, 1, 2], q)
    >>> qtraj.squad_segment(q[0], q[1], controls.a[0], controls.b[1], [0, 1]).round(3)
    array([[1. , 0. , 0. , 0. ],
           [0.6, 0. , 0. , 0.8]])
    """
    ends = (quaternions(name, q) for name, q in (("q0", q0), ("q1", q1), ("a", a), ("b", b)))
    return call(_ufuncs.squad_segment, *ends, scalars("fraction", fraction), out=out)


# ---- Algebra ----


def multiply(a: Any, b: Any, *, out: Any = None) -> Any:
    """Hamilton product a b, of quaternions as they are, 0 too.

    Examples
    --------
    >>> import qtraj
    >>> qtraj.multiply([0, 1, 0, 0], [0, 0, 1, 0])
    array([0., 0., 0., 1.])
    """
    return call(_ufuncs.multiply, quaternions("a", a), quaternions("b", b), out=out)


def conjugate(q: Any, *, out: Any = None) -> Any:
    """w, -x, -y, -z.

    Examples
    --------
    >>> import qtraj
    >>> qtraj.conjugate([1, 2, 3, 4])
    array([ 1., -2., -3., -4.])
    """
    return call(_ufuncs.conjugate, quaternions("q", q), out=out)


def inverse(q: Any, *, out: Any = None) -> Any:
    """Conjugate over squared norm: multiply(q, inverse(q)) is 1.

    Examples
    --------
    >>> import qtraj
    >>> qtraj.inverse([0, 2, 0, 0])
    array([ 0. , -0.5, -0. , -0. ])
    """
    return call(_ufuncs.inverse, quaternions("q", q), out=out)


def norm(q: Any, *, out: Any = None) -> Any:
    """Norms (...) of quaternions (..., 4): neither overflow nor underflow on the way.

    Examples
    --------
    >>> import qtraj
    >>> float(qtraj.norm([0, 3, 4, 0]))
    5.0
    """
    return call(_ufuncs.norm, quaternions("q", q), out=out)


def dot(a: Any, b: Any, *, out: Any = None) -> Any:
    """Dot products (...) of quaternions (..., 4): below 0 where signs differ.

    Examples
    --------
    >>> import qtraj
    >>> float(qtraj.dot([1, 2, 3, 4], [1, 0, 0, -1]))
    -3.0
    """
    return call(_ufuncs.dot, quaternions("a", a), quaternions("b", b), out=out)


def exp(v: Any, *, out: Any = None) -> Any:
    """Quaternion exponential of half-angle vectors: unit quaternions (..., 4) of v (..., 3), rad.

    q_from_rotation_vector() takes whole angles.

    Examples
    --------
    >>> import numpy as np, qtraj
    >>> qtraj.exp([0, 0, np.pi / 4]).round(3)
    array([0.707, 0.   , 0.   , 0.707])
    """
    return call(_ufuncs.exp, rows("v", v, 3), out=out)


def log(q: Any, *, out: Any = None) -> Any:
    """Half-angle vectors (..., 3), rad, of which q (..., 4) is the exponential, norms apart; keeps the sign of q.

    Warns
    -----
    AmbiguousWarning
        At -1, whose logarithm is pi about any axis: it is that about x.

    Examples
    --------
    >>> import qtraj
    >>> qtraj.log([1, 0, 0, 1]).round(4)
    array([0.    , 0.    , 0.7854])
    """
    return call(_ufuncs.log, quaternions("q", q), out=out)


def power(q: Any, exponent: Any, *, out: Any = None) -> Any:
    """Turns of q, times a number: (..., 4), unit.

    Examples
    --------
    >>> import qtraj
    >>> qtraj.power([1, 0, 0, 1], 2).round(3)
    array([0., 0., 0., 1.])
    """
    return call(_ufuncs.power, quaternions("q", q), scalars("exponent", exponent), out=out)


def rotate(q: Any, v: Any, *, out: Any = None) -> Any:
    """World vectors (..., 3) of body vectors v (..., 3): q v q^-1.

    Examples
    --------
    >>> import qtraj
    >>> qtraj.rotate([1, 0, 0, 1], [1, 0, 0]).round(3)
    array([0., 1., 0.])
    """
    return call(_ufuncs.rotate, quaternions("q", q), rows("v", v, 3), out=out)


def distance(a: Any, b: Any, *, out: Any = None) -> Any:
    """Angle in four dimensions between a and b (..., 4), where signs count: (...), rad, in [0, pi].

    Examples
    --------
    >>> import qtraj
    >>> float(qtraj.distance([1, 0, 0, 0], [1, 0, 0, 1]).round(4))
    0.7854
    """
    return call(_ufuncs.distance, quaternions("a", a), quaternions("b", b), out=out)


def angle(a: Any, b: Any, *, out: Any = None) -> Any:
    """Angle by which the body turns between a and b (..., 4), whatever their signs: (...), rad, in [0, pi].

    Examples
    --------
    >>> import qtraj
    >>> float(qtraj.angle([1, 0, 0, 0], [-1, 0, 0, -1]).round(4))
    1.5708
    """
    return call(_ufuncs.angle, quaternions("a", a), quaternions("b", b), out=out)


# ---- Other representations ----


def rotation_vector_from_q(q: Any, *, out: Any = None) -> Any:
    """Rotation vectors (..., 3), rad, of q (..., 4): the shorter way, at most half a turn.

    Warns
    -----
    AmbiguousWarning
        Half a turn: of two opposite vectors it is one.

    Examples
    --------
    >>> import qtraj
    >>> qtraj.rotation_vector_from_q([1, 0, 0, 1]).round(4)
    array([0.    , 0.    , 1.5708])
    """
    return call(_ufuncs.rotation_vector_from_q, quaternions("q", q), out=out)


def q_from_rotation_vector(r: Any, *, out: Any = None) -> Any:
    """Quaternions (..., 4) of rotation vectors r (..., 3), rad, of any length.

    Examples
    --------
    >>> import numpy as np, qtraj
    >>> qtraj.q_from_rotation_vector([0, 0, np.pi / 2]).round(3)
    array([0.707, 0.   , 0.   , 0.707])
    """
    return call(_ufuncs.q_from_rotation_vector, rows("r", r, 3), out=out)


def matrix_from_q(q: Any, *, out: Any = None) -> Any:
    """Rotation matrices (..., 3, 3) of q (..., 4): v_world = matrix @ v_body.

    Examples
    --------
    >>> import qtraj
    >>> qtraj.matrix_from_q([1, 0, 0, 1]).round(3)
    array([[ 0., -1.,  0.],
           [ 1.,  0.,  0.],
           [ 0.,  0.,  1.]])
    """
    return call(_ufuncs.matrix_from_q, quaternions("q", q), out=out)


def q_from_matrix(matrix: Any, limit: Any = 1e-3, *, return_distance: bool = False) -> Any:
    """Quaternions (..., 4), w >= 0, of the rotations nearest to matrices (..., 3, 3).

    Parameters
    ----------
    matrix : array_like, shape (..., 3, 3)
        v_world = matrix @ v_body.
    limit : float
        A matrix farther than this, at most 0.5, from every rotation is NaN: 2e-3 suits elements of three decimals.
    return_distance : bool
        Also return how far each matrix is from its rotation.

    Examples
    --------
    >>> import qtraj
    >>> qtraj.q_from_matrix([[0, -1, 0], [1, 0, 0], [0, 0, 1]]).round(3)
    array([0.707, 0.   , 0.   , 0.707])
    """
    if not np.all((np.asarray(limit) > 0) & (np.asarray(limit) <= 0.5)):
        raise ValueError(f"limit={limit!r}: a number above 0, at most 0.5")
    q, away = call(_ufuncs.q_from_matrix, matrices("matrix", matrix), scalars("limit", limit))
    return (q, away) if return_distance else q


def wxyz_from_xyzw(q_xyzw: Any, *, out: Any = None) -> Any:
    """The order of this library, ``w x y z``, of rows ``x y z w``, that of SciPy, ROS and glTF.

    Examples
    --------
    >>> import qtraj
    >>> qtraj.wxyz_from_xyzw([1, 2, 3, 4])
    array([4., 1., 2., 3.])
    """
    return call(_ufuncs.wxyz_from_xyzw, rows("q_xyzw", q_xyzw, 4), out=out)


def xyzw_from_wxyz(q: Any, *, out: Any = None) -> Any:
    """Rows ``x y z w``, the order of SciPy, ROS and glTF, of rows ``w x y z``.

    Examples
    --------
    >>> import qtraj
    >>> qtraj.xyzw_from_wxyz([1, 2, 3, 4])
    array([2., 3., 4., 1.])
    """
    return call(_ufuncs.xyzw_from_wxyz, rows("q", q, 4), out=out)


def normalize(q: Any, *, out: Any = None) -> Any:
    """Quaternions of norm 1, signs kept.

    Examples
    --------
    >>> import qtraj
    >>> qtraj.normalize([0, 3, 4, 0])
    array([0. , 0.6, 0.8, 0. ])
    """
    return call(_ufuncs.normalize, quaternions("q", q), out=out)


# ---- Rates ----


def derivatives_from_rates(q: Any, omega: Any, alpha: Any = None, *, frame: str) -> tuple[Any, Any]:
    """dq/dt and its derivative of angular velocity and acceleration.

    Parameters
    ----------
    q : array_like, shape (..., 4)
    omega, alpha : array_like, shape (..., 3)
        rad/s and rad/s^2 in the frame; alpha 0 unless given.
    frame : {"body", "world"}

    Returns
    -------
    dq, ddq : ndarray, shape (..., 4)
        1/s and 1/s^2.

    Examples
    --------
    >>> import qtraj
    >>> dq, ddq = qtraj.derivatives_from_rates([1, 0, 0, 0], [0, 0, 2], frame="body")
    >>> dq, ddq
    (array([0., 0., 0., 1.]), array([-1.,  0.,  0.,  0.]))
    """
    ufunc = chosen("derivatives", "frame", frame, FRAMES)
    omega = rows("omega", omega, 3)
    return call(ufunc, quaternions("q", q), omega, np.zeros_like(omega) if alpha is None else rows("alpha", alpha, 3))


def rates_from_derivatives(q: Any, dq: Any, ddq: Any = None, *, frame: str) -> tuple[Any, Any]:
    """Angular velocity and acceleration of dq/dt and its derivative: the way back. Changes of the norm are ignored.

    Parameters
    ----------
    q, dq, ddq : array_like, shape (..., 4)
        1, 1/s and 1/s^2; ddq 0 unless given.
    frame : {"body", "world"}

    Returns
    -------
    omega, alpha : ndarray, shape (..., 3)
        rad/s and rad/s^2 in the frame.

    Examples
    --------
    >>> import qtraj
    >>> omega, alpha = qtraj.rates_from_derivatives([1, 0, 0, 0], [0, 0, 0, 1], [-1, 0, 0, 0], frame="body")
    >>> omega, alpha
    (array([0., 0., 2.]), array([0., 0., 0.]))
    """
    ufunc = chosen("rates", "frame", frame, FRAMES)
    dq = rows("dq", dq, 4)
    return call(ufunc, quaternions("q", q), dq, np.zeros_like(dq) if ddq is None else rows("ddq", ddq, 4))


def mean_from_moments(moments: Any, *, return_eigengap: bool = False) -> Any:
    """Eigen means (..., 4), w >= 0, of moments (..., 11): see moments().

    Examples
    --------
    >>> import qtraj
    >>> parts = [qtraj.moments([[1, 0, 0, .1]]), qtraj.moments([[1, 0, 0, -.1]])]
    >>> qtraj.mean_from_moments(sum(parts))
    array([1., 0., 0., 0.])
    """
    mean, eigengap = call(_ufuncs.mean_from_moments, rows("moments", moments, 11, np.float64))
    return (mean, eigengap) if return_eigengap else mean
