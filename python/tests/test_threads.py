"""Threads: the GIL is released, and curves give the same bits to all of them."""

from __future__ import annotations

import threading
import time
from concurrent.futures import ThreadPoolExecutor

import numpy as np
import pytest
import qtraj
from orientations import orientations, walk


def test_eight_threads_on_one_curve_give_the_same_bits(rng):
    curve = qtraj.Trajectory(np.arange(100.0), walk(rng, 100))
    times = [rng.uniform(0, 99, n) for n in (1, 10, 1000, 20000)]
    expected = [curve.motion(t, frame="body") for t in times]

    def work(seed):
        order = np.random.default_rng(seed).integers(0, 4, 40)
        return all(
            np.array_equal(one, other)
            for k in order
            for one, other in zip(curve.motion(times[k], frame="body"), expected[k], strict=True)
        )

    with ThreadPoolExecutor(8) as pool:
        assert all(pool.map(work, range(8)))


def test_ambiguous_rows_warn_in_their_own_thread_only():
    def work(ambiguous):
        import warnings

        b = [-1, 0, 0, 0] if ambiguous else [0, 1, 0, 0]
        seen = []
        for _ in range(200):
            with warnings.catch_warnings():
                warnings.simplefilter("error" if not ambiguous else "ignore")
                seen.append(qtraj.slerp([1, 0, 0, 0], b, 0.5, path="as_given"))
        return seen

    # filters are of the process: threads that never see an ambiguous row must not see a warning, whatever runs beside them
    with ThreadPoolExecutor(4) as pool:
        for result in pool.map(work, [False] * 4):
            assert len(result) == 200


@pytest.mark.parametrize("call", ["curve", "slerp", "batch"])
def test_other_threads_run_meanwhile(call, rng):
    curve = qtraj.Trajectory(np.arange(1000.0), walk(rng, 1000))
    t, out = rng.uniform(0, 999, 3_000_000), np.empty((3_000_000, 4))
    a, b = orientations(rng, 2, 100)
    a, b = np.tile(a, (30000, 1)), np.tile(b, (30000, 1))
    offsets = np.array([0, 1000])
    calls = {
        "curve": lambda: curve(t, out=out),
        "slerp": lambda: qtraj.slerp(a, b, 0.3, out=out),
        "batch": lambda: qtraj.sample_batch((offsets, curve.times, curve.keys), at=([0, len(t)], t)),
    }
    ticks, done = [], threading.Event()

    def tick():
        while not done.is_set():
            ticks.append(time.perf_counter())
            time.sleep(0.0005)

    thread = threading.Thread(target=tick)
    thread.start()
    try:
        start = time.perf_counter()
        calls[call]()
        end = time.perf_counter()
    finally:
        done.set()
        thread.join()
    # a call that held the lock would let none through between its first and its last moments
    inside = [tick for tick in ticks if start + 0.2 * (end - start) < tick < end - 0.2 * (end - start)]
    assert len(inside) >= 2, f"{len(ticks)} ticks, none in the middle of {1e3 * (end - start):.1f} ms"
