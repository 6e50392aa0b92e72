"""Tests that the notebooks run unchanged. Their last cells assert properties of their results."""

from __future__ import annotations

import json
import subprocess
import sys
from pathlib import Path

import pytest

from support.daemons import BIN

NOTEBOOKS = sorted((Path(__file__).parents[2] / "docs" / "tutorials").glob("*.ipynb"))
RUN = """
import sys, nbformat
from nbclient import NotebookClient
notebook = NotebookClient(nbformat.read(sys.argv[1], 4), timeout=250, resources={"metadata": {"path": sys.argv[2]}}).execute()
nbformat.write(notebook, sys.argv[2] + "/run.ipynb")
"""


@pytest.mark.timeout(300)
@pytest.mark.parametrize("notebook", NOTEBOOKS, ids=lambda path: path.stem)
def test_a_notebook_runs_as_it_stands_there(notebook, tmp_path, monkeypatch):
    monkeypatch.setenv("PYTHONPATH", f"{BIN.parent / 'lib' / 'python'}:{Path(__file__).parents[2] / 'client' / 'python'}")
    monkeypatch.setenv("PATH", f"{BIN}:/usr/bin:/bin")
    ended = subprocess.run([sys.executable, "-c", RUN, notebook, tmp_path], capture_output=True, text=True)
    assert ended.returncode == 0, ended.stderr
    cells = [cell for cell in json.loads((tmp_path / "run.ipynb").read_text())["cells"] if cell["cell_type"] == "code"]
    outputs = [output for cell in cells for output in cell["outputs"]]
    assert sum("image/png" in output.get("data", {}) for output in outputs) >= 2
    assert "assert" in "".join(cells[-1]["source"])
    assert not [output for output in outputs if output.get("name") == "stderr"], "a warning in a notebook"


def test_there_are_notebooks():
    assert len(NOTEBOOKS) >= 2


@pytest.mark.parametrize("notebook", NOTEBOOKS, ids=lambda path: path.stem)
def test_a_notebook_is_kept_without_results(notebook):
    """The site recomputes them. To remove outputs, run jupyter nbconvert --clear-output --inplace FILE."""
    cells = [cell for cell in json.loads(notebook.read_text())["cells"] if cell["cell_type"] == "code"]
    assert cells
    assert not [cell["id"] for cell in cells if cell["outputs"] or cell["execution_count"]]
