# Statuses of the library as Python's exceptions and warnings; new arrays.


cdef object error_of(int status, size_t bad, str about, str unit):
    """The exception for a status; bad is the index at fault, SIZE_MAX for none."""
    text = qtraj_status_text(status).decode()
    index = None if bad == SIZE_MAX else bad
    return error(status, _words.STATUSES.get(status, str(status)), text, index, about, unit)


cdef int check(int status, size_t bad=SIZE_MAX, str about="", str unit="row") except -1:
    """Raises what a status says unless it is OK."""
    if status != QTRAJ_OK:
        raise error_of(status, bad, about, unit)
    return 0


cdef int invalid() except -1:
    """Rows of NaN: np.errstate decides whether that is nothing, a warning or an exception."""
    _ufuncs.sample(0.0)
    return 0


cdef int judge(int status, size_t bad, str about, str unit) except -1:
    """For results that hold NaN where data are at fault: raises for what was refused, else tells by errstate."""
    if status == QTRAJ_OK:
        return 0
    cdef int kind = qtraj_status_class(status)
    if kind == QTRAJ_CLASS_ONE_OF_SEVERAL:
        warnings.warn(AmbiguousWarning(str(error_of(status, bad, about, unit))), stacklevel=1)
    elif kind == QTRAJ_CLASS_DATA:
        invalid()
    else:
        raise error_of(status, bad, about, unit)
    return 0


cdef inline void* data(object array):
    """The numbers of an array, or NULL for None."""
    return NULL if array is None else cnp.PyArray_DATA(<cnp.ndarray>array)


cdef inline object new_array(int axes, cnp.npy_intp* shape, bint single):
    return cnp.PyArray_EMPTY(axes, shape, cnp.NPY_FLOAT if single else cnp.NPY_DOUBLE, 0)


cdef object new_rows(cnp.ndarray times, int width, bint single):
    """An array of times' shape with a last axis of the given length; of none where width is 0."""
    cdef cnp.npy_intp shape[65]
    cdef int axes = cnp.PyArray_NDIM(times), i
    for i in range(axes):
        shape[i] = cnp.PyArray_DIM(times, i)
    shape[axes] = width
    return new_array(axes + 1 if width else axes, shape, single)


cdef cnp.ndarray times_of(object t, str name="t"):
    """Times of any shape as an array of double that the library can read."""
    if type(t) is cnp.ndarray and cnp.PyArray_TYPE(<cnp.ndarray>t) == cnp.NPY_DOUBLE and (
            cnp.PyArray_ISCARRAY_RO(<cnp.ndarray>t)):
        return t
    return _arrays.reals(name, t, np.float64)


cdef size_t whole(str name, object value, size_t least) except? 0:
    """A number of things: whole, and not below the least."""
    number = operator.index(value)
    if number < <object>least or number > 1 << 40:
        raise ValueError(f"{name}={value!r}: a whole number of {least} or more, and no more than memory holds")
    return number


cdef object constant(str name, dict family, object word):
    return _words.number(name, family, word)


cdef int frame_of(object frame) except -1:
    """The constant of a frame, which has no default."""
    if frame is None:
        raise TypeError("frame is missing: 'body' or 'world', the axes that rates are given in")
    return _words.number("frame", _words.FRAMES, frame)
