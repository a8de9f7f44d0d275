# Orientations and positions together, and many trajectories at shared times.


@cython.final
cdef class Poses:
    """A Trajectory and a VectorCurve of three numbers, sampled together.

    Parameters
    ----------
    trajectory : Trajectory
    positions : VectorCurve
        Of any dimension; float32 together with a trajectory of float32.

    Examples
    --------
    >>> import qtraj
    >>> turn = qtraj.Trajectory([0, 2], [[1, 0, 0, 0], [0.6, 0, 0, 0.8]])
    >>> way = qtraj.VectorCurve([0, 2], [[0, 0, 0], [4, 0, 0]], "linear")
    >>> qtraj.Poses(turn, way)(0.5).position
    array([1., 0., 0.])
    """

    cdef Trajectory turning
    cdef VectorCurve moving

    def __cinit__(self, Trajectory trajectory not None, VectorCurve positions not None):
        if trajectory.single != positions.single:
            raise TypeError(f"trajectory samples {trajectory.dtype}, positions {positions.dtype}: pass dtype= to one of them")
        self.turning, self.moving = trajectory, positions

    def __call__(self, t):
        """Poses at times of any shape, s: a named tuple of q (..., 4) and position (..., dim).

        A time that one of the two has no value for is NaN in both; outside the keys of one, "error" raises.
        """
        cdef cnp.ndarray times = times_of(t)
        q, position = new_rows(times, 4, self.turning.single), self.moving.result(times, None, "position")
        self.sampled(times, _words.FRAMES["body"], (q, None, None, position, None, None))
        return _results.Pose(q, position)

    def motion(self, t, *, frame):
        """Poses and their rates in one pass: a named tuple of q, omega, alpha, position, velocity, acceleration.

        omega, rad/s, and alpha, rad/s^2, in the frame; velocity and acceleration in that of the positions.

        Examples
        --------
        >>> import qtraj
        >>> turn = qtraj.Trajectory([0, 2], [[1, 0, 0, 0], [0.6, 0, 0, 0.8]])
        >>> way = qtraj.VectorCurve([0, 2], [[0, 0, 0], [4, 0, 0]], "linear")
        >>> qtraj.Poses(turn, way).motion(0.5, frame="body").velocity
        array([2., 0., 0.])
        """
        cdef cnp.ndarray times = times_of(t)
        cdef bint single = self.turning.single
        results = (new_rows(times, 4, single), new_rows(times, 3, single), new_rows(times, 3, single),
                   *(self.moving.result(times, None, "out") for _ in range(3)))
        self.sampled(times, frame_of(frame), results)
        return _results.PoseMotion(*results)

    cdef int sampled(self, cnp.ndarray times, int frame, tuple results) except -1:
        cdef size_t count = cnp.PyArray_SIZE(times), bad = SIZE_MAX
        cdef const double* t = <const double*>cnp.PyArray_DATA(times)
        cdef qtraj_trajectory* turning = self.turning.handle
        cdef qtraj_vector_curve* moving = self.moving.handle
        cdef void* out[6]
        cdef int i, status
        for i in range(6):
            out[i] = data(results[i])
        with nogil:
            if self.turning.single:
                status = qtraj_sample_poses_f32(
                    turning, moving, frame, t, count, <float*>out[0], <float*>out[1], <float*>out[2], <float*>out[3],
                    <float*>out[4], <float*>out[5], &bad)
            else:
                status = qtraj_sample_poses(
                    turning, moving, frame, t, count, <double*>out[0], <double*>out[1], <double*>out[2],
                    <double*>out[3], <double*>out[4], <double*>out[5], &bad)
        if status != QTRAJ_OK:
            check_range(times, self.turning.start, self.turning.end, self.turning.raises_before,
                        self.turning.raises_after)
            check_range(times, self.moving.start, self.moving.end, self.moving.raises_before, self.moving.raises_after)
        return judge(status, bad, "t", "time")

    @property
    def trajectory(self):
        """The curve of orientations."""
        return self.turning

    @property
    def positions(self):
        """The curve of positions."""
        return self.moving

    @property
    def span(self):
        """Times between which both curves have keys, s."""
        return max(self.turning.start, self.moving.start), min(self.turning.end, self.moving.end)

    def __repr__(self):
        return f"<qtraj.Poses of {self.turning!r} and {self.moving!r}>"

    def __eq__(self, other):
        if not isinstance(other, Poses):
            return NotImplemented
        return self.trajectory == other.trajectory and self.positions == other.positions

    def __hash__(self):
        return hash((self.turning, self.moving))

    def __reduce__(self):
        return Poses, (self.turning, self.moving)


def sample_many(trajectories, t, *, rates=None, layout="series_first"):
    """Samples many trajectories at shared times: a rig of twenty joints at one time is one call.

    Parameters
    ----------
    trajectories : sequence of Trajectory
        All of float64, or all of float32.
    t : array_like
        Times of any shape, s.
    rates : {"body", "world"}, optional
        Frame of rates, where they are wanted.
    layout : {"series_first", "time_first"}
        Whether trajectories are the first axis of results, or the last but one.

    Returns
    -------
    ndarray, shape (series,) + t.shape + (4,) or t.shape + (series, 4)
        Orientations ``w x y z``; with rates a Motion of q, omega, alpha.

    Examples
    --------
    >>> import qtraj
    >>> curve = qtraj.Trajectory([0, 2], [[1, 0, 0, 0], [0.6, 0, 0, 0.8]])
    >>> qtraj.sample_many([curve, curve], [0.0, 1.0, 2.0]).shape
    (2, 3, 4)
    """
    cdef cnp.ndarray times = times_of(t)
    curves = list(trajectories)
    for curve in curves:
        if not isinstance(curve, Trajectory):
            raise TypeError(f"trajectories has an element of type {type(curve).__name__}")
    cdef bint single = bool(curves) and (<Trajectory>curves[0]).single
    if any((<Trajectory>curve).single != single for curve in curves):
        raise TypeError("trajectories of float32 and of float64: make them alike by dtype=")
    cdef int order = constant("layout", _words.LAYOUTS, layout)
    cdef int frame = _words.FRAMES["body"] if rates is None else frame_of(rates)
    shape = (<object>times).shape
    shape = (len(curves), *shape) if layout == "series_first" else (*shape, len(curves))
    real = np.float32 if single else np.float64
    results = (np.empty((*shape, 4), real),
               *(None if rates is None else np.empty((*shape, 3), real) for _ in range(2)))
    handles = np.array([<size_t>(<Trajectory>curve).handle for curve in curves], np.uintp)
    cdef const qtraj_trajectory* const* series = <const qtraj_trajectory* const*>data(handles)
    cdef size_t n = len(curves), count = cnp.PyArray_SIZE(times), bad = SIZE_MAX
    cdef const double* at = <const double*>cnp.PyArray_DATA(times)
    cdef void *q = data(results[0])
    cdef void *w = data(results[1])
    cdef void *a = data(results[2])
    cdef int status
    with nogil:
        if single:
            status = qtraj_sample_many_f32(series, n, frame, at, count, order, <float*>q, <float*>w, <float*>a, &bad)
        else:
            status = qtraj_sample_many(series, n, frame, at, count, order, <double*>q, <double*>w, <double*>a, &bad)
    if status != QTRAJ_OK:
        for curve in curves:
            check_range(times, (<Trajectory>curve).start, (<Trajectory>curve).end, (<Trajectory>curve).raises_before,
                        (<Trajectory>curve).raises_after)
    judge(status, bad, "t", "row")
    return results[0] if rates is None else _results.Motion(*results)
