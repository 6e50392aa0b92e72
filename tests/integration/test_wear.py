"""Tests wear of surfaces from a daemon: of contacts, of steps and of wheels on rails."""

from __future__ import annotations

import math

import numpy as np
import pytest

from contactd import (
    ArchardWear,
    BrWear,
    ContactProblem,
    ContactWarning,
    EnergyWear,
    Friction,
    Grid,
    InvalidArgument,
    Material,
    Paraboloid,
    Rolling,
    SevereWear,
    UsfdWear,
    WearLaw,
    WearRequest,
)
from contactd.wheel_rail import WheelRailSetup, WheelRailState, WheelsetPosition, WheelsetVelocity

USFD = UsfdWear([(0, 0, 5.3), (10.4, 55, 0), (77.2, 55, 61.9)], density=7850)
ENERGY = WearLaw("energy", "a test", "lower", (0, 1000), energy=EnergyWear(1e-3))
LAWS = [
    ENERGY,
    WearLaw("usfd", "a test", "lower", (0, 1000), usfd=USFD, zones=[(-0.5, 0.1), (0, 1)]),
    WearLaw("map", "a test", "upper", (0, 1e5), archard=ArchardWear(3000, 1e-4, SevereWear(1e-3, (200, 700)))),
    WearLaw("br", "a test", "upper", (0, 1e5), br=BrWear([(0, 0, 0.25), (100, 25, 0)])),
]
PROBLEM = ContactProblem(
    grid=Grid.centred(31, 25, 12.6, 10.2),
    upper=Material(82000, 0.28),
    gap=Paraboloid(460, 300),
    Fn=40_000,
    friction=Friction(0.35, rolling=Rolling(xi=0.002, eta=0.001, phi=2e-4, velocity=3e4)),
    wear=WearRequest(LAWS),
)
STATE = WheelRailState(
    position=WheelsetPosition(y=6, yaw=0.0144, roll=-6.272e-4),
    velocity=WheelsetVelocity(x=2000, pitch=-4.3293718),
    Fz=10_000,
)


def test_a_solution_has_what_a_passage_takes_off(shared):
    solution = shared.solve(PROBLEM)
    wear = solution.wear
    rolling = solution.motion
    T_gamma = -(solution.Fx * rolling.xi + solution.Fy * rolling.eta)
    assert wear.T_gamma == pytest.approx(T_gamma, rel=1e-12)
    assert wear.T_gamma_with_spin == pytest.approx(T_gamma - solution.Mz * rolling.phi, rel=1e-12)
    rows = np.abs(solution.traction_x * solution.slip_x + solution.traction_y * solution.slip_y).sum(axis=1)
    rows = wear.factor * rows[(solution.pressure > 0).any(axis=1)] * PROBLEM.grid.dx
    np.testing.assert_allclose(wear.dissipation_of_rows, rows, rtol=1e-5)  # adhesion has slip within the tolerance
    np.testing.assert_allclose(wear.depth("energy"), 1e-6 * wear.dissipation_of_rows, rtol=1e-9)
    assert [law.name for law in wear.laws] == ["energy", "usfd", "map", "br"]
    assert [law.body for law in wear.laws] == ["lower", "lower", "upper", "upper"]
    assert wear.laws[3].area == pytest.approx(math.pi * 1e-6 * 25, rel=1e-12) or wear.T_gamma < 100
    assert wear.laws[0].area == pytest.approx(1e-6 * wear.T_gamma_with_spin, rel=1e-12)
    with pytest.raises(KeyError, match="not a law of this wear"):
        wear.depth("zobory")


def test_an_answer_without_arrays_has_wear_all_the_same(shared):
    assert shared.solve(PROBLEM.replace(wear=None)).wear is None
    assert shared.solve(PROBLEM, fields=[]).wear == shared.solve(PROBLEM).wear


def test_steps_of_a_session_wear_as_it_says(shared):
    with shared.session(PROBLEM) as session:
        assert session.step().wear == shared.solve(PROBLEM).wear


def test_wheels_wear_in_track_coordinates_and_left_ones_in_the_mirror(shared):
    setup = WheelRailSetup(wear=WearRequest(LAWS), dx=0.4, dy=0.4)
    right = shared.wheel_rail(setup, STATE, fields=[]).patches[0]
    wear = right.solution.wear
    assert abs(wear.y.mean() - right.place.reference.y) < 3
    assert wear.angle[0] == right.place.reference.angle
    mirrored = WheelRailState(
        position=WheelsetPosition(y=-6, yaw=-0.0144, roll=6.272e-4), velocity=STATE.velocity, Fz=STATE.Fz
    )
    left = shared.wheel_rail(setup.replace(side="left"), mirrored, fields=[]).patches[0].solution.wear
    np.testing.assert_array_equal(left.y, -wear.y[::-1])
    np.testing.assert_array_equal(left.depth("usfd"), wear.depth("usfd")[::-1])
    assert left.laws == wear.laws


def test_a_law_beyond_its_range_warns(shared):
    law = WearLaw("narrow", "a test", "lower", (0, 1e-3), energy=EnergyWear(1e-3))
    with pytest.warns(ContactWarning, match=r"wear law narrow was tested from 0 to 0\.001"):
        shared.solve(PROBLEM.replace(wear=WearRequest([law])), fields=[])


@pytest.mark.parametrize(
    ("law", "field"),
    [
        (WearLaw("a", "a test", "lower", (0, 1)), r"wear\.laws\[0\]"),
        (WearLaw("a", "a test", "lower", (1, 1), energy=EnergyWear(1)), r"wear\.laws\[0\]\.range"),
        (WearLaw("a", "a test", "lower", (0, 1), br=BrWear([(1, 0, 1)])), r"wear\.laws\[0\]\.br\.pieces\[0\]\.from"),
    ],
)
def test_laws_that_say_too_little_are_refused_by_name(shared, law, field):
    with pytest.raises(InvalidArgument, match=field):
        shared.solve(PROBLEM.replace(wear=WearRequest([law])))
