"""Examples in docstrings run, and everything public has a docstring."""

from __future__ import annotations

import doctest
import inspect
import subprocess
import sys

import numpy as np
import pytest
import qtraj

PUBLIC = [getattr(qtraj, name) for name in qtraj.__all__]
MEMBERS = [
    member
    for kind in (qtraj.Trajectory, qtraj.VectorCurve, qtraj.Poses)
    for name, member in vars(kind).items()
    if not name.startswith("_")
]


@pytest.mark.parametrize("thing", [*PUBLIC, *MEMBERS], ids=lambda thing: getattr(thing, "__name__", str(thing)))
def test_everything_public_says_what_it_is(thing):
    assert inspect.getdoc(thing) and len(inspect.getdoc(thing)) > 20


@pytest.mark.parametrize("thing", [qtraj, *PUBLIC], ids=lambda thing: getattr(thing, "__name__", str(thing)))
def test_examples_run(thing):
    names = {"np": np}
    for example in doctest.DocTestFinder(recurse=False).find(thing, getattr(thing, "__name__", "?"), module=False, globs=names):
        # text mode gives arrays their shortest form in every NumPy from 1.25 on
        with np.printoptions(legacy="1.25"):
            found = doctest.DocTestRunner(optionflags=doctest.NORMALIZE_WHITESPACE).run(example)
        assert found.failed == 0


def test_functions_without_an_example_are_few():
    without = [thing.__name__ for thing in PUBLIC if callable(thing) and ">>>" not in (inspect.getdoc(thing) or "")]
    assert set(without) <= {"AmbiguousWarning", "NormWarning", "Error"}


def test_the_import_is_quick():
    """At most 15 ms beyond NumPy, whose own import is the measure of the machine."""
    script = (
        "import time, numpy; a = time.perf_counter(); import qtraj; print(time.perf_counter() - a)"
    )
    best = min(float(subprocess.run([sys.executable, "-c", script], capture_output=True, text=True, check=True).stdout) for _ in range(7))
    numpy_alone = "import time; a = time.perf_counter(); import numpy; print(time.perf_counter() - a)"
    numpy = min(float(subprocess.run([sys.executable, "-c", numpy_alone], capture_output=True, text=True, check=True).stdout) for _ in range(7))
    print(f"import qtraj: {1e3 * best:.1f} ms beyond NumPy, which takes {1e3 * numpy:.1f} ms")
    assert best < 0.25 * numpy


def test_the_import_loads_no_optional_package():
    script = "import sys, qtraj; print([m for m in ('scipy', 'pandas', 'polars', 'pyarrow', 'rosbags', 'asyncio') if m in sys.modules])"
    assert subprocess.run([sys.executable, "-c", script], capture_output=True, text=True, check=True).stdout.strip() == "[]"
