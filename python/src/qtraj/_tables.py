"""Recordings in data frames, resampled: pandas and Polars."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np

from . import _core
from ._batch import sample_batch

# What a whole number of a time column counts, s.
UNITS = {"ns": 1, "us": 10**3, "ms": 10**6, "s": 10**9}


def resample(
    frame: Any,
    on: str | None = "t",
    q: Sequence[str] = ("qw", "qx", "qy", "qz"),
    *,
    position: Sequence[str] | None = None,
    by: str | Sequence[str] | None = None,
    rate: float | None = None,
    step: float | None = None,
    at: Any = None,
    method: str = "rotation_spline",
    position_method: str = "cubic",
    rates: str | None = None,
    others: str = "drop",
    unit: str | None = None,
    scalar_first: bool = True,
    extrapolate: Any = "nan",
    longest_gap: float | None = None,
) -> Any:
    """Resamples a recording in a data frame: orientations, positions beside them, other columns by a rule.

    Parameters
    ----------
    frame : pandas.DataFrame or polars.DataFrame
        A row for each key, in the order of time; groups may be mixed.
    on : str or None
        Column of times: seconds, datetimes, or whole numbers of a unit. None: the index of a pandas frame.
    q : four names
        Columns of the quaternion ``w x y z``; with ``scalar_first=False``, ``x y z w``.
    position : names, optional
        Columns that go along by ``position_method``, as of VectorCurve: "cubic", "linear" or "step".
    by : name or names, optional
        Columns that tell groups apart: a curve for each, in the order in which they begin.
    rate, step, at
        One of the three: samples a second; s from one to the next; or the times themselves, of the type of the column.
        From the first key of each group on, up to its last.
    method, extrapolate, longest_gap
        As of Trajectory; a time without data is NaN.
    rates : {"body", "world"}, optional
        Adds columns wx, wy, wz of the angular velocity, rad/s, in this frame.
    others : {"drop", "previous", "nearest"}
        What becomes of all other columns: they are left out, or taken from the row before or nearest in time.
    unit : {"ns", "us", "ms", "s"}
        What whole numbers of the time column count.

    Returns
    -------
    A frame of the same kind; its times have the type of the column. Datetimes and whole numbers are exact: samples are at
    whole nanoseconds.

    Raises
    ------
    qtraj.Error
        Keys at fault, with the row of the frame.

    Examples
    --------
    >>> import pandas, qtraj
    >>> frame = pandas.DataFrame({"t": [0.0, 1.0], "qw": [1, .6], "qx": [0, 0], "qy": [0, 0], "qz": [0, .8]})
    >>> qtraj.resample(frame, step=0.5, method="slerp").round(3) + 0
         t     qw   qx   qy     qz
    0  0.0  1.000  0.0  0.0  0.000
    1  0.5  0.894  0.0  0.0  0.447
    2  1.0  0.600  0.0  0.0  0.800
    """
    if sum(choice is not None for choice in (rate, step, at)) != 1:
        raise TypeError("one of rate=, step= and at= is needed")
    if others not in ("drop", "previous", "nearest"):
        raise ValueError(f"others={others!r}: one of 'drop', 'previous', 'nearest'")
    table = Table(frame)
    if len(q) != 4:
        raise TypeError(f"q names {len(q)} columns: four are needed")
    groups = [by] if isinstance(by, str) else list(by or ())
    clock = Clock(table.times(on), unit, "the index" if on is None else repr(on))

    order, offsets = grouped(table, groups)
    seconds = clock.seconds[order]
    keys = _core.rows_from_columns([table.numbers(name)[order] for name in q])
    find_faults(seconds, keys, offsets, order)
    sample_offsets, samples = sample_times(clock, offsets, seconds, order, rate, step, at)
    batch = sample_batch(
        (offsets, seconds, keys), at=(sample_offsets, samples.seconds), method=method, rates=rates,
        scalar_first=scalar_first, extrapolate=extrapolate, longest_gap=longest_gap,
    )  # fmt: skip
    raise_first(batch.status, offsets, order)

    columns = dict(zip(q, _core.columns_from_rows(in_order(batch.q, scalar_first)), strict=True))
    if position:
        values = _core.rows_from_columns([table.numbers(name)[order] for name in position])
        sampled = sample_positions(
            offsets, seconds, values, sample_offsets, samples.seconds, position_method, longest_gap, extrapolate
        )
        columns.update(zip(position, _core.columns_from_rows(sampled), strict=True))
    if rates is not None:
        columns.update(zip(("wx", "wy", "wz"), _core.columns_from_rows(batch.omega), strict=True))
    rows = order[source_rows(offsets, seconds, sample_offsets, samples.seconds, others)]
    kept = [name for name in table.names if name in groups or name in columns or name == on or others != "drop"]
    return table.built(kept, rows, on, samples.stamps, columns)


class Clock:
    """The times of a column: seconds for the library, whole nanoseconds where the column has such."""

    def __init__(self, stamps: Any, unit: str | None, name: str) -> None:
        self.type = stamps.dtype
        self.scale = 1
        if stamps.dtype.kind == "M":
            if np.isnat(stamps).any():
                raise TypeError(f"column {name} has no time in row {int(np.isnat(stamps).argmax())}")
            self.ns = stamps.astype("datetime64[ns]").view(np.int64)
            self.scale = int(np.ones(1, stamps.dtype.str.replace("M8", "m8")).astype("timedelta64[ns]").view(np.int64)[0])
        elif stamps.dtype.kind in "iu":
            if unit not in UNITS:
                raise TypeError(f"column {name} holds whole numbers: say unit='ns', 'us', 'ms' or 's'")
            self.scale = UNITS[unit]
            self.ns = np.multiply(stamps, self.scale, dtype=np.int64)
        elif stamps.dtype.kind == "f":
            self.ns = None
            self.seconds = stamps.astype(np.float64)
            return
        else:
            raise TypeError(f"column {name} is of type {stamps.dtype}: seconds, datetimes or whole numbers are needed")
        self.origin = int(self.ns[0]) if len(self.ns) else 0
        self.seconds = _core.seconds_from_ns(self.ns, self.origin)

    def stamps_of(self, ns: np.ndarray) -> np.ndarray:
        """Whole nanoseconds as the column has its times."""
        if self.type.kind == "M":
            return ns.view("datetime64[ns]").astype(self.type)
        return (ns // self.scale).astype(self.type)


class Samples:
    """Times of samples: seconds, and stamps of the type of the column."""

    def __init__(self, seconds: np.ndarray, stamps: np.ndarray) -> None:
        self.seconds = seconds
        self.stamps = stamps


def sample_times(
    clock: Clock, offsets: np.ndarray, seconds: np.ndarray, order: np.ndarray, rate: Any, step: Any, at: Any
) -> tuple[np.ndarray, Samples]:
    """Offsets and times of the samples of all groups."""
    series = len(offsets) - 1
    if at is not None:
        at = np.asarray(at)
        stamps = np.tile(at.astype(clock.type), series)
        if clock.ns is None:
            samples = Samples(stamps.astype(np.float64), stamps)
        else:
            whole = stamps.astype("datetime64[ns]").view(np.int64) if clock.type.kind == "M" else stamps * clock.scale
            samples = Samples(_core.seconds_from_ns(whole, clock.origin), stamps)
        return np.arange(series + 1) * len(at), samples
    if not (step if step is not None else rate) > 0:
        raise ValueError(f"rate={rate!r}, step={step!r}: above 0")
    distance = step if step is not None else 1.0 / rate
    if clock.ns is None:
        sample_offsets, times = _core.batch_steps(offsets, seconds, distance)
        return sample_offsets, Samples(times, times.astype(clock.type))
    # whole nanoseconds: each sample is rounded by itself, so that a rate of 3 a second does not drift
    ns = clock.ns[order]
    unit = clock.scale
    if not distance > 0 or distance * 1e9 < unit:
        raise ValueError(f"a sample each {distance!r} s: times of this column are whole numbers of {unit} ns")
    parts = []
    for first, last in zip(ns[offsets[:-1]], ns[offsets[1:] - 1], strict=True):
        count = int((last - first) / (distance * 1e9) + 1e-9) + 1
        # by double: exact to a nanosecond for 50 days
        steps = np.rint(np.arange(count) * (distance * 1e9 / unit)).astype(np.int64) * unit
        parts.append(np.minimum(first + steps, last))
    sample_offsets = np.concatenate([[0], np.cumsum([len(part) for part in parts])]).astype(np.int64)
    all_ns = np.concatenate(parts) if parts else np.zeros(0, np.int64)
    return sample_offsets, Samples(_core.seconds_from_ns(all_ns, clock.origin), clock.stamps_of(all_ns))


def grouped(table: Table, by: list[str]) -> tuple[np.ndarray, np.ndarray]:
    """Rows in the order of groups, each in its own order, and where groups begin."""
    count = table.height
    if not by:
        return np.arange(count), np.array([0, count])
    codes = table.codes(by)
    order = np.argsort(codes, kind="stable")
    starts = np.flatnonzero(np.diff(codes[order], prepend=-1))
    return order, np.append(starts, count)


def find_faults(seconds: np.ndarray, keys: np.ndarray, offsets: np.ndarray, order: np.ndarray) -> None:
    """The exception for the first key at fault, by its row in the frame."""
    from ._errors import error

    bad = ~np.isfinite(seconds) | ~np.isfinite(keys).all(axis=1)
    zero = ~bad & (keys == 0).all(axis=1)
    late = np.zeros(len(seconds), bool)
    late[1:] = seconds[1:] <= seconds[:-1]
    late[offsets[:-1][offsets[:-1] < len(late)]] = False
    for fault, status, name in ((bad, 21, "NOT_FINITE"), (zero, 22, "ZERO_NORM"), (late, 23, "TIME_ORDER")):
        if fault.any():
            row = int(order[fault.argmax()])
            raise error(status, name, _core.status_text(status), row, "resample")


def raise_first(status: np.ndarray, offsets: np.ndarray, order: np.ndarray) -> None:
    """The exception for a group whose keys make no curve: its first row."""
    from ._errors import error

    # samples without data are rows of NaN, no exception
    faulty = (status != 0) & ~np.isin(status, (21, 24, 26))
    if faulty.any():
        group = int(faulty.argmax())
        code = int(status[group])
        row = int(order[offsets[group]]) if len(order) else None
        raise error(code, _core.status_name(code), _core.status_text(code), row, "resample, the group that begins there")


def sample_positions(
    offsets: np.ndarray, seconds: np.ndarray, values: np.ndarray, sample_offsets: np.ndarray, samples: np.ndarray,
    method: Any, longest_gap: float | None, extrapolate: Any,
) -> np.ndarray:  # fmt: skip
    """Positions of all groups, a curve for each."""
    out = np.empty((len(samples), values.shape[1]), values.dtype)
    for k in range(len(offsets) - 1):
        rows, to = slice(offsets[k], offsets[k + 1]), slice(sample_offsets[k], sample_offsets[k + 1])
        curve = _core.VectorCurve(
            seconds[rows], values[rows], method, longest_gap=longest_gap, extrapolate=extrapolate, dtype=values.dtype
        )
        with np.errstate(invalid="ignore"):  # told by the orientations
            curve(samples[to], out=out[to])
    return out


def in_order(q: np.ndarray, scalar_first: bool) -> np.ndarray:
    return q if scalar_first else np.roll(q, -1, axis=1)


def source_rows(
    offsets: np.ndarray, seconds: np.ndarray, sample_offsets: np.ndarray, samples: np.ndarray, others: str
) -> np.ndarray:
    """For each sample the row, in the order of groups, that other columns come from."""
    rows = np.empty(len(samples), np.int64)
    for k in range(len(offsets) - 1):
        t = seconds[offsets[k] : offsets[k + 1]]
        at = samples[sample_offsets[k] : sample_offsets[k + 1]]
        before = np.clip(np.searchsorted(t, at, "right") - 1, 0, len(t) - 1)
        if others == "nearest":
            after = np.minimum(before + 1, len(t) - 1)
            before = np.where(np.abs(t[after] - at) < np.abs(at - t[before]), after, before)
        rows[sample_offsets[k] : sample_offsets[k + 1]] = offsets[k] + before
    return rows


class Table:
    """What pandas and Polars have in common."""

    def __init__(self, frame: Any) -> None:
        self.frame = frame
        self.kind = type(frame).__module__.partition(".")[0]
        if self.kind not in ("pandas", "polars") or not hasattr(frame, "columns"):
            raise TypeError(f"frame is of type {type(frame).__name__}: a DataFrame of pandas or Polars is needed")
        if self.kind == "polars" and not hasattr(frame, "height"):
            raise TypeError("frame is lazy: pass frame.collect(), or map_batches of it")
        self.names = list(frame.columns)
        self.height = len(frame)

    def column(self, name: str) -> Any:
        if name not in self.names:
            raise TypeError(f"no column {name!r}: there are {', '.join(map(repr, self.names))}")
        return self.frame[name]

    def times(self, on: str | None) -> np.ndarray:
        if on is not None:
            column = self.column(on)
        elif self.kind == "pandas":
            column = self.frame.index
        else:
            raise TypeError("on=None is the index of a pandas frame; Polars has none")
        if getattr(column.dtype, "tz", None) is not None:
            column = column.dt.tz_convert(None) if hasattr(column, "dt") else column.tz_convert(None)
        return np.asarray(column.to_numpy())

    def numbers(self, name: str) -> np.ndarray:
        column = self.column(name)
        array = column.to_numpy()
        if array.dtype.kind not in "fiu":
            raise TypeError(f"column {name!r} is of type {column.dtype}: numbers are needed")
        return array if array.dtype == np.float32 else array.astype(np.float64)

    def codes(self, names: list[str]) -> np.ndarray:
        """A number for each row's group, in the order in which groups begin."""
        for name in names:
            self.column(name)
        if self.kind == "pandas":
            return self.frame.groupby(names, sort=False, dropna=False).ngroup().to_numpy()
        import polars

        ranks = self.frame.select(polars.struct(names).rank("dense")).to_series().to_numpy()
        _, first, code = np.unique(ranks, return_index=True, return_inverse=True)
        return np.argsort(np.argsort(first))[code]

    def built(self, kept: list[str], rows: np.ndarray, on: str | None, stamps: np.ndarray, columns: dict) -> Any:
        """The frame of the results: rows taken from the old one, then times and sampled columns."""
        if self.kind == "pandas":
            frame = self.frame[kept].iloc[rows].reset_index(drop=True)
            if on is None:
                frame.index = type(self.frame.index)(self.localized(stamps, self.frame.index.dtype), name=self.frame.index.name)
            else:
                frame[on] = self.localized(stamps, self.frame[on].dtype)
            for name, values in columns.items():
                frame[name] = values
            return frame
        import polars

        frame = self.frame.select(kept)[rows]
        series = [polars.Series(on, stamps).cast(self.frame[on].dtype)] if on is not None else []
        return frame.with_columns(*series, *(polars.Series(name, values) for name, values in columns.items()))

    @staticmethod
    def localized(stamps: np.ndarray, dtype: Any) -> Any:
        """Stamps as pandas has them, in the time zone of the column."""
        import pandas  # type: ignore[import-untyped]

        if getattr(dtype, "tz", None) is None:
            return stamps
        return pandas.DatetimeIndex(stamps).tz_localize("UTC").tz_convert(dtype.tz)
