"""Tests the example of a wheelset as a user runs it, and compares its contacts with linear theory."""

from __future__ import annotations

import os
import re
import subprocess
import sys

import numpy as np
import pytest

from contactd import Client, Friction, Material, Paraboloid, Rolling
from contactd.values.generated.grid import Grid
from contactd.wheel_rail import ArcProfile, ConeProfile, Track, WheelRailFriction, WheelRailSetup
from support.wheelset import EXAMPLE, wheelset

__all__ = ["wheelset"]

LOAD = 54500.0  # of a wheel (N)
#: Cones of 1/20 on arcs of 300 mm, 750 mm from the middle. Without a bound of friction, fastsim is linear theory.
CONES = WheelRailSetup(
    wheel=ConeProfile(-0.05),
    rail=ArcProfile(300, slope=-0.05),
    track=Track(rail_origin=(750, 0)),
    model="fastsim",
    friction=WheelRailFriction(1000.0),
    dx=0.5,
    dy=0.5,
)


def run(endpoint, *options, path=()):
    environment = {**os.environ, "PYTHONPATH": os.pathsep.join([*map(str, path), str(EXAMPLE.parents[1])])}
    return subprocess.run(
        [sys.executable, EXAMPLE, "--endpoint", endpoint, *options],
        capture_output=True, text=True, timeout=100, env={**environment, "PYTHONDONTWRITEBYTECODE": "1"},
    )  # fmt: skip


def linear_theory(wheelset, client, rest):
    """Returns the forces of cones on arcs: Kalker's forces by the derivatives at zero creepage, Hertz's stiffness by a
    difference."""
    ellipse = {
        "model": "fastsim", "grid": Grid.centred(60, 60, 20, 20), "upper": Material(G=82000, nu=0.28),
        "gap": Paraboloid(Rx=460, Ry=300), "friction": Friction(1000.0, rolling=Rolling()),
    }  # fmt: skip
    solution = client.solve(**ellipse, Fn=LOAD, derivatives=True)
    more = client.solve(**ellipse, Fn=1.01 * LOAD)
    d = solution.derivatives
    creep = np.array([[getattr(getattr(d, force), by) for by in ("xi", "eta", "phi")] for force in ("Fx", "Fy", "Mz")])
    return wheelset.contact.LinearContact(
        load=LOAD, normal_stiffness=0.01 * LOAD / (more.approach - solution.approach), half_distance=750, radius=460,
        conicity=0.05, angle=0.05, creep=creep, rest=rest,
    )  # fmt: skip


def test_cones_on_arcs_agree_with_linear_theory(wheelset, shared):
    law = wheelset.contact.WheelRailContact(shared, CONES)
    rest = law.rest(2 * LOAD)
    theory = linear_theory(wheelset, shared, rest)
    straight = wheelset.motion.Motion(0, 0, rest, 0, 0, 4e4, 0, 0, 0, -4e4 / 460, 0)
    moves = {"y": 0.05, "roll": 1e-5, "yaw": 1e-4, "vx": 4, "vy": 4, "z": 1e-3, "yaw_rate": 0.01, "pitch_rate": 0.01}
    for field, step in moves.items():
        answers = []
        for contact in (law, theory):
            moved = [contact(straight._replace(**{field: getattr(straight, field) + s})) for s in (-step, step)]
            answers.append([(np.array(after) - before) for before, after in zip(*moved)])
        (force, moment), (expected_force, expected_moment) = answers
        # The lateral force due to y and roll is the difference of two larger ones: that of spin, and that of the
        # plane's angle.
        assert force == pytest.approx(expected_force, abs=0.06 * np.abs(expected_force).max()), field
        largest = max(np.abs(expected_moment).max(), 1.0 * np.abs(expected_force).max())  # an arm of a millimetre
        assert moment == pytest.approx(expected_moment, abs=0.06 * largest), field


def test_the_example_runs_and_draws(shared_daemon, tmp_path):
    ended = run(
        shared_daemon.endpoint, "--integrator", "runge-kutta", "--contacts", "fastsim", "full", "--speeds", "40",
        "--seconds", "0.08", "--output", tmp_path,
    )  # fmt: skip
    assert ended.returncode == 0, ended.stderr
    assert len(re.findall(r"40 m/s: y from -?\d\.\d\d to \d\.\d\d mm at the end, 640 solves", ended.stdout)) == 2
    assert re.search(r"full: \d+\.\d s for a simulated second, \d+\.\d\d times fastsim", ended.stdout)
    assert (tmp_path / "wheelset-hunting.png").stat().st_size > 10000


def test_without_exudyn_the_example_says_how_to_install_it(shared_daemon, tmp_path):
    (tmp_path / "exudyn.py").write_text("raise ModuleNotFoundError('No module named exudyn')")
    ended = run(shared_daemon.endpoint, path=[tmp_path])
    assert ended.returncode == 1
    assert "exudyn is not installed: pip install './client/python[wheelset]'" in ended.stderr


@pytest.mark.parametrize(
    ("options", "complaint"),
    [
        (["--speeds", "3"], "at least 30 m/s"),
        (["--seconds", "0"], "--seconds must be positive"),
        (["--output", "/no/where"], "is not a folder"),
        (["--contacts", "elastic"], "invalid choice: 'elastic'"),
    ],
)
def test_options_that_make_no_sense_are_refused(shared_daemon, options, complaint):
    ended = run(shared_daemon.endpoint, *options)
    assert ended.returncode == 2
    assert complaint in ended.stderr


def test_a_wheelset_that_leaves_the_track_ends_its_run(wheelset, shared):
    integrate = wheelset.runge_kutta.integrate
    done = wheelset.runs.simulate(shared, "fastsim", 30, 0.01, integrate=integrate, y=30)
    assert done.derailed
    assert list(done.y) == [30]

    def thrown(wheelset, state, duration, step):
        return np.array([0, duration]), np.vstack([state, 16 * np.eye(11)[1]])

    assert wheelset.runs.simulate(shared, "fastsim", 30, 0.3, integrate=thrown).derailed

    def broken(*arguments):
        raise ZeroDivisionError

    with pytest.raises(ZeroDivisionError):
        wheelset.runs.simulate(shared, "fastsim", 30, 0.01, integrate=broken)


@pytest.mark.slow  # integrates 1.5 seconds of motion
@pytest.mark.timeout(400)
def test_hunting_dies_down_grows_and_is_limited_by_the_flanges(wheelset, shared_daemon):
    with Client(shared_daemon.endpoint) as client:
        simulate, integrate = wheelset.runs.simulate, wheelset.runge_kutta.integrate
        slow = simulate(client, "fastsim", 35, 0.75, integrate=integrate, y=3)
        fast = simulate(client, "fastsim", 75, 0.75, integrate=integrate, y=1)
    assert wheelset.railway.growth_of_swing(slow.times, slow.y) < -0.5
    assert not fast.derailed
    assert 5 < np.abs(fast.y).max() < 11
