"""Tests that the start values of FMUs are the defaults of the schemas."""

from __future__ import annotations

import json
import subprocess
from pathlib import Path

import pytest

from support.daemons import BIN

SCHEMAS = Path(__file__).parents[3] / "proto" / "schema"
SETUP = ("definitions", "definitions", "wheel_rail_setup", "properties")
STATE = ("definitions", "definitions", "wheel_rail_state", "properties")
PROFILE = ("definitions", "definitions", "profile", "properties")
ROLLING = ("definitions", "definitions", "rolling", "properties")
SETTINGS = ("contact.solve.params", "properties", "settings", "properties")
TOLERANCE = ("definitions", "definitions", "solver_settings", "properties", "tolerance")
COMMON = {
    "model": ("contact.solve.params", "properties", "model"),
    "tolerances.normal": (*SETTINGS, "normal", "properties", "tolerance"),
    "tolerances.tangential": TOLERANCE,
    "tolerances.outer": TOLERANCE,
    "accept_unconverged": ("session.open.params", "properties", "accept_unconverged"),
}
WHEEL = {
    **COMMON,
    **{name: (*SETUP, name) for name in ("side", "model", "conformal")},
    **{f"elements.{name}": (*SETUP, name) for name in ("dx", "dy", "dq")},
    **{f"track.{name}": (*SETUP, "track", "properties", name) for name in ("gauge", "gauge_height", "cant")},
    **{
        f"wheelset.{name}": (*SETUP, "wheelset", "properties", name)
        for name in ("flange_back_distance", "flange_back_position", "nominal_radius")
    },
    # position.z has no default: a message must contain it or Fz.
    **{f"position.{name}": (*STATE, "position", "properties", name) for name in ("x", "y", "roll", "yaw")},
    **{f"deviation.{name}": (*STATE, "rail", "properties", name) for name in ("y", "z", "roll")},
    **{f"deviation_rate.{name}": (*STATE, "rail", "properties", f"{name}_velocity") for name in ("y", "z", "roll")},
    "friction.mu": ("definitions", "definitions", "wheel_rail_friction", "properties", "mu"),
    "roller.pitch": (*STATE, "roller_pitch"),
    "tolerances.force": TOLERANCE,
    "rail.slope": (*PROFILE, "arc", "properties", "slope"),
    **{f"{body}.smoothing": (*PROFILE, "smoothing_length") for body in ("wheel", "rail")},
}
CONTACT = {
    **COMMON,
    **{f"motion.{name}": (*ROLLING, name) for name in ("xi", "eta", "phi", "chi")},
    "elements.L_over_h": ("definitions", "definitions", "ics", "properties", "L_over_h"),
}


def declared(place):
    node = json.loads((SCHEMAS / f"{place[0]}.json").read_text())
    for name in place[1:]:
        node = node[name]
    return node["default"]


@pytest.fixture(scope="module")
def starts():
    said = json.loads(subprocess.run([BIN / "contactd-fmu-description"], capture_output=True, check=True).stdout)
    return {kind["name"]: {variable["name"]: variable for variable in kind["variables"]} for kind in said["kinds"]}


@pytest.mark.parametrize(
    ("kind", "name", "place"),
    [
        pytest.param(f"contactd_{kind}", name, place, id=f"{kind}: {name}")
        for kind, places in (("wheel", WHEEL), ("contact", CONTACT))
        for name, place in places.items()
    ],
)
def test_a_variable_starts_with_the_default_of_the_wire(starts, kind, name, place):
    variable = starts[kind][name]
    words = variable.get("enumeration", {}).get("words")
    start = words[variable["start"]] if words else variable["start"]
    assert start == declared(place)


def test_what_has_another_name_on_the_wire_starts_alike(starts):
    wheel = {name: variable["start"] for name, variable in starts["contactd_wheel"].items()}
    assert declared((*SETUP, "wheel")) == {"s1002": True} and wheel["wheel.profile"] == "S1002"
    assert declared((*SETUP, "rail")) == {"rail_60e1": {"inclination": wheel["rail.inclination"]}}
    assert wheel["rail.profile"] == "60E1"
    for shape in ("arc", "cone"):
        ends = declared((*PROFILE, shape, "properties", "ends"))
        assert [[wheel[f"{body}.from"], wheel[f"{body}.to"]] for body in ("wheel", "rail")] == [ends, ends]
    assert declared((*SETUP, "patches", "properties", "search")) == "locus" and wheel["mesh_search"] is False
    assert declared((*SETUP, "rigid_slip")) == "plane" and wheel["slip_of_surfaces"] is False
    assert declared((*SETUP, "friction")) == {"mu": wheel["friction.mu"]} and wheel["friction.none"] is False
