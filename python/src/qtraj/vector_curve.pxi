# A curve of vectors, such as positions.


cdef tuple vector_ends(object ends, size_t dim):
    """Words of the two ends, and the rows of GIVEN derivatives [2, dim], None where there are none."""
    start, end = pair("ends", ends)
    rates = [end_rate("ends", start, dim), end_rate("ends", end, dim)]
    if rates[0] is None and rates[1] is None:
        return (start, end), None
    return (start, end), np.array([np.zeros(dim) if rate is None else rate for rate in rates])


@cython.final
cdef class VectorCurve:
    """A curve of vectors of any length through keys, such as positions beside a Trajectory.

    Parameters
    ----------
    times : array_like, shape (n,)
        Times of the keys, s, strictly increasing.
    values : array_like, shape (n, dim) or (n,)
        The keys, in any unit; a flat array is one number a key.
    method : str
        ``"cubic"`` (C2), ``"linear"``, ``"hermite"`` (C1), ``"quintic"`` (C2) or ``"step"``.
    first, second : array_like, of values' shape
        First and second derivatives at the keys, a second and a second^2, of HERMITE and QUINTIC.
    ends : str, array_like (dim,), or a pair of such
        CUBIC: ``"natural"``, ``"not_a_knot"``, ``"periodic"``, or the first derivative there.
    extrapolate, longest_gap, period, closure, dtype
        As of Trajectory.

    Examples
    --------
    >>> import qtraj
    >>> path = qtraj.VectorCurve([0, 1, 2], [[0, 0, 0], [1, 1, 0], [2, 0, 0]])
    >>> path(0.5).round(4)
    array([0.5   , 0.6875, 0.    ])
    """

    cdef qtraj_vector_curve* handle
    cdef bint single
    cdef bint flat
    cdef bint raises_before
    cdef bint raises_after
    cdef size_t dim
    cdef double start
    cdef double end
    cdef object given_times
    cdef object given_values
    cdef str word
    cdef dict settings
    cdef object __weakref__

    def __cinit__(self, times, values, method="cubic", *, first=None, second=None, ends=None, extrapolate="error",
                  longest_gap=None, period=None, closure=None, dtype=None):
        cdef Settings settings = Settings(constant("method", _words.VECTOR_METHODS, method))
        settings.set_common(extrapolate, longest_gap, period, closure)
        self.word = method
        self.raises_before, self.raises_after = settings.raises_before, settings.raises_after
        self.given_values = frozen(_arrays.reals("values", values))
        if self.given_values.ndim not in (1, 2):
            raise TypeError(f"values has the shape {self.given_values.shape}, not (n, dim) or (n,)")
        self.flat = self.given_values.ndim == 1
        self.dim = 1 if self.flat else self.given_values.shape[1]
        self.given_times = frozen(_arrays.reals("times", times, np.float64))
        if self.given_times.shape != self.given_values.shape[:1]:
            raise TypeError(f"times has the shape {self.given_times.shape}, values {self.given_values.shape}: one time "
                            "for each key")
        self.single = result_is_single(dtype, self.given_values)
        self.build(settings, first, second, ends)
        self.start, self.end = qtraj_vector_start_time(self.handle), qtraj_vector_end_time(self.handle)
        self.settings = kept_settings(self.single, self.given_values, extrapolate, dict(
            first=first, second=second, ends=ends, longest_gap=longest_gap, period=period, closure=closure))

    def __dealloc__(self):
        qtraj_vector_destroy(self.handle)

    cdef int build(self, Settings settings, object first, object second, object ends) except -1:
        cdef bint single = self.given_values.dtype == np.float32
        cdef size_t bad = SIZE_MAX, count = len(self.given_values), dim = self.dim
        cdef int status
        real = self.given_values.dtype.type
        if first is not None:
            first = self.derivative("first", first, real)
        if second is not None:
            second = self.derivative("second", second, real)
        if ends is not None:
            (start, end), given = vector_ends(ends, dim)
            check(qtraj_options_set_ends(settings.options, end_constant(start), end_constant(end)), SIZE_MAX, "ends")
            if given is not None:
                first = given.astype(real)
        cdef const double* t = <const double*>data(self.given_times)
        cdef void *values = data(self.given_values)
        cdef void *d = data(first)
        cdef void *dd = data(second)
        with nogil:
            if single:
                status = qtraj_vector_create_f32(settings.options, t, <float*>values, <float*>d, <float*>dd, count, dim,
                                                 &self.handle, &bad)
            else:
                status = qtraj_vector_create(settings.options, t, <double*>values, <double*>d, <double*>dd, count, dim,
                                             &self.handle, &bad)
        return check(status, bad, f"VectorCurve by {self.word!r}", "key")

    cdef object derivative(self, str name, object array, object real):
        array = _arrays.reals(name, array, real)
        if array.shape != self.given_values.shape:
            raise TypeError(f"{name} has the shape {array.shape}, not that of values, {self.given_values.shape}")
        return array

    def __call__(self, t, int order=0, *, out=None):
        """Values (order 0), first (1) or second (2) derivatives at times of any shape, s.

        Returns
        -------
        ndarray, shape t.shape + (dim,); t.shape where the keys are a flat array

        Raises
        ------
        qtraj.Error
            TIME_RANGE: outside the keys under "error".
        """
        if order < 0 or order > 2:
            raise ValueError(f"order={order}: 0, 1 or 2")
        cdef cnp.ndarray times = times_of(t)
        results = [None, None, None]
        results[order] = self.result(times, out, "out")
        self.sampled(times, results[0], results[1], results[2])
        return results[order]

    def motion(self, t):
        """Values and both derivatives in one pass: a named tuple of value, first, second.

        Examples
        --------
        >>> import qtraj
        >>> path = qtraj.VectorCurve([0, 2], [[0.0, 0], [2, 4]], "linear")
        >>> path.motion(0.5).first
        array([1., 2.])
        """
        cdef cnp.ndarray times = times_of(t)
        results = [self.result(times, None, "out") for _ in range(3)]
        self.sampled(times, results[0], results[1], results[2])
        return _results.VectorMotion(*results)

    def uniform(self, *, rate=None, step=None, count=None, start=None):
        """Values at even distances, as of Trajectory.uniform(): a named tuple of times (n,) and values (n, dim).

        Examples
        --------
        >>> import qtraj
        >>> path = qtraj.VectorCurve([0, 2], [[0.0, 0], [2, 4]], "linear")
        >>> path.uniform(count=3).values[1]
        array([1., 2.])
        """
        if is_count(rate, step, count, start):
            times = even_times(self.start, self.end, count)
            return _results.Samples(times, self(times))
        cdef size_t samples = 0, bad = SIZE_MAX
        cdef double begin = self.start if start is None else start
        cdef double distance = distance_of(rate, step)
        check(qtraj_vector_uniform_count(self.handle, begin, distance, &samples), SIZE_MAX, "uniform")
        times = begin + np.arange(samples) * distance
        values = self.result(times, None, "out")
        cdef void* rows = data(values)
        cdef int status
        with nogil:
            if self.single:
                status = qtraj_vector_sample_uniform_f32(self.handle, begin, distance, samples, <float*>rows, NULL, NULL,
                                                         &bad)
            else:
                status = qtraj_vector_sample_uniform(self.handle, begin, distance, samples, <double*>rows, NULL, NULL,
                                                     &bad)
        judge(status, bad, "uniform", "sample")
        return _results.Samples(times, values)

    cdef object result(self, cnp.ndarray times, object out, str name):
        if out is None:
            return new_rows(times, 0 if self.flat else self.dim, self.single)
        shape = (<object>times).shape + (() if self.flat else (self.dim,))
        return _arrays.output(name, out, shape, self.dtype)

    cdef int sampled(self, cnp.ndarray times, object value, object first, object second) except -1:
        """Fills the arrays that are not None."""
        cdef size_t count = cnp.PyArray_SIZE(times), bad = SIZE_MAX
        cdef const double* t = <const double*>cnp.PyArray_DATA(times)
        cdef void *v = data(value)
        cdef void *d = data(first)
        cdef void *dd = data(second)
        cdef int status
        with nogil:
            if self.single:
                status = qtraj_vector_sample_f32(self.handle, t, count, <float*>v, <float*>d, <float*>dd, &bad)
            else:
                status = qtraj_vector_sample(self.handle, t, count, <double*>v, <double*>d, <double*>dd, &bad)
        if status != QTRAJ_OK and (self.raises_before or self.raises_after):
            check_range(times, self.start, self.end, self.raises_before, self.raises_after)
        return judge(status, bad, "t", "time")

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
        times = np.empty(qtraj_vector_key_count(self.handle))
        check(qtraj_vector_keys(self.handle, <double*>data(times), NULL))
        return times

    @property
    def keys(self):
        """The keys, of the shape of values, as float64."""
        values = np.empty((len(self), self.dim))
        check(qtraj_vector_keys(self.handle, NULL, <double*>data(values)))
        return values[:, 0] if self.flat else values

    def __len__(self):
        """Number of keys."""
        return qtraj_vector_key_count(self.handle)

    def __repr__(self):
        return (f"<qtraj.VectorCurve {self.word!r} of {len(self)} keys of {self.dim} numbers, {self.start:g} s to "
                f"{self.end:g} s{told(self.settings)}>")

    def __eq__(self, other):
        if not isinstance(other, VectorCurve):
            return NotImplemented
        cdef VectorCurve curve = other
        return (self.word == curve.word and same_settings(self.settings, curve.settings) and same_settings(
            {"times": self.given_times, "values": self.given_values},
            {"times": curve.given_times, "values": curve.given_values}))

    def __hash__(self):
        return hash((self.word, self.given_times.tobytes(), self.given_values.tobytes()))

    def __reduce__(self):
        return rebuilt_vector_curve, (self.given_times, self.given_values, self.word, self.settings)


def rebuilt_vector_curve(times, values, method, settings):
    """A vector curve from what it was made of, for pickle."""
    return VectorCurve(times, values, method, **settings)
