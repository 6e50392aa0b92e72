"""Tests docs/fmu.md: its programs run, and its tables are those of the lists."""

from __future__ import annotations

import importlib.util
import json
import re
import subprocess
import sys
from pathlib import Path

import pytest

from support.daemons import BIN
from support.fmus import FOLDER, PACKAGES
from support.slowness import SLOWER

ROOT = Path(__file__).parents[3]
PAGE = ROOT / "docs" / "fmu.md"
PROGRAMS = re.findall(r"^```python\n(.*?)^```", PAGE.read_text(), re.MULTILINE | re.DOTALL)


@pytest.mark.parametrize(
    ("program", "shows"), zip(PROGRAMS, ("Fx -", "y 4 mm: Fy"), strict=True), ids=["FMI 2", "FMI 3"]
)
def test_a_program_runs_as_it_stands(program, shows, tmp_path):
    (tmp_path / "build").mkdir()
    (tmp_path / "build" / "fmu").symlink_to(FOLDER)
    code = f"import sys\nsys.path.append({str(PACKAGES)!r})\n{program}"
    ended = subprocess.run(
        [sys.executable, "-c", code], cwd=tmp_path, capture_output=True, text=True, timeout=50 * SLOWER
    )
    assert ended.returncode == 0, ended.stderr
    assert shows in ended.stdout


def test_the_tables_are_those_of_the_lists():
    spec = importlib.util.spec_from_file_location("fmu_variables", ROOT / "docs" / "fmu_variables.py")
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    said = json.loads(subprocess.run([BIN / "contactd-fmu-description"], capture_output=True, check=True).stdout)
    assert PAGE.read_text().partition(module.MARK)[2].strip() == module.tables(said).strip(), "./dev docs writes them"
