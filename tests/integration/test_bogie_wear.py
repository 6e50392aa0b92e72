"""Tests the example that computes states of the bogie on worn wheels, as contactctl wear calls it: dynamics, wear, and
dynamics again."""

from __future__ import annotations

import os
import subprocess
import sys

import numpy as np

from contactd import EnergyWear, WearLaw
from contactd.files.profile_text import format_profile
from contactd.wear import WearStudy, WeightedState, evolve, read_states
from contactd.wear.dynamics import Dynamics, evolve_with, states_of_stage
from contactd.wheel_rail import WheelRailSetup, WheelRailState
from support.daemons import BIN
from support.slowness import SLOWER
from support.wheelset import BOGIE

LAW = WearLaw("energy", "a test", "lower", (0, 1000), energy=EnergyWear(6.75e-4))
PROGRAM = [sys.executable, str(BOGIE / "wear_states.py"), "--seconds", "0.03", "--count", "3", "--speed", "40"]


def test_the_bogie_runs_on_the_wheels_that_it_has_worn(shared, tmp_path, monkeypatch):
    monkeypatch.setenv("PYTHONPATH", os.pathsep.join(place for place in sys.path if place))
    monkeypatch.setenv("PATH", f"{BIN}:{os.environ['PATH']}")
    dynamics = Dynamics(PROGRAM, tmp_path, depth=0.01, conicity=None)
    study = WearStudy(WheelRailSetup(dx=0.8, dy=0.8), [WeightedState(WheelRailState(), 1.0)], "wheel", LAW, until=300, depth=0.006)
    new = next(evolve(shared, study))
    first = states_of_stage(dynamics, 0, {"wheel": new.points}, 0.0)
    assert {one.group for one in first} == {"straight", "right curve", "left curve"}
    assert sum(one.weight for one in first) == 1 and len(first) == 9
    assert all(one.state.Fz > 0 and one.state.velocity.x > 25e3 for one in first)
    steps = list(evolve_with(shared, study, dynamics, steps=[new]))
    assert steps[-1].distance == 300 and steps[-1].stage >= 1
    again = read_states(tmp_path / "stage-001" / "states.csv")
    assert len(again) == 9 and again != first
    assert np.isfinite(steps[-1].points).all() and steps[-1].removed > 0


def critical(folder, *options):
    program = [sys.executable, str(BOGIE / "wear_critical.py"), *options, str(folder)]
    environment = {**os.environ, "PYTHONPATH": os.pathsep.join(place for place in sys.path if place), "PATH": f"{BIN}:{os.environ['PATH']}"}
    return subprocess.run(program, env=environment, capture_output=True, text=True, timeout=100 * SLOWER)


def test_the_critical_speed_falls_with_the_conicity_of_the_wheels(tmp_path):
    y = np.linspace(-60, 60, 241)
    for stage, slope in enumerate((0.05, 0.2)):  # the conicity of cones is their slope
        folder = tmp_path / f"stage-{stage:03d}"
        folder.mkdir()
        (folder / "wheel.prw").write_text(format_profile(np.stack([y, -slope * y], axis=-1), "wheel", ".prw", ["a cone"]))
        (folder / "distance.txt").write_text(f"{1000.0 * stage!r}\n")
    ended = critical(tmp_path, "--contact", "linear", "--tolerance", "1", "--picture", str(tmp_path / "critical.png"))
    assert ended.returncode == 0, ended.stderr
    new, worn = np.genfromtxt(tmp_path / "critical.csv", delimiter=",", names=True)
    assert (new["distance"], worn["distance"]) == (0, 1000)
    assert new["growth_low"] < 0
    assert new["critical_speed"] > 1.2 * worn["critical_speed"] > 48
    assert (tmp_path / "critical.png").stat().st_size > 5000


def test_a_folder_without_stages_and_speeds_that_are_none_are_refused(tmp_path):
    ended = critical(tmp_path)
    assert ended.returncode == 1 and "has no stage-000 with a wheel.prw" in ended.stderr
    ended = critical(tmp_path, "--between", "80", "40")
    assert ended.returncode == 2 and "the second above the first" in ended.stderr
