"""Many trajectories in one call: series of keys one after the other, by offsets, or tables of Arrow."""

from __future__ import annotations

from typing import Any

import numpy as np

from . import _core
from ._arrays import quaternions, reals
from ._results import Batch
from ._words import FRAMES, number


def sample_batch(
    keys: Any,
    *,
    times: str = "t",
    q: str = "q",
    count: int | None = None,
    rate: Any = None,
    step: Any = None,
    at: tuple[Any, Any] | None = None,
    method: str = "rotation_spline",
    rates: str | None = None,
    scalar_first: bool = True,
    omega: Any = None,
    alpha: Any = None,
    frame: str | None = None,
    ends: Any = None,
    tangents: str | None = None,
    reference: Any = None,
    turns: str | None = None,
    extrapolate: Any = "nan",
    longest_gap: float | None = None,
    period: float | None = None,
    closure: float | None = None,
) -> Any:
    """Samples many curves, each through a series of keys, in one call of the library.

    Parameters
    ----------
    keys : tuple, or an object with ``__arrow_c_stream__``
        ``(offsets, times, q)``: offsets (series + 1,), the row of the first key of each series and, last, of the end of
        the last; times (n,), s; q (n, 4). Or a table of Arrow, Polars, DuckDB, ...: a row for each series, whose lists
        of times and of quaternions (lists of 4, or one flat list) are named by times= and q=.
    times, q : str
        Columns of a table.
    count, rate, step, at
        One of the four: so many samples of each series, evenly from its first key to its last; samples a second, or s
        from one to the next, one for all or one for each series; or ``(offsets, times)`` of the samples.
    rates : {"body", "world"}, optional
        Frame of angular velocities and accelerations, where they are wanted.
    omega, alpha : array_like, shape (n, 3)
        Rates at the keys, of methods that take them.
    method, scalar_first, frame, ends, tangents, reference, turns, longest_gap, period, closure
        As of Trajectory, for all series.
    extrapolate : str or pair
        As of Trajectory, "nan" unless given; times outside are NaN under "error", too.

    Returns
    -------
    Batch, or a table of Arrow
        Of arrays: a named tuple of q (m, 4), omega and alpha (m, 3) or None, status (series,), offsets (series + 1,) and
        times (m,). Of a table: its other columns, with lists of times and quaternions in the place of those of the keys,
        ``status``, and lists ``omega`` and ``alpha`` with rates. A RecordBatch gives a RecordBatch, anything else a
        Table, one batch a time.
        A series at fault has NaN and its status; all others are right. ``np.errstate`` decides what else happens.

    Raises
    ------
    qtraj.Error
        Settings or inputs that do not fit the method; nothing is sampled.

    Examples
    --------
    >>> import qtraj
    >>> batch = qtraj.sample_batch(([0, 2, 4], [0, 1, 0, 2], [[1, 0, 0, 0], [.6, 0, 0, .8]] * 2), count=3, method="slerp")
    >>> batch.times
    array([0. , 0.5, 1. , 0. , 1. , 2. ])
    >>> batch.q[1].round(3)
    array([0.894, 0.   , 0.   , 0.447])
    """
    if sum(choice is not None for choice in (count, rate, step, at)) != 1:
        raise TypeError("one of count=, rate=, step= and at= is needed")
    arguments = dict(
        count=count, rate=rate, step=step, at=at, method=method, rates=rates, scalar_first=scalar_first, omega=omega,
        alpha=alpha, frame=frame, ends=ends, tangents=tangents, reference=reference, turns=turns,
        extrapolate=extrapolate, longest_gap=longest_gap, period=period, closure=closure,
    )  # fmt: skip
    if hasattr(keys, "__arrow_c_stream__") or hasattr(keys, "__arrow_c_array__"):
        from . import _arrow

        return _arrow.sample_table(keys, times, q, arguments)
    try:
        offsets, key_times, key_q = keys
    except (TypeError, ValueError):
        raise TypeError(
            f"keys is of type {type(keys).__name__}: (offsets, times, q), or a table with __arrow_c_stream__, is needed"
        ) from None
    return sample_series(offsets, key_times, key_q, **arguments)


def sample_series(
    offsets: Any, times: Any, q: Any, *, count: Any, rate: Any, step: Any, at: Any, method: str, rates: Any,
    scalar_first: bool, omega: Any, alpha: Any, frame: Any, ends: Any, tangents: Any, reference: Any, turns: Any,
    extrapolate: Any, longest_gap: Any, period: Any, closure: Any,
) -> Batch:  # fmt: skip
    """sample_batch() of arrays."""
    q = quaternions("q", q, scalar_first=scalar_first)
    if q.ndim != 2:
        raise TypeError(f"q has the shape {q.shape}, not (n, 4)")
    times = reals("times", times, np.float64)
    if times.shape != (len(q),):
        raise TypeError(f"times has the shape {times.shape}, q {q.shape}: one time for each key")
    settings = _core.batch_settings(
        method, frame, ends, tangents, reference, turns, extrapolate, longest_gap, period, closure
    )
    if at is not None:
        sample_offsets, sample_times = at
    elif count is not None:
        sample_offsets, sample_times = _core.batch_even_times(offsets, times, count, period or 0.0)
    else:
        with np.errstate(divide="ignore"):  # a rate of 0 is an infinite step: a fault of its series
            distance = step if step is not None else 1.0 / np.asarray(rate, np.float64)
        sample_offsets, sample_times = _core.batch_steps(offsets, times, distance)
    # rates that come and rates that go are in one frame
    if rates is not None and frame is not None and rates != frame:
        raise ValueError(f"rates={rates!r} and frame={frame!r}: one frame for all rates of a batch")
    word = rates if rates is not None else frame
    number_of_frame = FRAMES["body"] if word is None else number("frame", FRAMES, word)
    if (omega is not None or alpha is not None) and frame is None:
        raise TypeError("frame is missing: 'body' or 'world', the axes of omega and alpha")
    results = _core.batch_sample(
        settings, number_of_frame, offsets, times, q, omega, alpha, sample_offsets, sample_times, rates is not None
    )
    return Batch(*results, np.asarray(sample_offsets, np.int64), np.asarray(sample_times, np.float64))
