"""Tests that omitted fields have the defaults of the schemas, in requests and in docstrings."""

import inspect
import json
import re
from dataclasses import MISSING, fields
from pathlib import Path

import pytest

import contactd
from contactd import wheel_rail

SCHEMAS = Path(__file__).parents[3] / "proto" / "schema"


def properties(document, *path):
    node = json.loads((SCHEMAS / f"{document}.json").read_text())
    for name in path:
        node = node[name]
    return node["properties"]


DEFINITIONS = ("definitions", "definitions")
SETUP = (*DEFINITIONS, "wheel_rail_setup")
STATE = (*DEFINITIONS, "wheel_rail_state", "properties")
PLACES = [
    (wheel_rail.WheelRailSetup, SETUP),
    (wheel_rail.WheelRailFriction, (*DEFINITIONS, "wheel_rail_friction")),
    (wheel_rail.Track, (*SETUP, "properties", "track")),
    (wheel_rail.Wheelset, (*SETUP, "properties", "wheelset")),
    (wheel_rail.PatchRules, (*SETUP, "properties", "patches")),
    (wheel_rail.WheelsetPosition, (*STATE, "position")),
    (wheel_rail.WheelsetVelocity, (*STATE, "velocity")),
    (wheel_rail.RailDeviation, (*STATE, "rail")),
    (wheel_rail.Rail60E1, (*DEFINITIONS, "profile", "properties", "rail_60e1")),
    (wheel_rail.StandardProfile, (*DEFINITIONS, "profile", "properties", "standard")),
    (wheel_rail.ArcProfile, (*DEFINITIONS, "profile", "properties", "arc")),
    (wheel_rail.ProfilePoints, (*DEFINITIONS, "profile")),
    (wheel_rail.ProfileFile, (*DEFINITIONS, "profile", "properties", "file")),
    (wheel_rail.KinkRule, (*DEFINITIONS, "profile", "properties", "file", "properties", "kinks")),
    (contactd.Rolling, (*DEFINITIONS, "rolling")),
    (contactd.Friction, ("contact.solve.params", "properties", "friction")),
    (contactd.KineticFriction, ("contact.solve.params", "properties", "friction", "properties", "kinetic")),
    (contactd.ContactProblem, ("contact.solve.params",)),
    (contactd.FemIcs, (*DEFINITIONS, "ics")),
    (contactd.AnalyticIcs, (*DEFINITIONS, "ics")),
]
IN_WORDS = {"pi/2": 1.5707963267948966, "zero": 0, "one": 1}


def stated(text):
    """Returns the default that a sentence of a docstring states as a number or a word, or None."""
    if found := re.search(r'"(\w+)"[^";]{0,40}\(default\b|[Dd]efault:? "(\w+)"', text):
        return found[1] or found[2]
    if found := re.search(r"(-?\d[\d.e-]*) \(default\)|[Dd]efault:? (-?\d[\d.e-]*\d|-?\d|pi/2)", text):
        said = found[1] or found[2]
        return IN_WORDS[said] if said in IN_WORDS else float(said)
    return None


def sentences(cls):
    """Returns the description of each attribute in the docstring."""
    text = inspect.getdoc(cls).partition("Attributes:\n")[2]
    return {name: re.sub(r"\s+", " ", said) for name, said in re.findall(r"^ {4}(\w+): ((?:.+\n?(?: {8}.*\n?)*))", text, re.MULTILINE)}


def test_sentences_are_read():
    assert stated(sentences(wheel_rail.Track)["gauge"]) == 1435
    assert stated(sentences(wheel_rail.PatchRules)["search"]) == "locus"
    assert stated(sentences(wheel_rail.WheelRailSetup)["side"]) == "right"
    assert stated(sentences(wheel_rail.WheelRailSetup)["friction"]) == 0.3
    assert stated(sentences(wheel_rail.Track)["springs"]) is None


@pytest.mark.parametrize(("cls", "place"), PLACES, ids=[cls.__name__ for cls, _ in PLACES])
def test_defaults_are_those_of_the_schema(cls, place):
    declared, said = properties(*place), sentences(cls)
    compared = 0
    for field in fields(cls):
        default = declared.get(field.name, {}).get("default")
        if isinstance(default, (dict, type(None))) and field.name != "friction":
            continue
        if isinstance(default, dict):
            default = default["mu"]
        if isinstance(value := field.default, (int, float, str)) and value is not MISSING:
            assert value == default, field.name
            compared += 1
        if (sentence := stated(said.get(field.name, ""))) is not None:
            assert sentence == default, field.name
            compared += 1
    assert compared, "nothing was compared"
