"""Tests requests of wear laws, and the reading of answers."""

from __future__ import annotations

import numpy as np
import pytest

from contactd import (
    ArchardWear,
    BrWear,
    ContactProblem,
    ContactWear,
    EnergyWear,
    Friction,
    Grid,
    Material,
    Paraboloid,
    Rolling,
    SeizureWear,
    SevereWear,
    WearLaw,
    WearRequest,
)
from contactd.values.answers import read
from contactd.values.contact_params import problem_params

ENERGY = WearLaw("energy", "a test", "lower", (0, 10), energy=EnergyWear(1e-3))
PROBLEM = ContactProblem(
    Grid(3, 2, 0.5, 1.0), Material(1, 0.1), Paraboloid(1, 1), 0.1, friction=Friction(0.3, rolling=Rolling(xi=1e-3, velocity=2e4))
)
ANSWER = {
    "T_gamma": 7.1, "T_gamma_with_spin": 7.2, "dissipation": 6.9, "factor": 1.04, "largest_pressure_slip": 3.1,
    "largest_dissipation": 0.9, "largest_sliding_velocity": 40,
    "rows": [{"y": y, "z": 0, "angle": 0.1, "pressure_slip": 4, "dissipation": 1.2, "depths": [1e-7, y * 1e-7]} for y in (0, 1, 2)],
    "laws": [{"name": name, "body": "lower", "area": 5e-6, "depth": 8e-7, "argument": 0.9} for name in ("energy", "br")],
}  # fmt: skip


def sent(request: WearRequest) -> dict:
    return problem_params(PROBLEM.replace(wear=request))["wear"]


def test_laws_are_sent_with_all_of_their_coefficients_and_nothing_else():
    assert sent(WearRequest()) == {}
    energy = {"name": "energy", "source": "a test", "body": "lower", "range": [0, 10], "energy": {"coefficient": 1e-3}}
    assert sent(WearRequest([ENERGY], "plain")) == {"energy": "plain", "laws": [energy]}
    archard = ArchardWear(3000, 1e-4, SevereWear(4e-3, (200, 700)), SeizureWear(3e-2, 0.8))
    (law,) = sent(WearRequest([WearLaw("map", "a test", "upper", (0, 1e3), archard=archard)]))["laws"]
    assert law["archard"]["severe"] == {"k": 4e-3, "velocity": [200, 700]}
    assert law["archard"]["seizure"] == {"k": 3e-2, "pressure": 0.8}


def test_pieces_and_zones_are_tuples_in_the_order_of_their_fields():
    given = WearLaw("br", "a test", "lower", (0, 1e3), br=BrWear([(0, 0, 0.25), (100, 25, 0)]), zones=[(-1, 0.1), (0, 1)])
    (law,) = sent(WearRequest([given]))["laws"]
    assert law["br"]["pieces"] == [{"from": 0, "value": 0, "slope": 0.25}, {"from": 100, "value": 25, "slope": 0}]
    assert law["zones"] == [{"angle": -1, "factor": 0.1}, {"angle": 0, "factor": 1}]


def test_a_piece_that_is_no_triple_is_refused():
    with pytest.raises(ValueError, match="it must have from, value, slope"):
        sent(WearRequest([WearLaw("br", "a test", "lower", (0, 1), br=BrWear([(0, 1)]))]))


def test_rows_of_an_answer_are_arrays():
    wear = read(ContactWear, ANSWER, "wear")
    np.testing.assert_array_equal(wear.y, [0, 1, 2])
    np.testing.assert_array_equal(wear.z, [0, 0, 0])
    np.testing.assert_array_equal(wear.angle, [0.1] * 3)
    np.testing.assert_array_equal(wear.dissipation_of_rows, [1.2] * 3)
    np.testing.assert_array_equal(wear.pressure_slip_of_rows, [4] * 3)
    np.testing.assert_array_equal(wear.depth("br"), [0, 1e-7, 2e-7])
    with pytest.raises(KeyError, match="energy, br"):
        wear.depth("usfd")
