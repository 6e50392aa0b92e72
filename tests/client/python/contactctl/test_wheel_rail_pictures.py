"""Tests pictures of contactctl wheelrail solve: wheel and rail are those drawn by Python for the same problem."""

import re

import numpy as np
import pytest

from contactctl.commands.wheelrail import _profiles, _solution
from contactd.values.wheel_rail.params import setup_params, state_params
from contactd.wheel_rail import (
    RailDeviation,
    WheelRailSetup,
    WheelRailState,
    Wheelset,
    WheelsetPosition,
    WheelsetVelocity,
)

pytest.importorskip("matplotlib").use("Agg")


def lines(figure):
    """Returns profiles, contacts and other lines drawn across the track."""
    return [np.transpose(line.get_data()) for line in figure.axes[0].lines]


@pytest.mark.parametrize("side", ["right", "left"])
def test_a_wheel_and_its_rail_are_drawn_as_python_draws_them(shared, side):
    out = 1 if side == "right" else -1
    setup = WheelRailSetup(side=side, dx=0.8, dy=0.8, wheelset=Wheelset(nominal_radius=425))
    state = WheelRailState(
        position=WheelsetPosition(y=3 * out, roll=1e-3 * out), rail=RailDeviation(y=0.5, z=1.0, roll=2e-3),
        velocity=WheelsetVelocity(x=20e3, pitch=-20e3 / 425), Fz=60e3,
    )  # fmt: skip
    params = {"setup": setup_params(setup), "state": state_params(state, "state")}
    by_command = _solution(params, shared.call("wheelrail.solve", params), _profiles(shared, params)).plot()
    by_python = shared.wheel_rail(setup, state).plot()
    found, expected = lines(by_command), lines(by_python)
    assert len(found) == len(expected) and sum(len(line) > 100 for line in found) == 2
    for one, other in zip(found, expected):
        np.testing.assert_allclose(one, other, atol=1e-9)


def test_the_picture_that_is_written_has_wheel_and_rail(ctl):
    words = ("--y", 3, "--Fz", 60e3, "--set", "setup.dx=0.8", "--set", "setup.dy=0.8")
    ended = ctl("wheelrail", "solve", *words, "-o", "there.svg", "-o", "there.json")
    assert ended.code == 0, ended.err
    filled = re.findall(r'id="(?:FillBetween)?PolyCollection_\d+"', (ctl.folder / "there.svg").read_text())
    assert len(filled) == 2


def test_slices_that_have_no_such_profiles_are_drawn_all_the_same(ctl):
    head = [[y, y * y / 600] for y in range(-36, 37)]
    slices = [{"x": x, "profile": {"points": head}} for x in (-200, 200)]
    ctl.write("slices.json", {"setup": {"dx": 1, "dy": 1, "rail_slices": slices, "track": {"rail_origin": {"y": 750, "z": 0}}}, "state": {"Fz": 60e3}})
    ended = ctl("wheelrail", "solve", "slices.json", "-o", "slices.png")
    assert ended.code == 0, ended.err
    assert (ctl.folder / "slices.png").stat().st_size > 10_000
