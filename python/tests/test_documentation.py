"""Examples in docstrings run, and everything public has a docstring."""

from __future__ import annotations

import doctest
import inspect
import os
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


@pytest.mark.parametrize("thing", [qtraj, *PUBLIC, *MEMBERS], ids=lambda thing: getattr(thing, "__name__", str(thing)))
def test_examples_run(thing):
    names = {"np": np}
    for example in doctest.DocTestFinder(recurse=False).find(thing, getattr(thing, "__name__", "?"), module=False, globs=names):
        # text mode gives arrays their shortest form in every NumPy from 1.25 on
        with np.printoptions(legacy="1.25"):
            found = doctest.DocTestRunner(optionflags=doctest.NORMALIZE_WHITESPACE).run(example)
        assert found.failed == 0


def test_functions_without_an_example_are_few():
    without = [thing.__name__ for thing in PUBLIC if callable(thing) and ">>>" not in (inspect.getdoc(thing) or "")]
    methods = [member.__name__ for member in MEMBERS if callable(member) and ">>>" not in inspect.getdoc(member)]
    assert set(without) <= {"AmbiguousWarning", "NormWarning", "Error"} and not methods


def seconds_of_import(before: str, module: str) -> float:
    """The best of several interpreters; bytecode is kept, as everywhere after a first import."""
    script = f"import time{before}; start = time.perf_counter(); import {module}; print(time.perf_counter() - start)"
    keep = {name: value for name, value in os.environ.items() if name != "PYTHONDONTWRITEBYTECODE"}
    runs = (subprocess.run([sys.executable, "-c", script], capture_output=True, text=True, check=True, env=keep) for _ in range(7))
    return min(float(run.stdout) for run in runs)


def test_the_import_is_quick(capsys):
    """15 ms beyond NumPy, on a machine whose NumPy takes 100 ms: an eighth of it, and room for noise."""
    ours, numpy = seconds_of_import(", numpy", "qtraj"), seconds_of_import("", "numpy")
    with capsys.disabled():
        print(f"\n  import qtraj: {1e3 * ours:.1f} ms beyond NumPy, which takes {1e3 * numpy:.1f} ms", end="")
    assert ours < 0.15 * numpy


def test_the_import_loads_no_optional_package():
    script = "import sys, qtraj; print([m for m in ('scipy', 'pandas', 'polars', 'pyarrow', 'rosbags', 'asyncio') if m in sys.modules])"
    assert subprocess.run([sys.executable, "-c", script], capture_output=True, text=True, check=True).stdout.strip() == "[]"
