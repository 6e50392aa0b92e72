"""Chooses the contactd program that the benchmarks start."""

from __future__ import annotations

import os
from pathlib import Path


def daemon_program() -> Path | str:
    """Returns contactd from the folder in the environment variable CONTACTD_BIN, or its name, to be found on PATH."""
    return Path(os.environ["CONTACTD_BIN"]) / "contactd" if "CONTACTD_BIN" in os.environ else "contactd"
