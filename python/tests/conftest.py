"""What the tests share: the sources' data, and numbers that are the same in every run."""

from __future__ import annotations

import os
from pathlib import Path

import numpy as np
import pytest

# The package is tested as it was installed, away from its sources; of those only data and the header are read.
SOURCE = Path(os.environ.get("QTRAJ_SOURCE", Path(__file__).resolve().parents[2]))


@pytest.fixture(scope="session")
def source() -> Path:
    return SOURCE


@pytest.fixture
def rng() -> np.random.Generator:
    return np.random.default_rng(20261201)
