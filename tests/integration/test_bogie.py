"""Tests the example of a bogie as users run it: in process and by a daemon, on straight track, in a curve, and above
the critical speed."""

from __future__ import annotations

import contextlib
import os
import re
import subprocess
import sys

import numpy as np
import pytest

import contactd
from support.daemons import BIN
from support.fmus import PACKAGES, VERSIONS, archive
from support.wheelset import BOGIE, bogie

__all__ = ["bogie"]


def run(*options, path=()):
    search = os.pathsep.join([*map(str, path), *(place for place in sys.path if place)])
    environment = {**os.environ, "PYTHONPATH": search, "PATH": f"{BIN}:{os.environ['PATH']}", "PYTHONDONTWRITEBYTECODE": "1"}
    return subprocess.run([sys.executable, BOGIE, *map(str, options)], capture_output=True, text=True, timeout=100, env=environment)


def test_the_bogie_goes_the_same_way_in_process_and_by_a_daemon(bogie, shared):
    track = bogie.track.IrregularTrack(seed=2, scale=3)
    with contactd.local(in_process=True) as here:
        for contact, duration in (("fastsim", 0.02), ("full", 0.01)):
            one, other = (bogie.runs.simulate(client, contact, 50, duration, track=track, y=2) for client in (here, shared))
            largest = np.abs(one.states).max(axis=0)
            assert np.all(np.abs(one.states - other.states).max(axis=0) <= 1e-9 * largest)
            assert one.solves == other.solves == 1000 * duration * 4 * 4


needs_fmpy = pytest.mark.skipif(PACKAGES is None, reason="this build has no FMUs: ./dev could not reach PyPI")


@needs_fmpy
@pytest.mark.parametrize("fmi", VERSIONS, ids=lambda version: f"FMI {version}")
def test_the_bogie_goes_the_same_way_by_fmus(bogie, shared, fmi):
    track = bogie.track.IrregularTrack(seed=2, scale=3)
    fmus = bogie.module("fmu_wheels").FmuWheels
    for contact, duration in (("linear", 0.02), ("fastsim", 0.02), ("full", 0.01)):
        one, other = (
            bogie.runs.simulate(shared, contact, 50, duration, track=track, y=2, open_wheels=opened)
            for opened in (bogie.wheels.SessionWheels, lambda _, setups: fmus(archive("contactd_wheel", fmi), setups))
        )
        largest = np.abs(one.states).max(axis=0)
        # Searches that start from the last step differ in the last digits. The integrator's error is up to 0.3 of the
        # largest of the nearly constant values.
        assert np.all(np.abs(one.states - other.states).max(axis=0) <= 1e-5 * largest)
        assert other.places == pytest.approx(one.places, abs=1e-6)
        assert one.solves == other.solves


@needs_fmpy
@pytest.mark.parametrize("fmi", VERSIONS, ids=lambda version: f"FMI {version}")
def test_fmus_know_where_no_elastic_contact_is(bogie, shared, fmi):
    setups = bogie.runs.wheel_setups("fastsim", bogie.vehicle.bogie())
    state = bogie.wheels.wheel_state("left", bogie.motion.Motion(0, 0, 50, 0, 0, 5e4, 0, 0, 0, -5e4 / 460, 0), bogie.track.Track())
    fmus = bogie.module("fmu_wheels").FmuWheels
    with fmus(archive("contactd_wheel", fmi), setups) as wheels:
        with fmus(archive("contactd_wheel", fmi), setups):
            pass  # what came and went meanwhile hears nothing
        with pytest.raises(contactd.InvalidArgument, match="elastic contact allows"):
            wheels(4 * [state])
    with pytest.raises(ValueError, match="contains dq"):
        fmus(archive("contactd_wheel", fmi), [setups[0].replace(dq=0.5)])


def test_its_energy_goes_to_dampers_and_rails(bogie, shared):
    errors = []
    for step in (1e-3, 5e-4):
        done = bogie.runs.simulate(shared, "fastsim", 50, 0.01, y=3, step=step)
        vehicle = bogie.vehicle.bogie()
        with bogie.wheels.SessionWheels(shared, bogie.runs.wheel_setups("fastsim", vehicle)) as wheels:
            rolling = bogie.rolling.Rolling(vehicle, wheels, done.line, bogie.track.Track())
            found = bogie.energy.balance(bogie.equations.Equations(rolling), done.times, done.states)
        errors.append(np.abs(found.error).max())
    assert errors[0] < 1e-3 * found.to_rails[-1]
    assert errors[1] < errors[0] / 8, "of the step's fourth order"
    # Friction from creepages and all other forces balance the forces on the rails, except for energy stored in
    # contacts.
    assert found.friction[-1] == pytest.approx(found.to_rails[-1], rel=0.3)


def test_who_solves_the_wheels_can_be_exchanged(bogie, shared):
    """Uses requests instead of sessions: the same function, with complete states."""

    class Requests(contextlib.AbstractContextManager):
        def __init__(self, client, setups):
            self.client, self.setups = client, setups

        def __call__(self, states):
            answers = [self.client.wheel_rail(setup, state, fields=[]) for setup, state in zip(self.setups, states)]
            return [bogie.wheels.on_wheelset(answer) for answer in answers]

        def __exit__(self, *of_an_error):
            pass

    one, other = (
        bogie.runs.simulate(shared, "fastsim", 50, 0.01, y=2, open_wheels=opened)
        for opened in (bogie.wheels.SessionWheels, Requests)
    )
    assert other.places == pytest.approx(one.places, abs=1e-6)
    assert other.solves == one.solves


def test_a_bogie_off_its_track_ends_its_run(bogie, shared):
    done = bogie.runs.simulate(shared, "fastsim", 40, 0.2, integrate=thrown(bogie))
    assert done.derailed
    assert len(done.times) == 2


def thrown(bogie):
    def integrate(equations, state, duration, step):
        bodies = state.reshape(-1, 12).copy()
        bodies[:, 1] += 16
        return np.array([0, duration]), np.vstack([state, bodies.ravel()])

    return integrate


def test_the_example_runs_and_draws(tmp_path):
    ended = run("--integrator", "runge-kutta", "--contacts", "fastsim", "--speeds", "50", "--seconds", "0.02", "--output", tmp_path)
    assert ended.returncode == 0, ended.stderr
    assert re.search(r"fastsim  50 m/s: y from -?\d\.\d\d to -?\d\.\d\d mm at the end, 320 solves; \d+\.\d s for", ended.stdout)
    assert (tmp_path / "bogie-hunting.png").stat().st_size > 10000
    assert (tmp_path / "bogie.gif").read_bytes()[:6] == b"GIF89a"


@needs_fmpy
def test_the_example_runs_with_an_fmu():
    ended = run(
        "--integrator", "runge-kutta", "--contacts", "fastsim", "--speeds", "50", "--seconds", "0.01",
        "--fmu", archive("contactd_wheel", 2),
    )  # fmt: skip
    assert ended.returncode == 0, ended.stderr
    assert "160 solves" in ended.stdout
    ended = run("--integrator", "runge-kutta", "--fmu", archive("contactd_contact", 2))
    assert ended.returncode == 1
    assert "it must be contactd_wheel" in ended.stderr


def test_without_exudyn_the_example_says_how_to_install_it(tmp_path):
    (tmp_path / "exudyn.py").write_text("raise ModuleNotFoundError('No module named exudyn')")
    ended = run(path=[tmp_path])
    assert ended.returncode == 1
    assert "exudyn is not installed: pip install './client/python[wheelset]'" in ended.stderr


@pytest.mark.parametrize(
    ("options", "complaint"),
    [
        (["--speeds", "3"], "at least 30 m/s"),
        (["--speeds", "nan"], "at least 30 m/s"),
        (["--seconds", "0"], "--seconds must be positive"),
        (["--element", "0"], "--element must be 0.1 to 2 mm"),
        (["--output", "/no/where"], "is not a folder"),
        (["--fmu", "/no/where"], "is not a file"),
        (["--fmu", BOGIE / "__main__.py", "--curve"], "--fmu requires --speeds"),
        (["--contacts", "elastic"], "invalid choice: 'elastic'"),
    ],
)
def test_options_that_make_no_sense_are_refused(options, complaint):
    ended = run(*options)
    assert ended.returncode == 2
    assert complaint in ended.stderr


@pytest.mark.slow  # integrates 2.5 seconds of motion
@pytest.mark.timeout(600)
def test_hunting_dies_down_below_the_critical_speed_grows_above_it_and_is_limited_by_the_flanges(bogie):
    with contactd.local(in_process=True) as client:
        growth = bogie.module("hunting").small_motions(client, "fastsim")
        assert growth(60).real < -0.5 < 0.5 < growth(90).real
        slow = bogie.runs.simulate(client, "fastsim", 60, 1.0, y=3)
        fast = bogie.runs.simulate(client, "fastsim", 90, 1.5, y=3)
    assert bogie.railway.growth_of_swing(slow.times, slow.places[:, 0]) < -0.5
    assert not fast.derailed
    late = fast.places[fast.times > 1.0]
    assert 4 < np.abs(late).max() < 11
