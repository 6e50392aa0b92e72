"""Tests the wire format of friction, and that it has every option of the schema."""

import json
from dataclasses import fields
from pathlib import Path
from typing import Literal, get_args, get_origin, get_type_hints

import numpy as np
import pytest

from contactd import Friction, KineticFriction, Rolling, Shift
from contactd.values.generated.evidence import Model
from contactd.values.generated.problem import ContactProblem

FOLDER = Path(__file__).parents[3] / "proto" / "schema"
PROBLEM = json.loads((FOLDER / "contact.solve.params.json").read_text())["properties"]
FRICTION = PROBLEM["friction"]["properties"]
ROLLING = json.loads((FOLDER / "definitions.json").read_text())["definitions"]["rolling"]["properties"]
MOTION = json.loads((FOLDER / "contact.solve.result.json").read_text())["properties"]["motion"]["properties"]


def names(kind):
    return {field.name for field in fields(kind)}


def words(kind, name):
    hint = get_type_hints(kind)[name]
    (literal,) = [t for t in (hint, *get_args(hint)) if get_origin(t) is Literal]
    return list(get_args(literal))


def test_friction_and_problem_have_every_option_and_no_other():
    assert names(Friction) == set(FRICTION)
    assert names(KineticFriction) == set(FRICTION["kinetic"]["properties"])
    assert names(Rolling) == set(ROLLING)
    assert names(Shift) | names(Rolling) == set(MOTION)
    other_names = {"upper", "lower", "upper_ics", "lower_ics", "normal", "tangential", "outer"}
    assert names(ContactProblem) - other_names == set(PROBLEM) - {"bodies", "settings", "fields"}


def test_the_words_are_those_of_the_schema():
    assert words(Rolling, "kind") == ROLLING["kind"]["enum"]
    assert words(KineticFriction, "law") == FRICTION["kinetic"]["properties"]["law"]["enum"]
    assert list(get_args(Model)) == PROBLEM["model"]["enum"]


def test_a_shift_says_what_was_given():
    assert Friction(0.4, (0.1, 0)).params() == {"mu": 0.4, "rigid_shift": [0.1, 0]}
    friction = Friction(mu=0.4, force=(-3, None), rotation=0.1, duration=2, kinetic=KineticFriction(0.3, 5))
    assert friction.params() == {
        "mu": 0.4,
        "force": [-3, None],
        "rotation": 0.1,
        "duration": 2,
        "kinetic": {"mu": 0.3, "slip_velocity": 5},
    }


def test_rolling_says_what_was_given():
    rolling = Rolling(xi=1e-3, chi=0.5, dq=0.1, spin_offset=0, kind="transient", steps=7, velocity=3, force=(None, 2))
    assert Friction(0.3, rolling=rolling).params() == {
        "mu": 0.3,
        "rolling": {
            "xi": 1e-3, "eta": 0, "phi": 0, "chi": 0.5, "dq": 0.1, "spin_offset": 0, "kind": "transient", "steps": 7, "velocity": 3,
            "force": [None, 2],
        },
    }  # fmt: skip


@pytest.mark.parametrize("mu", [[[0.1, 0.2]], np.array([[0.1, 0.2]])])
def test_a_coefficient_per_element_is_an_array(mu):
    array = Friction(mu, (0, 0)).params()["mu"]
    np.testing.assert_array_equal(array, [[0.1, 0.2]])


@pytest.mark.parametrize("mu", [0, 0.5, np.float32(0.5), np.array(0.5)])
def test_one_coefficient_is_a_number(mu):
    assert type(Friction(mu, (0, 0)).params()["mu"]) in (int, float)


def test_pairs_may_be_any_sequence():
    friction = Friction(0.4, np.array([0.1, 0.2]), force=np.array([1.0, 2.0]))
    assert friction.params() == {"mu": 0.4, "rigid_shift": [0.1, 0.2], "force": [1.0, 2.0]}


def test_what_is_no_pair_goes_out_for_the_daemon_to_refuse():
    assert Friction(0.4, rigid_shift=0.1).params()["rigid_shift"] == 0.1


def test_friction_without_a_motion_is_a_shift_of_zero():
    assert Friction(mu=0.4).params() == {"mu": 0.4, "rigid_shift": [0.0, 0.0]}
    assert "rigid_shift" not in Friction(mu=0.4, rolling=Rolling(xi=1e-3)).params()


def test_the_documentation_has_every_option_and_every_word():
    text = (FOLDER.parents[1] / "docs" / "protocol.md").read_text()
    for options in (PROBLEM, FRICTION, ROLLING, MOTION, FRICTION["kinetic"]["properties"]):
        for name, option in options.items():
            for word in [name, *option.get("enum", [])]:
                assert any(form in text for form in (f"`{word}`", f".{word}`", f'"{word}"')), word
