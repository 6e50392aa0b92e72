"""Tests wheelrail.wheelset: both wheels of a wheelset that is free to roll."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest

from contactd import Client, InvalidArgument, TimeoutExpired
from contactd.wheel_rail import (
    ConeProfile,
    ProfilePoints,
    RailDeviation,
    Track,
    WheelRailSetup,
    WheelRailState,
    WheelsetPosition,
    WheelsetState,
    WheelsetVelocity,
)

SETUP = WheelRailSetup()
COARSE = SETUP.replace(dx=0.8, dy=0.8)


def rolling(y=0.0, yaw=0.0, pitch=-4.3481181, Fz=(1e4, 1e4), **more: Any) -> WheelsetState:
    position, velocity = WheelsetPosition(y=y, yaw=yaw), WheelsetVelocity(x=2000, pitch=pitch)
    return WheelsetState(Fz_left=Fz[0], Fz_right=Fz[1], position=position, velocity=velocity, **more)


def test_a_wheelset_has_the_roll_of_the_benchmark(shared):
    """Uses the Manchester contact benchmark, A-2.2, case 13."""
    solution = shared.wheelset(SETUP, rolling(6, 0.0144, -4.3293718), fields=[])
    assert solution.converged
    assert solution.warnings == ()
    assert solution.roll == pytest.approx(-0.0006272, abs=3e-6)
    assert (solution.left.z, solution.right.z) == pytest.approx((-0.1957, -0.1961), abs=3e-3)
    assert solution.left.z == pytest.approx(solution.right.z, abs=1e-6)
    for wheel in (solution.left, solution.right):
        assert wheel.forces.track.Fz == pytest.approx(1e4, rel=1e-5)


def test_each_wheel_is_as_by_itself_at_that_roll(shared):
    solution = shared.wheelset(COARSE, rolling(3, 0.007, Fz=(1e4, 1.2e4)))
    position = WheelsetPosition(y=3, yaw=0.007, roll=solution.roll)
    for side, wheel, force in (("left", solution.left, 1e4), ("right", solution.right, 1.2e4)):
        state = WheelRailState(position=position, velocity=WheelsetVelocity(x=2000, pitch=-4.3481181), Fz=force)
        alone = shared.wheel_rail(COARSE.replace(side=side), state)
        for name in ("Fx", "Fy", "Fz"):
            assert getattr(wheel.forces.track, name) == pytest.approx(getattr(alone.forces.track, name), abs=2e-6 * force)
        one, other = wheel.patches[0].solution.pressure, alone.patches[0].solution.pressure
        np.testing.assert_allclose(one, other, atol=1e-5 * other.max())


def test_a_left_wheel_may_have_profiles_of_its_own(shared):
    worn = COARSE.replace(wheel=ConeProfile(-0.05, ends=(-60, 60)))
    there = shared.wheelset(COARSE, rolling(2, 0.005, Fz=(1e4, 1.2e4)), left=worn, fields=[])
    mirrored = shared.wheelset(worn, rolling(-2, -0.005, Fz=(1.2e4, 1e4)), left=COARSE, fields=[])
    assert there.converged
    assert abs(there.roll) > 1e-5
    assert mirrored.roll == pytest.approx(-there.roll, abs=1e-9)
    assert mirrored.right.forces.track.Fy == pytest.approx(-there.left.forces.track.Fy, rel=1e-5)
    assert there.roll != pytest.approx(shared.wheelset(COARSE, rolling(2, 0.005), fields=[]).roll, rel=0.1)


def test_a_rail_that_lies_lower_lets_the_wheelset_roll(shared):
    level = shared.wheelset(COARSE, rolling(), fields=[])
    lower = shared.wheelset(COARSE, rolling(right_rail=RailDeviation(z=3)), fields=[])
    assert level.roll == pytest.approx(0, abs=1e-9)
    assert lower.roll == pytest.approx(3 / 1500, rel=0.05)
    assert lower.z == pytest.approx(level.z + 1.5, abs=0.2)


def test_a_wheelset_beside_its_track_is_an_answer(shared):
    solution = shared.wheelset(COARSE, rolling(200), fields=[])
    assert not solution.converged
    assert "The left wheel does not carry its load" in solution.warnings[0]
    assert solution.left.warnings[0].startswith("No part of the wheel is above the rail")


@pytest.mark.parametrize(
    ("setup", "left", "state", "field"),
    [
        ({"dx": 0}, None, {}, "setup.dx"),
        ({}, {"dx": 0}, {}, "left.dx"),
        ({}, {"rail": ProfilePoints([[0, 0]])}, {}, "left.rail.points"),
        ({}, {"wheel": ProfilePoints([[0, 0], [1, math.nan], [2, 0]])}, {}, "left.wheel.points"),
        ({"rail": ProfilePoints([[0, 0]])}, {}, {}, "setup.rail.points"),
        ({}, {"track": Track(gauge=30)}, {}, "left.track.gauge"),
        ({"model": "hertz"}, None, {}, "setup.model"),
        ({}, None, {"Fz": (0, 1)}, "state.Fz_left"),
        ({}, None, {"Fz": (1, -1)}, "state.Fz_right"),
        ({}, None, {"Fz": (1, math.inf)}, "state.Fz_right"),
        ({}, None, {"yaw": 2}, "state.position.yaw"),
        ({}, None, {"left_rail": RailDeviation(y=math.inf)}, "state.left_rail.y"),
    ],
)
def test_bad_input_is_named_by_its_field(shared_daemon, setup, left, state, field):
    own = None if left is None else COARSE.replace(**left)
    with Client(shared_daemon.endpoint) as client, pytest.raises(InvalidArgument) as caught:
        client.wheelset(COARSE.replace(**setup), rolling(**state), left=own)
    assert caught.value.violations[0].field.startswith(field), caught.value


def test_a_solve_beyond_its_deadline_ends(shared):
    with pytest.raises(TimeoutExpired):
        shared.wheelset(SETUP.replace(dx=0.03, dy=0.03), rolling(8, 0.0192), timeout=0.05)
    assert shared.wheelset(COARSE, rolling(), fields=[]).converged
