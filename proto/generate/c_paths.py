"""Writes contactd/paths.h: paths and keywords of the C interface as constants, so that a compiler finds a wrong one."""

from __future__ import annotations

import re
from collections.abc import Iterator
from pathlib import Path

from .cpp import NOTE, formatted
from .declarations import ROOT, Declarations, Schema, is_custom

GENERATED = ROOT / "client" / "c" / "generated"
#: Maps the beginnings of paths in contactd.h to their schemas.
INPUTS = [
    ("setup", "definitions.json#/definitions/wheel_rail_setup"),
    ("state", "definitions.json#/definitions/wheel_rail_state"),
]
RESULTS = [
    ("", "wheelrail.solve.result.json#"),
    ("roll", "wheelrail.wheelset.result.json#/properties/roll"),
    ("roll_search", "wheelrail.wheelset.result.json#/properties/roll_search"),
]
CONTACT_INPUTS = [
    ("", "contact.solve.params.json#"),
    ("", "session.open.params.json#"),
]
CONTACT_RESULTS = [
    ("", "session.step.result.json#"),
    ("ics", "session.open.result.json#/properties/ics"),
]
TITLED = {
    "inputs of a contact": CONTACT_INPUTS,
    "results of a contact": CONTACT_RESULTS,
    "inputs of a wheel": INPUTS,
    "results of a wheel": RESULTS,
}
#: Objects with a special form on the wire whose fields are nevertheless part of contactd.h.
WITH_FIELDS = re.compile(r"(setup\.)?bodies\b|ics\b|columns\.frames|friction\.(rolling\.)?force|motion\b")
#: Fields below these have no constants: they repeat the fields of "ics" or the evidence of ic.get.
NOT_BELOW = re.compile(r"bodies\.\w+\.ics|ics\.\w+\.evidence")
#: Fields without a constant: "contacts" is the length of a list, and other functions serve the rest.
NO_FIELDS = {"contacts", "fields", "initial", "wheelrail", "ics.section.profile_section.profile.file"}
_LONGEST = 120  #: characters of a line

HEAD = """/* Paths of fields and keywords for contactd.h. An entry of a list has its number printed in place of %d:
 *
 *     snprintf(path, sizeof path, CONTACTD_PATH_PATCHES_SOLUTION_PMAX, patch);
 */
#ifndef CONTACTD_PATHS_H
#define CONTACTD_PATHS_H
"""


def c_files(declarations: Declarations) -> dict[Path, str]:
    enums: set[str] = set()
    lines = [NOTE.replace("// ", "/* ").replace(".\n", ". */\n").rstrip(), HEAD]
    known: set[str] = set()
    for title, roots in TITLED.items():
        lines.append(f"/* --- {title} --- */")
        for root, reference in roots:
            schema = declarations.resolved({"$ref": reference})
            for path, field in [(root, schema)] * bool(root) + list(_fields(declarations, schema, f"{root}." if root else "")):
                if "enum" in field and "x-cpp" in field:
                    enums.add(field["x-cpp"])
                if path not in known:
                    lines.append(_path(path, field))
                known.add(path)
        lines.append("")
    lines.append("/* --- keywords --- */")
    for name in sorted(enums):
        start = f"#define CONTACTD_WORD_{_upper(name.removesuffix('Kind'))}_"
        lines += [f'{start}{_upper(word)} "{word}"' for word in declarations.enums[name].keywords]
    return {GENERATED / "include" / "contactd" / "paths.h": formatted("\n".join([*lines, "", "#endif", ""]))}


def _fields(declarations: Declarations, schema: Schema, above: str) -> Iterator[tuple[str, Schema]]:
    """Yields the fields of contactd.h below a schema, each before its own fields."""
    for name, given in schema.get("properties", {}).items():
        field, path = declarations.resolved(given), above + name
        if "x-partial" in field:  # the struct has all fields
            field = declarations.schemas[field["x-cpp"]]
        if "else" in field and "$ref" in field["else"]:  # coefficients other than a table
            field = declarations.resolved(field["else"])
        is_beside_struct = "x-derived" in field and "." in path
        if is_beside_struct or path in NO_FIELDS or not _has_path(declarations, field, path):
            continue
        yield path, field
        if _is_array(field) or NOT_BELOW.fullmatch(path):
            continue
        if "x-cpp-items" in field:
            yield from ((f"{path}.{name}", field["items"]) for name in field["x-cpp-items"])
            continue
        items = declarations.resolved(field.get("items") or {})
        if items.get("type") == "string":
            yield f"{path}[%d]", items
        yield from _fields(declarations, items or field, f"{path}[%d]." if items else f"{path}.")


def _has_path(declarations: Declarations, field: Schema, path: str) -> bool:
    value = declarations.resolved(field.get("items") or {}) or field
    return _is_array(field) or not is_custom(value) or bool(WITH_FIELDS.match(path))


def _is_array(field: Schema) -> bool:
    return "$array" in field.get("properties", {})


def _path(path: str, field: Schema) -> str:
    unit = f" /* {field['x-unit']} */" if "x-unit" in field else ""
    name = path.removesuffix("[%d]") + "_at" * path.endswith("[%d]")
    line = f'#define CONTACTD_PATH_{_upper(name.replace("[%d]", ""))} "{path}"'
    # The unit is omitted where clang-format would break the line and break it again in the next run: at the limit of a
    # line, and for units of two words beyond it.
    length = len(line + unit)
    return line if length in (_LONGEST - 1, _LONGEST) or (" " in field.get("x-unit", "") and length >= _LONGEST) else line + unit


def _upper(name: str) -> str:
    """Returns the name in capitals; CAPITAL_ marks a capital letter that differs from another field only in case."""
    name = re.sub(r"\b([A-Z])_", r"capital_\1_", name)
    return re.sub(r"(?<=[a-z])(?=[A-Z][a-z])", "_", name).replace(".", "_").replace("::", "_").upper()
