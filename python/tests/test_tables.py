"""Data frames: resample() of pandas and Polars."""

from __future__ import annotations

import numpy as np
import pytest
import qtraj
from orientations import walk

pandas = pytest.importorskip("pandas")
polars = pytest.importorskip("polars")
Q = ("qw", "qx", "qy", "qz")


@pytest.fixture
def recording(rng):
    t = np.cumsum(rng.uniform(0.05, 0.15, 100))
    return {"t": t, **dict(zip(Q, walk(rng, 100).T)), "x": np.sin(t), "y": t, "note": np.arange(100).astype(str)}


KINDS = [pandas.DataFrame, polars.DataFrame]


def values(frame, names):
    return np.stack([frame[name].to_numpy() for name in names], axis=1)


@pytest.mark.parametrize("kind", KINDS)
def test_a_recording_is_resampled_in_its_own_kind(kind, recording):
    frame = kind(recording)
    out = qtraj.resample(frame, rate=50, position=("x", "y"))
    assert type(out) is kind and list(out.columns) == ["t", *Q, "x", "y"]
    curve = qtraj.Trajectory(recording["t"], values(frame, Q))
    times, q = curve.uniform(rate=50)
    np.testing.assert_array_equal(out["t"].to_numpy(), times)
    np.testing.assert_array_equal(values(out, Q), q)
    path = qtraj.VectorCurve(recording["t"], values(frame, ("x", "y")))
    np.testing.assert_array_equal(values(out, ("x", "y")), path(times))
    assert frame.equals(kind(recording))


@pytest.mark.parametrize("kind", KINDS)
@pytest.mark.parametrize(("others", "pick"), [("previous", 4), ("nearest", 5)])
def test_other_columns_are_carried_by_a_rule(kind, others, pick, recording):
    t = recording["t"]
    at = [t[4] + 0.9 * (t[5] - t[4])]
    out = qtraj.resample(kind(recording), at=at, others=others)
    assert list(out.columns) == list(recording) and out["note"].to_list() == [str(pick)]
    assert out["x"].to_list() == [recording["x"][pick]]
    with pytest.raises(ValueError, match="others='mean'"):
        qtraj.resample(kind(recording), at=at, others="mean")


@pytest.mark.parametrize("kind", KINDS)
def test_groups_are_curves_of_their_own_in_the_order_in_which_they_begin(kind, rng):
    names = np.array(["b", "a", "c"])[rng.permutation(np.repeat([0, 1, 2], 20))]
    names[0] = "b"
    t = np.sort(rng.uniform(0, 10, 60))
    q = walk(rng, 60)
    frame = kind({"who": names, "t": t, **dict(zip(Q, q.T))})
    out = qtraj.resample(frame, by="who", step=0.1, method="slerp", rates="body")
    assert list(out.columns) == ["who", "t", *Q, "wx", "wy", "wz"]
    for who in "abc":
        mine, theirs = names == who, out["who"].to_numpy() == who
        curve = qtraj.Trajectory(t[mine], q[mine], "slerp")
        times, samples = curve.uniform(step=0.1)
        np.testing.assert_array_equal(out["t"].to_numpy()[theirs], times)
        np.testing.assert_array_equal(values(out, Q)[theirs], samples)
        np.testing.assert_array_equal(values(out, ("wx", "wy", "wz"))[theirs], curve(times, 1, frame="body"))
    changes = out["who"].to_numpy()
    assert len(list(dict.fromkeys(changes))) == 1 + (changes[1:] != changes[:-1]).sum()


def test_groups_by_several_columns_keep_their_order():
    frame = pandas.DataFrame({"a": [2, 2, 1, 1], "b": ["x", "x", "x", "x"], "t": [0.0, 1, 0, 1], **dict(zip(Q, np.eye(4)[[0, 0, 0, 0]].T))})
    out = qtraj.resample(frame, by=["a", "b"], step=1.0)
    assert out["a"].tolist() == [2, 2, 1, 1]
    polar = qtraj.resample(polars.from_pandas(frame), by=["a", "b"], step=1.0)
    assert polar["a"].to_list() == [2, 2, 1, 1]


@pytest.mark.parametrize("resolution", ["ns", "us", "ms"])
def test_datetimes_are_exact(resolution, rng):
    start = np.datetime64("2026-12-01T12:00:00.123456789", "ns")
    stamps = (start + np.arange(50) * np.timedelta64(10, "ms")).astype(f"datetime64[{resolution}]")
    q = walk(rng, 50)
    for frame in (pandas.DataFrame({"t": stamps, **dict(zip(Q, q.T))}), polars.DataFrame({"t": stamps, **dict(zip(Q, q.T))})):
        out = qtraj.resample(frame, rate=1000)
        times = out["t"].to_numpy()
        assert out["t"].dtype == frame["t"].dtype and len(times) == 491
        np.testing.assert_array_equal(times, stamps[0] + (np.arange(491) * np.timedelta64(1, "ms")))
        curve = qtraj.Trajectory(qtraj.seconds_from_ns(stamps), q)
        np.testing.assert_array_equal(values(out, Q), curve(qtraj.seconds_from_ns(times, stamps[0])))
        again = qtraj.resample(frame, at=times[::10])
        np.testing.assert_array_equal(values(again, Q), values(out, Q)[::10])


def test_a_rate_that_no_nanosecond_divides_does_not_drift(rng):
    stamps = 1403715273262142976 + np.arange(0, 4_000_000_000, 5_000_000)
    frame = pandas.DataFrame({"stamp": stamps, **dict(zip(Q, walk(rng, len(stamps)).T))})
    out = qtraj.resample(frame, "stamp", rate=3, unit="ns")
    np.testing.assert_array_equal(out["stamp"] - stamps[0], [0, 333333333, 666666667, 1000000000, 1333333333, 1666666667,
                                                             2000000000, 2333333333, 2666666667, 3000000000, 3333333333, 3666666667])
    with pytest.raises(TypeError, match="say unit='ns'"):
        qtraj.resample(frame, "stamp", rate=3)


def test_a_pandas_index_of_times_in_a_zone(rng):
    index = pandas.date_range("2026-12-01", periods=20, freq="100ms", tz="Europe/Berlin", name="when")
    frame = pandas.DataFrame(dict(zip(Q, walk(rng, 20).T)), index=index)
    out = qtraj.resample(frame, on=None, rate=20)
    assert out.index.name == "when" and out.index.dtype == index.dtype and out.index[1] - out.index[0] == pandas.Timedelta("50ms")
    assert out.index[0] == index[0] and out.index[-1] == index[-1]


def test_a_polars_column_of_times_in_a_zone(rng):
    when = pandas.date_range("2026-12-01", periods=20, freq="100ms", tz="Europe/Berlin")
    frame = polars.from_pandas(pandas.DataFrame({"when": when, **dict(zip(Q, walk(rng, 20).T))}))
    out = qtraj.resample(frame, "when", rate=20)
    assert out["when"].dtype == frame["when"].dtype and out["when"][0] == frame["when"][0] and out["when"][-1] == frame["when"][-1]
    assert out["when"][1] - out["when"][0] == pandas.Timedelta("50ms")


def test_gaps_and_times_outside_are_nan(recording):
    frame = pandas.DataFrame(recording).drop(index=range(40, 60))
    with np.errstate(invalid="ignore"):
        out = qtraj.resample(frame, rate=20, longest_gap=0.5, position=["x"])
        outside = qtraj.resample(frame, at=[-1.0, 3.0])
    hole = (out["t"] > frame["t"][39]) & (out["t"] < frame["t"][60])
    assert hole.sum() > 10 and out["qw"].isna().equals(hole) and out["x"].isna().equals(hole)
    assert outside["qw"].isna().tolist() == [True, False]


@pytest.mark.parametrize("kind", KINDS)
def test_faults_name_the_row_of_the_frame(kind, recording):
    with pytest.raises(TypeError, match="no column 'qa': there are 't', 'qw'"):
        qtraj.resample(kind(recording), q=("qa", *Q[1:]), rate=1)
    with pytest.raises(TypeError, match="'note' is of type"):
        qtraj.resample(kind(recording), q=("note", *Q[1:]), rate=1)
    with pytest.raises(TypeError, match="one of rate="):
        qtraj.resample(kind(recording))
    with pytest.raises(TypeError, match="of type dict"):
        qtraj.resample(recording, rate=1)
    recording["t"][70] = recording["t"][69]
    with pytest.raises(qtraj.Error, match="row 70") as caught:
        qtraj.resample(kind(recording), rate=1)
    assert (caught.value.name, caught.value.index) == ("TIME_ORDER", 70)
    recording["qx"][33] = np.nan
    with pytest.raises(qtraj.Error) as caught:
        qtraj.resample(kind(recording), rate=1)
    assert (caught.value.name, caught.value.index) == ("NOT_FINITE", 33)
    with pytest.raises(qtraj.Error) as caught:
        qtraj.resample(kind(recording)[:1], rate=1)
    assert caught.value.name == "TOO_FEW"


def test_xyzw_columns(recording):
    frame = pandas.DataFrame(recording)
    one = qtraj.resample(frame, rate=10)
    other = qtraj.resample(frame, q=("qx", "qy", "qz", "qw"), scalar_first=False, rate=10)
    np.testing.assert_array_equal(values(one, Q), values(other, Q))
