"""The programs of examples/engines, on 1e5 trajectories: all give what a plain call gives."""

from __future__ import annotations

import shutil
import subprocess
import sys
import time

import numpy as np
import pytest
import qtraj
from conftest import SOURCE
from orientations import orientations

pa = pytest.importorskip("pyarrow")
pq = pytest.importorskip("pyarrow.parquet")
ENGINES = SOURCE / "examples" / "engines"
SERIES = 100_000


@pytest.fixture(scope="module")
def keys(tmp_path_factory):
    """A file of trajectories of 4 to 12 keys."""
    rng = np.random.default_rng(7)
    counts = rng.integers(4, 13, SERIES)
    offsets = np.concatenate([[0], np.cumsum(counts)])
    steps = np.cumsum(rng.uniform(0.05, 0.5, offsets[-1]))
    times = steps - np.repeat(steps[offsets[:-1]], counts)
    q = np.repeat(orientations(rng, SERIES), counts, axis=0) + rng.normal(0, 0.12, (offsets[-1], 4))
    lists = pa.ListArray.from_arrays(pa.array(offsets.astype(np.int32)), pa.array(times))
    flat = pa.ListArray.from_arrays(pa.array((offsets * 4).astype(np.int32)), pa.array(q.reshape(-1)))
    path = tmp_path_factory.mktemp("keys") / "keys.parquet"
    pq.write_table(pa.table({"id": np.arange(SERIES), "t": lists, "q": flat}), path, row_group_size=25_000)
    return path


@pytest.fixture(scope="module")
def expected(keys):
    return qtraj.sample_batch(pq.read_table(keys), count=20)


def compare(engine, keys, target, expected, capsys):
    start = time.perf_counter()
    run = subprocess.run([sys.executable, str(ENGINES / f"with_{engine}.py"), str(keys), str(target)], capture_output=True, text=True, cwd=target.parent)
    seconds = time.perf_counter() - start
    assert run.returncode == 0, run.stderr[-3000:]
    found = pq.read_table(target).sort_by("id")
    assert found.schema.names == ["id", "t", "q", "status"] and found.num_rows == SERIES
    for name in ("t", "q"):
        ours = found[name].combine_chunks().flatten().to_numpy()
        np.testing.assert_array_equal(ours, expected[name].combine_chunks().flatten().to_numpy())
    assert not found["status"].to_numpy().any()
    with capsys.disabled():
        print(f"\n  {engine}: {SERIES / seconds:.0f} trajectories a second, start and files included", end="")


@pytest.mark.long
@pytest.mark.parametrize("engine", ["polars", "duckdb", "dask"])
def test_engines_on_one_machine(engine, keys, expected, tmp_path, capsys):
    pytest.importorskip({"dask": "distributed"}.get(engine, engine))
    compare(engine, keys, tmp_path / "out.parquet", expected, capsys)


@pytest.mark.long
def test_spark(keys, expected, tmp_path, capsys):
    if shutil.which("java") is None:
        pytest.skip("no JDK here")
    pytest.importorskip("pyspark")
    compare("spark", keys, tmp_path / "out.parquet", expected, capsys)
