"""Tests out-of-round wheels and massless flexible rails, with a daemon."""

from __future__ import annotations

import math

import numpy as np
import pytest

from contactd import Client, InvalidArgument
from contactd.wheel_rail import (
    S1002,
    ArcProfile,
    ConeProfile,
    ProfilePoints,
    RailDeviation,
    RailSprings,
    Track,
    WheelRailSetup,
    WheelRailState,
    Wheelset,
    WheelsetPosition,
    WheelsetState,
    WheelsetVelocity,
)

R, DEPTH = 450.0, 0.5
EDGE = math.acos(1 - DEPTH / R)
ROLLING = WheelsetVelocity(x=20e3, pitch=-43.4)
COARSE = WheelRailSetup(dx=0.8, dy=0.8)


def with_flat() -> WheelRailSetup:
    """Creates a cylinder with a flat on an arc."""
    slices = []
    for angle in np.linspace(-3, 3, 61) * EDGE:
        z = min(0.0, (R - DEPTH) / math.cos(angle) - R)
        slices.append((angle, ProfilePoints([[-40, z], [0, z], [40, z]])))
    track, wheelset = Track(rail_origin=(750, 0)), Wheelset(nominal_radius=R)
    return WheelRailSetup(wheel_slices=slices, rail=ArcProfile(300), track=track, wheelset=wheelset, dx=0.5, dy=0.5, friction=None)


def at(pitch: float, **more: float) -> WheelRailState:
    return WheelRailState(position=WheelsetPosition(pitch=pitch, **more), Fz=60e3)


def test_the_axle_goes_down_over_a_flat(shared):
    setup = with_flat()
    states = [WheelRailState(position=WheelsetPosition(pitch=share * EDGE)) for share in (0, 0.5, 1, 2)]
    found = shared.wheel_rail_geometry(setup, states)
    for share, geometry in zip((0, 0.5, 1, 2), found):
        left = max(0.0, 1 - share) * EDGE
        assert geometry.clearance == pytest.approx(R * (1 - math.cos(left)), abs=0.05 * DEPTH)  # edges lie between nodes


def test_a_flat_is_felt_where_it_is(shared):
    setup = with_flat()
    flat, beside, after_a_revolution = (shared.wheel_rail(setup, at(pitch), fields=[]) for pitch in (0, 1, 2 * math.pi))
    assert flat.z > beside.z + 0.8 * DEPTH
    assert flat.patches[0].solution.area.contact > 1.2 * beside.patches[0].solution.area.contact
    assert flat.patches[0].place.radii.wheel_along is None or abs(flat.patches[0].place.radii.wheel_along) > 10 * R
    assert after_a_revolution.z == pytest.approx(flat.z, abs=1e-6)


def test_a_session_rolls_over_a_flat_as_single_requests_do(shared):
    setup = with_flat()
    with shared.wheel_rail_session(setup) as session:
        for pitch in (0.1, 0.05, 0.02, 0):
            step, alone = session.step(at(pitch)), shared.wheel_rail(setup, at(pitch), fields=[])
            assert step.z == pytest.approx(alone.z, abs=1e-5)
            assert step.forces.track.Fz == pytest.approx(60e3, rel=2e-6)


def test_a_massless_flexible_rail_is_in_balance_with_its_wheel(shared):
    setup = COARSE.replace(track=Track(springs=RailSprings(y=1e4, z=1e5)))
    state = WheelRailState(
        position=WheelsetPosition(y=7.5, yaw=0.01), velocity=ROLLING, Fz=80e3, rail=RailDeviation(y=0.5, Fy=-2e3, Fz=1e3), derivatives=True
    )  # fmt: skip
    solution = shared.wheel_rail(setup, state, fields=[])
    track, deflection = solution.forces.track, solution.rail_deflection
    assert deflection is not None
    assert solution.rail_search is not None
    assert track.Fy - 2e3 == pytest.approx(1e4 * deflection.y, abs=0.1)
    assert track.Fz + 1e3 == pytest.approx(1e5 * deflection.z, abs=0.1)
    assert solution.rail_search.residual <= 1e-6
    fixed = RailDeviation(y=0.5 + deflection.y, z=deflection.z)
    rigid = shared.wheel_rail(COARSE, WheelRailState(position=state.position, velocity=ROLLING, Fz=80e3, rail=fixed), fields=[])
    assert rigid.forces.track.Fy == pytest.approx(track.Fy, abs=1)
    assert rigid.rail_deflection is None
    assert solution.derivatives is not None
    assert 0 < solution.derivatives.position.z.Fz < 1.1e5


def test_a_session_starts_where_its_rail_was(shared):
    setup = COARSE.replace(track=Track(springs=RailSprings(y=1e4, z=1e5)))
    with shared.wheel_rail_session(setup) as session:
        for y in (7.0, 7.02, 7.04):
            state = WheelRailState(position=WheelsetPosition(y=y), velocity=ROLLING, Fz=80e3)
            step, alone = session.step(state), shared.wheel_rail(setup, state, fields=[])
            assert step.forces.track.Fy == pytest.approx(alone.forces.track.Fy, abs=1)
    assert step.rail_search.iterations < alone.rail_search.iterations


def test_both_wheels_press_their_rails_down(shared):
    setup = COARSE.replace(track=Track(springs=RailSprings(z=5e4)))
    wheelset = shared.wheelset(setup, WheelsetState(Fz_left=50e3, Fz_right=100e3, velocity=ROLLING), fields=[])
    assert wheelset.left.rail_deflection.z == pytest.approx(1, rel=1e-4)
    assert wheelset.right.rail_deflection.z == pytest.approx(2, rel=1e-4)
    assert wheelset.roll == pytest.approx(1 / 1505, rel=0.1)


SLICES = [(-0.1, S1002()), (0.0, S1002()), (0.1, S1002())]


@pytest.mark.parametrize(
    ("setup", "state", "field"),
    [
        ({"wheel_slices": SLICES[:1]}, {}, "setup.wheel_slices"),
        ({"wheel_slices": SLICES[::-1]}, {}, "setup.wheel_slices[1].angle"),
        ({"wheel_slices": [(angle * 180, profile) for angle, profile in SLICES]}, {}, "setup.wheel_slices[0].angle"),
        ({"wheel_slices": [*SLICES, (0.2, ConeProfile(-0.05))]}, {}, "setup.wheel_slices[3].profile"),
        ({"wheel_slices": [*SLICES, (0.2, ProfilePoints([[0, 0]]))]}, {}, "setup.wheel_slices[3].profile.points"),
        ({"track": Track(springs=RailSprings())}, {}, "setup.track.springs"),
        ({"track": Track(springs=RailSprings(z=0))}, {}, "setup.track.springs.z"),
        ({"track": Track(springs=RailSprings(y=math.inf))}, {}, "setup.track.springs.y"),
        ({}, {"rail": RailDeviation(Fy=100)}, "state.rail.Fy"),
        ({"track": Track(springs=RailSprings(y=1e5))}, {"rail": RailDeviation(Fz=100)}, "state.rail.Fz"),
        ({}, {"position": WheelsetPosition(pitch=math.nan)}, "state.position.pitch"),
    ],
)
def test_bad_input_is_named_by_its_field(shared_daemon, setup, state, field):
    with Client(shared_daemon.endpoint) as client, pytest.raises(InvalidArgument) as caught:
        client.wheel_rail(COARSE.replace(**setup), WheelRailState(**{"Fz": 1e4, **state}))
    assert caught.value.violations[0].field.startswith(field), caught.value


def test_a_wheelset_of_out_of_round_wheels_has_no_conicity(shared):
    with pytest.raises(InvalidArgument) as caught:
        shared.equivalent_conicity(COARSE.replace(wheel_slices=SLICES), [3])
    assert caught.value.violations[0].field == "setup.wheel_slices"
