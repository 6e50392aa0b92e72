"""Generates the variables of FMUs: the fields of a wheel on its rail that have a role there (`x-fmu`), by their paths."""

from __future__ import annotations

import json
from collections.abc import Iterator
from pathlib import Path

from .cpp import NOTE, formatted, number_text
from .declarations import ROOT, DeclarationError, Declarations, Schema

GENERATED = ROOT / "client" / "fmu" / "variables" / "generated"
ROLES = ("parameter", "input", "output")
#: Prefixes of paths in contactd.h, each with the schema where its fields begin.
ROOTS = [
    ("setup", "definitions.json#/definitions/wheel_rail_setup"),
    ("state", "definitions.json#/definitions/wheel_rail_state"),
    ("", "wheelrail.solve.result.json#"),
]


def fmu_files(declarations: Declarations) -> dict[Path, str]:
    variables = []
    for root, reference in ROOTS:
        schema = declarations.resolved({"$ref": reference})
        variables += [_variable(root, name, field) for name, field in _fields(declarations, schema, "")]
    lines = [NOTE, "#pragma once\n", "#include <array>\n", '#include "variables/variable.hpp"\n', "namespace contactd::fmu::detail {\n"]
    lines += ["inline constexpr auto wheel_fields = std::to_array<Variable>({", *variables, "});\n"]
    return {GENERATED / "wheel_fields.hpp": formatted("\n".join([*lines, "}  // namespace contactd::fmu::detail\n"]))}


def _fields(declarations: Declarations, schema: Schema, above: str) -> Iterator[tuple[str, Schema]]:
    for name, given in schema.get("properties", {}).items():
        field = declarations.resolved(given)
        if "x-fmu" in field:
            yield above + name, field
        yield from _fields(declarations, field, f"{above}{name}.")


def _variable(root: str, name: str, field: Schema) -> str:
    """Returns a variable, named by its path without the common prefix. An optional field is omitted while its value is 0."""
    role, start = field["x-fmu"], field.get("default")
    if role not in ROLES or field.get("type") != "number":
        raise DeclarationError(f"{name} has x-fmu {role}; only numbers are variables, and these are {', '.join(ROLES)}")
    unit = field.get("x-unit", "").replace("^", "").replace(" ", ".")
    says = field["description"] + (" 0: omitted." if start is None and role != "output" else "")
    path = f"{root}.{name}" if root else name
    parts = [f'.name = "{name}"', f".role = Role::{role}", f'.unit = "{unit}"', f".start = {number_text(start or 0)}"]
    parts += [f".says = {json.dumps(says)}", f'.path = "{path}"', f".zero_is_absent = {str(start is None).lower()}"]
    return f"Variable{{{', '.join(parts)}}},"
