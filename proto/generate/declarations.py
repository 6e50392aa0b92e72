"""Reads the declarations of proto/schema: structs with their fields, and enums with their keywords.

A schema of a C++ type gives the name of the type in `x-cpp`: a struct for an object, an enum for a list of words. Other types
with a name have a special form in messages, and so do objects none of whose fields has a name in C++.

`x-unit`      unit of a number
`x-parity`    odd: the sign of the value is reversed in the mirror image of a wheel
`x-fmu`       the role of a number or flag in FMUs: parameter, tunable, input or output; or an object:
               role, name, start, says  of its variable if name, start or description differ; {body} is upper or lower
               enumeration  of a list of words: the name of its enumeration;  name: its variable;  before, after: words
                            that only FMUs have
`x-derived`   a field that follows from others, and is not a member of the struct
`x-cpp-only`  members of the struct that are not fields
`x-cpp-at`    the path to the field's member, if its name differs from that of the field: members, members of other structs as
              Struct::name, and <Type> for an alternative of a variant, separated by slashes; "name/.." for an object whose
              fields are members of the struct itself, and which is present if the optional member `name` has a value
`x-cpp-items` for a list of a fixed number of values: the names of the struct's members
`x-cpp-list`  for an array: in C++ it is a list of structs of numbers
`x-cpp-none`  the value of a number's member that is omitted in messages: 0 or infinity
`x-cpp-owner` the structs that contain an object's fields, if the object is not a struct; x-cpp is then the name of a view
`x-partial`   an object with a selection of the fields of the given struct
`x-arrays-of` an object that refers to each array of the given document; ./dev generate adds the rows
`x-history`   an array that a step passes on to the next. An array other than tractions also has:
               if, enters  whether a friction law `law` keeps it, and its value for a particle `element` that enters the contact,
                           both as code in C++
               minimum, exclusiveMinimum  0, its bound
               fmu       up to two variables of FMUs, named by their paths, that are 0 where the law does not keep it
`x-only-with` JSON pointers to fields of the request: an answer has the array only if one of them is given and not false
`x-label`     the name and the unit of an array in data sets
`x-python`    a field in Python, if it is not a plain field:
               type      its type;  default: its default, both as code
               says      its description
               keys      an object that is a tuple in Python: the names of its items
               array     the name of the array that replaces the object
               flat      an object whose fields are fields of the class;  spread: so are the fields of these objects
               required  whether it is required, if this differs from the schema
`x-python-class` an object, or a list of words, in Python. An object of several classes has a list of these:
               name, description  of the class, if they differ from those in C++ and of the object; a list of paragraphs
               bases, dataclass, keywords, examples: the base classes, the arguments of the decorator, the name of the type of
                         the keyword arguments, and lines of code for the docstring
               public    the traceback of an error ends at the line that creates a value
               typed_dict  a dictionary instead of a dataclass
               fields, without  the fields of the object to include, or to exclude
               of_fields x-python of fields that differs in this class
               order, positional  the first fields, and the positional arguments of a class with keyword arguments
               adds      fields that the client sets, with their types and descriptions
               beside    the same, for fields that are next to the object in messages
               sends_defaults  omitted fields have the defaults of the schema, not None
               fixed     a field of messages with a constant value;  key: the object that contains all other fields
"""

from __future__ import annotations

import json
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any

Schema = dict[str, Any]
ROOT = Path(__file__).parents[2]
SCHEMAS = ROOT / "proto" / "schema"

_BOUNDS = {"minimum": ("least", False), "exclusiveMinimum": ("least", True), "maximum": ("most", False), "exclusiveMaximum": ("most", True)}


class DeclarationError(Exception):
    """Reports a declaration that contradicts another one or is not understood."""


@dataclass(frozen=True)
class Bounds:
    least: float | None = None
    most: float | None = None
    least_excluded: bool = False
    most_excluded: bool = False


@dataclass(frozen=True)
class Field:
    """Describes a member of a struct. `type` is the struct or enum of its value, as `x-cpp` names it, or None. `at` is
    the path to the member if that differs from the member with the field's name."""

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
    """Describes a struct and its fields. `owners` are the structs that own the fields if the fields form no separate
    struct. A tuple is a list on the wire."""

    name: str
    fields: tuple[Field, ...]
    other_members: tuple[str, ...] = ()
    owners: tuple[str, ...] = ()
    is_tuple: bool = False

    @property
    def is_whole(self) -> bool:
        """Returns whether every member of the struct is either a field or listed in `other_members`."""
        return not self.owners and all(field.at is None for field in self.fields)


@dataclass(frozen=True)
class Enum:
    name: str
    keywords: tuple[str, ...]


class Declarations:
    """All declarations in the documents of a folder, by the names of the types. `texts` replace those of files."""

    def __init__(self, folder: Path = SCHEMAS, texts: Mapping[Path, str] | None = None) -> None:
        self._documents: dict[str, Schema] = {
            path.name: json.loads((texts or {}).get(path) or path.read_text()) for path in sorted(folder.glob("*.json"))
        }
        self.structs: dict[str, Struct] = {}
        self.enums: dict[str, Enum] = {}
        self.schemas: dict[str, Schema] = {}  # one schema for each struct
        for document in self._documents.values():
            for schema in _all_schemas(document):
                if "x-cpp" in schema and "x-partial" not in schema:
                    self._declare(self.resolved(schema))

    def resolved(self, schema: Schema) -> Schema:
        """Returns the target of a reference merged with the keys beside the reference, which take precedence. Keys that
        apply to one place only are omitted."""
        if "$ref" not in schema:
            return schema
        file, _, pointer = schema["$ref"].partition("#")
        target: Any = self._documents[file]
        for step in filter(None, pointer.split("/")):
            target = target[step]
        there = {key: value for key, value in self.resolved(target).items() if key not in ("x-cpp-at", "x-derived", "x-fmu")}
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
    """Returns whether the value on the wire is neither a plain value nor an object with the fields of a struct."""
    if "x-cpp" in schema:
        return not {"enum", "const", "x-cpp-items"} & set(schema) and not _has_fields(schema)
    if "enum" in schema:
        return False
    return not _types(schema) or bool(_types(schema) - {"number", "integer", "boolean", "string"})


def _has_fields(schema: Schema) -> bool:
    """Returns whether the schema is an object with fields; the object of an array only refers to a frame."""
    return "properties" in schema and "$array" not in schema["properties"]


def _types(schema: Schema) -> set[str]:
    kind = schema.get("type", [])
    return {kind} if isinstance(kind, str) else set(kind)


def _all_schemas(value: Any) -> Iterator[Schema]:
    if isinstance(value, dict):
        yield value
    for part in value.values() if isinstance(value, dict) else value if isinstance(value, list) else ():
        yield from _all_schemas(part)
