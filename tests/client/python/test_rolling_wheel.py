"""Tests the solve of a rolling wheel in one call, and its picture without a client."""

from __future__ import annotations

import asyncio
import gc
import subprocess
import sys

import matplotlib
import pytest

import contactd
from contactd import AsyncClient, ConnectionFailed, InvalidArgument, wheel_rail
from contactd.wheel_rail import (
    Track,
    WheelRailSetup,
    WheelRailSolution,
    WheelRailState,
    Wheelset,
    WheelsetPosition,
    WheelsetVelocity,
)

matplotlib.use("Agg")
pytestmark = pytest.mark.usefixtures("solving_here")


def test_it_rolls_on_the_nominal_radius():
    solution = wheel_rail(y=3, speed=20e3, Fz=80e3, fields=[])
    state = WheelRailState(position=WheelsetPosition(y=3), velocity=WheelsetVelocity(x=20e3, pitch=-20e3 / 460), Fz=80e3)
    assert solution.state == state
    by_state = contactd.default_client().wheel_rail(WheelRailSetup(), state, fields=[])
    assert solution.forces == by_state.forces
    assert solution.forces.track.Fz == pytest.approx(80e3, rel=1e-5)
    assert solution.pitch_rate == pytest.approx(-20e3 / 460)


def test_the_radius_is_that_of_the_wheelset_of_the_set_up():
    setup = WheelRailSetup(wheelset=Wheelset(nominal_radius=500), model="fastsim")
    assert wheel_rail(setup, speed=10e3, Fz=50e3, fields=[]).state.velocity.pitch == -20
    assert wheel_rail(setup, speed=10e3, Fz=50e3, pitch_rate=-21, fields=[]).state.velocity.pitch == -21


def test_a_wheel_that_rolls_freely_has_no_longitudinal_force():
    solution = wheel_rail(y=3, speed=20e3, Fz=80e3, Fx=0, fields=[])
    assert solution.forces.wheelset.Fx == pytest.approx(0, abs=1)
    assert abs(wheel_rail(y=3, speed=20e3, Fz=80e3, fields=[]).forces.wheelset.Fx) > 1000


def test_on_a_roller_the_wheelset_stays_and_the_roller_turns():
    setup = WheelRailSetup(track=Track(roller_radius=1000), model="fastsim")
    solution = wheel_rail(setup, speed=10e3, Fz=50e3, fields=[])
    assert (solution.state.velocity.x, solution.state.roller_pitch) == (0, 10)
    assert solution.patches[0].place.creepages.velocity == pytest.approx(10e3, rel=0.02)
    assert solution.patches[0].place.creepages.xi == pytest.approx(0, abs=0.02)


def test_it_is_a_module_all_the_same():
    code = "import contactd.wheel_rail, contactd\nfrom contactd.wheel_rail import S1002\nassert callable(contactd.wheel_rail)\nassert contactd.wheel_rail.S1002 is S1002\n"
    ended = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=False)
    assert ended.returncode == 0, ended.stderr
    assert wheel_rail.WheelRailSolution is WheelRailSolution
    assert sys.modules["contactd.wheel_rail"] is wheel_rail


@pytest.mark.parametrize(
    ("fields", "sentence"),
    [
        ({"speed": "fast", "Fz": 80e3}, "state.velocity.x"),
        ({"speed": 20e3, "Fz": -1}, "state.Fz is -1"),
        ({"speed": 20e3}, "position.z"),
        ({"speed": float("inf"), "Fz": 80e3}, "state.velocity.x"),
    ],
)
def test_bad_values_are_refused_by_their_names(fields, sentence):
    with pytest.raises((InvalidArgument, ValueError)) as refused:
        wheel_rail(**fields)
    assert sentence in str(refused.value)


def profiles_drawn(figure) -> int:
    return len(figure.axes[0].collections)  # wheel and rail are filled


def test_the_picture_needs_no_open_client():
    with contactd.local(in_process=True, config={"workers": 1}) as client:
        solution = client.wheel_rail(WheelRailSetup(), WheelRailState(velocity=WheelsetVelocity(x=2e4, pitch=-2e4 / 460), Fz=8e4))
        open_picture = profiles_drawn(solution.plot())
    closed_picture = profiles_drawn(solution.plot())
    del client
    gc.collect()
    assert open_picture == closed_picture == profiles_drawn(solution.plot()) == 2
    matplotlib.pyplot.close("all")


def test_the_picture_of_a_coroutine_has_the_profiles_too(shared_daemon):
    state = WheelRailState(velocity=WheelsetVelocity(x=2e4, pitch=-2e4 / 460), Fz=8e4)

    async def solved():
        async with AsyncClient(shared_daemon.endpoint) as client:
            solution = await client.wheel_rail(WheelRailSetup(), state)
            return solution, await asyncio.to_thread(lambda: profiles_drawn(solution.plot()))

    solution, while_open = asyncio.run(solved())
    assert (while_open, profiles_drawn(solution.plot()), solution.state) == (2, 2, state)
    matplotlib.pyplot.close("all")


def test_where_nothing_solves_any_more_contacts_are_drawn_without_profiles(monkeypatch, tmp_path):
    solution = wheel_rail(speed=20e3, Fz=80e3)
    contactd.default_client().close()
    with monkeypatch.context() as patch:
        patch.setitem(sys.modules, "contactd_local", None)
        patch.setenv("PATH", str(tmp_path))
        assert profiles_drawn(solution.plot()) == 0
    matplotlib.pyplot.close("all")


def test_a_solution_from_a_file_has_no_state(tmp_path):
    solution = wheel_rail(speed=20e3, Fz=80e3, fields=[])
    solution.save(tmp_path / "wheel.h5")
    assert contactd.load(tmp_path / "wheel.h5").state is None


def test_a_daemon_that_is_named_is_asked(monkeypatch, tmp_path):
    contactd.default_client().close()
    with monkeypatch.context() as patch:
        patch.setenv("CONTACTD_ENDPOINT", f"ipc://{tmp_path}/nobody")
        contactd.default_client().connect_timeout = 0.1
        with pytest.raises(ConnectionFailed):
            wheel_rail(speed=20e3, Fz=80e3)
        contactd.default_client().close()
