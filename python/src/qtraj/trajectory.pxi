# A curve of orientations.


cdef object frozen(object array):
    """A copy of an array that nobody writes to."""
    if array is None:
        return None
    copy = np.array(array, order="C")
    copy.flags.writeable = False
    return copy


cdef bint same_settings(dict a, dict b):
    """Whether two sets of arguments are equal, arrays bit by bit."""
    if a.keys() != b.keys():
        return False
    for name, one in a.items():
        other = b[name]
        if isinstance(one, np.ndarray) and isinstance(other, np.ndarray):
            if one.dtype != other.dtype or one.shape != other.shape or one.tobytes() != other.tobytes():
                return False
        elif isinstance(one, np.ndarray) or isinstance(other, np.ndarray) or not same_value(one, other):
            return False
    return True


cdef bint same_value(object a, object b):
    if isinstance(a, tuple) and isinstance(b, tuple):
        return same_settings(dict(enumerate(a)), dict(enumerate(b)))
    return type(a) is type(b) and a == b


cdef object frozen_setting(str name, object value):
    """A setting that was passed, kept so that the constructor takes it again: pairs as pairs, arrays as copies."""
    if name in ("ends", "extrapolate") and isinstance(value, (tuple, list)) and len(value) == 2:
        return tuple([frozen_setting("", part) for part in value])
    if name == "tangents" and isinstance(value, tuple) and len(value) == 2:
        return tuple([frozen_setting("", part) for part in value])
    if value is None or isinstance(value, str):
        return value
    if isinstance(value, (int, float)):
        return float(value)
    if hasattr(value, "as_quat"):
        value = _arrays.quaternions(name, value)
    array = np.asarray(value)
    return frozen(array if array.dtype.kind in "iu" else _arrays.reals(name, value))


cdef bint result_is_single(object dtype, object keys) except -1:
    """Whether samples are float32: as asked for, or else as the keys are."""
    if dtype is None:
        return keys.dtype == np.float32
    if np.dtype(dtype) not in (np.float32, np.float64):
        raise TypeError(f"dtype={dtype!r}: float32 or float64")
    return np.dtype(dtype) == np.float32


cdef dict kept_settings(bint single, object keys, object extrapolate, dict arguments):
    """What a curve was made with beside its keys, as its constructor takes it again."""
    settings = {name: frozen_setting(name, value) for name, value in arguments.items() if value is not None}
    if extrapolate != "error":
        settings["extrapolate"] = frozen_setting("extrapolate", extrapolate)
    if single != (keys.dtype == np.float32):
        settings["dtype"] = "float32" if single else "float64"
    return settings


cdef str told_setting(object value):
    """A setting as it is passed, arrays by their shape."""
    if isinstance(value, np.ndarray):
        return f"array{value.shape}"
    if isinstance(value, tuple):
        return f"({', '.join([told_setting(part) for part in value])})"
    return repr(value)


cdef str told(dict settings):
    return "".join([f", {name}={told_setting(value)}" for name, value in settings.items()])


cdef int check_range(cnp.ndarray t, double start, double end, bint before, bint after) except -1:
    """Raises for the first time that lies outside the keys where that is an error."""
    late = np.asarray((t < start) & before | (t > end) & after).ravel()
    if late.any():
        index = int(late.argmax())
        raise error(QTRAJ_E_TIME_RANGE, "TIME_RANGE", f"time {t.ravel()[index]!s} is outside the keys, "
                    f"{start!r} to {end!r}", index, "t")
    return 0


cdef bint is_count(object rate, object step, object count, object start) except -1:
    """Whether uniform samples go by their number, not by a distance."""
    if (rate is not None) + (step is not None) + (count is not None) != 1:
        raise TypeError("one of rate=, step= and count= is needed")
    if count is not None and start is not None:
        raise TypeError("start= belongs to rate= or step=; count= goes from the first key to the last")
    return count is not None


cdef double distance_of(object rate, object step) except? -1:
    """The distance of samples, s."""
    if rate is None:
        return step
    if not rate > 0:
        raise ValueError(f"rate={rate!r}: samples a second, above 0")
    return 1.0 / rate


cdef tuple tangent_arrays(object tangents, object real, size_t count):
    """Tangents before and after each key; the second is None where one array serves both, both are for a word."""
    if tangents is None or isinstance(tangents, str):
        return None, None
    if isinstance(tangents, tuple) and len(tangents) == 2:
        return (_arrays.rows("tangents[0]", tangents[0], 4, real, (count,)),
                _arrays.rows("tangents[1]", tangents[1], 4, real, (count,)))
    return _arrays.rows("tangents", tangents, 4, real, (count,)), None


@cython.final
cdef class Trajectory:
    """A smooth curve of orientations through keyframes.

    Parameters
    ----------
    times : array_like, shape (n,)
        Times of the keys, s, strictly increasing.
    q : array_like, shape (n, 4), or scipy.spatial.transform.Rotation
        Orientations at these times, body to world, ``w x y z``, of any norm but 0 and any sign.
    method : str
        ``"rotation_spline"`` (C2, the first to try), ``"slerp"``, ``"nlerp"``, ``"squad"``, ``"log_spline"``,
        ``"hermite"``, ``"rotation_quintic"``, ``"quaternion_quintic"``, ``"quaternion_hermite"`` or ``"step"``.
    scalar_first : bool
        Whether q is ``w x y z``; False for ``x y z w``. Results are always ``w x y z``.
    omega, alpha : array_like, shape (n, 3)
        Angular velocities, rad/s, and accelerations, rad/s^2, at the keys, for methods that take them.
    frame : {"body", "world"}
        Axes of omega, alpha and of rates in ends.
    ends : str, array_like of three, or a pair of such
        What determines the curve at its first and last key: ``"chord"``, ``"natural"``, ``"not_a_knot"``,
        ``"estimated"``, ``"periodic"``, or a rate in rad/s.
    tangents : str or array_like, shape (n, 4), or a pair of such arrays
        SQUAD: ``"catmull_rom"``, ``"mean_velocity"``, ``"rest"`` (no overshoot) or ``"given"`` (by omega).
        QUATERNION_HERMITE: dq/dt at the keys, 1/s, ``w x y z``; a pair is before and after each key.
    reference : str or array_like, shape (4,)
        LOG_SPLINE: ``"first"``, ``"mean"`` or an orientation.
    turns : str or array_like of int, shape (n - 1,)
        How far steps turn: ``"shortest"``, ``"as_given"``, ``"from_rates"``, or whole turns beside the shorter one.
    extrapolate : str or a pair of such
        Before the first and after the last key: ``"error"``, ``"nan"``, ``"hold"``, ``"constant_rate"``,
        ``"periodic"``.
    longest_gap : float
        Times inside longer intervals, s, are NaN.
    period : float
        The first key is repeated after this time, s: closes the curve.
    closure : float
        By how much, rad, the last key of a closed curve may differ from the first; 1e-6 unless given.
    dtype : float32 or float64
        Of samples; that of q unless given, and float64 for what is neither.

    Raises
    ------
    qtraj.Error
        With the index of the key at fault.
    TypeError
        Arrays of a wrong type or shape.

    Warns
    -----
    qtraj.NormWarning
        Norms are off by more than 0.01.

    Examples
    --------
    >>> import qtraj
    >>> curve = qtraj.Trajectory([0, 2], [[1, 0, 0, 0], [0.6, 0, 0, 0.8]])
    >>> curve(1.0).round(3)
    array([0.894, 0.   , 0.   , 0.447])
    >>> curve([0.5, 1.0], 1, frame="body").round(4)
    array([[0.    , 0.    , 0.9273],
           [0.    , 0.    , 0.9273]])
    """

    cdef qtraj_trajectory* handle
    cdef bint single
    cdef bint raises_before
    cdef bint raises_after
    cdef double start
    cdef double end
    cdef object given_times
    cdef object given_q
    cdef str word
    cdef dict settings
    cdef object __weakref__

    def __cinit__(self, times, q, method="rotation_spline", *, scalar_first=True, omega=None, alpha=None, frame=None,
                  ends=None, tangents=None, reference=None, turns=None, extrapolate="error", longest_gap=None,
                  period=None, closure=None, dtype=None):
        cdef Settings settings = Settings(constant("method", _words.METHODS, method))
        if frame is not None:
            frame_of(frame)
        settings.set_common(extrapolate, longest_gap, period, closure)
        settings.set_ends(ends, frame)
        settings.set_reference(reference)
        self.word = method
        self.raises_before, self.raises_after = settings.raises_before, settings.raises_after
        self.given_q = frozen(_arrays.quaternions("q", q, None, None, scalar_first))
        if self.given_q.ndim != 2:
            raise TypeError(f"q has the shape {self.given_q.shape}, not (n, 4)")
        count = len(self.given_q)
        self.given_times = frozen(_arrays.reals("times", times, np.float64))
        if self.given_times.shape != (count,):
            raise TypeError(f"times has the shape {self.given_times.shape}, q {self.given_q.shape}: one time for each key")
        self.single = result_is_single(dtype, self.given_q)
        self.build(settings, omega, alpha, frame, tangents, turns)
        self.start, self.end = qtraj_start_time(self.handle), qtraj_end_time(self.handle)
        self.settings = kept_settings(self.single, self.given_q, extrapolate, dict(
            omega=omega, alpha=alpha, frame=frame, ends=ends, tangents=tangents, reference=reference, turns=turns,
            longest_gap=longest_gap, period=period, closure=closure))
        self.look_at_norms()

    def __dealloc__(self):
        qtraj_destroy(self.handle)

    cdef int build(self, Settings settings, object omega, object alpha, object frame, object tangents,
                   object turns) except -1:
        """Calls the constructor that takes what was passed."""
        cdef bint single = self.given_q.dtype == np.float32
        cdef size_t bad = SIZE_MAX, count = len(self.given_q)
        cdef const double* t = <const double*>data(self.given_times)
        cdef void* keys = data(self.given_q)
        cdef int status
        cdef int in_frame = 0 if omega is None and alpha is None else frame_of(frame)
        cdef qtraj_options* options = settings.options
        real = self.given_q.dtype.type
        if omega is not None:
            omega = _arrays.rows("omega", omega, 3, real, (count,))
        if alpha is not None:
            alpha = _arrays.rows("alpha", alpha, 3, real, (count,))
        before, after = tangent_arrays(tangents, real, count)
        if before is None and tangents is not None:
            check(qtraj_options_set_tangents(options, constant("tangents", _words.TANGENTS, tangents)), SIZE_MAX,
                  "tangents")
        turns = self.set_turns(settings, turns)
        cdef void *w = data(omega)
        cdef void *a = data(alpha)
        cdef void *p = data(before)
        cdef void *r = data(after)
        cdef int32_t* n = <int32_t*>data(turns)
        with nogil:
            if p and single:
                status = qtraj_create_with_tangents_f32(options, t, <float*>keys, <float*>p, <float*>r, count,
                                                        &self.handle, &bad)
            elif p:
                status = qtraj_create_with_tangents(options, t, <double*>keys, <double*>p, <double*>r, count,
                                                    &self.handle, &bad)
            elif n and single:
                status = qtraj_create_with_turns_f32(options, in_frame, t, <float*>keys, <float*>w, <float*>a, n,
                                                     count, &self.handle, &bad)
            elif n:
                status = qtraj_create_with_turns(options, in_frame, t, <double*>keys, <double*>w, <double*>a, n,
                                                 count, &self.handle, &bad)
            elif single and (w or a):
                status = qtraj_create_with_rates_f32(options, in_frame, t, <float*>keys, <float*>w, <float*>a, count,
                                                     &self.handle, &bad)
            elif w or a:
                status = qtraj_create_with_rates(options, in_frame, t, <double*>keys, <double*>w, <double*>a, count,
                                                 &self.handle, &bad)
            elif single:
                status = qtraj_create_with_options_f32(options, t, <float*>keys, count, &self.handle, &bad)
            else:
                status = qtraj_create_with_options(options, t, <double*>keys, count, &self.handle, &bad)
        return check(status, bad, f"Trajectory by {self.word!r}", "key")

    cdef object set_turns(self, Settings settings, object turns):
        """Sets the rule of turns by word; numbers of turns come back as an array."""
        if turns is None:
            return None
        numbers = None
        if not isinstance(turns, str):
            numbers = np.asarray(turns)
            if numbers.dtype.kind not in "iu" or numbers.ndim != 1:
                raise TypeError(f"turns is of type {numbers.dtype} and shape {numbers.shape}: whole numbers are needed, "
                                "one for each step")
            steps = len(self.given_q) - (0 if settings.has_period else 1)
            if len(numbers) != steps:
                raise TypeError(f"turns has {len(numbers)} elements; the curve has {steps} steps")
            if np.any(np.abs(numbers.astype(np.float64)) > 2147483647):
                raise TypeError("turns are more than 32 bits hold")
            numbers, turns = np.ascontiguousarray(numbers, np.int32), "given"
        check(qtraj_options_set_turns(settings.options, constant("turns", _words.TURNS, turns)), SIZE_MAX, "turns")
        return numbers

    cdef int look_at_norms(self) except -1:
        """Warns where keys are hardly quaternions."""
        cdef double off = qtraj_worst_norm_error(self.handle)
        if off > 0.01:
            key = int(np.argmax(np.abs(np.linalg.norm(self.given_q.astype(np.float64), axis=1) - 1)))
            warnings.warn(NormWarning(
                f"norms of q are off 1 by up to {off:.2g} (key {key}): are these rows w x y z? A transposed array, "
                "columns shifted by one or another type look like that; x y z w keeps the norm, pass scalar_first=False"
            ), stacklevel=1)
        return 0

    # ---- Samples ----

    def __call__(self, t, int order=0, *, frame=None, out=None):
        """Orientations, or their rates, at times.

        Parameters
        ----------
        t : array_like
            Times of any shape, s.
        order : {0, 1, 2}
            0: orientations; 1: angular velocities, rad/s; 2: angular accelerations, rad/s^2.
        frame : {"body", "world"}
            Axes of rates, which have no default.
        out : ndarray
            Receives the result: exactly of its shape and type, contiguous.

        Returns
        -------
        ndarray, shape t.shape + (4,) or t.shape + (3,)
            Rows ``w x y z`` or x y z. A time that is not finite, in a gap, or outside the keys under "nan" has NaN, and
            ``np.errstate`` decides what becomes of it.

        Raises
        ------
        qtraj.Error
            TIME_RANGE: outside the keys under "error", with the index in t, counted row by row.
        """
        cdef cnp.npy_intp four = 4
        cdef object q
        if order == 0 and out is None and PyFloat_Check(t):
            q = new_array(1, &four, self.single)
            if self.one(PyFloat_AsDouble(t), cnp.PyArray_DATA(<cnp.ndarray>q)) == QTRAJ_OK:
                return q
        cdef cnp.ndarray times = times_of(t)
        if order == 0:
            return self.sampled(times, 0, self.result(times, 4, out, "out"), None, None)[0]
        if order == 1:
            return self.sampled(times, frame_of(frame), None, self.result(times, 3, out, "out"), None)[1]
        if order == 2:
            return self.sampled(times, frame_of(frame), None, None, self.result(times, 3, out, "out"))[2]
        raise ValueError(f"order={order}: 0, 1 or 2")

    def motion(self, t, *, frame, out=(None, None, None)):
        """Orientations, angular velocities and angular accelerations in one pass.

        Parameters
        ----------
        t : array_like
            Times of any shape, s.
        frame : {"body", "world"}
            Axes of omega and alpha.
        out : tuple of three ndarrays or None
            Receive the results.

        Returns
        -------
        Motion
            A named tuple of q (..., 4), omega (..., 3), rad/s, and alpha (..., 3), rad/s^2.

        Examples
        --------
        >>> import qtraj
        >>> curve = qtraj.Trajectory([0, 2], [[1, 0, 0, 0], [0.6, 0, 0, 0.8]], "slerp")
        >>> curve.motion(1.0, frame="body").omega.round(4)
        array([0.    , 0.    , 0.9273])
        """
        cdef cnp.ndarray times = times_of(t)
        q, omega, alpha = out
        return _results.Motion(*self.sampled(
            times, frame_of(frame), self.result(times, 4, q, "out[0]"), self.result(times, 3, omega, "out[1]"),
            self.result(times, 3, alpha, "out[2]")))

    def rotation(self, t):
        """Samples as a ``scipy.spatial.transform.Rotation``: of one time or of a list of times.

        Examples
        --------
        >>> import qtraj
        >>> curve = qtraj.Trajectory([0, 2], [[1, 0, 0, 0], [0.6, 0, 0, 0.8]], "slerp")
        >>> round(float(curve.rotation(1.0).magnitude()), 4)
        0.9273
        """
        from scipy.spatial.transform import Rotation
        return Rotation.from_quat(np.roll(self(t), -1, axis=-1))

    def uniform(self, *, rate=None, step=None, count=None, start=None):
        """Samples at even distances from the first key to the last.

        Parameters
        ----------
        rate, step, count : float, float, int
            One of the three: samples a second; s from one to the next; how many, the last exactly at the last key.
        start : float
            Time of the first sample, s; that of the first key unless given. With rate or step.

        Returns
        -------
        Samples
            A named tuple of times (n,) and values (n, 4), ``w x y z``.

        Examples
        --------
        >>> import qtraj
        >>> curve = qtraj.Trajectory([0, 2], [[1, 0, 0, 0], [0.6, 0, 0, 0.8]], "slerp")
        >>> curve.uniform(rate=2).times
        array([0. , 0.5, 1. , 1.5, 2. ])
        """
        if is_count(rate, step, count, start):
            times = even_times(self.start, self.end, count)
            return _results.Samples(times, self(times))
        cdef size_t samples = 0, bad = SIZE_MAX
        cdef double first = self.start if start is None else start
        cdef double distance = distance_of(rate, step)
        check(qtraj_uniform_count(self.handle, first, distance, &samples), SIZE_MAX, "uniform")
        times = first + np.arange(samples) * distance
        cdef cnp.ndarray q = new_rows(times, 4, self.single)
        cdef void* rows = data(q)
        cdef int status
        with nogil:
            if self.single:
                status = qtraj_sample_uniform_f32(self.handle, first, distance, samples, <float*>rows, &bad)
            else:
                status = qtraj_sample_uniform(self.handle, first, distance, samples, <double*>rows, &bad)
        judge(status, bad, "uniform", "sample")
        return _results.Samples(times, q)

    def unnormalized(self, t):
        """The curve in R^4 that is normalised, and its derivatives, of NLERP, QUATERNION_QUINTIC, QUATERNION_HERMITE.

        Returns
        -------
        Unnormalized
            A named tuple of p, dp, ddp, each of shape t.shape + (4,), float64; 1, 1/s, 1/s^2.

        Examples
        --------
        >>> import qtraj
        >>> curve = qtraj.Trajectory([0, 2], [[1, 0, 0, 0], [0.6, 0, 0, 0.8]], "slerp")
        >>> qtraj.Trajectory([0, 2], [[1, 0, 0, 0], [0, 0, 0, 1]], "nlerp").unnormalized(1.0).p.round(4)
        array([0.5, 0. , 0. , 0.5])
        """
        cdef cnp.ndarray times = times_of(t)
        cdef size_t bad = SIZE_MAX
        p, dp, ddp = (new_rows(times, 4, False) for _ in range(3))
        cdef int status = qtraj_sample_unnormalized(
            self.handle, <double*>data(times), times.size, <double*>data(p), <double*>data(dp), <double*>data(ddp), &bad)
        self.judge(status, bad, times)
        return _results.Unnormalized(p, dp, ddp)

    cdef int one(self, double time, void* q) noexcept:
        if self.single:
            return qtraj_sample_at_f32(self.handle, time, NULL, <float*>q)
        return qtraj_sample_at(self.handle, time, NULL, <double*>q)

    cdef object result(self, cnp.ndarray times, int width, object out, str name):
        """The array of a result: that of the caller, or a new one."""
        if out is None:
            return new_rows(times, width, self.single)
        shape = (<object>times).shape + (width,)
        return _arrays.output(name, out, shape, np.dtype(np.float32 if self.single else np.float64))

    cdef tuple sampled(self, cnp.ndarray times, int frame, object q, object omega, object alpha):
        """Fills the arrays that are not None."""
        cdef size_t count = cnp.PyArray_SIZE(times), bad = SIZE_MAX
        cdef const double* t = <const double*>cnp.PyArray_DATA(times)
        cdef void *q_out = data(q)
        cdef void *w_out = data(omega)
        cdef void *a_out = data(alpha)
        cdef int status
        if count > MANY:
            with nogil:
                status = self.fill(frame, t, count, q_out, w_out, a_out, &bad)
        else:
            status = self.fill(frame, t, count, q_out, w_out, a_out, &bad)
        if status != QTRAJ_OK:
            self.judge(status, bad, times)
        return q, omega, alpha

    cdef int fill(self, int frame, const double* t, size_t count, void* q, void* w, void* a,
                  size_t* bad) noexcept nogil:
        if frame == 0 and self.single:
            return qtraj_sample_f32(self.handle, t, count, <float*>q, bad)
        if frame == 0:
            return qtraj_sample(self.handle, t, count, <double*>q, bad)
        if self.single:
            return qtraj_sample_rates_f32(self.handle, frame, t, count, <float*>q, <float*>w, <float*>a, bad)
        return qtraj_sample_rates(self.handle, frame, t, count, <double*>q, <double*>w, <double*>a, bad)

    cdef int judge(self, int status, size_t bad, cnp.ndarray times) except -1:
        """Times outside the keys are an exception where they are to be one, other faults are told by errstate."""
        if status == QTRAJ_OK:
            return 0
        if self.raises_before or self.raises_after:
            check_range(times, self.start, self.end, self.raises_before, self.raises_after)
        return judge(status, bad, "t", "time")

    # ---- What it is ----

    @property
    def method(self):
        """The method, as it was passed."""
        return self.word

    @property
    def dtype(self):
        """Type of samples, float32 or float64."""
        return np.dtype(np.float32 if self.single else np.float64)

    @property
    def span(self):
        """Times of the first and the last key, s."""
        return self.start, self.end

    @property
    def times(self):
        """Times of the keys, s; with a period there is one more than was passed."""
        times = np.empty(qtraj_key_count(self.handle))
        check(qtraj_keys(self.handle, <double*>data(times), NULL))
        return times

    @property
    def keys(self):
        """The keys as the curve uses them, (n, 4): normalised, of the signs that samples have there."""
        q = np.empty((qtraj_key_count(self.handle), 4))
        check(qtraj_keys(self.handle, NULL, <double*>data(q)))
        return q

    def segment_times(self, per_segment):
        """Times in every segment, evenly spaced, both ends included and knots once: for plots of rates that jump.

        Examples
        --------
        >>> import qtraj
        >>> curve = qtraj.Trajectory([0, 2], [[1, 0, 0, 0], [0.6, 0, 0, 0.8]], "slerp")
        >>> curve.segment_times(3)
        array([0., 1., 2.])
        """
        cdef size_t each = whole("per_segment", per_segment, 2)
        times = np.empty((len(self) - 1) * (each - 1) + 1)
        check(qtraj_segment_times(self.handle, each, <double*>data(times)))
        return times

    def __len__(self):
        """Number of keys."""
        return qtraj_key_count(self.handle)

    def __repr__(self):
        return (f"<qtraj.Trajectory {self.word!r} of {len(self)} keys, {self.start:g} s to {self.end:g} s"
                f"{told(self.settings)}>")

    def __eq__(self, other):
        if not isinstance(other, Trajectory):
            return NotImplemented
        cdef Trajectory curve = other
        return (self.word == curve.word and same_settings(self.settings, curve.settings) and same_settings(
            {"times": self.given_times, "q": self.given_q}, {"times": curve.given_times, "q": curve.given_q}))

    def __hash__(self):
        return hash((self.word, self.given_times.tobytes(), self.given_q.tobytes()))

    def __reduce__(self):
        return rebuilt_trajectory, (self.given_times, self.given_q, self.word, self.settings)

    # ---- Diagnostics of the curve ----

    @property
    def diagnostics(self):
        """What construction found: a named tuple.

        sign_flips, keys whose sign was changed; worst_norm_error, | |q| - 1 | of the keys as passed; least_dot of
        neighbours; iterations and residual of a ROTATION_SPLINE; least_norm and least_norm_time, s, of curves that are
        normalised.
        """
        cdef double norm = 0, time = 0
        check(qtraj_curve_least_norm(self.handle, &norm, &time))
        return _results.Diagnostics(
            qtraj_sign_flips(self.handle), qtraj_worst_norm_error(self.handle), qtraj_least_dot(self.handle),
            qtraj_iterations(self.handle), qtraj_residual(self.handle), norm, time)

    def jumps(self, *, frame):
        """By how much rates jump at each key: a named tuple of omega (n, 3), rad/s, and alpha (n, 3), rad/s^2.

        Examples
        --------
        >>> import qtraj
        >>> curve = qtraj.Trajectory([0, 2], [[1, 0, 0, 0], [0.6, 0, 0, 0.8]], "slerp")
        >>> curve.jumps(frame="body").omega.shape
        (2, 3)
        """
        count = qtraj_key_count(self.handle)
        omega, alpha = np.empty((count, 3)), np.empty((count, 3))
        judge(qtraj_curve_jumps(self.handle, frame_of(frame), <double*>data(omega), <double*>data(alpha)), SIZE_MAX,
              "jumps", "key")
        return _results.Jumps(omega, alpha)

    def peak_rates(self):
        """Greatest lengths of the rates, and when: a named tuple of omega, rad/s, omega_time, alpha, alpha_time.

        Examples
        --------
        >>> import qtraj
        >>> curve = qtraj.Trajectory([0, 2], [[1, 0, 0, 0], [0.6, 0, 0, 0.8]], "slerp")
        >>> round(curve.peak_rates().omega, 4)
        0.9273
        """
        cdef double omega = 0, omega_time = 0, alpha = 0, alpha_time = 0
        cdef int status
        with nogil:
            status = qtraj_curve_peak_rates(self.handle, &omega, &omega_time, &alpha, &alpha_time)
        check(status, SIZE_MAX, "peak_rates")
        return _results.PeakRates(omega, omega_time, alpha, alpha_time)

    def rate_bounds(self):
        """Bounds never below the true peaks and within 1e-6 of them: a named tuple of omega, rad/s, alpha, rad/s^2.

        Examples
        --------
        >>> import qtraj
        >>> curve = qtraj.Trajectory([0, 2], [[1, 0, 0, 0], [0.6, 0, 0, 0.8]], "slerp")
        >>> curve.rate_bounds().omega >= curve.peak_rates().omega
        True
        """
        cdef double omega = 0, alpha = 0
        cdef int status
        with nogil:
            status = qtraj_rate_bounds(self.handle, &omega, &alpha)
        check(status, SIZE_MAX, "rate_bounds")
        return _results.RateBounds(omega, alpha)

    def rate_mismatch(self):
        """Largest angle, rad, between a step and what the rates at its ends make of it, and the index of the step.

        Half a radian or more says that the rates passed are not what they are taken for: degrees for radians, world for
        body, a wrong sign.

        Examples
        --------
        >>> import qtraj
        >>> curve = qtraj.Trajectory([0, 2], [[1, 0, 0, 0], [0.6, 0, 0, 0.8]], "slerp")
        >>> curve.rate_mismatch().angle < 1e-12
        True
        """
        cdef double angle = 0
        cdef size_t step = 0
        check(qtraj_rate_mismatch(self.handle, &angle, &step), SIZE_MAX, "rate_mismatch")
        return _results.RateMismatch(angle, step)

    def energy(self):
        """Integral of the square of the angular acceleration over the curve, rad^2/s^3.

        Examples
        --------
        >>> import qtraj
        >>> curve = qtraj.Trajectory([0, 2], [[1, 0, 0, 0], [0.6, 0, 0, 0.8]], "slerp")
        >>> curve.energy() < 1e-12
        True
        """
        cdef double energy = 0
        cdef int status
        with nogil:
            status = qtraj_curve_energy(self.handle, &energy)
        check(status, SIZE_MAX, "energy")
        return energy

    def total_angle(self):
        """Integral of the angular speed over the curve, rad: by how much the body turns in all.

        Examples
        --------
        >>> import qtraj
        >>> curve = qtraj.Trajectory([0, 2], [[1, 0, 0, 0], [0.6, 0, 0, 0.8]], "slerp")
        >>> round(curve.total_angle(), 4)
        1.8546
        """
        cdef double angle = 0
        cdef int status
        with nogil:
            status = qtraj_curve_total_angle(self.handle, &angle)
        check(status, SIZE_MAX, "total_angle")
        return angle


def rebuilt_trajectory(times, q, method, settings):
    """A trajectory from what it was made of, for pickle."""
    return Trajectory(times, q, method, **settings)
