"""sample_batch(): ragged series as arrays and as Arrow tables."""

from __future__ import annotations

import numpy as np
import pytest
import qtraj
from orientations import walk

pa = pytest.importorskip("pyarrow")


@pytest.fixture
def series(rng):
    """Offsets, times and keys of ten series of 4 to 12 keys, after three rows that belong to none."""
    counts = rng.integers(4, 13, 10)
    offsets = 3 + np.concatenate([[0], np.cumsum(counts)])
    times = np.concatenate([np.zeros(3), *(np.cumsum(rng.uniform(0.1, 0.5, n)) for n in counts)])
    q = np.concatenate([np.zeros((3, 4)), *(walk(rng, n) for n in counts)])
    return offsets, times, q


def curves(series, **settings):
    offsets, times, q = series
    return [qtraj.Trajectory(times[a:b], q[a:b], **settings) for a, b in zip(offsets, offsets[1:])]


@pytest.mark.parametrize("method", ["slerp", "squad", "rotation_spline"])
def test_rows_are_those_of_trajectories(series, method):
    batch = qtraj.sample_batch(series, count=20, method=method, rates="body")
    assert batch.q.shape == (200, 4) and not batch.status.any() and batch.offsets.tolist() == list(range(0, 201, 20))
    for k, curve in enumerate(curves(series, method=method)):
        rows = slice(20 * k, 20 * k + 20)
        times, q = curve.uniform(count=20)
        np.testing.assert_array_equal(batch.times[rows], times)
        motion = curve.motion(times, frame="body")
        np.testing.assert_array_equal(batch.q[rows], motion.q)
        np.testing.assert_array_equal(batch.omega[rows], motion.omega)
        np.testing.assert_array_equal(batch.alpha[rows], motion.alpha)


def test_a_fixed_step_and_times_of_ones_own(series):
    for batch in (qtraj.sample_batch(series, step=0.05), qtraj.sample_batch(series, rate=20)):
        for k, curve in enumerate(curves(series)):
            rows = slice(*batch.offsets[k : k + 2])
            times, q = curve.uniform(step=0.05)
            np.testing.assert_array_equal(batch.times[rows], times)
            np.testing.assert_array_equal(batch.q[rows], q)
    own = qtraj.sample_batch(series, at=(np.arange(11) * 2, np.tile([0.5, 0.6], 10)))
    for k, curve in enumerate(curves(series)):
        np.testing.assert_array_equal(own.q[2 * k : 2 * k + 2], curve([0.5, 0.6]))
    steps = np.linspace(0.05, 0.2, 10)
    many = qtraj.sample_batch(series, step=steps)
    assert len(curves(series)[9].uniform(step=0.2).times) == many.offsets[10] - many.offsets[9]


def test_a_series_at_fault_has_its_status_and_no_other(series):
    offsets, times, q = series
    whole = qtraj.sample_batch(series, count=5)
    q[offsets[2] + 1] = 0
    times[offsets[5] + 2] = times[offsets[5] + 1]
    offsets = np.insert(offsets, 8, offsets[8])  # a series without keys
    with pytest.warns(RuntimeWarning, match="invalid"):
        batch = qtraj.sample_batch((offsets, times, q), count=5)
    names = {k: qtraj.status_name(status) for k, status in enumerate(batch.status) if status}
    assert names == {2: "ZERO_NORM", 5: "TIME_ORDER", 8: "TOO_FEW"}
    good = np.repeat(~np.isin(np.arange(11), [2, 5, 8]), 5)
    assert np.isnan(batch.q[~good]).all()
    np.testing.assert_array_equal(batch.q[good], whole.q[np.repeat(~np.isin(np.arange(10), [2, 5]), 5)])


def test_float32_and_the_order_of_components(series):
    offsets, times, q = series
    batch = qtraj.sample_batch((offsets, times, q.astype(np.float32)), count=7)
    assert batch.q.dtype == np.float32
    np.testing.assert_allclose(batch.q, qtraj.sample_batch(series, count=7).q, atol=1e-6)
    other = qtraj.sample_batch((offsets, times, q[:, [1, 2, 3, 0]]), count=7, scalar_first=False)
    np.testing.assert_array_equal(other.q, qtraj.sample_batch(series, count=7).q)


def test_rates_at_the_keys(series, rng):
    offsets, times, q = series
    omega = rng.normal(size=(len(q), 3))
    batch = qtraj.sample_batch(series, count=9, method="hermite", omega=omega, frame="world", rates="world")
    for k, (a, b) in enumerate(zip(offsets, offsets[1:])):
        curve = qtraj.Trajectory(times[a:b], q[a:b], "hermite", omega=omega[a:b], frame="world")
        np.testing.assert_array_equal(batch.omega[9 * k : 9 * k + 9], curve(curve.uniform(count=9).times, 1, frame="world"))
    with pytest.raises(ValueError, match="one frame for all rates"):
        qtraj.sample_batch(series, count=9, method="hermite", omega=omega, frame="world", rates="body")
    with pytest.raises(TypeError, match="frame is missing"):
        qtraj.sample_batch(series, count=9, method="hermite", omega=omega)


@pytest.mark.parametrize(
    ("change", "error"),
    [
        (lambda o, t, q: (o + 1, t, q), ValueError),
        (lambda o, t, q: (o[::-1], t, q), (qtraj.Error, ValueError)),
        (lambda o, t, q: (-o, t, q), (qtraj.Error, ValueError)),
        (lambda o, t, q: (o + 0.5, t, q), TypeError),
        (lambda o, t, q: ([], t, q), TypeError),
        (lambda o, t, q: (o, t[1:], q), TypeError),
        (lambda o, t, q: (o, t, q.T), TypeError),
        (lambda o, t, q: (o, t), TypeError),
        (lambda o, t, q: 5, TypeError),
    ],
)
@pytest.mark.parametrize("choice", [{"count": 3}, {"step": 0.1}, {"at": (np.arange(11), np.zeros(10))}])
def test_wrong_offsets_and_shapes_are_refused(change, error, choice, series):
    with pytest.raises(error):
        qtraj.sample_batch(change(*series), **choice)


def test_wrong_choices_are_refused(series):
    for choice in ({}, {"count": 3, "step": 1}):
        with pytest.raises(TypeError, match="one of count="):
            qtraj.sample_batch(series, **choice)
    with pytest.raises(TypeError, match="10 series"):
        qtraj.sample_batch(series, at=(np.arange(9), np.zeros(8)))
    with pytest.raises(ValueError, match="ends at row 10"):
        qtraj.sample_batch(series, at=(np.arange(11), np.zeros(7)))
    with pytest.raises(TypeError, match="step has the shape"):
        qtraj.sample_batch(series, step=[0.1, 0.2])
    with pytest.raises(qtraj.Error, match="needs omega"):
        qtraj.sample_batch(series, count=3, method="hermite")


def table(series, flat):
    offsets, times, q = series
    lists = pa.array((offsets - offsets[0]).astype(np.int32))
    t = pa.ListArray.from_arrays(lists, pa.array(times[offsets[0] :]))
    values = pa.array(q[offsets[0] :].reshape(-1))
    if flat:
        rows = pa.ListArray.from_arrays(pa.array(((offsets - offsets[0]) * 4).astype(np.int32)), values)
    else:
        rows = pa.ListArray.from_arrays(lists, pa.FixedSizeListArray.from_arrays(values, 4))
    return pa.table({"id": np.arange(10), "t": t, "q": rows})


@pytest.mark.parametrize("flat", [False, True])
def test_a_table_of_arrow_keeps_its_layout(flat, series):
    frame = table(series, flat)
    out = qtraj.sample_batch(frame, count=5, rates="world")
    assert out.schema.names == ["id", "t", "q", "omega", "alpha", "status"] and out.schema.field("q").type == frame.schema.field("q").type
    batch = qtraj.sample_batch(series, count=5, rates="world")
    np.testing.assert_array_equal(np.array(out["q"].to_pylist()).reshape(-1, 4), batch.q)
    np.testing.assert_array_equal(np.array(out["omega"].to_pylist()).reshape(-1, 3), batch.omega)
    np.testing.assert_array_equal(np.array(out["t"].to_pylist()).reshape(-1), batch.times)
    part = qtraj.sample_batch(frame.slice(3, 4), count=5)
    assert part["q"].to_pylist() == out["q"].to_pylist()[3:7]
    (one,) = frame.slice(2, 6).to_batches()
    assert isinstance(qtraj.sample_batch(one, count=5), pa.RecordBatch)
    assert qtraj.sample_batch(one, count=5)["q"].to_pylist() == out["q"].to_pylist()[2:8]
    chunks = pa.concat_tables([frame.slice(0, 3), frame.slice(3)])
    assert qtraj.sample_batch(chunks, count=5)["q"].to_pylist() == out["q"].to_pylist()
    assert qtraj.sample_batch(frame.slice(0, 0), count=5).num_rows == 0
    large = frame.set_column(1, "t", frame["t"].cast(pa.large_list(pa.float64())))
    assert qtraj.sample_batch(large, count=5)["q"].to_pylist() == out["q"].to_pylist()


def test_missing_lists_stay_missing_and_missing_numbers_are_faults(series):
    frame = table(series, flat=True)
    q = frame["q"].to_pylist()
    t = frame["t"].to_pylist()
    t[4] = q[4] = None
    q[6][5] = None
    frame = pa.table({"t": pa.array(t, pa.list_(pa.float64())), "q": pa.array(q, pa.list_(pa.float64()))})
    with np.errstate(invalid="ignore"):
        out = qtraj.sample_batch(frame, count=2)
    assert out["q"][4].as_py() is None and out["t"][4].as_py() is None
    assert qtraj.status_name(out["status"][6].as_py()) == "NOT_FINITE" and np.isnan(out["q"][6].as_py()).all()


def test_wrong_tables_are_refused_by_name(series):
    frame = table(series, flat=True)
    with pytest.raises(TypeError, match="no column 'time': there are 'id', 't', 'q'"):
        qtraj.sample_batch(frame, times="time", count=2)
    with pytest.raises(TypeError, match="column 'id' is of type int64: lists"):
        qtraj.sample_batch(frame, times="id", count=2)
    short = frame.set_column(1, "t", pa.array([[0.0, 1.0]] * 10))
    with pytest.raises(ValueError, match="row 0: 2 times in 't'"):
        qtraj.sample_batch(short, count=2)
    with pytest.raises(ValueError, match="no multiple of 4"):
        qtraj.sample_batch(frame.set_column(2, "q", frame["t"]).set_column(1, "t", frame["t"]), count=2)


def test_other_tables_come_in_by_the_arrow_stream(series):
    polars = pytest.importorskip("polars")
    frame = table(series, flat=True)
    out = qtraj.sample_batch(polars.from_arrow(frame), count=3)
    np.testing.assert_array_equal(np.array(out["q"].to_pylist()), np.array(qtraj.sample_batch(frame, count=3)["q"].to_pylist()))
