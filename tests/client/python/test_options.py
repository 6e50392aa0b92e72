"""The client's influence coefficients have every option of the schema, with the words it knows."""

import json
from dataclasses import fields
from pathlib import Path
from typing import Literal, get_args, get_origin, get_type_hints

import pytest

from contactd import AnalyticIcs, FemIcs

ROOT = Path(__file__).parents[3]
SCHEMA = json.loads((ROOT / "proto" / "schema" / "definitions.json").read_text())["definitions"]["ics"]
OPTIONS = {name: option for name, option in SCHEMA["properties"].items() if name != "source"}
JSON_TYPES = {"integer": int, "number": float, "boolean": bool}


def kind_of(cls, name):
    """The type of an option without its None."""
    (kind,) = [t for t in get_args(get_type_hints(cls)[name]) if t is not type(None)]
    return kind


def test_finite_elements_have_every_option_and_no_other():
    assert {field.name for field in fields(FemIcs)} == set(OPTIONS)


@pytest.mark.parametrize("name", OPTIONS)
def test_an_option_has_the_type_of_the_schema(name):
    kind = kind_of(FemIcs, name)
    if "enum" in OPTIONS[name]:
        assert get_origin(kind) is Literal
        assert list(get_args(kind)) == OPTIONS[name]["enum"]
    else:
        assert kind is JSON_TYPES[OPTIONS[name]["type"]]


def test_the_closed_form_has_the_options_that_go_with_it():
    (condition,) = [rule["then"] for rule in SCHEMA["allOf"] if "source" in rule["if"].get("properties", {})]
    names = {field.name for field in fields(AnalyticIcs)}
    assert {"source", *names} == set(condition["propertyNames"]["enum"])
    assert list(get_args(kind_of(AnalyticIcs, "load_shape"))) == OPTIONS["load_shape"]["enum"]


@pytest.mark.parametrize("document", ["ic-tables.md", "protocol.md"])
def test_the_documentation_has_every_option_and_every_word(document):
    text = (ROOT / "docs" / document).read_text()
    for name, option in OPTIONS.items():
        for word in [name, *option.get("enum", [])]:
            assert f"`{word}`" in text, word
