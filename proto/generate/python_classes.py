"""Classes and lists of words that a module of Python has, as schemas declare them: fields with types, defaults and sentences."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from dataclasses import field as dataclass_field
from typing import Any

from .cpp import number_text
from .declarations import DeclarationError, Declarations, Schema
from .python_modules import Module

OF_FIELDS = {"type", "default", "keys", "flat", "required"}
OF_CLASSES = {"name", "description", "bases", "dataclass", "keywords", "examples", "adds", "sends_defaults"}
JSON_TYPES = {"number": "float", "integer": "int", "boolean": "bool", "string": "str"}


@dataclass(frozen=True)
class Member:
    """A field of a dataclass; `default` is code, and None of a field that must be given."""

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
    """Classes and keywords of a module, each behind those that it is made of."""

    def __init__(self, declarations: Declarations, module: Module) -> None:
        self._resolved = declarations.resolved
        schemas = [self._resolved({"$ref": root}) for root in module.roots]
        self.roots = {_name(schema): schema for schema in schemas}
        self.classes: dict[str, Class] = {}
        self.words: dict[str, tuple[str, ...]] = {}

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
        members = list(self._members(schema, options))
        members += [Member(added, f"{kind} | None", "None", says, {}) for added, (kind, says) in options.get("adds", {}).items()]
        members.sort(key=lambda member: member.default is not None)
        self.classes[name] = Class(name, schema, members)

    def _members(self, schema: Schema, options: Schema, within: str = "") -> Iterator[Member]:
        for name, given in schema["properties"].items():
            part = self._resolved(given)
            own = part.get("x-python", {})
            if unknown := (own.keys() - OF_FIELDS) | (options.keys() - OF_CLASSES):
                raise DeclarationError(f"{name} has {', '.join(sorted(unknown))} in Python, which nobody knows")
            if own.get("flat"):
                yield from self._members(part, options, name)
                continue
            kind = self._type_of_value(part)
            required = own.get("required", name in schema.get("required", [])) and not within
            default = None if required and "default" not in own else self._default(part, own, kind, options)
            if (default == "None" or "null" in _types(part)) and not kind.endswith("| None"):
                kind = f"{kind} | None"
            notes = {key: value for key, value in [("keys", own.get("keys")), ("within", within)] if value}
            yield Member(name, kind, default, _sentence(part, default), notes)

    def _default(self, schema: Schema, own: Schema, kind: str, options: Schema) -> str:
        if "default" in own:
            return str(own["default"])
        value = schema.get("default")
        if value is None or not options.get("sends_defaults"):
            return "None"
        if isinstance(value, dict):
            return f"{kind}()"
        return repr(float(value)) if kind == "float" else literal(value)

    def _type_of_value(self, schema: Schema) -> str:
        """The type of a value; what it declares is collected."""
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
    """What a class or a list of words is called: as in C++, or as the schema says."""
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


def _sentence(schema: Schema, default: str | None) -> str:
    """The description, with its unit, and what the daemon takes in place of None."""
    text = in_python(schema["description"])
    if unit := schema.get("x-unit"):
        end = r"(?=; |\. |\.$)" if text.startswith(("Of ", "Where ")) else r"(?=: |; |\. |\.$)"
        text = re.sub(end, f" ({unit})", text, count=1)
    if "enum" in schema and (schema.get("x-python", {}).get("type") or not {"x-cpp", "x-python-class"} & schema.keys()):
        text = f"{text} One of {', '.join(map(literal, schema['enum']))}."
    daemons = schema.get("default")
    if default == "None" and daemons is not None and not isinstance(daemons, (dict, list)):
        text = f"{text} Default {literal(daemons)}."
    return text


def in_python(text: str) -> str:
    return re.sub(r"\b(left out|Left out|null)\b", "None", text)
