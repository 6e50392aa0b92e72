"""Writes the method reference of docs/protocol.md from the OpenRPC document of the daemon; the text above it is kept.

    ./dev docs           (python3 docs/protocol_reference.py --bin build/development/bin)
"""

from __future__ import annotations

import argparse
import json
import textwrap
from pathlib import Path
from typing import Any

from contactd import LocalDaemon

PAGE = Path(__file__).with_name("protocol.md")
MARK = "<!-- The rest is written by ./dev docs from proto/schema: edit it there. -->\n"
SCHEMAS = "#/components/schemas/"
Schema = dict[str, Any]


class Reference:
    """Returns the page of one OpenRPC document."""

    def __init__(self, document: Schema) -> None:
        self.document = document
        self.schemas: Schema = document["components"]["schemas"]
        methods = {method["name"] for method in document["methods"]}
        messages = {f"{name}.{part}" for name in methods for part in ("params", "result")}
        #: Lists objects with fields that several messages share: they have separate sections.
        self.parts = {
            name: schema
            for name, schema in self.schemas.items()
            if name not in messages | {"envelope", "progress", "reply"} and schema.get("properties")
        }
        del self.parts["array"]  # The text above explains it.

    def text(self) -> str:
        sections = ["## Methods\n"]
        sections += [self.method(method) for method in self.document["methods"]]
        sections += ["## Messages\n"]
        sections += [self.message(name) for name in ("envelope", "progress", "reply")]
        sections += ["## Parts\n\nDefinitions that several messages have in common.\n"]
        sections += [
            f"### {name}\n\n{_paragraph(schema['description'])}\n{self.table(schema)}" for name, schema in self.parts.items()
        ]
        return "\n".join(sections)

    def method(self, method: Schema) -> str:
        name = method["name"]
        params, result = self.schemas[f"{name}.params"], self.schemas[f"{name}.result"]
        lines = [f"### `{name}`\n", _paragraph(method["summary"])]
        lines += [_indented(example) for example in params["examples"] if example]
        if params["properties"]:
            lines.append(self.table(params))
        lines.append(_paragraph(f"Result: {result['description']}"))
        lines += [_indented(example) for example in result["examples"] if len(json.dumps(example)) < 2000]
        lines.append(self.table(result))
        errors = [error["message"] for error in method["errors"]]
        lines.append(_paragraph(f"Errors: {', '.join(errors)}."))
        return "\n".join(lines)

    def message(self, name: str) -> str:
        schema = self.schemas[name]
        examples = "\n".join(_indented(example) for example in schema["examples"])
        return f"### {name}\n\n{_paragraph(schema['description'])}\n{examples}\n{self.table(schema)}"

    def table(self, schema: Schema) -> str:
        rows = [
            f"| `{path}` | {self.kind(field)} | {_cell(self.meaning(field))} | {_default(field, required)} |"
            for path, field, required in self.fields(schema, "", outermost=True)
        ]
        return "\n".join(["| field | value | meaning | default |", "|---|---|---|---|", *rows]) + "\n"

    def fields(self, schema: Schema, path: str, outermost: bool) -> list[tuple[str, Schema, bool]]:
        found = []
        required = schema.get("required", [])
        for name, given in sorted(schema.get("properties", {}).items(), key=lambda item: item[0] not in required):
            field, place = self.resolved(given), f"{path}{name}"
            found.append((place, field, name in required))
            if field.get("part"):
                continue
            if field.get("properties") and "$array" not in field["properties"]:
                found += self.fields(field, f"{place}.", outermost=False)
            items = self.resolved(field.get("items") or {})
            if items.get("properties") and not items.get("part"):
                found += self.fields(items, f"{place}[].", outermost=False)
        return found

    def resolved(self, schema: Schema) -> Schema:
        """Resolves a reference, including the fields beside it; `part` names a section to search."""
        if "$ref" not in schema:
            return schema
        target: Any = self.schemas
        steps = schema["$ref"].removeprefix(SCHEMAS).split("/")
        for step in steps:
            target = target[step]
        words = {key: value for key, value in schema.items() if key != "$ref"}
        named = {"part": steps[0]} if len(steps) == 1 and (steps[0] in self.parts or steps[0] in self.schemas) else {}
        if steps[0] == "array" or not target.get("properties"):
            named = {}
        return {**self.resolved(target), **named, **words}

    def kind(self, field: Schema) -> str:
        if part := field.get("part"):
            return f"[{part}](#{_anchor(part)})" if part in self.parts else f"as of `{part.removesuffix('.params')}`"
        if "$array" in field.get("properties", {}):
            return "number or array" if "number" in field["type"] else "array"
        if "const" in field:
            return f"`{json.dumps(field['const'])}`"
        if "enum" in field:
            return ", ".join(f"`{word}`" for word in field["enum"])
        kinds = field["type"] if isinstance(field.get("type"), list) else [field.get("type", "any")]
        words = " or ".join({"array": "list"}.get(kind, kind) for kind in kinds)
        if items := field.get("items"):
            inner = self.resolved(items)
            words += " of " + (self.kind(inner) if inner.get("part") or "enum" in inner else str(inner["type"]))
        return words + _bounds(field)

    def meaning(self, field: Schema) -> str:
        words: str = field.get("description", "")
        for rule in ("oneOf", "anyOf"):
            if names := [choice["required"][0] for choice in field.get(rule, []) if "required" in choice]:
                words += f" {'Exactly' if rule == 'oneOf' else 'At least'} one of {', '.join(names)}."
        return words


def _bounds(field: Schema) -> str:
    """Returns the unit and the bounds of a value."""
    rules = [
        (f"{sign} {field[key]:g}" if abs(field[key]) >= 1e6 else f"{sign} {field[key]}")
        for key, sign in [("minimum", ">="), ("exclusiveMinimum", ">"), ("maximum", "<="), ("exclusiveMaximum", "<")]
        if key in field
    ]
    for least, most, unit in [("minLength", "maxLength", "characters"), ("minItems", "maxItems", "values")]:
        if least in field or most in field:
            low, high = field.get(least, 0), field.get(most, "")
            words = f"{low} or more" if high == "" else f"{low}" if low == high else f"{low} to {high}" if low else f"up to {high}"
            rules.append(f"{words} {unit}")
    return (f" ({field['x-unit']})" if "x-unit" in field else "") + (f", {', '.join(rules)}" if rules else "")


def _default(field: Schema, required: bool) -> str:
    if required:
        return "required"
    return f"`{json.dumps(field['default'])}`" if "default" in field else ""


def _cell(text: str) -> str:
    return text.replace("|", "\\|")


def _anchor(name: str) -> str:
    return name.lower()


def _paragraph(text: str) -> str:
    """Wraps text to lines of at most 110 characters."""
    return textwrap.fill(text, 110, break_long_words=False, break_on_hyphens=False) + "\n"


def _indented(example: Any) -> str:
    """Returns JSON in lines of at most 110 characters."""
    return "\n".join("    " + line for line in _lines(example)) + "\n"


def _lines(value: Any, before: str = "", indent: str = "") -> list[str]:
    short = indent + before + json.dumps(value)
    if len(short) <= 110 or not isinstance(value, (dict, list)) or not value:
        return [short]
    inner = indent + " "
    entries = value.items() if isinstance(value, dict) else (("", entry) for entry in value)
    blocks = [_lines(entry, f"{json.dumps(key)}: " if isinstance(value, dict) else "", inner) for key, entry in entries]
    lines = [line + ("," if line is block[-1] and block is not blocks[-1] else "") for block in blocks for line in block]
    first, last = ("{", "}") if isinstance(value, dict) else ("[", "]")
    return [indent + before + first + lines[0].lstrip(), *lines[1:-1], lines[-1] + last] if len(lines) > 1 else [short]


def page(document: Schema, current: str) -> str:
    """Returns the whole page: the text above the mark, and the reference."""
    above, mark, _ = current.partition(MARK)
    if not mark:
        raise SystemExit(f"{PAGE} lacks the line that marks the start of the reference:\n{MARK}")
    return above + MARK + "\n" + Reference(document).text()


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--bin", type=Path, required=True, help="folder with contactd")
    options = parser.parse_args()
    with LocalDaemon(options.bin / "contactd") as daemon, daemon.client() as client:
        document = client.describe()
    PAGE.write_text(page(document, PAGE.read_text()))
    print(f"{PAGE}: {len(document['methods'])} methods")


if __name__ == "__main__":
    main()
