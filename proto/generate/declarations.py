"""The declarations of proto/schema: structs with their fields, and enums with their keywords.

A schema that stands for a type of C++ names it in `x-cpp`: an object a struct, a list of words an enum. A number has
its unit in `x-unit`, and in `x-parity` whether the mirror image of a wheel turns its sign.
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


@dataclass(frozen=True)
class Struct:
    name: str
    fields: tuple[Field, ...]


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
                if "x-cpp" in schema:
                    self._declare(self.resolved(schema))

    def resolved(self, schema: Schema) -> Schema:
        """What a reference leads to, with what stands beside it."""
        if "$ref" not in schema:
            return schema
        file, _, pointer = schema["$ref"].partition("#/")
        target: Any = self._documents[file]
        for step in pointer.split("/"):
            target = target[step]
        return {**self.resolved(target), **{key: value for key, value in schema.items() if key != "$ref"}}

    def _declare(self, schema: Schema) -> None:
        name = schema["x-cpp"]
        if "enum" in schema:
            found = Enum(name, tuple(word for word in schema["enum"] if word is not None))
            if self.enums.setdefault(name, found) != found:
                raise DeclarationError(f"{name} has the words {found.keywords} here and others there")
            return
        fields = tuple(self._field(field, self.resolved(part)) for field, part in schema["properties"].items())
        struct = Struct(name, fields)
        if self.structs.setdefault(name, struct) != struct:
            raise DeclarationError(f"{name} is declared twice, and differently: {struct}, {self.structs[name]}")

    def _field(self, name: str, schema: Schema) -> Field:
        items = self.resolved(schema.get("items") or {}) if "array" in _types(schema) else {}
        named = schema if "x-cpp" in schema else items
        is_plain = bool(_types(schema) & {"number", "integer", "boolean", "string"}) and not schema.get("properties")
        bounds: dict[str, Any] = {}
        for key, (end, excluded) in _BOUNDS.items():
            if key in schema and not items:
                bounds[end], bounds[f"{end}_excluded"] = schema[key], excluded
        is_custom = "x-cpp" not in named and not is_plain
        return Field(name, named.get("x-cpp"), is_custom, Bounds(**bounds), schema.get("x-unit", ""), schema.get("x-parity", "even"))


def _types(schema: Schema) -> set[str]:
    kind = schema.get("type", [])
    return {kind} if isinstance(kind, str) else set(kind)


def _all_schemas(value: Any) -> Iterator[Schema]:
    if isinstance(value, dict):
        yield value
    for part in value.values() if isinstance(value, dict) else value if isinstance(value, list) else ():
        yield from _all_schemas(part)
