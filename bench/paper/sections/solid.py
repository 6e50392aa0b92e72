"""Solves strips of a block with an edge in three dimensions, by a program of bench/."""

from __future__ import annotations

import json
import os
import subprocess
from pathlib import Path
from typing import Any

PROGRAM = "section_solid"


def measure(programs: Path, options: dict[str, float]) -> dict[str, Any]:
    """Returns the output of bench/section_solid.cpp."""
    arguments = [part for name, value in options.items() for part in (f"--{name}", f"{value:g}")]
    environment = {**os.environ, "OMP_NUM_THREADS": "1", "OPENBLAS_NUM_THREADS": "1"}
    command = [str(programs / PROGRAM), *arguments]
    printed = subprocess.run(command, check=True, capture_output=True, text=True, env=environment).stdout
    result: dict[str, Any] = json.loads(printed)
    return result
