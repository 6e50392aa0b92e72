"""Lists of fields and keywords in C++: a header and a source for each header of core whose types are declared."""

from __future__ import annotations

import re
import subprocess
from pathlib import Path

from .declarations import ROOT, Bounds, DeclarationError, Declarations, Enum, Field, Struct

INCLUDE = ROOT / "core" / "include" / "contactd"
SOURCES = ROOT / "core" / "types" / "fields"
NOTE = "// Written by ./dev generate from proto/schema: edit it there.\n"
#: Words that C++ reserves, and the enumerators for them.
RESERVED = {"auto": "automatic"}


def cpp_files(declarations: Declarations) -> dict[Path, str]:
    """The text of each file."""
    homes = _homes()
    by_header: dict[str, list[Struct | Enum]] = {}
    for declared in [*declarations.enums.values(), *declarations.structs.values()]:
        by_header.setdefault(_home(declared.name, homes), []).append(declared)
    files = {}
    for header, declared in by_header.items():
        enums = [one for one in declared if isinstance(one, Enum)]
        structs = [one for one in declared if isinstance(one, Struct)]
        used = {_home(field.type, homes) for struct in structs for field in struct.fields if field.type and not field.is_custom}
        files[INCLUDE / "fields" / header] = formatted(_header(header, sorted(used - {header}), enums, structs))
        if structs:
            files[SOURCES / f"{Path(header).stem}.cpp"] = formatted(_source(header, structs))
    return files


def _home(name: str, homes: dict[str, str]) -> str:
    outer = name.partition("::")[0]
    if outer not in homes:
        raise DeclarationError(f"no header of core/include/contactd defines {outer}")
    return homes[outer]


def _homes() -> dict[str, str]:
    """The header of each struct and enum of core."""
    homes: dict[str, str] = {}
    for path in sorted(INCLUDE.glob("*.hpp")):
        for name in re.findall(r"^(?:struct|enum class) (\w+)(?: : [\w:]+)? \{", path.read_text(), re.MULTILINE):
            homes[name] = path.name
    return homes


def _header(header: str, used: list[str], enums: list[Enum], structs: list[Struct]) -> str:
    includes = sorted(["contactd/fields.hpp", f"contactd/{header}", *(f"contactd/fields/{name}" for name in used)])
    lines = [NOTE, "#pragma once\n", *(f'#include "{name}"' for name in includes), "\nnamespace contactd {\n"]
    for enum in enums:
        words = ", ".join(f'"{word}"' for word in enum.keywords)
        lines += ["template <>", f"inline constexpr auto enum_words<{enum.name}> = std::to_array<std::string_view>({{{words}}});"]
        for value, word in enumerate(enum.keywords):
            lines.append(f"static_assert(static_cast<int>({enum.name}::{RESERVED.get(word, word)}) == {value});")
        lines.append("")
    lines += [f"template <>\nconst FieldType& type_of<{struct.name}>();" for struct in structs]
    return "\n".join([*lines, "\n}  // namespace contactd\n"])


def _source(header: str, structs: list[Struct]) -> str:
    lines = [NOTE, f'#include "contactd/fields/{header}"\n', "#include <array>", "\nnamespace contactd {", "namespace {\n"]
    lines.append("// A member that the schema does not declare makes the number of these names wrong.")
    for struct in structs:
        members = [field.name for field in struct.fields] + list(struct.other_members)
        names = ", ".join(f"{name}_" for name in members)
        lines += [f"[[maybe_unused]] void all_of(const {struct.name}& all) {{", f"[[maybe_unused]] const auto& [{names}] = all;", "}"]
    lines.append("\n}  // namespace\n")
    for struct in structs:
        lines += ["template <>", f"const FieldType& type_of<{struct.name}>() {{", "static const auto list = std::to_array<Field>({"]
        lines += [f"{_field(struct.name, field)}," for field in struct.fields]
        lines += ["});", "static const FieldType type = fields::object_type(list);", "return type;", "}\n"]
    return "\n".join([*lines, "}  // namespace contactd\n"])


def _field(struct: str, field: Field) -> str:
    call = "custom_field" if field.is_custom else "field"
    notes = ", ".join(_notes(field))
    return f'fields::{call}<&{struct}::{field.name}>("{field.name}"{", {" + notes + "}" if notes else ""})'


def _notes(field: Field) -> list[str]:
    notes = []
    if field.bounds != Bounds():
        bounds = field.bounds
        ends = [f".{end} = {number_text(value)}" for end, value in [("least", bounds.least), ("most", bounds.most)] if value is not None]
        ends += [f".{end}_excluded = true" for end in ("least", "most") if getattr(bounds, f"{end}_excluded")]
        notes.append(f".bounds = {{{', '.join(ends)}}}")
    if field.unit:
        notes.append(f'.unit = "{field.unit}"')
    if field.parity != "even":
        notes.append(f".parity = MirrorParity::{field.parity}")
    if field.required:
        notes.append(".required = true")
    return notes


def number_text(value: float) -> str:
    """In the fewest digits that read back to it."""
    short = f"{value:.6g}"
    return short if float(short) == value else repr(value)


def formatted(text: str) -> str:
    command = ["clang-format", f"--style=file:{ROOT / '.clang-format'}"]
    return subprocess.run(command, input=text, capture_output=True, text=True, check=True).stdout
