"""Tests depths along rails that vary along the track."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from contactd import ContactWarning, EnergyWear, InvalidArgument, WearLaw, WearRequest
from contactd.wear import WeightedState
from contactd.wear.slices import depths_along
from contactd.wheel_rail import (
    ConeProfile,
    ProfilePoints,
    Track,
    WheelRailSetup,
    WheelRailState,
    WheelsetPosition,
    WheelsetVelocity,
)

LAW = WearLaw("energy", "a test", "upper", (0, 100), energy=EnergyWear(6.75e-4))
Y = np.linspace(735, 775, 81)


def head(z: float) -> ProfilePoints:
    y = np.linspace(-35, 35, 141)
    return ProfilePoints(np.stack([y, z + 300 - np.sqrt(300**2 - y**2)], axis=1))


#: A nose that rises by 2 mm over 200 mm, and is level beyond.
SLICES = [(x, head(z)) for x, z in ((-500.0, 0.0), (0.0, 0.0), (200.0, -2.0), (700.0, -2.0))]
SETUP = WheelRailSetup(wheel=ConeProfile(-0.05), rail_slices=SLICES, track=Track(rail_origin=(755, 0)), dx=1.0, dy=1.0)


def state(x: float, weight: float = 1.0, yaw: float = 2e-3) -> WeightedState:
    made = WheelRailState(
        position=WheelsetPosition(x=x, yaw=yaw), velocity=WheelsetVelocity(x=20e3, pitch=-20e3 / 460), Fz=60e3
    )
    return WeightedState(made, weight)


def test_a_nose_loses_in_each_piece_what_the_states_there_take_off(shared):
    found = depths_along(shared, SETUP, [state(-100), state(100), state(110, 3.0), state(400)], LAW, [-200, 0, 200, 300, 500], Y)
    assert found.depths.shape == (4, 80)
    assert (found.depths[2] == 0).all() and found.pmax[2] == 0
    for piece in (0, 1, 3):
        assert found.depths[piece].max() > 0 and found.pmax[piece] > 500
    # The removed area of a section in a passage equals that of the answer.
    setup = SETUP.replace(wear=WearRequest([LAW]))
    area = sum(patch.solution.wear.laws[0].area for patch in shared.wheel_rail(setup, state(400).state, fields=[]).patches)
    assert (found.depths[3] * np.diff(Y)).sum() == pytest.approx(area, rel=1e-6)
    np.testing.assert_array_equal(found.after(1e6), found.depths * 1e6)


def test_warnings_name_their_states(shared):
    coarse = SETUP.replace(dx=4.0, dy=4.0)
    with pytest.warns(ContactWarning) as caught:
        depths_along(shared, coarse, [state(-100), state(400)], LAW, [-200, 0, 500], Y)
    (only,) = caught
    assert {sentence.partition(":")[0] for sentence in only.message.sentences} == {"states[0]", "states[1]"}


def test_what_makes_no_sense_is_refused(shared):
    with pytest.raises(InvalidArgument, match="law.body"):
        depths_along(shared, SETUP, [state(0)], replace(LAW, body="lower"), [-1, 1], Y)
    with pytest.raises(InvalidArgument, match="outside the pieces"):
        depths_along(shared, SETUP, [state(9)], LAW, [-1, 1], Y)
    with pytest.raises(InvalidArgument, match="ascend"):
        depths_along(shared, SETUP, [state(0)], LAW, [1, -1], Y)
