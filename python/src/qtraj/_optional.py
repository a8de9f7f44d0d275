"""Packages that only some functions need, imported when these are called."""

from __future__ import annotations

import importlib
from typing import Any


def optional(module: str, extra: str) -> Any:
    """A module, or an ImportError that says what to install."""
    try:
        return importlib.import_module(module)
    except ImportError as missing:
        raise ImportError(
            f"this takes {module.partition('.')[0]}, which is not installed: pip install 'qtraj[{extra}]'"
        ) from missing
