"""Tests temperatures of surfaces from a daemon: of contacts, of steps and of wheels on rails, and friction by them."""

from __future__ import annotations

import warnings
from dataclasses import replace

import numpy as np
import pytest

from contactd import (
    ContactProblem,
    Friction,
    FrictionMemory,
    Grid,
    InterfacialLayer,
    InvalidArgument,
    Material,
    Paraboloid,
    Rolling,
    TemperatureFriction,
    ThermalBodies,
    ThermalBody,
)
from contactd.wheel_rail import WheelRailFriction, WheelRailSetup, WheelRailState, WheelsetVelocity

BODIES = ThermalBodies(upper=ThermalBody(bulk_temperature=20), lower=ThermalBody(bulk_temperature=140, conductivity=12))
FALLING = TemperatureFriction(change=-0.2, reference=20, range=150)
PROBLEM = ContactProblem(
    grid=Grid.centred(21, 17, 12.6, 10.2),
    upper=Material(82000, 0.28),
    gap=Paraboloid(460, 300),
    Fn=40_000,
    friction=Friction(0.35, rolling=Rolling(xi=0.004, eta=0.002, phi=2e-4, velocity=3e4)),
    temperature=BODIES,
)


def with_law(law: TemperatureFriction | None) -> ContactProblem:
    friction = PROBLEM.friction
    assert friction is not None
    return PROBLEM.replace(friction=Friction(0.35, rolling=friction.rolling, temperature=law))


def test_a_solve_and_the_method_of_its_own_agree_to_the_last_bit(shared):
    solution = shared.solve(PROBLEM)
    found = shared.temperature(solution, BODIES)
    np.testing.assert_array_equal(found.upper_temperature, solution.upper_temperature)
    np.testing.assert_array_equal(found.lower_temperature, solution.lower_temperature)
    assert found.temperature == solution.temperature
    total = found.temperature.heat_upper + found.temperature.heat_lower
    assert total == pytest.approx(solution.frictional_power, rel=1e-6)


def test_temperatures_are_named_as_other_arrays_are(shared):
    assert shared.solve(PROBLEM.replace(temperature=None)).upper_temperature is None
    partial = shared.solve(PROBLEM, fields=["lower_temperature"])
    assert not hasattr(partial, "upper_temperature") and partial.lower_temperature.shape == (17, 21)
    assert shared.solve(PROBLEM, fields=[]).temperature.largest == partial.temperature.largest


def test_friction_falls_with_the_temperature(shared):
    constant, falling = (shared.solve(with_law(law)) for law in (None, FALLING))
    assert -falling.Fx < -0.95 * constant.Fx
    slips = falling.element_division == 2
    mu = 0.35 - 0.2 * np.clip((falling.upper_temperature - 20) / 150, 0, 1)
    traction = np.hypot(falling.traction_x, falling.traction_y)
    np.testing.assert_allclose(traction[slips], (mu * falling.pressure)[slips], rtol=1e-5)
    assert falling.evidence.outer.iterations <= 8


def test_friction_by_temperature_remembers(shared):
    def at(distance):
        return shared.solve(with_law(replace(FALLING, memory=FrictionMemory(distance, 1))))

    forces = [-at(distance).Fx for distance in (1e-9, 0.01, 1e9)]
    assert forces[0] == pytest.approx(-shared.solve(with_law(FALLING)).Fx, rel=1e-5)
    assert forces[0] < forces[1] < forces[2]
    between = at(0.01)
    slips = between.element_division == 2
    traction = np.hypot(between.traction_x, between.traction_y)
    np.testing.assert_allclose(traction[slips], (between.friction_coefficient * between.pressure)[slips], rtol=1e-5)


def test_layers_that_flow_heat_the_surfaces(shared):
    friction = Friction(0.35, rolling=Rolling(xi=0.01, velocity=3e4), layer=InterfacialLayer(1e-5, 100))
    problem = PROBLEM.replace(friction=friction, temperature=replace(BODIES, plastic_share=0.9))
    solution = shared.solve(problem)
    found = shared.temperature(solution, problem.temperature)
    assert found.temperature == solution.temperature
    heat = found.temperature.heat_upper + found.temperature.heat_lower
    assert solution.plastic_power > 0
    assert heat == pytest.approx(solution.frictional_power - 0.1 * solution.plastic_power, rel=1e-5)


def test_a_wheel_that_slides_leaves_its_heat_to_the_rail(shared):
    setup = WheelRailSetup(friction=WheelRailFriction(0.3), temperature=ThermalBodies(), dx=0.4, dy=0.4)
    for rolls, most in ((1.0, 0.51), (0.2, 0.35), (0.0, 0.02)):
        state = WheelRailState(Fz=8e4, velocity=WheelsetVelocity(x=2e4, pitch=-rolls * 2e4 / 460))
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            solution = shared.wheel_rail(setup, state)
        found = max((patch.solution for patch in solution.patches), key=lambda patch: patch.Fn).temperature
        wheel = found.heat_lower / (found.heat_upper + found.heat_lower)
        assert wheel < most
        if rolls < 1:  # the rail moves at the speed of the train
            assert wheel == pytest.approx(rolls**0.5 / (1 + rolls**0.5), abs=0.02)


def test_steps_of_a_session_have_temperatures(shared):
    with shared.session(with_law(FALLING)) as session:
        first = session.step(fields=["upper_temperature"])
        second = session.step(xi=0.02)
    expected = shared.solve(with_law(FALLING))
    np.testing.assert_allclose(first.upper_temperature, expected.upper_temperature, rtol=1e-6)
    assert second.temperature.largest > first.temperature.largest


def test_models_that_tell_the_slip_have_temperatures(shared):
    assert shared.solve(PROBLEM.replace(model="fastsim")).temperature.largest > 60


@pytest.mark.parametrize(
    ("changes", "field"),
    [
        ({"model": "hertz"}, "model"),
        ({"friction": Friction(0.3, rigid_shift=(1e-3, 0))}, "temperature"),
        ({"friction": Friction(0.3, rolling=Rolling(xi=1e-3, velocity=2e4, chi=0.4))}, "friction.rolling.chi"),
        ({"friction": Friction(0.3, rolling=Rolling(xi=1e-3, velocity=2e4, kind="transient"))}, "friction.rolling.kind"),
        ({"friction": Friction(0.3, rolling=Rolling(xi=1e-3))}, "friction.rolling.velocity"),
        ({"temperature": None, "friction": Friction(0.3, rolling=Rolling(xi=1e-3), temperature=FALLING)}, "friction.temperature"),
        ({"temperature": ThermalBodies(ThermalBody(conductivity=0))}, "temperature.upper.conductivity"),
    ],
)
def test_what_has_no_temperatures_is_refused_by_name(shared, changes, field):
    with pytest.raises(InvalidArgument) as caught:
        shared.solve(PROBLEM.replace(**changes))
    assert [violation.field for violation in caught.value.violations] == [field]


def wheels(side: str, law: TemperatureFriction | None = None) -> WheelRailSetup:
    friction = WheelRailFriction(0.35, temperature=law)
    return WheelRailSetup(side=side, friction=friction, dx=0.4, dy=0.4, temperature=BODIES)


def rolls(**changes):
    return WheelRailState(Fz=80_000, velocity=WheelsetVelocity(x=30_000, pitch=-66.5), **changes)


def test_wheels_on_rails_have_temperatures_in_each_patch(shared):
    right, left = (shared.wheel_rail(wheels(side), rolls()) for side in ("right", "left"))
    patch, mirrored = right.patches[0].solution, left.patches[0].solution
    assert patch.temperature.largest > 80
    assert patch.temperature.largest == pytest.approx(mirrored.temperature.largest)
    np.testing.assert_allclose(patch.upper_temperature, mirrored.upper_temperature[::-1])
    found = shared.temperature(patch, BODIES)
    np.testing.assert_array_equal(found.upper_temperature, patch.upper_temperature)


@pytest.mark.parametrize(
    "changes", [{"conformal": "half_space"}, {"rigid_slip": "elements"}, {"rigid_slip": "surfaces"}]
)
def test_temperatures_of_a_patch_and_of_its_solution_agree_however_slip_is_given(shared, changes):
    setup = wheels("right").replace(**changes)
    state = replace(rolls(), velocity=WheelsetVelocity(x=30_000, pitch=-50))
    patch = shared.wheel_rail(setup, state).patches[0].solution
    assert patch.upper_speed == pytest.approx(30_000)
    found = shared.temperature(patch, BODIES)
    np.testing.assert_array_equal(found.upper_temperature, patch.upper_temperature)
    assert found.temperature == patch.temperature


def test_friction_by_temperature_and_angle_has_memory(shared):
    laws = [(-0.2, -0.1, 20, 200), (0.2, -0.25, 20, 200)]
    friction = WheelRailFriction(0.35, True, temperature_by_angle=laws)
    at_once, slowly = (
        shared.wheel_rail(wheels("right").replace(friction=replace(friction, memory=memory)), rolls())
        for memory in (None, FrictionMemory(0.05, 1))
    )
    assert abs(slowly.forces.track.Fx) > 1.001 * abs(at_once.forces.track.Fx)
    assert slowly.patches[0].solution.friction_coefficient.min() < 0.34
    with pytest.raises(InvalidArgument, match="friction.memory"):
        shared.wheel_rail(wheels("right").replace(friction=WheelRailFriction(memory=FrictionMemory(0.05, 1))), rolls())


def test_friction_of_wheels_on_rails_falls_with_the_temperature(shared):
    constant, falling = (shared.wheel_rail(wheels("right", law), rolls()) for law in (None, FALLING))
    assert abs(falling.forces.track.Fx) < 0.98 * abs(constant.forces.track.Fx)


def test_wheels_that_do_not_roll_steadily_have_no_temperatures(shared):
    with pytest.raises(InvalidArgument, match="state.motion"):
        shared.wheel_rail(wheels("right"), rolls(motion="transient_rolling", time_step=1e-5))
    with pytest.raises(InvalidArgument, match="friction.temperature"):
        shared.wheel_rail(WheelRailSetup(friction=WheelRailFriction(temperature=FALLING)), rolls())
