"""Tests steps of a wheel on its rail that continue from the tractions of the previous step, and wheels of flexible
wheelsets."""

from __future__ import annotations

import numpy as np
import pytest

from contactd import InvalidArgument
from contactd.wheel_rail import (
    WheelDeviation,
    WheelRailSetup,
    WheelRailState,
    WheelsetPosition,
    WheelsetState,
    WheelsetVelocity,
)

COARSE = WheelRailSetup(dx=0.8, dy=0.8)
FIELDS = ["traction_x", "traction_y"]


def rolling(y: float = 3.0, mirrored: bool = False, **more) -> WheelRailState:
    sign = -1 if mirrored else 1
    position = WheelsetPosition(y=sign * y, yaw=sign * 2e-3)
    velocity = WheelsetVelocity(x=2000, pitch=-4.345)
    return WheelRailState(position=position, velocity=velocity, Fz=5e4, motion="transient_rolling", **more)


def shift(y: float, seconds: float = 1.0) -> WheelRailState:
    return WheelRailState(
        position=WheelsetPosition(y=3.0), velocity=WheelsetVelocity(y=y), Fz=5e4, motion="shift", time_step=seconds
    )


@pytest.fixture
def wheel(shared):
    with shared.wheel_rail_session(COARSE) as session:
        yield session


def creep_force(solution) -> float:
    return sum(float(np.hypot(patch.solution.Fx, patch.solution.Fy)) for patch in solution.patches)


def test_steps_build_up_the_force_that_a_first_one_begins(shared, wheel):
    alone = shared.wheel_rail(COARSE, rolling())
    forces = [creep_force(wheel.step(rolling())) for _ in range(8)]
    assert forces[0] == pytest.approx(creep_force(alone), rel=1e-6)
    assert all(later > earlier for earlier, later in zip(forces[:5], forces[1:6]))


def test_a_step_is_taken_back_with_its_tractions(wheel):
    wheel.step(rolling())
    wheel.step(rolling(y=3.1))
    again = wheel.step(rolling(), again=True, fields=FIELDS)
    state = wheel.save()
    later = wheel.step(rolling(), fields=FIELDS)
    wheel.restore(state)
    repeated = wheel.step(rolling(), fields=FIELDS)
    assert creep_force(later) > creep_force(again)
    assert np.array_equal(later.patches[0].solution.traction_y, repeated.patches[0].solution.traction_y)


def test_a_left_wheel_steps_as_a_right_one_in_a_mirror(shared, wheel):
    with shared.wheel_rail_session(COARSE.replace(side="left")) as left:
        for _ in range(3):
            one, other = wheel.step(rolling()), left.step(rolling(mirrored=True))
    assert other.forces.track.Fy == -one.forces.track.Fy
    assert other.forces.track.Fx == one.forces.track.Fx


def test_what_a_shift_brings_depends_on_its_length_alone(shared):
    with shared.wheel_rail_session(COARSE) as one, shared.wheel_rail_session(COARSE) as other:
        assert one.step(shift(0.02)).forces.track.Fy == pytest.approx(other.step(shift(2.0, 0.01)).forces.track.Fy, abs=0.1)


def test_conformal_contacts_and_springs_step_too(shared):
    conformal = COARSE.replace(conformal="half_space")
    with shared.wheel_rail_session(conformal) as session:
        first = session.step(rolling(y=6.5))
        for _ in range(4):
            last = session.step(rolling(y=6.5))
    assert last.patches[0].place.rows
    assert creep_force(last) > creep_force(first)


def test_steps_that_make_no_sense_are_refused_by_name(shared):
    for state, field in [
        (WheelRailState(velocity=WheelsetVelocity(y=1), Fz=5e4, motion="shift"), "state.time_step"),
        (WheelRailState(Fz=5e4, time_step=0.1), "state.time_step"),
    ]:
        with pytest.raises(InvalidArgument) as refused:
            shared.wheel_rail(COARSE, state)
        assert refused.value.violations[0].field == field
    with pytest.raises(InvalidArgument, match="state.motion"):
        shared.wheel_rail(COARSE.replace(model="fastsim"), rolling())


def test_a_wheelset_has_wheels_that_deviate(shared):
    velocity = WheelsetVelocity(x=2000, pitch=-2000 / 460)
    rigid = WheelsetState(velocity=velocity, Fz_left=5e4, Fz_right=5e4)
    lower = WheelsetState(velocity=velocity, Fz_left=5e4, Fz_right=5e4, right_wheel=WheelDeviation(z=0.3))
    one, other = shared.wheelset(COARSE, rigid, fields=[]), shared.wheelset(COARSE, lower, fields=[])
    # A lower wheel raises its end of the axle.
    assert one.roll == pytest.approx(0, abs=1e-6)
    assert other.roll == pytest.approx(-0.3 / 1500, rel=0.05)


def test_deviations_of_both_wheels_are_those_of_mirror_images(shared):
    state = WheelRailState(
        velocity=WheelsetVelocity(x=2000, pitch=-2000 / 460), Fz=5e4, wheel=WheelDeviation(y=0.4, roll=2e-3, yaw=1e-3, x_velocity=5)
    )
    mirrored = WheelRailState(
        velocity=WheelsetVelocity(x=2000, pitch=-2000 / 460), Fz=5e4, wheel=WheelDeviation(y=-0.4, roll=-2e-3, yaw=-1e-3, x_velocity=5)
    )
    right, left = shared.wheel_rail(COARSE, state, fields=[]), shared.wheel_rail(COARSE.replace(side="left"), mirrored, fields=[])
    assert left.forces.track.Fy == -right.forces.track.Fy
    assert left.z == right.z
    assert right.z != shared.wheel_rail(COARSE, WheelRailState(velocity=state.velocity, Fz=5e4), fields=[]).z
