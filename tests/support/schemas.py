"""Validates every message of the daemon against the JSON Schemas of proto/schema."""

from __future__ import annotations

import functools
import json
from pathlib import Path
from typing import Any

from jsonschema import Draft7Validator
from referencing import Registry
from referencing.jsonschema import DRAFT7

FOLDER = Path(__file__).parents[2] / "proto" / "schema"


@functools.cache
def _registry() -> Registry[Any]:
    documents = {path.name: json.loads(path.read_text()) for path in FOLDER.glob("*.json")}
    return Registry().with_resources((name, DRAFT7.create_resource(text)) for name, text in documents.items())


@functools.cache
def _validator(name: str) -> Draft7Validator:
    registry = _registry()
    schema = registry[f"{name}.json"].contents
    Draft7Validator.check_schema(schema)
    return Draft7Validator(schema, registry=registry)


def method_names() -> list[str]:
    return sorted(path.name.removesuffix(".params.json") for path in FOLDER.glob("*.params.json"))


def example(method: str) -> Any:
    """Returns the last request that the schema of the method shows."""
    return _registry()[f"{method}.params.json"].contents["examples"][-1]


def check(name: str, message: Any) -> None:
    """Fails with every place where `message` does not conform to proto/schema/<name>.json."""
    errors = [f"{error.json_path}: {error.message[:200]}" for error in _validator(name).iter_errors(message)]
    assert not errors, f"not as {name}.json says:\n" + "\n".join(errors)


def check_reply(method: str, envelope: dict[str, Any]) -> None:
    """Validates a whole answer: its envelope, and its result by the method's own schema."""
    check("reply", envelope)
    if envelope["status"]["code"] == 0:
        check(f"{method}.result", envelope["result"])
