"""Generates the variables and enumerations of FMUs: the fields of contacts and wheels with a role there (`x-fmu`)."""

from __future__ import annotations

import json
import re
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path

from .cpp import NOTE, formatted, number_text
from .declarations import ROOT, DeclarationError, Declarations, Schema

GENERATED = ROOT / "client" / "fmu" / "variables" / "generated"
ROLES = ("parameter", "tunable", "input", "output")
#: Prefixes of paths in contactd.h, each with the schema where its fields begin.
CONTACT = [("", "contact.solve.params.json#"), ("", "contact.solve.result.json#")]
WHEEL = [
    ("setup", "definitions.json#/definitions/wheel_rail_setup"),
    ("state", "definitions.json#/definitions/wheel_rail_state"),
    ("", "wheelrail.solve.result.json#"),
]
#: Inputs that client/fmu/models sets for contacts; the wheel's are all set by their paths.
OF_CONTACT = re.compile(r"grid\.|gap\.(paraboloid|semi_axes)\.|Fn$|approach$|friction\.rolling\.|bodies\.\w+\.(viscoelastic\.|(G|nu|rigid)$)")


@dataclass(frozen=True)
class Field:
    """A field with x-fmu. Its name is the path without the common prefix, unless x-fmu has another."""

    path: str
    name: str
    schema: Schema
    fmu: Schema

    def filled(self, text: str) -> str:
        """Returns the text with the field's body, upper or lower, in place of {body}."""
        return text.replace("{body}", self.path.split(".")[1]) if "{body}" in text else text


def fmu_files(declarations: Declarations) -> dict[Path, str]:
    contact, wheel = (list(_fields(declarations, roots)) for roots in (CONTACT, WHEEL))
    for field in contact:
        if field.fmu.get("role", "output") != "output" and not OF_CONTACT.match(field.path):
            raise DeclarationError(f"{field.path} has x-fmu, but client/fmu/models sets no such field of a contact")
    for field in wheel:
        if field.fmu.get("role") == "tunable":
            raise DeclarationError(f"{field.path} is tunable; numbers of a wheel are set before the simulation or at each step")
    return {
        GENERATED / "contact_fields.hpp": _variables("contact_fields", contact),
        GENERATED / "wheel_fields.hpp": _variables("wheel_fields", wheel),
        GENERATED / "enumerations.hpp": _enumerations([*contact, *wheel]),
    }


def _fields(declarations: Declarations, roots: list[tuple[str, str]]) -> Iterator[Field]:
    for root, reference in roots:
        for name, schema in _below(declarations, declarations.resolved({"$ref": reference}), ""):
            given = schema["x-fmu"]
            yield Field(f"{root}.{name}" if root else name, name, schema, {"role": given} if isinstance(given, str) else given)


def _below(declarations: Declarations, schema: Schema, above: str) -> Iterator[tuple[str, Schema]]:
    for name, given in schema.get("properties", {}).items():
        field = declarations.resolved(given)
        if "x-fmu" in field:
            yield above + name, field
        yield from _below(declarations, field, f"{above}{name}.")


def _variables(name: str, fields: list[Field]) -> str:
    variables = [_variable(field) for field in fields if "enumeration" not in field.fmu]
    lines = [NOTE, "#pragma once\n", "#include <array>\n", '#include "variables/variable.hpp"\n', "namespace contactd::fmu::detail {\n"]
    lines += [f"inline constexpr auto {name} = std::to_array<Variable>({{", *variables, "});\n"]
    return formatted("\n".join([*lines, "}  // namespace contactd::fmu::detail\n"]))


def _variable(field: Field) -> str:
    """Returns a variable. An optional field without a start is omitted while its value is 0."""
    role, start = field.fmu["role"], field.fmu.get("start", field.schema.get("default"))
    kind = "boolean" if field.schema.get("const") is True else field.schema.get("type")
    if role not in ROLES or kind not in ("number", "integer", "boolean"):
        raise DeclarationError(f"{field.path} has x-fmu {role}; only numbers and flags are variables, and these are {', '.join(ROLES)}")
    unit = field.schema.get("x-unit", "").replace("^", "").replace(" ", ".")
    omitted = " 0: omitted." if start is None and role != "output" else ""
    says = field.filled(field.fmu.get("says", field.schema["description"] + omitted))
    parts = [f'.name = "{field.filled(field.fmu.get("name", field.name))}"', f".role = Role::{role}"]
    parts += [f".type = Type::{kind}"] * (kind != "number")
    parts += [f'.unit = "{unit}"', f".start = {number_text(start or 0)}", f".says = {json.dumps(says)}", f'.path = "{field.path}"']
    return f"Variable{{{', '.join(parts)}, .zero_is_absent = {str(start is None).lower()}}},"


def _enumerations(fields: list[Field]) -> str:
    lines = [NOTE, "#pragma once\n", '#include "variables/variable.hpp"\n', "namespace contactd::fmu::enumerations {\n"]
    first = {field.fmu["enumeration"]: field for field in reversed(fields) if "enumeration" in field.fmu}
    for field in reversed(first.values()):
        lines += _enumeration(field)
    return formatted("\n".join([*lines, "}  // namespace contactd::fmu::enumerations\n"]))


def _enumeration(field: Field) -> list[str]:
    """Returns the field's keywords, between those that only FMUs have, and the text of the integer for them."""
    title, name = field.fmu["enumeration"], field.fmu.get("name", field.name)
    keywords = [*field.fmu.get("before", []), *field.schema["enum"], *field.fmu.get("after", [])]
    constant = re.sub(r"(?<=[a-z])(?=[A-Z])", "_", title).lower()
    numbers = ", ".join(f"{number} {keyword}" for number, keyword in enumerate(keywords))
    says = f"Overrides {name}: {numbers}; -1: {name} applies."
    quoted = ", ".join(f'"{keyword}"' for keyword in keywords)
    return [
        f"inline constexpr std::string_view {constant}_keywords[] = {{{quoted}}};",
        f'inline constexpr Enumeration {constant}{{"{title}", {constant}_keywords, {json.dumps(says)}}};\n',
    ]
