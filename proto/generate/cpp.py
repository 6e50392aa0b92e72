"""Generates lists of fields and keywords in C++: a header and a source for each header of core that declares types."""

from __future__ import annotations

import re
import subprocess
from pathlib import Path

from .declarations import ROOT, Bounds, DeclarationError, Declarations, Enum, Field, Struct

INCLUDE = ROOT / "core" / "include" / "contactd"
GENERATED = ROOT / "core" / "types" / "generated"
HEADERS = GENERATED / "include" / "contactd" / "fields"
NOTE = "// Written by ./dev generate from proto/schema: edit it there.\n"
#: Reserved words of C++, and the enumerators used in their place.
RESERVED = {"auto": "automatic"}


def cpp_files(declarations: Declarations) -> dict[Path, str]:
    """Returns the text of each file."""
    homes = _homes()
    by_header: dict[str, list[Struct | Enum]] = {}
    for declared in [*declarations.enums.values(), *declarations.structs.values()]:
        if isinstance(declared, Struct) and declared.owners:
            homes[declared.name] = _home(declared.owners[-1], homes)
        by_header.setdefault(_home(declared.name, homes), []).append(declared)
    files = {}
    for header, declared in by_header.items():
        enums = [one for one in declared if isinstance(one, Enum)]
        structs = [one for one in declared if isinstance(one, Struct)]
        used = {_home(field.type, homes) for struct in structs for field in struct.fields if field.type and not field.is_custom}
        files[HEADERS / header] = formatted(_header(header, sorted(used - {header}), enums, structs))
        if structs:
            files[GENERATED / f"{Path(header).stem}.cpp"] = formatted(_source(header, structs, declarations.structs))
    return files


def _home(name: str, homes: dict[str, str]) -> str:
    outer = name.partition("::")[0]
    if outer not in homes:
        raise DeclarationError(f"no header of core/include/contactd defines {outer}")
    return homes[outer]


def _homes() -> dict[str, str]:
    """Returns the header of each struct and enum of core."""
    homes: dict[str, str] = {}
    for path in sorted(INCLUDE.glob("*.hpp")):
        for name in re.findall(r"^(?:struct|enum class|using) (\w+)(?: : [\w:, ]+)?(?: \{|;| =)", path.read_text(), re.MULTILINE):
            homes.setdefault(name, path.name)
    return homes


def _header(header: str, used: list[str], enums: list[Enum], structs: list[Struct]) -> str:
    includes = sorted(["contactd/fields.hpp", f"contactd/{header}", *(f"contactd/fields/{name}" for name in used)])
    lines = [NOTE, "#pragma once\n", *(f'#include "{name}"' for name in includes), "\nnamespace contactd {\n"]
    for enum in enums:
        words = ", ".join(f'"{word}"' for word in enum.keywords)
        lines += ["template <>", f"inline constexpr auto enum_words<{enum.name}> = std::to_array<std::string_view>({{{words}}});"]
        for value, word in enumerate(enum.keywords):
            lines.append(f"static_assert(static_cast<int>({enum.name}::{_enumerator(word)}) == {value});")
        lines.append("")
    for struct in structs:
        if _is_view(struct):
            lines += [f"/// Fields that are members of {' and of '.join(struct.owners)}.", f"template <class Owner>\nstruct {struct.name};"]
        lines += [f"template <>\nconst FieldType& type_of<{key}>();" for _, key in _owners(struct)]
    return "\n".join([*lines, "\n}  // namespace contactd\n"])


def _enumerator(word: str) -> str:
    """Returns the name of the enumerator with this word. A word that begins with a digit gets an n."""
    return f"n{word}" if word[0].isdigit() else RESERVED.get(word, word)


def _is_view(struct: Struct) -> bool:
    return bool(struct.owners) and struct.owners != (struct.name,)


def _owners(struct: Struct) -> list[tuple[str, str]]:
    """Returns the structs that own the fields, each with the type under which its list is found."""
    if not _is_view(struct):
        return [(struct.name, struct.name)]
    return [(owner, f"{struct.name}<{owner}>") for owner in struct.owners]


def _source(header: str, structs: list[Struct], all_structs: dict[str, Struct]) -> str:
    lines = [NOTE, f'#include "contactd/fields/{header}"\n', "#include <array>", "\nnamespace contactd {"]
    if whole := [struct for struct in structs if struct.is_whole]:
        lines += ["namespace {\n", "// A member that the schema does not declare makes the number of these names wrong."]
        for struct in whole:
            members = [field.name for field in struct.fields] + list(struct.other_members)
            names = ", ".join(f"{name}_" for name in members)
            lines += [f"[[maybe_unused]] void all_of(const {struct.name}& all) {{", f"[[maybe_unused]] const auto& [{names}] = all;", "}"]
        lines.append("\n}  // namespace\n")
    for struct in structs:
        for owner, key in _owners(struct):
            lines += ["template <>", f"const FieldType& type_of<{key}>() {{", "static const auto list = std::to_array<Field>({"]
            lines += [f"{_field(owner, struct, field, all_structs)}," for field in struct.fields]
            kind = "tuple" if struct.is_tuple else "object"
            lines += ["});", f"static const FieldType type = fields::{kind}_type(list);", "return type;", "}\n"]
    return "\n".join([*lines, "}  // namespace contactd\n"])


def _field(owner: str, struct: Struct, field: Field, structs: dict[str, Struct]) -> str:
    notes = ", ".join(_notes(field))
    end = f', {{{notes}}})' if notes else ")"
    of = structs.get(field.type or "")
    if of and _is_view(of):
        view = f"{of.name}<{owner}>"
        optional = (field.at or "").removesuffix("..").removesuffix("/")
        place = f"field_beside<{owner}, &{owner}::{optional}>" if optional else f"field_within<{owner}>"
        return f'fields::{place}("{field.name}", &type_of<{view}>)'
    kind = "custom_field" if field.is_custom else "field"
    if not struct.owners and field.at is None:
        return f'fields::{kind}<&{struct.name}::{field.name}>("{field.name}"{end}'
    steps = ", ".join([owner, *_steps(owner, field)])
    if field.is_custom and field.type:
        return f'fields::field_as<{steps}>("{field.name}", &custom_type<{field.type}>{end}'
    return f'fields::{kind}_along<{steps}>("{field.name}"{end}'


def _steps(owner: str, field: Field) -> list[str]:
    """Returns the path to the field's member, as template arguments."""
    steps, at = [], owner
    for step in (field.at or field.name).split("/"):
        if step.startswith("<"):
            at = step[1:-1]
            steps.append(f"fields::alternative<{at}>")
        else:
            steps.append(f"&{step}" if "::" in step else f"&{at}::{step}")
    return steps


def _notes(field: Field) -> list[str]:
    notes = []
    if field.bounds != Bounds():
        bounds = field.bounds
        ends = [f".{end} = {number_text(value)}" for end, value in [("least", bounds.least), ("most", bounds.most)] if value is not None]
        ends += [f".{end}_excluded = true" for end in ("least", "most") if getattr(bounds, f"{end}_excluded")]
        notes.append(f".bounds = {{{', '.join(ends)}}}")
    if field.none is not None:
        notes.append(f".none = {'std::numeric_limits<double>::infinity()' if field.none == 'infinity' else field.none}")
    if field.unit:
        notes.append(f'.unit = "{field.unit}"')
    if field.parity != "even":
        notes.append(f".parity = MirrorParity::{field.parity}")
    if field.required:
        notes.append(".required = true")
    return notes


def number_text(value: float) -> str:
    """Returns the number with the fewest digits that read back as the same value."""
    short = f"{value:.6g}"
    return short if float(short) == value else repr(value)


def formatted(text: str) -> str:
    command = ["clang-format", f"--style=file:{ROOT / '.clang-format'}"]
    return subprocess.run(command, input=text, capture_output=True, text=True, check=True).stdout
