"""Tests the derivative of the pressures by the approach from a daemon: of contacts, of steps and of wheels on rails."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from contactd import (
    ContactProblem,
    Friction,
    Grid,
    InvalidArgument,
    Layer,
    LayeredBody,
    Material,
    Paraboloid,
    Rolling,
    ViscoelasticBody,
    from_dict,
    to_dict,
)
from contactd.wheel_rail import WheelRailSetup, WheelRailState, WheelsetPosition, WheelsetVelocity

STEEL = Material(82000, 0.28)
PROBLEM = ContactProblem(
    grid=Grid.centred(41, 33, 16.4, 13.2), upper=STEEL, gap=Paraboloid(460, 300), Fn=50_000, derivatives=True
)
ROLLING = Friction(0.3, rolling=Rolling(xi=8e-4, eta=5e-4, velocity=2e4))
AREA = PROBLEM.grid.dx * PROBLEM.grid.dy


def punch_of(problem: ContactProblem, pressure: np.ndarray) -> ContactProblem:
    """Returns the flat punch with the outline of the contact."""
    return problem.replace(gap=np.where(pressure > 0, 0.0, 1e3), Fn=100.0, derivatives=False)


@pytest.mark.parametrize(
    "body",
    [
        STEEL,
        Material(20000, 0.1),
        LayeredBody([Layer(1.0, G=20000, nu=0.3)], base=STEEL),
    ],
    ids=["steel", "another", "layered"],
)
def test_weights_are_those_of_a_flat_punch(shared, body):
    problem = PROBLEM.replace(upper=body, lower=STEEL)
    solution = shared.solve(problem)
    punch = shared.solve(punch_of(problem, solution.pressure))
    weights = solution.pressure_by_approach / solution.pressure_by_approach.sum()
    flat = punch.pressure / punch.pressure.sum()
    assert np.abs(weights - flat).max() <= 1e-5 * flat.max()
    assert solution.pressure_by_approach.sum() * AREA == pytest.approx(punch.Fn / punch.approach, rel=1e-5)


def test_the_array_belongs_to_the_derivatives(shared):
    solution = shared.solve(PROBLEM)
    assert solution.pressure_by_approach.sum() * AREA == pytest.approx(1 / solution.derivatives.approach.Fn, rel=1e-9)
    by_approach = shared.solve(PROBLEM.replace(Fn=None, approach=solution.approach))
    assert by_approach.pressure_by_approach.sum() * AREA == pytest.approx(by_approach.derivatives.Fn.approach, rel=1e-9)
    assert shared.solve(PROBLEM.replace(derivatives=False)).pressure_by_approach is None
    assert shared.solve(PROBLEM.replace(model="hertz")).pressure_by_approach is None
    named = shared.solve(PROBLEM, fields=["pressure_by_approach"])
    np.testing.assert_array_equal(named.pressure_by_approach, solution.pressure_by_approach)
    assert not hasattr(named, "pressure")
    assert not hasattr(shared.solve(PROBLEM, fields=["pressure"]), "pressure_by_approach")


def test_solutions_with_the_array_are_saved(shared):
    solution = shared.solve(PROBLEM)
    again = from_dict(to_dict(solution))
    np.testing.assert_array_equal(again.pressure_by_approach, solution.pressure_by_approach)


def test_steps_and_many_problems_have_the_array(shared):
    rolling = PROBLEM.replace(friction=ROLLING)
    alone = shared.solve(rolling)
    (many,) = shared.solve_many([rolling])
    np.testing.assert_array_equal(many.pressure_by_approach, alone.pressure_by_approach)
    with shared.session(rolling.replace(derivatives=False)) as session:
        assert session.step(fields=["pressure_by_approach"]).pressure_by_approach is None
        step = session.step(derivatives=True, fields=["pressure_by_approach"])
        later = session.step(derivatives=True, Fn=60_000, fields=["pressure_by_approach"])
    np.testing.assert_allclose(step.pressure_by_approach, alone.pressure_by_approach, rtol=1e-4)
    assert later.pressure_by_approach.sum() > step.pressure_by_approach.sum()


@pytest.mark.parametrize(
    ("changes", "why"),
    [
        ({"model": "fastsim", "friction": ROLLING, "normal_model": "kp"}, "whole rows"),
        (
            {
                "upper": ViscoelasticBody(G=1143, nu=0.4, f=1, tau=0.005),
                "friction": ROLLING,
            },
            "elastic bodies only",
        ),
    ],
    ids=["penetration", "viscoelastic"],
)
def test_unavailable_derivatives_are_refused_by_name(shared, changes, why):
    with pytest.raises(InvalidArgument, match=why) as caught:
        shared.solve(PROBLEM.replace(**changes))
    assert [violation.field for violation in caught.value.violations] == ["derivatives"]


def test_patches_of_wheels_have_the_array(shared):
    setup = WheelRailSetup(dx=0.5, dy=0.5, friction=None)
    state = WheelRailState(
        position=WheelsetPosition(y=3), velocity=WheelsetVelocity(x=2e4, pitch=-43.4), Fz=80e3, derivatives=True
    )
    found = shared.wheel_rail(setup, state)
    (patch,) = found.patches
    assert patch.solution.pressure_by_approach.shape == patch.place.grid.shape
    stiffness = np.cos(patch.place.reference.angle) ** 2 * patch.solution.pressure_by_approach.sum() * 0.25
    assert stiffness == pytest.approx(found.derivatives.position.z.Fz, rel=0.03)
    with shared.wheel_rail_session(setup) as session:
        step = session.step(state, fields=["pressure_by_approach"])
        plain = session.step(replace(state, derivatives=False), fields=["pressure_by_approach"])
    np.testing.assert_allclose(
        step.patches[0].solution.pressure_by_approach, patch.solution.pressure_by_approach, rtol=1e-6
    )
    assert plain.patches[0].solution.pressure_by_approach is None
