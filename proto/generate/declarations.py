"""The declarations of proto/schema: structs with their fields, and enums with their keywords.

A schema that stands for a type of C++ names it in `x-cpp`: an object a struct, a list of words an enum. What else is
named there has a form of its own on the wire, and so has an object with fields of which none is named.

`x-unit`     of a number
`x-parity`   odd: the mirror image of a wheel turns its sign
`x-fmu`      what a number is in FMUs: parameter, input or output
`x-derived`  a field that follows from others, and is no member of the struct
`x-cpp-only` members of the struct that are no fields
`x-partial`  an object that has some fields only of the struct that it names
"""

from __future__ import annotations

import json
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import Any

Schema = dict[str, Any]
ROOT = Path(__file__).parents[2]
SCHEMAS = ROOT / "proto" / "schema"

_BOUNDS = {"minimum": ("least", False), "exclusiveMinimum": ("least", True), "maximum": ("most", False), "exclusiveMaximum": ("most", True)}


class DeclarationError(Exception):
    """A declaration that does not go together with another one, or is not understood."""


@dataclass(frozen=True)
class Bounds:
    least: float | None = None
    most: float | None = None
    least_excluded: bool = False
    most_excluded: bool = False


@dataclass(frozen=True)
class Field:
    """A member of a struct. `type` is the struct or enum that it is made of, as `x-cpp` names it, or None."""

    name: str
    type: str | None
    is_custom: bool
    bounds: Bounds
    unit: str
    parity: str
    required: bool


@dataclass(frozen=True)
class Struct:
    name: str
    fields: tuple[Field, ...]
    other_members: tuple[str, ...]


@dataclass(frozen=True)
class Enum:
    name: str
    keywords: tuple[str, ...]


class Declarations:
    """All that the documents of a folder declare, by the names of the types."""

    def __init__(self, folder: Path = SCHEMAS) -> None:
        self._documents: dict[str, Schema] = {path.name: json.loads(path.read_text()) for path in sorted(folder.glob("*.json"))}
        self.structs: dict[str, Struct] = {}
        self.enums: dict[str, Enum] = {}
        for document in self._documents.values():
            for schema in _all_schemas(document):
                if "x-cpp" in schema and "x-partial" not in schema:
                    self._declare(self.resolved(schema))

    def resolved(self, schema: Schema) -> Schema:
        """What a reference leads to, with what stands beside it."""
        if "$ref" not in schema:
            return schema
        file, _, pointer = schema["$ref"].partition("#")
        target: Any = self._documents[file]
        for step in filter(None, pointer.split("/")):
            target = target[step]
        return {**self.resolved(target), **{key: value for key, value in schema.items() if key != "$ref"}}

    def _declare(self, schema: Schema) -> None:
        name = schema["x-cpp"]
        if "enum" in schema:
            found = Enum(name, tuple(word for word in schema["enum"] if word is not None))
            if self.enums.setdefault(name, found) != found:
                raise DeclarationError(f"{name} has the words {found.keywords} here and others there")
            return
        if "properties" not in schema:
            return
        properties = {field: self.resolved(part) for field, part in schema["properties"].items()}
        required = schema.get("required", [])
        fields = tuple(self._field(field, part, field in required) for field, part in properties.items() if "x-derived" not in part)
        struct = Struct(name, fields, tuple(schema.get("x-cpp-only", ())))
        if self.structs.setdefault(name, struct) != struct:
            raise DeclarationError(f"{name} is declared twice, and differently: {struct}, {self.structs[name]}")

    def _field(self, name: str, schema: Schema, required: bool) -> Field:
        is_list = "array" in _types(schema) and "x-cpp" not in schema
        value = self.resolved(schema.get("items") or {}) if is_list else schema
        bounds: dict[str, Any] = {}
        for key, (end, excluded) in _BOUNDS.items():
            if key in value and not is_list:
                bounds[end], bounds[f"{end}_excluded"] = value[key], excluded
        return Field(
            name,
            value.get("x-cpp"),
            _is_custom(value),
            Bounds(**bounds),
            schema.get("x-unit", ""),
            schema.get("x-parity", "even"),
            required,
        )


def _is_custom(schema: Schema) -> bool:
    """Whether a value has another form on the wire than that of a plain one, or of the fields of a struct."""
    if "x-cpp" in schema:
        return "enum" not in schema and "properties" not in schema
    return not _types(schema) or bool(_types(schema) - {"number", "integer", "boolean", "string"})


def _types(schema: Schema) -> set[str]:
    kind = schema.get("type", [])
    return {kind} if isinstance(kind, str) else set(kind)


def _all_schemas(value: Any) -> Iterator[Schema]:
    if isinstance(value, dict):
        yield value
    for part in value.values() if isinstance(value, dict) else value if isinstance(value, list) else ():
        yield from _all_schemas(part)
