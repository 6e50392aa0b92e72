"""The declarations of proto/schema: structs with their fields, and enums with their keywords.

A schema that stands for a type of C++ names it in `x-cpp`: an object a struct, a list of words an enum. What else is
named there has a form of its own on the wire, and so has an object with fields of which none is named.

`x-unit`      of a number
`x-parity`    odd: the mirror image of a wheel turns its sign
`x-fmu`       what a number is in FMUs: parameter, input or output
`x-derived`   a field that follows from others, and is no member of the struct
`x-cpp-only`  members of the struct that are no fields
`x-cpp-at`    the way to a field's member where that is not the member of its name: members, of other structs as
              Struct::name, and <Type> for an alternative of a variant, with slashes; "name/.." for an object whose fields are members of the struct
              itself, and which is there while the optional member `name` is
`x-cpp-items` of a list of so many numbers, the names of the struct's members
`x-cpp-list`  of an array, that C++ has it as a list of structs of numbers
`x-cpp-none`  the value of a number's member that the wire leaves out: 0 or infinity
`x-cpp-owner` the structs that have an object's fields, where it is not a struct of its own; x-cpp names a view, then
`x-partial`   an object that has some fields only of the struct that it names
`x-python`    a field in Python, where that is not plain:
               type      its type;  default: its default, both as code
               says      its sentence
               keys      an object that is a tuple there: the names of its parts
               array     the name that an array has in the object in whose place it stands
               flat      an object whose fields are those of the class around it;  spread: these, too
               required  whether it must be there, where it differs
`x-python-class` an object, or a list of words, in Python. An object that is several classes has a list of these:
               name, description  of the class, where they are not that of C++ and that of the object; a list of paragraphs
               bases, dataclass, keywords, examples: its bases, the arguments of the decorator, the name of the typed keyword
                         arguments, and lines of code that its docstring shows
               public    refusals end at the line that makes a value;  typed_dict: a dictionary instead of a dataclass
               fields, without  those of the object that it has, or has not
               of_fields x-python of fields that are otherwise in this class
               order, positional  the fields that come first, and those that are given by place in a class of keywords
               adds      fields that the client fills in, with their types and sentences
               beside    fields that the class has and that stand beside the object on the wire, likewise
               sends_defaults  fields that are left out have the defaults of the schema, not None
               fixed     a field of the wire and the value that it always has;  key: the object in which all others are
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
    """A member of a struct. `type` is the struct or enum that it is made of, as `x-cpp` names it, or None; `at` the way
    to the member, where that is not the one of its name."""

    name: str
    type: str | None
    is_custom: bool
    at: str | None
    none: float | str | None
    bounds: Bounds
    unit: str
    parity: str
    required: bool


@dataclass(frozen=True)
class Struct:
    """`owners` are the structs that have the fields, where these are not a struct of their own. The wire has a tuple as
    the list of its fields."""

    name: str
    fields: tuple[Field, ...]
    other_members: tuple[str, ...] = ()
    owners: tuple[str, ...] = ()
    is_tuple: bool = False

    @property
    def is_whole(self) -> bool:
        """Whether every member of a struct of this name is a field, or named as none."""
        return not self.owners and all(field.at is None for field in self.fields)


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
        self.schemas: dict[str, Schema] = {}  # of the structs, one for each
        for document in self._documents.values():
            for schema in _all_schemas(document):
                if "x-cpp" in schema and "x-partial" not in schema:
                    self._declare(self.resolved(schema))

    def resolved(self, schema: Schema) -> Schema:
        """What a reference leads to, with what stands beside it, without what is so at one place only."""
        if "$ref" not in schema:
            return schema
        file, _, pointer = schema["$ref"].partition("#")
        target: Any = self._documents[file]
        for step in filter(None, pointer.split("/")):
            target = target[step]
        there = {key: value for key, value in self.resolved(target).items() if key not in ("x-cpp-at", "x-derived")}
        return {**there, **{key: value for key, value in schema.items() if key != "$ref"}}

    def _declare(self, schema: Schema) -> None:
        name = schema["x-cpp"]
        if "enum" in schema:
            found = Enum(name, tuple(word for word in schema["enum"] if word is not None))
            if self.enums.setdefault(name, found) != found:
                raise DeclarationError(f"{name} has the words {found.keywords} here and others there")
            return
        if "x-cpp-items" in schema:
            fields = tuple(self._field(field, schema["items"], False) for field in schema["x-cpp-items"])
            self._add(Struct(name, fields, owners=tuple(schema.get("x-cpp-owner", ())), is_tuple=True))
        if not _has_fields(schema):
            return
        properties = {field: self.resolved(part) for field, part in schema["properties"].items()}
        required = schema.get("required", [])
        fields = tuple(self._field(field, part, field in required) for field, part in properties.items() if "x-derived" not in part)
        self.schemas.setdefault(name, schema)
        self._add(Struct(name, fields, tuple(schema.get("x-cpp-only", ())), tuple(schema.get("x-cpp-owner", ()))))

    def _add(self, struct: Struct) -> None:
        if self.structs.setdefault(struct.name, struct) != struct:
            raise DeclarationError(f"{struct.name} is declared twice, and differently: {struct}, {self.structs[struct.name]}")

    def _field(self, name: str, schema: Schema, required: bool) -> Field:
        is_list = "array" in _types(schema) and "x-cpp" not in schema
        value = self.resolved(schema.get("items") or {}) if is_list else schema
        bounds: dict[str, Any] = {}
        for key, (end, excluded) in _BOUNDS.items():
            if key in value and not is_list:
                bounds[end], bounds[f"{end}_excluded"] = value[key], excluded
        if value.get("const") is True:
            bounds = {"least": 1, "most": 1}
        return Field(
            name,
            value.get("x-cpp"),
            "x-cpp-list" not in schema and is_custom(value),
            schema.get("x-cpp-at"),
            schema.get("x-cpp-none"),
            Bounds(**bounds),
            schema.get("x-unit", ""),
            schema.get("x-parity", "even"),
            required,
        )


def is_custom(schema: Schema) -> bool:
    """Whether a value has another form on the wire than that of a plain one, or of the fields of a struct."""
    if "x-cpp" in schema:
        return not {"enum", "const", "x-cpp-items"} & set(schema) and not _has_fields(schema)
    if "enum" in schema:
        return False
    return not _types(schema) or bool(_types(schema) - {"number", "integer", "boolean", "string"})


def _has_fields(schema: Schema) -> bool:
    """Returns whether it is an object of fields; that of an array refers to a frame."""
    return "properties" in schema and "$array" not in schema["properties"]


def _types(schema: Schema) -> set[str]:
    kind = schema.get("type", [])
    return {kind} if isinstance(kind, str) else set(kind)


def _all_schemas(value: Any) -> Iterator[Schema]:
    if isinstance(value, dict):
        yield value
    for part in value.values() if isinstance(value, dict) else value if isinstance(value, list) else ():
        yield from _all_schemas(part)
