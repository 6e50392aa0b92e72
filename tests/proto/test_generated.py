"""Tests that the files generated from proto/schema are up to date."""

from __future__ import annotations

import json
import shutil
import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).parents[2]


def generate(*arguments: str, folder: Path = ROOT) -> subprocess.CompletedProcess[str]:
    command = [sys.executable, "-B", "-m", "generate", *arguments]
    return subprocess.run(command, cwd=folder / "proto", capture_output=True, text=True)


def test_the_tree_has_what_its_schemas_say() -> None:
    checked = generate("--check")
    assert checked.returncode == 0, f"run ./dev generate\n{checked.stdout}{checked.stderr}"


def generate_with(tmp_path: Path, document: str, place: list[str], fmu: object) -> subprocess.CompletedProcess[str]:
    """Generates from schemas in which a field has this x-fmu."""
    for folder in ("core/include", "proto/schema", "proto/generate"):
        shutil.copytree(ROOT / folder, tmp_path / folder)
    shutil.copy(ROOT / ".clang-format", tmp_path)
    path = tmp_path / "proto" / "schema" / document
    node = schema = json.loads(path.read_text())
    for name in place:
        node = node[name]
    node["x-fmu"] = fmu
    path.write_text(json.dumps(schema))
    return generate(folder=tmp_path)


def test_a_number_of_a_contact_becomes_a_variable_of_its_fmu(tmp_path: Path) -> None:
    fmu = {"name": "grid.corner", "role": "parameter", "start": -2, "says": "A corner."}
    made = generate_with(tmp_path, "definitions.json", ["definitions", "grid", "properties", "x0"], fmu)
    assert made.returncode == 0, made.stderr
    text = (tmp_path / "client" / "fmu" / "variables" / "generated" / "contact_fields.hpp").read_text()
    _, _, variable = text.partition('Variable{.name = "grid.corner"')
    for part in (".role = Role::parameter", '.unit = "mm"', ".start = -2", '.says = "A corner."', '.path = "grid.x0"'):
        assert part in variable.partition("}")[0]


def test_a_number_that_no_fmu_sets_is_refused(tmp_path: Path) -> None:
    made = generate_with(tmp_path, "contact.solve.params.json", ["properties", "sheet_flexibility"], "parameter")
    assert made.returncode != 0
    assert "sheet_flexibility has x-fmu, but client/fmu/models sets no such field of a contact" in made.stderr
