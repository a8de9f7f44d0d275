"""The library's reference vectors, computed at 60 digits, through the package."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
import qtraj
from conftest import SOURCE

FOLDER = SOURCE / "tests" / "reference" / "vectors"
METHODS = {
    "slerp": "slerp",
    "nlerp": "nlerp",
    "squad": "squad",
    "logspline": "log_spline",
    "spline": "rotation_spline",
    "hermite": "hermite",
    "rotquintic": "rotation_quintic",
    "quintic": "quaternion_quintic",
}
FILES = [file for file in sorted(FOLDER.glob("*.txt")) if file.read_text().split("\nmethod ")[1:] and (
    file.read_text().split("\nmethod ")[1].split()[0] in METHODS)]


def read(file: Path) -> tuple[str, dict[str, list[str]], np.ndarray, np.ndarray]:
    """Method, options, rows of keys and rows of samples."""
    method, options, tables = "", {}, {}
    lines = iter(line for line in file.read_text().splitlines() if line and not line.startswith("#"))
    for line in lines:
        word, *rest = line.split()
        if word == "method":
            method = METHODS[rest[0]]
        elif word == "option":
            options[rest[0]] = rest[1:]
        else:
            tables[word] = np.array([next(lines).split() for _ in range(int(rest[0]))], dtype=float)
    return method, options, tables["keys"], tables["samples"]


def settings_of(options: dict[str, list[str]]) -> dict[str, object]:
    words = {"meanvelocity": "mean_velocity", "catmullrom": "catmull_rom", "notaknot": "not_a_knot", "mean_velocity": "mean_velocity"}
    settings: dict[str, object] = {}
    for name, value in options.items():
        word = words.get(value[0].lower(), value[0].lower())
        if name == "boundary" and word in ("given", "clamped"):
            rates = np.array(options["end_rates_body"], dtype=float).reshape(2, 3)
            settings.update(ends=(rates[0], rates[1]), frame="body")
        elif name == "boundary":
            settings["ends"] = word
        elif name == "tangents":
            settings["tangents"] = word
        elif name == "reference":
            settings["reference"] = word if len(value) == 1 else np.array(value, dtype=float)
    return settings


def test_there_are_vectors_of_every_method():
    assert {read(file)[0] for file in FILES} == set(METHODS.values())


@pytest.mark.filterwarnings("ignore::qtraj.NormWarning")
@pytest.mark.parametrize("file", FILES, ids=lambda file: file.stem)
def test_samples_are_right_to_rounding(file):
    method, options, keys, samples = read(file)
    settings = settings_of(options)
    if keys.shape[1] == 11:
        settings.update(omega=keys[:, 5:8], frame="world")
        if method != "hermite":
            settings["alpha"] = keys[:, 8:11]
    curve = qtraj.Trajectory(keys[:, 0], keys[:, 1:5], method, **settings)
    motion = curve.motion(samples[:, 0], frame="world")
    # splines through wildly uneven knots are ill-conditioned: what rounding makes of that, the library's tests bound
    assert np.abs(motion.q - samples[:, 1:5]).max() < (1e-12 if "wild" in file.stem else 2e-14)
    scale = np.abs(samples[:, 5:8]).max()
    assert np.abs(motion.omega - samples[:, 5:8]).max() <= 2e-10 * scale + 1e-300
