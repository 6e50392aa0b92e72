"""Compiles and runs programs that call the C interface."""

from __future__ import annotations

import os
import shutil
import subprocess
from pathlib import Path

import pytest

from support.daemons import BIN
from support.slowness import SLOWER

__all__ = ["LIBRARY", "ROOT", "STRICT", "needs", "octave", "run"]

ROOT = Path(__file__).parents[2]
LIBRARY = BIN.parent / "lib"
STRICT = ("-std=c99", "-pedantic-errors", "-Wall", "-Wextra", "-Werror")


def run(*command: str | Path, **options) -> subprocess.CompletedProcess[str]:
    environment = {**os.environ, "LD_LIBRARY_PATH": str(LIBRARY)}
    return subprocess.run(command, env=environment, capture_output=True, text=True, timeout=50 * SLOWER, **options)


def needs(program: str) -> pytest.MarkDecorator:
    return pytest.mark.skipif(
        shutil.which(program) is None, reason=f"{program} is not here; packaging/debian-packages.txt has its package"
    )


def octave(program: str) -> subprocess.CompletedProcess[str]:
    return run(
        "octave-cli", "--norc", "--quiet", "--path", LIBRARY / "octave",
        "--path", ROOT / "client" / "c" / "matlab", "--eval", program,
    )  # fmt: skip
