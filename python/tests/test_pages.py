"""What the pages show is true: sessions are replayed, programs run, lessons draw their pictures."""

from __future__ import annotations

import doctest
import os
import re
import shutil
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest
from conftest import SOURCE

PAGES = [SOURCE / "python" / "README.md", *sorted((SOURCE / "docs" / "python").glob("*.md")), SOURCE / "examples" / "python" / "README.md"]
LESSONS = sorted((SOURCE / "examples" / "python").glob("[0-9]*.py"))
DATA = SOURCE / "examples" / "data"


def blocks(page: Path, language: str) -> list[str]:
    return re.findall(rf"^```{language}\n(.*?)^```$", page.read_text(), re.M | re.S)


@pytest.mark.parametrize("page", PAGES, ids=lambda page: page.parent.name + "/" + page.name)
def test_sessions_replay(page, tmp_path, monkeypatch):
    sessions = blocks(page, "pycon")
    if any("xarray" in session for session in sessions):
        pytest.importorskip("xarray")
    shutil.copy(DATA / "tum_fr1_xyz.tum", tmp_path)
    monkeypatch.chdir(tmp_path)
    with np.printoptions(legacy="1.25"):
        test = doctest.DocTestParser().get_doctest("\n".join(sessions), {}, page.name, str(page), 0)
        found = doctest.DocTestRunner(optionflags=doctest.NORMALIZE_WHITESPACE).run(test)
    assert found.failed == 0 and (found.attempted > 0 or not sessions)


def test_there_are_sessions():
    assert sum(len(blocks(page, "pycon")) for page in PAGES) >= 8


def run(script: Path | list[str], folder: Path) -> subprocess.CompletedProcess:
    command = [sys.executable, str(script)] if isinstance(script, Path) else script
    return subprocess.run(command, capture_output=True, text=True, cwd=folder, env={**os.environ, "MPLBACKEND": "agg"})


@pytest.mark.parametrize("name", ["first.py", "resample.py"])
def test_programs_of_the_readme_run(name, tmp_path):
    if name == "resample.py":
        pytest.importorskip("matplotlib")
        pytest.importorskip("pandas")
    shutil.copy(DATA / "tum_fr1_xyz.tum", tmp_path)
    programs = dict(re.findall(r"^<!-- (\w+\.py) -->\n```python\n(.*?)^```$", PAGES[0].read_text(), re.M | re.S))
    (tmp_path / name).write_text(programs[name])
    done = run(tmp_path / name, tmp_path)
    assert done.returncode == 0 and done.stderr == "", done.stderr
    if name == "resample.py":
        assert len((tmp_path / "steady.csv").read_text().splitlines()) == 1506 and (tmp_path / "omega.png").stat().st_size > 5000


def test_commands_of_the_recordings_page_run(tmp_path):
    shutil.copy(DATA / "tum_fr1_xyz.tum", tmp_path / "poses.tum")
    commands = blocks(SOURCE / "docs" / "python" / "recordings.md", "sh")[0].splitlines()
    assert len(commands) == 3
    for command in (commands[0], commands[2]):
        words = command.partition("#")[0].split()
        assert run([sys.executable, *words[1:]], tmp_path).returncode == 0
    assert (tmp_path / "steady.csv").exists()


@pytest.mark.parametrize("lesson", LESSONS, ids=lambda lesson: lesson.stem)
def test_lessons_draw_the_pictures_that_are_shown(lesson, tmp_path):
    pytest.importorskip("matplotlib")
    done = run(lesson, tmp_path)
    assert done.returncode == 0 and done.stderr == "", done.stderr
    picture = tmp_path / f"{lesson.stem}.png"
    shown = lesson.parent / "pictures" / picture.name
    assert picture.stat().st_size > 5000 and shown.stat().st_size < 60_000
    assert f"pictures/{picture.name}" in (lesson.parent / "README.md").read_text()
    expected = re.search(r"^# prints: (.*)$", lesson.read_text(), re.M)
    if expected:
        assert done.stdout.strip() == expected.group(1)


@pytest.mark.parametrize("page", PAGES, ids=lambda page: page.parent.name + "/" + page.name)
def test_links_lead_somewhere(page):
    for target in re.findall(r"\]\(([^)#\s]+)[^)]*\)", page.read_text()):
        if "://" not in target:
            assert (page.parent / target).exists(), target


def test_functions_that_pages_name_are_there():
    import qtraj

    text = (SOURCE / "docs" / "python" / "coming-from.md").read_text()
    # the right-hand column of every table
    cells = [line.split("|")[2] for line in text.splitlines() if line.startswith("| ") and line.count("|") >= 3]
    named = {name for cell in cells for name in re.findall(r"`(\w+)\(", cell) if name not in ("spline", "curve")}
    assert named and not [name for name in named if not hasattr(qtraj, name)]
