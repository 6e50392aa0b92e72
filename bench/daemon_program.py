"""Which contactd the programs of this folder start."""

from __future__ import annotations

import os
from pathlib import Path


def daemon_program() -> Path | str:
    """That in the folder CONTACTD_BIN of the environment; without it, that on PATH."""
    return Path(os.environ["CONTACTD_BIN"]) / "contactd" if "CONTACTD_BIN" in os.environ else "contactd"
