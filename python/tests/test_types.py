"""Stubs tell what the package does: by mypy's stubtest, and by pyright of a program that uses them."""

from __future__ import annotations

import json
import subprocess
import sys
from pathlib import Path

import pytest

pytest.importorskip("mypy")

# what Cython adds to a module
CYTHON = ["qtraj._core.__reduce_cython__", "qtraj._core.__setstate_cython__", "qtraj._core.__test__"]

PROGRAM = """
import numpy as np
import qtraj

curve = qtraj.Trajectory([0, 1], np.eye(4)[:2], "squad", extrapolate=("hold", "error"))
reveal_type(curve(0.5))
reveal_type(curve.motion([0.5], frame="body").omega)
reveal_type(qtraj.check_keys([0, 1], np.eye(4)[:2]).first_sign_change)
qtraj.Trajectory([0, 1], np.eye(4)[:2], "squat")
curve(0.5, 1, frame="bdoy")
curve.motion(0.5)
curve.method = "slerp"
"""


def test_stubs_agree_with_the_package(tmp_path):
    allowed = tmp_path / "allowed.txt"
    allowed.write_text("\n".join(CYTHON))
    run = subprocess.run(
        [sys.executable, "-m", "mypy.stubtest", "qtraj", "--allowlist", str(allowed)], capture_output=True, text=True, cwd=tmp_path
    )
    assert run.returncode == 0, run.stdout[-4000:]


def pyright(tmp_path: Path, *arguments: str) -> dict:
    run = subprocess.run(
        [sys.executable, "-m", "pyright", "--outputjson", "--pythonpath", sys.executable, *arguments],
        capture_output=True, text=True, cwd=tmp_path,
    )  # fmt: skip
    return json.loads(run.stdout[run.stdout.index("{") :])


def test_a_type_checker_finds_wrong_words_and_missing_frames(tmp_path):
    (tmp_path / "program.py").write_text(PROGRAM)
    found = pyright(tmp_path, "program.py")["generalDiagnostics"]
    kinds = {(item["range"]["start"]["line"], item["severity"]) for item in found}
    assert kinds == {(5, "information"), (6, "information"), (7, "information"), (8, "error"), (9, "error"), (10, "error"), (11, "error")}
    told = {item["range"]["start"]["line"]: item["message"] for item in found}
    assert "floating" in told[5] and "floating" in told[6] and "int | None" in told[7]
