"""``python -m qtraj``: recordings, from the shell."""

from __future__ import annotations

import sys

from .recordings.commands import main

if __name__ == "__main__":
    sys.exit(main())
