# The options of a method, from words.


cdef tuple pair(str name, object value):
    """Two settings, for the first and the last key: a pair is one of each, anything else both."""
    if isinstance(value, (tuple, list)) and len(value) == 2:
        return tuple(value)
    return value, value


cdef object end_rate(str name, object end, int width):
    """The rate of an end that is given by numbers, None for a word."""
    if end is None or isinstance(end, str):
        return None
    return _arrays.rows(name, end, width, np.float64, ())


cdef int end_constant(object end) except -1:
    """The constant of an end: a word, a rate, or None for the default."""
    if end is None:
        end = "default"
    return constant("ends", _words.ENDS, end if isinstance(end, str) else "given")


@cython.final
cdef class Settings:
    """Options of a method, in memory of their own."""

    cdef double memory[64]  # QTRAJ_OPTIONS_BYTES
    cdef qtraj_options* options
    cdef int method
    cdef bint raises_before
    cdef bint raises_after
    cdef bint has_period

    def __cinit__(self, int method):
        self.method = method
        self.raises_before = self.raises_after = self.has_period = False
        check(qtraj_options_init(self.memory, sizeof(self.memory), method, &self.options))

    cdef int set_common(self, object extrapolate, object longest_gap, object period, object closure) except -1:
        """What every method has."""
        before, after = pair("extrapolate", extrapolate)
        self.raises_before, self.raises_after = before == "error", after == "error"
        check(qtraj_options_set_extrapolation(
            self.options, constant("extrapolate", _words.EXTRAPOLATIONS, before),
            constant("extrapolate", _words.EXTRAPOLATIONS, after)), SIZE_MAX, "extrapolate")
        if longest_gap is not None:
            check(qtraj_options_set_longest_gap(self.options, longest_gap), SIZE_MAX, "longest_gap")
        if period is not None:
            check(qtraj_options_set_period(self.options, period), SIZE_MAX, "period")
            self.has_period = period != 0
        if closure is not None:
            check(qtraj_options_set_closure(self.options, closure), SIZE_MAX, "closure")
        return 0

    cdef int set_ends(self, object ends, object frame) except -1:
        """Ends by word, or GIVEN by a rate of three numbers in a frame."""
        if ends is None:
            return 0
        start, end = pair("ends", ends)
        rates = [end_rate("ends", start, 3), end_rate("ends", end, 3)]
        if (isinstance(start, str) and start == "given") or (isinstance(end, str) and end == "given"):
            raise ValueError("ends='given': pass the rate itself, three numbers in rad/s, in the place of the word")
        check(qtraj_options_set_ends(self.options, end_constant(start), end_constant(end)), SIZE_MAX, "ends")
        if rates[0] is not None or rates[1] is not None:
            check(qtraj_options_set_end_rates(self.options, frame_of(frame), <double*>data(rates[0]),
                                              <double*>data(rates[1])), SIZE_MAX, "ends")
        return 0

    cdef int set_reference(self, object reference) except -1:
        """The reference of a LOG_SPLINE, by word or as a quaternion."""
        if reference is None:
            return 0
        q = None
        if not isinstance(reference, str):
            q, reference = _arrays.quaternions("reference", reference, np.float64, ()), "given"
        check(qtraj_options_set_reference(self.options, constant("reference", _words.REFERENCES, reference),
                                          <double*>data(q)), SIZE_MAX, "reference")
        return 0
