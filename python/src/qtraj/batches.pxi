# Ragged batches: many series of keys in one call, by offsets.


cdef cnp.ndarray offsets_of(str name, object offsets, object rows):
    """Offsets of series as int64, [series + 1], that stay within so many rows; rows is None for no limit."""
    array = np.asarray(offsets)
    if array.dtype.kind not in "iu" or array.ndim != 1 or len(array) == 0:
        raise TypeError(f"{name} is of type {array.dtype} and shape {array.shape}: whole numbers are needed, one for each "
                        "series and one more")
    if rows is not None and int(array[-1]) > rows:
        raise ValueError(f"{name} ends at row {array[-1]}, but there are {rows} rows")
    return np.require(array, np.int64, "CA")


cdef object flat_times(object times):
    """Times of the keys of all series, (n,)."""
    times = _arrays.reals("times", times, np.float64)
    if times.ndim != 1:
        raise TypeError(f"times has the shape {times.shape}, not (n,)")
    return times


cdef cnp.ndarray steps_of(object step, size_t series):
    """Steps, s: one for all series or one for each."""
    steps = np.atleast_1d(_arrays.reals("step", step, np.float64))
    if steps.ndim != 1 or len(steps) not in (1, series):
        raise TypeError(f"step has the shape {steps.shape}: one number, or one for each of the {series} series")
    return steps


def batch_sample(Settings settings not None, int frame, key_offsets, times, q, omega, alpha, sample_offsets, at, rates):
    """Curves of all series, sampled: arrays q, omega, alpha (None without rates) and status, one for each series.

    times and q are contiguous, (n,) and (n, 4): sample_batch() has seen to that.
    """
    cdef bint single = q.dtype == np.float32
    real = q.dtype.type
    n = len(q)
    omega = None if omega is None else _arrays.rows("omega", omega, 3, real, (n,))
    alpha = None if alpha is None else _arrays.rows("alpha", alpha, 3, real, (n,))
    cdef cnp.ndarray keys = offsets_of("offsets", key_offsets, n)
    at = None if at is None else _arrays.reals("at", at, np.float64)
    if at is not None and at.ndim != 1:
        raise TypeError(f"at has the shape {at.shape}, not (n,)")
    cdef cnp.ndarray samples = offsets_of("sample offsets", sample_offsets, None if at is None else len(at))
    if samples.size != keys.size:
        raise TypeError(f"{keys.size - 1} series of keys, {samples.size - 1} series of samples")
    cdef size_t count = keys.size - 1, bad = SIZE_MAX
    # rows outside all series belong to nobody, and are NaN
    m = int(samples[-1])
    make = np.empty if int(samples[0]) == 0 else lambda shape, dtype: np.full(shape, np.nan, dtype)
    q_out = make((m, 4), real)
    omega_out, alpha_out = (make((m, 3), real), make((m, 3), real)) if rates else (None, None)
    status = np.empty(count, np.int32)
    cdef const int64_t *ko = <const int64_t*>data(keys)
    cdef const int64_t *so = <const int64_t*>data(samples)
    cdef const double *kt = <const double*>data(times)
    cdef const double *st = <const double*>data(at)
    cdef void *kq = data(q)
    cdef void *kw = data(omega)
    cdef void *ka = data(alpha)
    cdef void *oq = data(q_out)
    cdef void *ow = data(omega_out)
    cdef void *oa = data(alpha_out)
    cdef int32_t* codes = <int32_t*>data(status)
    cdef bint plain = not rates and omega is None and alpha is None
    cdef qtraj_options* options = settings.options
    cdef int code
    with nogil:
        if plain and single:
            code = qtraj_batch_sample_f32(options, count, ko, kt, <float*>kq, so, st, NULL, 0, <float*>oq, codes, &bad)
        elif plain:
            code = qtraj_batch_sample(options, count, ko, kt, <double*>kq, so, st, NULL, 0, <double*>oq, codes, &bad)
        elif single:
            code = qtraj_batch_sample_rates_f32(
                options, frame, count, ko, kt, <float*>kq, <float*>kw, <float*>ka, so, st, NULL, 0, <float*>oq,
                <float*>ow, <float*>oa, codes, &bad)
        else:
            code = qtraj_batch_sample_rates(
                options, frame, count, ko, kt, <double*>kq, <double*>kw, <double*>ka, so, st, NULL, 0, <double*>oq,
                <double*>ow, <double*>oa, codes, &bad)
    judge_series(code, bad)
    return q_out, omega_out, alpha_out, status


cdef int judge_series(int status, size_t bad) except -1:
    """A series at fault has rows of NaN, also where its fault would refuse a call of its own, such as too few keys."""
    if status != QTRAJ_E_COUNT and bad != SIZE_MAX:
        return invalid()
    return judge(status, bad, "batch", "series")


def batch_settings(method, frame, ends, tangents, reference, turns, extrapolate, longest_gap, period, closure):
    """The options of a batch, from words."""
    cdef Settings settings = Settings(constant("method", _words.METHODS, method))
    settings.set_common(extrapolate, longest_gap, period, closure)
    settings.set_ends(ends, frame)
    settings.set_reference(reference)
    if tangents is not None:
        check(qtraj_options_set_tangents(settings.options, constant("tangents", _words.TANGENTS, tangents)), SIZE_MAX,
              "tangents")
    if turns is not None:
        check(qtraj_options_set_turns(settings.options, constant("turns", _words.TURNS, turns)), SIZE_MAX, "turns")
    return settings


def batch_steps(key_offsets, times, step):
    """Offsets and times of samples at a fixed step from the first key of each series to its last."""
    times = flat_times(times)
    cdef cnp.ndarray keys = offsets_of("offsets", key_offsets, len(times))
    cdef size_t count = keys.size - 1, bad = SIZE_MAX
    cdef cnp.ndarray steps = steps_of(step, count)
    offsets = np.zeros(count + 1, np.int64)
    cdef const int64_t *ko = <const int64_t*>data(keys)
    cdef int64_t *so = <int64_t*>data(offsets)
    cdef const double *kt = <const double*>data(times)
    cdef const double *ds = <const double*>data(steps)
    cdef size_t step_count = steps.size
    cdef int code = qtraj_batch_step_offsets(count, ko, kt, ds, step_count, so, NULL, &bad)
    if qtraj_status_class(code) != QTRAJ_CLASS_DATA:
        check(code, bad, "batch", "series")
    at = np.empty(int(offsets[-1]))
    cdef double* out = <double*>data(at)
    with nogil:
        code = qtraj_batch_times(count, ko, kt, ds, step_count, so, out, NULL, &bad)
    # series at fault have no rows here; sampling tells their statuses
    if qtraj_status_class(code) != QTRAJ_CLASS_DATA:
        check(code, bad, "batch", "series")
    return offsets, at


def batch_mean_eigen(offsets, q, weights=None):
    """Eigen means of groups of rows, as mean_eigen() makes of each.

    Parameters
    ----------
    offsets : array_like of int, shape (groups + 1,)
        Row of the first sample of each group and, last, of the end of the last.
    q : array_like, shape (n, 4)
        Samples ``w x y z``, of any norm but 0.
    weights : array_like, shape (n,), optional
        0 or more.

    Returns
    -------
    ndarray, shape (groups, 4)
        A group at fault, such as one without samples, is NaN.

    Examples
    --------
    >>> import qtraj
    >>> qtraj.batch_mean_eigen([0, 1, 3], [[1, 0, 0, 0], [1, 0, 0, .1], [1, 0, 0, -.1]])
    array([[1., 0., 0., 0.],
           [1., 0., 0., 0.]])
    """
    q = _arrays.quaternions("q", q)
    if q.ndim != 2:
        raise TypeError(f"q has the shape {q.shape}, not (n, 4)")
    cdef bint single = q.dtype == np.float32
    if weights is not None:
        weights = _arrays.reals("weights", weights, q.dtype.type)
        if weights.shape != (len(q),):
            raise TypeError(f"weights has the shape {weights.shape}, not {(len(q),)}")
    cdef cnp.ndarray groups = offsets_of("offsets", offsets, len(q))
    cdef size_t count = groups.size - 1, bad = SIZE_MAX
    mean = np.empty((count, 4), q.dtype)
    cdef const int64_t* rows = <const int64_t*>data(groups)
    cdef void *x = data(q)
    cdef void *w = data(weights)
    cdef void *out = data(mean)
    cdef int code
    with nogil:
        if single:
            code = qtraj_batch_mean_eigen_f32(count, rows, <float*>x, <float*>w, <float*>out, NULL, NULL, &bad)
        else:
            code = qtraj_batch_mean_eigen(count, rows, <double*>x, <double*>w, <double*>out, NULL, NULL, &bad)
    if code == QTRAJ_E_AMBIGUOUS:
        judge(code, bad, "batch_mean_eigen", "group")
    else:
        judge_series(code, bad)
    return mean


def batch_even_times(key_offsets, times, samples, double period):
    """Offsets and times of so many samples of each series, evenly from its first key to its last, closing ones too."""
    cdef size_t count = whole("count", samples, 0)
    times = flat_times(times)
    cdef cnp.ndarray keys = offsets_of("offsets", key_offsets, len(times))
    if np.any(np.diff(keys) < 0) or keys[0] < 0:
        raise ValueError("offsets decrease, or begin below 0")
    cdef size_t series = keys.size - 1, i
    offsets = np.arange(series + 1, dtype=np.int64) * count
    at = np.empty(int(offsets[-1]))
    cdef const int64_t* rows = <const int64_t*>data(keys)
    cdef const double* t = <const double*>data(times)
    cdef double* out = <double*>data(at)
    cdef double first, last
    cdef int status
    with nogil:
        for i in range(series):
            first = t[rows[i]] if rows[i] < rows[i + 1] else NAN
            last = first + period if period > 0 else t[rows[i + 1] - 1] if rows[i] < rows[i + 1] else NAN
            # NaN where a series is at fault: sampling tells its status
            status = qtraj_even_times(first, last, count, out + i * count)
    return offsets, at
