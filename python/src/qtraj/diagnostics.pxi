# Functions of series of samples or keys, which no generalised ufunc can express: their outputs have lengths of their own.


cdef tuple series_of(object times, object q):
    """Times (n,) and orientations (n, 4) as float64."""
    q = _arrays.quaternions("q", q, np.float64)
    times = _arrays.reals("times", times, np.float64)
    if q.ndim != 2 or times.shape != (len(q),):
        raise TypeError(f"times has the shape {times.shape}, q {q.shape}; (n,) and (n, 4) are needed")
    return times, q


def even_times(double first, double last, count):
    """Times at even distances from first to last, both exact, s.

    Examples
    --------
    >>> import qtraj
    >>> qtraj.even_times(0, 1, 5)
    array([0.  , 0.25, 0.5 , 0.75, 1.  ])
    """
    times = np.empty(whole("count", count, 0))
    check(qtraj_even_times(first, last, times.size, <double*>data(times)), SIZE_MAX, "even_times")
    return times


def seconds_from_ns(ns, origin=None):
    """Seconds of time stamps that count nanoseconds, exact to half an ulp of the difference from the origin.

    Parameters
    ----------
    ns : array_like of int or datetime64
        Stamps; datetime64 of any unit is turned into nanoseconds first.
    origin : int or datetime64, optional
        The stamp that becomes 0; the first one unless given. Stamps since 1970 as double are off by up to 1.2e-7 s.

    Returns
    -------
    ndarray of float64, of the shape of ns

    Examples
    --------
    >>> import qtraj
    >>> qtraj.seconds_from_ns([1403715273262142976, 1403715273267142976])
    array([0.   , 0.005])
    """
    stamps = np.asarray(ns)
    if stamps.dtype.kind == "M":
        if np.isnat(stamps).any():
            raise TypeError(f"ns has a stamp that is not a time: NaT at {int(np.isnat(stamps).ravel().argmax())}")
        stamps = stamps.astype("datetime64[ns]").view(np.int64)
    if stamps.dtype.kind not in "iu" or stamps.dtype == np.uint64:
        raise TypeError(f"ns is of type {stamps.dtype}: whole numbers of 64 bits, or datetime64, are needed")
    stamps = np.require(stamps, np.int64, "CA")
    if origin is None:
        origin = stamps.ravel()[0] if stamps.size else 0
    elif isinstance(origin, np.datetime64) or hasattr(origin, "to_datetime64"):
        origin = np.datetime64(origin, "ns").view(np.int64)
    seconds = np.empty(stamps.shape)
    check(qtraj_seconds_from_ns(<const int64_t*>data(stamps), stamps.size, int(origin), <double*>data(seconds)))
    return seconds


def check_keys(times, q):
    """Finds all faults of a recording at once, and what is suspicious in it without being a fault.

    Parameters
    ----------
    times : array_like, shape (n,)
        s.
    q : array_like, shape (n, 4)
        Keys ``w x y z``.

    Returns
    -------
    KeyReport
        A named tuple: status (n,), 0 or that of the fault (see status_name()), the number of faults, and what is
        suspicious: sign changes, norms, angles and intervals, each with its key; an index is None where there is none.

    Examples
    --------
    >>> import qtraj
    >>> report = qtraj.check_keys([0, 1, 1], [[1, 0, 0, 0], [0, 0, 0, 0], [1, 0, 0, 1]])
    >>> [qtraj.status_name(status) for status in report.status]
    ['OK', 'ZERO_NORM', 'OK']
    """
    q = _arrays.quaternions("q", q)
    times = _arrays.reals("times", times, np.float64)
    if q.ndim != 2 or times.shape != (len(q),):
        raise TypeError(f"times has the shape {times.shape}, q {q.shape}; (n,) and (n, 4) are needed")
    cdef qtraj_key_report report
    cdef size_t count = len(q), bad = SIZE_MAX
    statuses = np.empty(count, np.int32)
    cdef int32_t* codes = <int32_t*>data(statuses)
    cdef const double* t = <const double*>data(times)
    cdef void* keys = data(q)
    cdef bint single = q.dtype == np.float32
    cdef int code
    with nogil:
        if single:
            code = qtraj_check_keys_f32(t, <float*>keys, count, codes, &report, &bad)
        else:
            code = qtraj_check_keys(t, <double*>keys, count, codes, &report, &bad)
    if qtraj_status_class(code) != QTRAJ_CLASS_DATA:
        check(code, bad, "check_keys", "key")
    return _results.KeyReport(
        statuses, report.faults, report.sign_changes, index_of(report.first_sign_change), report.worst_norm_error,
        index_of(report.worst_norm_index), report.largest_angle, index_of(report.largest_angle_index),
        report.longest_interval, index_of(report.longest_interval_index), report.shortest_interval,
        index_of(report.shortest_interval_index))


cdef object index_of(uint64_t index):
    return None if index == <uint64_t>-1 else index


def estimate_omega(times, q, *, frame):
    """Mean angular velocities between neighbouring samples, the shorter way round.

    Parameters
    ----------
    times : array_like, shape (n,)
        s, strictly increasing; two or more.
    q : array_like, shape (n, 4)
        Samples ``w x y z``, body to world, of any norm but 0.
    frame : {"body", "world"}

    Returns
    -------
    EstimatedRates
        A named tuple of times (n - 1,), the middles of the intervals, s, and omega (n - 1, 3), rad/s.

    Examples
    --------
    >>> import qtraj
    >>> qtraj.estimate_omega([0, 2], [[1, 0, 0, 0], [0.6, 0, 0, 0.8]], frame="body").omega.round(4)
    array([[0.    , 0.    , 0.9273]])
    """
    times, q = series_of(times, q)
    cdef size_t bad = SIZE_MAX, count = len(q)
    middles, omega = np.empty(max(len(q) - 1, 0)), np.empty((max(len(q) - 1, 0), 3))
    judge(qtraj_estimate_omega(frame_of(frame), <double*>data(times), <double*>data(q), count, <double*>data(middles),
                               <double*>data(omega), &bad), bad, "estimate_omega", "sample")
    return _results.EstimatedRates(middles, omega)


def estimate_energy(times, q, *, frame):
    """Sum that approximates the integral of |alpha|^2 of samples, rad^2/s^3; three or more.

    Examples
    --------
    >>> import qtraj
    >>> q = qtraj.q_from_rotation_vector([[0, 0, 0], [0, 0, 1], [0, 0, 3]])
    >>> round(qtraj.estimate_energy([0, 1, 2], q, frame="body"), 6)
    1.0
    """
    times, q = series_of(times, q)
    cdef size_t bad = SIZE_MAX
    cdef double energy = 0
    judge(qtraj_estimate_energy(frame_of(frame), <double*>data(times), <double*>data(q), len(q), &energy, &bad), bad,
          "estimate_energy", "sample")
    return energy


def estimate_jumps(times, q, knots, *, frame):
    """By how much the estimated rate of samples jumps at each knot: (knots, 3), rad/s.

    Examples
    --------
    >>> import qtraj
    >>> q = qtraj.q_from_rotation_vector([[0, 0, 0], [0, 0, 1], [0, 0, 3]])
    >>> qtraj.estimate_jumps([0, 1, 2], q, [1.0], frame="body").round(6) + 0
    array([[0., 0., 1.]])
    """
    times, q = series_of(times, q)
    knots = _arrays.reals("knots", knots, np.float64)
    if knots.ndim != 1:
        raise TypeError(f"knots has the shape {knots.shape}, not (n,)")
    cdef size_t bad = SIZE_MAX
    jumps = np.empty((len(knots), 3))
    judge(qtraj_estimate_jumps(frame_of(frame), <double*>data(times), <double*>data(q), len(q), <double*>data(knots),
                               len(knots), <double*>data(jumps), &bad), bad, "estimate_jumps", "row")
    return jumps


def keyframe_errors(key_times, key_q, times, q):
    """Rotation angle, rad, of each key to the sample nearest in time, and the index of that sample.

    Examples
    --------
    >>> import qtraj
    >>> q = qtraj.q_from_rotation_vector([[0, 0, 0], [0, 0, 1], [0, 0, 3]])
    >>> qtraj.keyframe_errors([0.9], q[1:2], [0, 1, 2], q).sample
    array([1])
    """
    key_times, key_q = series_of(key_times, key_q)
    times, q = series_of(times, q)
    cdef size_t bad = SIZE_MAX
    angles, index = np.empty(len(key_q)), np.empty(len(key_q), np.uintp)
    judge(qtraj_keyframe_errors(<double*>data(key_times), <double*>data(key_q), len(key_q), <double*>data(times),
                                <double*>data(q), len(q), <double*>data(angles), <size_t*>data(index), &bad), bad,
          "keyframe_errors", "row")
    return _results.KeyframeErrors(angles, index.astype(np.intp))


def squad_controls(times, q):
    """Inner controls of SQUAD for keys whose signs are continuous: a named tuple of a (n, 4) and b (n, 4).

    a[i] belongs to the segment that starts at key i, b[i] to the one that ends there; times None: evenly spaced keys.

    Examples
    --------
    >>> import qtraj
    >>> qtraj.squad_controls(None, [[1, 0, 0, 0], [0.6, 0, 0, 0.8]]).a
    array([[1. , 0. , 0. , 0. ],
           [0.6, 0. , 0. , 0.8]])
    """
    if times is None:
        q = _arrays.quaternions("q", q, np.float64)
        if q.ndim != 2:
            raise TypeError(f"q has the shape {q.shape}, not (n, 4)")
    else:
        times, q = series_of(times, q)
    cdef size_t bad = SIZE_MAX
    a, b = np.empty_like(q), np.empty_like(q)
    judge(qtraj_squad_controls(<double*>data(times), <double*>data(q), len(q), <double*>data(a), <double*>data(b), &bad),
          bad, "squad_controls", "key")
    return _results.Controls(a, b)


def cubic_spline(x, y, queries, *, ends="natural"):
    """C2 cubic spline through points, at queries: for one call; a VectorCurve keeps the curve.

    Parameters
    ----------
    x : array_like, shape (n,)
        Knots, strictly increasing.
    y : array_like, shape (n, dim) or (n,)
    queries : array_like, shape (m,)
    ends : {"natural", "not_a_knot", "periodic"}, or a pair of such

    Returns
    -------
    ndarray, shape (m, dim) or (m,)

    Examples
    --------
    >>> import qtraj
    >>> qtraj.cubic_spline([0, 1, 2], [0, 1, 0], [0.5, 1.0])
    array([0.6875, 1.    ])
    """
    x, y, queries = (_arrays.reals(name, value, np.float64) for name, value in (("x", x), ("y", y), ("queries", queries)))
    if y.ndim not in (1, 2) or x.shape != y.shape[:1] or queries.ndim != 1:
        raise TypeError(f"x has the shape {x.shape}, y {y.shape}, queries {queries.shape}; (n,), (n, dim), (m,) are needed")
    start, end = pair("ends", ends)
    cdef size_t bad = SIZE_MAX, dim = 1 if y.ndim == 1 else y.shape[1]
    out = np.empty((len(queries), *y.shape[1:]))
    judge(qtraj_cubic_spline(<double*>data(x), <double*>data(y), len(x), dim, end_constant(start), end_constant(end),
                             <double*>data(queries), len(queries), <double*>data(out), &bad), bad, "cubic_spline", "row")
    return out


def rows_from_columns(columns):
    """Columns of a table as rows of one array, (n, width): several times as fast as numpy.stack.

    All float32, or else float64.

    Examples
    --------
    >>> import qtraj
    >>> qtraj.rows_from_columns([[1, 2], [3, 4], [5, 6]])
    array([[1., 3., 5.],
           [2., 4., 6.]])
    """
    arrays = [_arrays.reals(f"columns[{i}]", column) for i, column in enumerate(columns)]
    if any(array.ndim != 1 or array.shape != arrays[0].shape for array in arrays):
        raise TypeError(f"columns have the shapes {[array.shape for array in arrays]}: one length is needed")
    cdef bint single = bool(arrays) and all(array.dtype == np.float32 for array in arrays)
    real = np.float32 if single else np.float64
    arrays = [np.ascontiguousarray(array, real) for array in arrays]
    rows = np.empty((len(arrays[0]) if arrays else 0, len(arrays)), real)
    pointers = np.array([<size_t>data(array) for array in arrays], np.uintp)
    if single:
        check(qtraj_rows_from_columns_f32(<const float* const*>data(pointers), rows.shape[1], rows.shape[0],
                                          <float*>data(rows)))
    else:
        check(qtraj_rows_from_columns(<const double* const*>data(pointers), rows.shape[1], rows.shape[0],
                                      <double*>data(rows)))
    return rows


def columns_from_rows(rows):
    """Rows (n, width) as a list of width contiguous columns, each (n,).

    Examples
    --------
    >>> import qtraj
    >>> qtraj.columns_from_rows([[1, 3], [2, 4]])
    [array([1., 2.]), array([3., 4.])]
    """
    rows = _arrays.reals("rows", rows)
    if rows.ndim != 2:
        raise TypeError(f"rows has the shape {rows.shape}, not (n, width)")
    columns = [np.empty(rows.shape[0], rows.dtype) for _ in range(rows.shape[1])]
    pointers = np.array([<size_t>data(column) for column in columns], np.uintp)
    if rows.dtype == np.float32:
        check(qtraj_columns_from_rows_f32(<float*>data(rows), rows.shape[1], rows.shape[0],
                                          <float* const*>data(pointers)))
    else:
        check(qtraj_columns_from_rows(<double*>data(rows), rows.shape[1], rows.shape[0],
                                      <double* const*>data(pointers)))
    return columns


def library_version():
    """Version of the library inside.

    Examples
    --------
    >>> import qtraj
    >>> qtraj.library_version() == qtraj.__version__
    True
    """
    return qtraj_version().decode()


def target():
    """Kernel that runs here and its arithmetic: samples have the same bits wherever the latter is the same.

    Examples
    --------
    >>> import qtraj
    >>> qtraj.target().split()[1] in ("fused", "plain")  # such as "avx2 fused"
    True
    """
    return qtraj_target().decode()


def status_text(int status):
    """One line of English about a status.

    Examples
    --------
    >>> import qtraj
    >>> qtraj.status_text(23)
    'time does not come after the one before: sort, leave repeats out'
    """
    return qtraj_status_text(status).decode()


def status_name(int status):
    """Name of a status without its prefix.

    Examples
    --------
    >>> import qtraj
    >>> qtraj.status_name(23)
    'TIME_ORDER'
    """
    return _words.STATUSES.get(status, str(status))
