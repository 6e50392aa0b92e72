"""The example that tells states of the bogie on worn wheels, as contactctl wear calls it: dynamics, wear, and dynamics again."""

from __future__ import annotations

import os
import sys

import numpy as np

from contactd import EnergyWear, WearLaw
from contactd.wear import WearStudy, WeightedState, evolve, read_states
from contactd.wear.dynamics import Dynamics, evolve_with, states_of_stage
from contactd.wheel_rail import WheelRailSetup, WheelRailState
from support.daemons import BIN
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
