"""Tests requests of fatigue, and the reading of answers."""

from __future__ import annotations

import math

import numpy as np
import pytest

from contactd import (
    ContactFatigue,
    ContactProblem,
    DamageFunction,
    FatigueRequest,
    FatigueStrength,
    Friction,
    Grid,
    Material,
    Paraboloid,
    Passage,
    Rolling,
)
from contactd.values.answers import read
from contactd.values.contact_params import problem_params

PROBLEM = ContactProblem(
    Grid(3, 2, 0.5, 1.0),
    Material(1, 0.1),
    Paraboloid(1, 1),
    0.1,
    friction=Friction(0.3, rolling=Rolling(xi=1e-3, velocity=2e4)),
)
ROW = {"z": 0, "angle": 0.1, "pressure": 900, "traction": 90}
ANSWER = {
    "body": "upper", "T_gamma": 7.1, "traction_coefficient": 0.1, "force_angle": 3.1, "driven": True, "FI_sub": 150, "limit": 3.5,
    "shear": {"value": 250, "y": 1, "z": 0, "depth": 1.5},
    "damages": [{"name": "ours", "value": 1e-6}],
    "rows": [
        {"y": 0, "force_x": -4, "force_y": 0, "shear": 240, "shear_depth": 1.4, **ROW},
        {"y": 1, "force_x": 0, "force_y": 2, "shear": 250, "shear_depth": 1.5, **ROW},
    ],
}  # fmt: skip


def sent(request: FatigueRequest) -> dict:
    return problem_params(PROBLEM.replace(fatigue=request))["fatigue"]


def test_requests_are_sent_with_what_they_say_and_nothing_else():
    assert sent(FatigueRequest("upper")) == {"body": "upper"}
    assert sent(FatigueRequest("lower", passage=Passage())) == {"body": "lower", "passage": {}}
    strength = FatigueStrength("rail", "a test", 300, a_DV=0.3, tau_e=200)
    function = DamageFunction("ours", "a test", (0, 200), [(0, 0, 0), (15, 0, 2e-7)])
    residual = Passage(depths=[0, 1], residual=[(0, -200, -100)])
    assert sent(FatigueRequest("upper", strength, [function], residual)) == {
        "body": "upper",
        "strength": {"name": "rail", "source": "a test", "shear_yield": 300, "a_DV": 0.3, "tau_e": 200},
        "damages": [
            {
                "name": "ours", "source": "a test", "range": [0, 200],
                "pieces": [{"from": 0, "value": 0, "slope": 0}, {"from": 15, "value": 0, "slope": 2e-7}],
            }
        ],
        "passage": {"depths": [0, 1], "residual": [{"depth": 0, "xx": -200, "yy": -100}]},
    }  # fmt: skip


def test_rows_of_an_answer_are_arrays():
    fatigue = read(ContactFatigue, ANSWER, "fatigue")
    np.testing.assert_array_equal(fatigue.y, [0, 1])
    np.testing.assert_array_equal(fatigue.z, [0, 0])
    np.testing.assert_array_equal(fatigue.shear_of_rows, [240, 250])
    assert np.isnan(fatigue.dang_van_of_rows).all()
    assert fatigue.shear.depth == 1.5
    assert fatigue.damage("ours") == 1e-6
    with pytest.raises(KeyError, match="ours"):
        fatigue.damage("theirs")


def test_cracks_run_across_the_force_of_their_row():
    fatigue = read(ContactFatigue, ANSWER, "fatigue")
    np.testing.assert_allclose(fatigue.crack_angles % math.pi, [math.pi / 2, 0], atol=1e-12)
