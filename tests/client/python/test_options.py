"""Tests that the client has every option of influence coefficients, and every value of the answers, that the schemas
declare."""

import json
from collections.abc import Mapping
from dataclasses import KW_ONLY, fields
from pathlib import Path
from typing import Any, Literal, get_args, get_origin, get_type_hints

import pytest

from contactd import (
    AnalyticIcs,
    FemIcs,
    ImportedIc,
    Job,
    Layer,
    LayeredBody,
    Limits,
    Progress,
    QuarantinedIc,
    RecentPatch,
    RecentSolve,
    ServerInfo,
    SessionSummary,
    StoredIc,
)
from contactd.values.type_hints import hints_of

ROOT = Path(__file__).parents[3]
SCHEMA = json.loads((ROOT / "proto" / "schema" / "definitions.json").read_text())["definitions"]["ics"]
OPTIONS = {name: option for name, option in SCHEMA["properties"].items() if name != "source"}
FEM_OPTIONS = set(OPTIONS) - {"line_contact", "layers", "base"}  # of closed forms only
JSON_TYPES = {"integer": int, "number": float, "boolean": bool}


def kind_of(cls, name):
    """Returns the type of an option without its None."""
    (kind,) = [t for t in get_args(get_type_hints(cls)[name]) if t is not type(None)]
    return kind


def test_finite_elements_have_every_option_and_no_other():
    assert {field.name for field in fields(FemIcs)} == FEM_OPTIONS


@pytest.mark.parametrize("name", sorted(FEM_OPTIONS))
def test_an_option_has_the_type_of_the_schema(name):
    kind = kind_of(FemIcs, name)
    if name == "section":  # an object, as on the wire
        assert kind == Mapping[str, Any]
    elif "enum" in OPTIONS[name]:
        assert get_origin(kind) is Literal
        assert list(get_args(kind)) == [word for word in OPTIONS[name]["enum"] if word != "layered"]
    else:
        assert kind is JSON_TYPES[OPTIONS[name]["type"]]


def test_the_closed_form_has_the_options_that_go_with_it():
    (condition,) = [rule["then"] for rule in SCHEMA["allOf"] if "source" in rule["if"].get("properties", {})]
    names = {field.name for field in fields(AnalyticIcs)}
    of_layers = {field.name for field in fields(LayeredBody)}
    assert {"source", *names, *of_layers} == set(condition["propertyNames"]["enum"])
    assert {field.name for field in fields(Layer)} == set(OPTIONS["layers"]["items"]["properties"])
    assert list(get_args(kind_of(AnalyticIcs, "load_shape"))) == OPTIONS["load_shape"]["enum"]


@pytest.mark.parametrize("document", ["ic-tables.md", "protocol.md"])
def test_the_documentation_has_every_option_and_every_word(document):
    text = (ROOT / "docs" / document).read_text()
    for name, option in OPTIONS.items():
        for word in [name, *option.get("enum", [])]:
            assert f"`{word}`" in text, word


@pytest.mark.parametrize(
    ("kind", "schema", "place"),
    [
        (Limits, "server.info.result", "limits"),
        (ServerInfo, "server.info.result", ""),
        (Job, "job.list.result", "jobs"),
        (RecentSolve, "solves.recent.result", "solves"),
        (RecentPatch, "solves.pressures.result", "patches"),
        (StoredIc, "ic.list.result", "tables"),
        (QuarantinedIc, "ic.list.result", "quarantined"),
        (ImportedIc, "ic.import.result", ""),
        (SessionSummary, "session.list.result", "sessions"),
        (Progress, "progress", "progress"),
    ],
)
def test_an_answer_has_every_field_of_its_schema(kind, schema, place):
    document = json.loads((ROOT / "proto" / "schema" / f"{schema}.json").read_text())
    described = document["properties"][place] if place else document
    properties = described.get("items", described)["properties"]
    assert set(properties) <= {field.name for field in fields(kind)}


def test_fields_that_are_given_by_name_are_read_by_every_version_of_python():
    """Python 3.10 does not accept their mark as a type, and refuses the class."""
    assert KW_ONLY not in hints_of(FemIcs).values()
    assert hints_of(FemIcs).keys() >= {field.name for field in fields(FemIcs)}
