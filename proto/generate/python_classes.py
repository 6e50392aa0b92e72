"""Collects the classes and keywords of a module of Python from the schemas: fields with types, defaults and sentences."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from dataclasses import field as dataclass_field
from typing import Any

from .cpp import number_text
from .declarations import DeclarationError, Declarations, Schema
from .python_modules import Module

OF_FIELDS = {"type", "default", "keys", "array", "flat", "spread", "required", "says"}
OF_CLASSES = {
    "name", "description", "bases", "dataclass", "public", "keywords", "typed_dict", "examples", "adds", "sends_defaults",
    "beside", "fields", "without", "of_fields", "order", "positional", "key", "fixed",
}  # fmt: skip
BOUNDS = {"minimum": ">=", "exclusiveMinimum": ">", "maximum": "<=", "exclusiveMaximum": "<"}
MEANT_BY_NOBODY = 1000
JSON_TYPES = {"number": "float", "integer": "int", "boolean": "bool", "string": "str"}


@dataclass(frozen=True)
class Member:
    """Describes a field of a dataclass. `default` is code, or None for a required field."""

    name: str
    type: str
    default: str | None
    says: str
    notes: dict[str, Any]


@dataclass
class Class:
    name: str
    schema: Schema
    members: list[Member] = dataclass_field(default_factory=list)


class Collected:
    """Generates the classes and keywords of a module, each after those that it uses."""

    def __init__(self, declarations: Declarations, module: Module) -> None:
        self._resolved = declarations.resolved
        self._says_ranges = module.is_asked
        schemas = [self._root(root) for root in module.roots]
        self.roots = {_name(schema): schema for schema in schemas}
        self.classes: dict[str, Class] = {}
        self.words: dict[str, tuple[str, ...]] = {}

    def _root(self, root: str) -> Schema:
        """Returns the schema at a pointer. For a schema with several classes, the name of one follows the pointer."""
        pointer, _, name = root.partition(" ")
        schema = self._resolved({"$ref": pointer})
        if not name:
            return schema
        (options,) = [options for options in schema["x-python-class"] if options["name"] == name]
        return {**schema, "x-python-class": options}

    def collect(self, is_mine: Callable[[str], bool]) -> None:
        self._is_mine = is_mine
        for schema in self.roots.values():
            if "enum" in schema:
                self._type_of_words(schema)
            else:
                self._declare(schema)

    def _declare(self, schema: Schema) -> None:
        name = _name(schema)
        if not self._is_mine(name) or name in self.classes:
            return
        schema = self.roots.get(name, schema)
        options = schema.get("x-python-class", {})
        members = {member.name: member for member in self._members(schema, options)}
        for added, (kind, says) in options.get("adds", {}).items():
            members[added] = Member(added, f"{kind} | None", "None", says, {})
        for named, (kind, says) in options.get("beside", {}).items():
            members[named] = Member(named, kind, None, says, {})
        order = {member: place for place, member in enumerate(options.get("order", ()))}
        if lacking := {*options.get("positional", ()), *order} - members.keys():
            raise DeclarationError(f"{name} has no {', '.join(sorted(lacking))}, which x-python-class names")
        listed = sorted(members.values(), key=lambda member: (member.default is not None, order.get(member.name, len(order))))
        self.classes[name] = Class(name, schema, listed)

    def _members(self, schema: Schema, options: Schema, within: str = "", is_there: bool = True) -> Iterator[Member]:
        """Yields the fields. `within` is the object of the wire that contains them and is not a field of the class."""
        properties = schema.get("properties", {})
        chosen = properties if within else options.get("fields", properties)
        for name in chosen:
            part = self._resolved(properties[name])
            own = {**part.get("x-python", {}), **options.get("of_fields", {}).get(name, {})}
            if unknown := (own.keys() - OF_FIELDS) | (options.keys() - OF_CLASSES):
                raise DeclarationError(f"{name} has {', '.join(sorted(unknown))} in Python, which are unknown")
            if name in options.get("without", ()):
                continue
            part = {**part, "x-python": own}
            if own.get("flat") or own.get("spread"):
                yield from self._members(part, options, name, name in schema.get("required", ()))
                if own.get("flat"):
                    continue
            kind = self._type_of_value(part)
            required = own.get("required", name in schema.get("required", ()) and is_there)
            default = None if required and "default" not in own else self._default(part, own, kind, options)
            if (default == "None" or "null" in _types(part)) and not kind.endswith("| None"):
                kind = f"{kind} | None"
            notes = {key: value for key, value in [("keys", own.get("keys")), ("within", within)] if value}
            if own.get("array") or kind.startswith("npt.ArrayLike"):
                notes["array"] = own.get("array", "")
            says = own["says"] if "says" in own else _sentence(part, default, self._says_ranges)
            yield Member(name, kind, default, says, notes)

    def _default(self, schema: Schema, own: Schema, kind: str, options: Schema) -> str:
        if "default" in own:
            return str(own["default"])
        value = schema.get("default")
        if value is None or not options.get("sends_defaults"):
            return "None"
        if isinstance(value, dict):
            return f"{kind}()"
        if isinstance(value, list):
            return f"({', '.join(repr(float(item)) for item in value)})"
        return repr(float(value)) if kind == "float" else literal(value)

    def _type_of_value(self, schema: Schema) -> str:
        """Returns the type of a value, and collects the classes that it uses."""
        if "type" in schema.get("x-python", {}):
            return str(schema["x-python"]["type"])
        if "enum" in schema:
            return self._type_of_words(schema)
        if "properties" in schema and "object" in _types(schema) and "array" not in _types(schema):
            self._declare(schema)
            return _name(schema)
        if "items" in schema:
            items = self._resolved(schema["items"])
            kind = self._type_of_value(items)
            pair = schema.get("minItems") == schema.get("maxItems") == 2
            return f"tuple[{kind}, {kind}]" if pair else f"tuple[{kind}, ...]"
        (json_type,) = _types(schema) - {"null"}
        return JSON_TYPES[json_type] + (" | None" if "null" in _types(schema) else "")

    def _type_of_words(self, schema: Schema) -> str:
        if "x-cpp" not in schema and "x-python-class" not in schema:
            return "str"
        name = _name(schema)
        if self._is_mine(name):
            self.words.setdefault(name, tuple(word for word in schema["enum"] if word is not None))
        return name


def _name(schema: Schema) -> str:
    """Returns the name of a class or of a list of keywords: that of C++, unless the schema gives another one."""
    own = schema.get("x-python-class", {})
    if not {"x-cpp", "x-python-class"} & schema.keys():
        raise DeclarationError(f"an object lacks x-python-class, the class that it is in Python: {schema.get('description')}")
    return str(own.get("name") or schema["x-cpp"].rpartition("::")[2])


def _types(schema: Schema) -> set[str]:
    kind = schema.get("type", [])
    return {kind} if isinstance(kind, str) else set(kind)


def literal(value: Any) -> str:
    if isinstance(value, str):
        return f'"{value}"'
    return number_text(value) if isinstance(value, (int, float)) and not isinstance(value, bool) else repr(value)


def in_code(value: Any) -> str:
    """Returns a JSON value as Python code, with lists as tuples."""
    if isinstance(value, dict):
        return "{" + ", ".join(f"{literal(key)}: {in_code(item)}" for key, item in value.items()) + "}"
    return f"({', '.join(map(literal, value))})" if isinstance(value, list) else literal(value)


def _sentence(schema: Schema, default: str | None, says_range: bool) -> str:
    """Returns the description with its unit, its range and, if None is the default in Python, the daemon's default."""
    text = in_python(schema["description"])
    unit, bounds = schema.get("x-unit"), _range(schema) if says_range else ""
    if unit or bounds:
        notes = f"({unit}), {bounds}" if unit and bounds else f"({unit or bounds})"
        ends = re.finditer(r"; |\. |\.$" if text.startswith(("Of ", "Where ")) else r": |; |\. |\.$", text)
        first = next(end.start() for end in ends if text.count("(", 0, end.start()) == text.count(")", 0, end.start()))
        text = f"{text[:first]} {notes}{text[first:]}"
    if "enum" in schema and (schema.get("x-python", {}).get("type") or not {"x-cpp", "x-python-class"} & schema.keys()):
        text = f"{text} One of {', '.join(map(literal, schema['enum']))}."
    daemons = schema.get("default")
    if default == "None" and daemons is not None and not isinstance(daemons, dict):
        text = f"{text} Default {in_code(daemons)}."
    return text


def _range(schema: Schema) -> str:
    """Returns bounds that are useful to state. Others only exclude absurd values, or exclude negative counts."""
    found = {key: schema[key] for key in BOUNDS if abs(schema.get(key, MEANT_BY_NOBODY)) < MEANT_BY_NOBODY}
    if {*found} == {"minimum", "maximum"}:
        return f"{found['minimum']:g} to {found['maximum']:g}"
    if "number" not in _types(schema):
        return ""
    return ", ".join(f"{BOUNDS[key]} {value:g}" for key, value in found.items())


def in_python(text: str) -> str:
    return re.sub(r"\b(left out|Left out|omitted|Omitted|null)\b", "None", text)
