"""Tests the requests of Client.wheel_rail and the reading of its answers."""

from __future__ import annotations

import copy
import json
from pathlib import Path

import numpy as np
import pytest

from contactd import (
    InvalidArgument,
    KineticFriction,
    Material,
    ProtocolError,
    RigidBody,
    SolverSettings,
    TangentialSettings,
)
from contactd.values.profiles import profile_params
from contactd.values.wheel_rail.params import setup_params, state_params, wheelset_state_params
from contactd.values.wheel_rail.solution import read_wheel_rail, read_wheelset
from contactd.wheel_rail import (
    S1002,
    ArcProfile,
    ConeProfile,
    PatchRules,
    ProfilePoints,
    Rail60E1,
    RailDeviation,
    RailSprings,
    StandardProfile,
    Track,
    WheelRailFriction,
    WheelRailSetup,
    WheelRailState,
    Wheelset,
    WheelsetPosition,
    WheelsetState,
)
from support import schemas

SCHEMAS = Path(__file__).parents[3] / "proto" / "schema"
#: One patch without arrays, as in the schema.
ANSWER = json.loads((SCHEMAS / "wheelrail.solve.result.json").read_text())["examples"][0]
WHEELSET_ANSWER = json.loads((SCHEMAS / "wheelrail.wheelset.result.json").read_text())["examples"][0]
GRID = ANSWER["patches"][0]["place"]["grid"]


def test_a_set_up_that_says_nothing_leaves_all_but_friction_to_the_daemon():
    assert setup_params(WheelRailSetup()) == {"friction": {"mu": 0.3}}
    assert setup_params(WheelRailSetup(friction=None)) == {"friction": None}


def test_all_fields_are_sent_as_the_schema_has_them():
    setup = WheelRailSetup(
        side="left",
        wheel=ProfilePoints([[0, 0], [1, 0.1]], unit=1000, mirror_y=True, mirror_z=False, smoothing_length=5),
        rail=ArcProfile(300, slope=0.1, ends=(-20, 20)),
        track=Track(1520, 13, 0.05, (760.5, -1), 500, True, RailSprings(2e4, 1e5)),
        wheelset=Wheelset(1440, -69, 475),
        upper=Material(80000, 0.3),
        lower=RigidBody(),
        model="fastsim",
        friction=WheelRailFriction([(-1.2, 0.1), (0, 0.4)], True, KineticFriction(0.05, 900, "linear")),
        dx=0.5,
        dy=0.25,
        dq=0.4,
        patches=PatchRules(1, 7, 3, 11, 0.5, "mesh"),
        wheel_surface="bilinear",
        slope_forces="all",
        rail_slices=[(-5, Rail60E1(0.05), (0, 20, 50)), (5, ArcProfile(300))],
        wheel_slices=[(-0.1, S1002()), (0.1, ConeProfile(-0.05))],
        rigid_slip="surfaces",
        conformal="half_space",
        normal=SolverSettings(1e-7),
        force=SolverSettings(1e-5, 30),
    )
    sent = setup_params(setup)
    points = sent["wheel"].pop("points")
    sent["wheel"]["points"] = points.tolist()
    schemas.check("wheelrail.solve.params", {"setup": sent, "state": state_params(WheelRailState(Fz=1.0), "state")})
    assert sent["friction"]["mu"] == [{"angle": -1.2, "mu": 0.1}, {"angle": 0, "mu": 0.4}]
    assert sent["track"]["rail_origin"] == {"y": 760.5, "z": -1}
    assert sent["bodies"] == {"upper": {"G": 80000, "nu": 0.3}, "lower": {"rigid": True}}
    assert sent["settings"] == {"normal": {"tolerance": 1e-7}}
    assert sent["slope_forces"] == "all"
    assert sent["rail_slices"][0] == {"x": -5, "profile": {"rail_60e1": {"inclination": 0.05}}, "features": [0, 20, 50]}
    assert sent["rail_slices"][1] == {"x": 5, "profile": {"arc": {"radius": 300}}}
    assert sent["wheel_slices"][1] == {"angle": 0.1, "profile": {"cone": {"slope": -0.05}}}
    assert sent["track"]["springs"] == {"y": 2e4, "z": 1e5}
    assert sent["force"] == {"tolerance": 1e-5, "max_iterations": 30}


def test_the_solver_of_tractions_is_sent():
    setup = WheelRailSetup(tangential=TangentialSettings(solver="tangcg"))
    assert setup_params(setup)["settings"] == {"tangential": {"solver": "tangcg"}}


def test_what_is_of_a_wrong_class_is_refused_where_it_stands():
    with pytest.raises(TypeError, match=r"setup\.track\.springs is 5; it must be of type RailSprings"):
        setup_params(WheelRailSetup(track=Track(springs=5)))  # type: ignore[arg-type]


def test_a_wheel_of_another_material_stands_on_a_rail_of_steel():
    assert setup_params(WheelRailSetup(lower=Material(1000, 0.4)))["bodies"] == {
        "upper": {"G": 82000, "nu": 0.28},
        "lower": {"G": 1000, "nu": 0.4},
    }


@pytest.mark.parametrize(
    ("profile", "sent"),
    [
        (S1002(), {"s1002": True}),
        (Rail60E1(), {"rail_60e1": {}}),
        (Rail60E1(0.025), {"rail_60e1": {"inclination": 0.025}}),
        (ConeProfile(-0.05), {"cone": {"slope": -0.05}}),
        (StandardProfile("54E1", inclination=0.025), {"standard": {"name": "54E1", "inclination": 0.025}}),
        (ArcProfile(-300, ends=(1, 2)), {"arc": {"radius": -300, "ends": [1, 2]}}),
    ],
)
def test_profiles_go_by_their_formula(profile, sent):
    assert profile_params(profile, "setup.wheel") == sent


def test_what_is_no_profile_is_refused():
    with pytest.raises(TypeError, match=r"setup\.wheel"):
        setup_params(WheelRailSetup(wheel="S1002"))  # type: ignore[arg-type]
    with pytest.raises(InvalidArgument, match=r"setup\.rail\.points has shape \[3\]; it must be \[n, 2\]"):
        setup_params(WheelRailSetup(rail=ProfilePoints([1, 2, 3])))
    with pytest.raises(TypeError, match="setup"):
        setup_params(WheelRailState())  # type: ignore[arg-type]
    with pytest.raises(TypeError, match=r"states\[2\]"):
        state_params(WheelRailSetup(), "states[2]")  # type: ignore[arg-type]


def test_a_state_has_all_of_its_numbers():
    sent = state_params(WheelRailState(position=WheelsetPosition(y=2, z=0, yaw=0.1)), "state")
    assert sent["position"] == {"y": 2, "z": 0, "roll": 0, "yaw": 0.1, "x": 0, "pitch": 0}
    assert "z" not in state_params(WheelRailState(), "state")["position"]
    assert sent["roller_pitch"] == 0
    assert "Fz" not in sent
    schemas.check("wheelrail.solve.params", {"state": sent})


def test_an_answer_is_read():
    solution = read_wheel_rail([], False, ANSWER)
    (patch,) = solution.patches
    assert solution.force is not None
    assert solution.force.iterations == 3
    assert solution.pitch_search is None
    assert solution.rail_deflection is None
    assert patch.place.regions[0].y == (748.0, 756.1)
    assert patch.place.radii.rail_along is None
    assert not hasattr(patch.solution, "pressure")
    assert patch.place.grid.shape == (GRID["ny"], GRID["nx"])
    assert "patch at y 751.87" in repr(solution)


def test_arrays_that_do_not_fit_their_grid_are_no_answer():
    answer = copy.deepcopy(ANSWER)
    with pytest.raises(ProtocolError, match="lacks the requested pressure"):
        read_wheel_rail(["pressure"], False, answer)
    answer["patches"][0]["gap"] = np.zeros((2, 2))
    with pytest.raises(ProtocolError, match="gap of patch 0"):
        read_wheel_rail([], True, answer)


def test_a_wheelset_is_told_by_both_of_its_wheels():
    state = WheelsetState(Fz_left=1.0, Fz_right=2.0, left_rail=RailDeviation(y=3))
    sent = {
        "setup": setup_params(WheelRailSetup()),
        "left": setup_params(WheelRailSetup(dx=1), "left"),
        "state": wheelset_state_params(state),
    }
    schemas.check("wheelrail.wheelset.params", sent)
    assert sent["state"]["left_rail"]["y"] == 3
    with pytest.raises(TypeError, match=r"left\.wheel"):
        setup_params(WheelRailSetup(wheel="S1002"), "left")  # type: ignore[arg-type]
    with pytest.raises(TypeError, match="state"):
        wheelset_state_params(WheelRailState())  # type: ignore[arg-type]


def test_both_wheels_of_an_answer_are_read():
    answer = copy.deepcopy(WHEELSET_ANSWER)
    solution = read_wheelset([], False, answer)
    assert solution.roll == answer["roll"]
    assert solution.right.forces.track.Fx == 973.1
    assert "left" in repr(solution)
    answer["right"] = ANSWER
    with pytest.raises(ProtocolError, match="lacks the requested pressure"):
        read_wheelset(["pressure"], False, answer)
