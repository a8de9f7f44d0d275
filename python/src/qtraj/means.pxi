# Means of rows along axes, and signs along one.


cdef tuple groups_of(object q, object weights, object axis):
    """Rows as [groups, n, 4], weights as [groups, n] or None, and the shape that is left: axes but the last are reduced."""
    q = _arrays.quaternions("q", q)
    axes = q.ndim - 1
    if axis is None:
        reduced = tuple(range(axes))
    else:
        reduced = np.lib.array_utils.normalize_axis_tuple(axis, axes) if hasattr(np.lib, "array_utils") else (
            np.core.numeric.normalize_axis_tuple(axis, axes))
    kept = tuple(k for k in range(axes) if k not in reduced)
    shape = tuple(q.shape[k] for k in kept)
    n = int(np.prod([q.shape[k] for k in reduced], dtype=np.int64))
    groups = int(np.prod(shape, dtype=np.int64))
    if weights is not None:
        weights = np.broadcast_to(_arrays.reals("weights", weights, q.dtype.type), q.shape[:-1])
        weights = np.ascontiguousarray(weights.transpose(kept + reduced)).reshape(groups, n)
    q = np.ascontiguousarray(q.transpose(kept + reduced + (axes,))).reshape(groups, n, 4)
    return q, weights, shape


cdef struct Descent:
    # What a Karcher mean is asked for beside its samples.
    double tolerance
    int32_t max_iterations

# One group: n samples and their weights, or NULL; out receives its mean or moments, more its eigengap.
ctypedef int (*call_of_group)(const void* q, const void* weights, size_t n, bint single, void* out, double* more,
                              Descent descent) noexcept nogil


cdef int eigen_of(const void* q, const void* weights, size_t n, bint single, void* out, double* more,
                  Descent descent) noexcept nogil:
    cdef size_t bad
    if single:
        return qtraj_mean_eigen_f32(<const float*>q, <const float*>weights, n, <float*>out, more, &bad)
    return qtraj_mean_eigen(<const double*>q, <const double*>weights, n, <double*>out, more, &bad)


cdef int karcher_of(const void* q, const void* weights, size_t n, bint single, void* out, double* more,
                    Descent descent) noexcept nogil:
    cdef size_t bad
    if single:
        return qtraj_mean_karcher_f32(<const float*>q, <const float*>weights, n, descent.tolerance,
                                      descent.max_iterations, <float*>out, NULL, NULL, &bad)
    return qtraj_mean_karcher(<const double*>q, <const double*>weights, n, descent.tolerance, descent.max_iterations,
                              <double*>out, NULL, NULL, &bad)


cdef int moments_of(const void* q, const void* weights, size_t n, bint single, void* out, double* more,
                    Descent descent) noexcept nogil:
    cdef size_t bad
    cdef double* sums = <double*>out
    cdef int status
    if single:
        status = qtraj_moments_add_f32(<const float*>q, <const float*>weights, n, sums, &bad)
    else:
        status = qtraj_moments_add(<const double*>q, <const double*>weights, n, sums, &bad)
    if status != QTRAJ_OK:
        sums[0] = NAN
    return status


cdef int each_group(call_of_group call, object q, object weights, object out, object more, Descent descent):
    """Calls a function for each group; the first status that is not OK, a fault before an ambiguity."""
    cdef size_t groups = q.shape[0], n = q.shape[1], i
    cdef bint single = q.dtype == np.float32
    cdef size_t size = 4 if single else 8, out_step = out.strides[0]
    cdef char *x = <char*>data(q)
    cdef char *w = <char*>data(weights)
    cdef char *y = <char*>data(out)
    cdef double *z = <double*>data(more)
    cdef int status, first = QTRAJ_OK
    with nogil:
        for i in range(groups):
            status = call(x + 4 * n * i * size, w + n * i * size if w else NULL, n, single, y + i * out_step,
                          z + i if z else NULL, descent)
            if status != QTRAJ_OK and (first == QTRAJ_OK or first == QTRAJ_E_AMBIGUOUS):
                first = status
    return first


def mean_eigen(q, weights=None, *, axis=None, return_eigengap=False):
    """Mean orientation that minimises the weighted sum of squared chords.

    Parameters
    ----------
    q : array_like, shape (..., 4)
        Samples ``w x y z``, of any norm but 0 and any sign.
    weights : array_like, optional
        0 or more; broadcast to the rows of q. Fuse readings of independent errors sigma with 1/sigma^2.
    axis : int or tuple of int, optional
        Axes of rows that are reduced; all of them unless given.
    return_eigengap : bool
        Also return how clear the answer is, in [0, 1]; 0 is a tie.

    Returns
    -------
    ndarray, shape (..., 4)
        A group at fault is NaN, by ``np.errstate``.

    Warns
    -----
    qtraj.AmbiguousWarning
        The two best tie.

    Examples
    --------
    >>> import qtraj
    >>> qtraj.mean_eigen([[1, 0, 0, .1], [1, 0, 0, -.1]])
    array([1., 0., 0., 0.])
    """
    q, weights, shape = groups_of(q, weights, axis)
    mean, gap = np.empty((len(q), 4), q.dtype), np.empty(len(q))
    cdef Descent none = Descent(0, 0)
    judge(each_group(eigen_of, q, weights, mean, gap, none), SIZE_MAX, "mean_eigen", "sample")
    mean = mean.reshape(*shape, 4)
    return (mean, gap.reshape(shape)[()]) if return_eigengap else mean


def mean_karcher(q, weights=None, *, axis=None, tolerance=0.0, max_iterations=64):
    """Mean orientation that minimises the weighted sum of squared angles: a proven global minimum, or a warning.

    Parameters
    ----------
    q, weights, axis
        As of mean_eigen().
    tolerance : float
        rad on S^3, half the angle of the body: a descent ends after a step of this length; 0 is the finest.
    max_iterations : int
        Of the descent to the mean; a mean that takes more raises NO_CONVERGENCE.

    Returns
    -------
    ndarray, shape (..., 4)

    Warns
    -----
    qtraj.AmbiguousWarning
        Samples are spread so widely that the best that was found is not proven to be the only one.

    Examples
    --------
    >>> import qtraj
    >>> qtraj.mean_karcher([[1, 0, 0, .1], [1, 0, 0, -.1]])
    array([1., 0., 0., 0.])
    """
    q, weights, shape = groups_of(q, weights, axis)
    mean = np.empty((len(q), 4), q.dtype)
    cdef Descent descent = Descent(tolerance, max_iterations)
    cdef int status = each_group(karcher_of, q, weights, mean, None, descent)
    if status == QTRAJ_E_NO_CONVERGENCE:
        check(status, SIZE_MAX, "mean_karcher")
    judge(status, SIZE_MAX, "mean_karcher", "sample")
    return mean.reshape(*shape, 4)


def moments(q, weights=None, *, axis=None):
    """Moments of samples, (..., 11): add those of parts number by number, and make mean_from_moments() of the sum.

    The sum of the weights, then the upper triangle of the sum of w q q^T, row by row, as float64.

    Examples
    --------
    >>> import qtraj
    >>> qtraj.moments([[1, 0, 0, 0], [0, 1, 0, 0]])
    array([2., 1., 0., 0., 0., 1., 0., 0., 0., 0., 0.])
    """
    q, weights, shape = groups_of(q, weights, axis)
    sums = np.zeros((len(q), 11))
    cdef Descent none = Descent(0, 0)
    judge(each_group(moments_of, q, weights, sums, None, none), SIZE_MAX, "moments", "sample")
    return sums.reshape(*shape, 11)


def make_continuous(q, *, int axis=-2, return_flips=False):
    """Signs of series of keys made continuous: the dot product of neighbours along an axis is then 0 or more.

    Parameters
    ----------
    q : array_like, shape (..., 4)
        Keys ``w x y z`` of any norm but 0.
    axis : int
        Along which keys follow each other: not the last.
    return_flips : bool
        Also return how many keys were negated.

    Returns
    -------
    ndarray, of the shape of q
        Nothing but signs is changed; the first key of a series keeps its own.

    Examples
    --------
    >>> import qtraj
    >>> qtraj.make_continuous([[.5, .5, .5, .5], [-.7, -.5, -.3, -.4]])
    array([[0.5, 0.5, 0.5, 0.5],
           [0.7, 0.5, 0.3, 0.4]])
    """
    q = _arrays.quaternions("q", q)
    cdef int at = axis + q.ndim if axis < 0 else axis
    if at < 0 or at >= q.ndim - 1:
        raise TypeError(f"axis={axis} of q with the shape {q.shape}: an axis of rows, not the last")
    cdef size_t before = int(np.prod(q.shape[:at], dtype=np.int64)), length = q.shape[at]
    cdef size_t between = int(np.prod(q.shape[at + 1:q.ndim - 1], dtype=np.int64)), i, flips = 0, part = 0, bad
    out = np.empty_like(q)
    cdef bint single = q.dtype == np.float32
    cdef size_t block = 4 * length * between
    cdef void *x = data(q)
    cdef void *y = data(out)
    cdef int status, first = QTRAJ_OK
    with nogil:
        for i in range(before):
            if single:
                status = qtraj_make_continuous_strided_f32(<float*>x + i * block, between, 1, length, between,
                                                           <float*>y + i * block, &part, &bad)
            else:
                status = qtraj_make_continuous_strided(<double*>x + i * block, between, 1, length, between,
                                                       <double*>y + i * block, &part, &bad)
            flips += part
            if status != QTRAJ_OK:
                first = status
    judge(first, SIZE_MAX, "make_continuous", "key")
    return (out, flips) if return_flips else out
