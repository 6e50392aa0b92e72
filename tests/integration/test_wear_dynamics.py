"""Tests the loop of dynamics and wear: the calls for new states, their times, and their profiles."""

from __future__ import annotations

import sys
from dataclasses import replace

import numpy as np
import pytest

from contactd import EnergyWear, InvalidArgument, WearLaw
from contactd.wear import WearStudy, WeightedState, read_states
from contactd.wear.dynamics import Dynamics, evolve_with, states_of_stage, write_states
from contactd.wheel_rail import WheelRailSetup, WheelRailState, WheelsetPosition, WheelsetVelocity

LAW = WearLaw("energy", "a test", "lower", (0, 100), energy=EnergyWear(6.75e-4))


def states(y: float) -> list[WeightedState]:
    made = [
        WheelRailState(position=WheelsetPosition(y=y + dy, yaw=1e-3), velocity=WheelsetVelocity(x=30e3, pitch=-30e3 / 460), Fz=80e3)
        for dy in (-0.5, 0.5)
    ]
    return [WeightedState(one, 0.5, "straight") for one in made]


def study(first: list[WeightedState], until: float = 120) -> WearStudy:
    return WearStudy(WheelRailSetup(dx=0.8, dy=0.8), first, "wheel", LAW, until=until, depth=0.01)


def test_states_are_asked_for_again_when_the_profile_has_changed(shared, tmp_path):
    heard = []

    def tell(profiles, km):
        heard.append((km, profiles["wheel"].copy()))
        return states(1.0 + 0.2 * len(heard))

    dynamics = Dynamics(tell, tmp_path, depth=0.03, conicity=None)
    first = states_of_stage(dynamics, 0, {"wheel": np.zeros((3, 2))}, 0.0)
    steps = list(evolve_with(shared, study(first), dynamics))
    assert steps[-1].distance == 120 and steps[0].number == 0
    assert [step.number for step in steps] == list(range(len(steps)))
    stages = [step.stage for step in steps]
    assert sorted(stages) == stages and stages[-1] >= 1
    for number, (km, profile) in enumerate(heard[1:], 1):
        before = next(step for step in reversed(steps) if step.stage < number)
        assert km == before.distance
        np.testing.assert_array_equal(profile, before.points)
        deep = sum(step.depths.max() for step in steps[1:] if step.stage == number - 1)
        assert 0.03 <= deep < 0.03 + 0.011
    # Reported states are kept, and a resumed run requests none again.
    asked = len(heard)
    again = list(evolve_with(shared, study(first), dynamics, steps[:3]))
    assert len(heard) == asked
    np.testing.assert_array_equal(again[-1].points, steps[-1].points)
    assert (again[-1].number, again[-1].stage) == (steps[-1].number, steps[-1].stage)


def test_a_change_of_conicity_or_a_distance_asks_again(shared, tmp_path):
    for name, limit in (("conicity", {"conicity": 1e-6}), ("distance", {"conicity": None, "distance": 1e-3})):
        dynamics = Dynamics(lambda *_: states(1.0), tmp_path / name, depth=99, **limit)
        first = states_of_stage(dynamics, 0, {"wheel": np.zeros((3, 2))}, 0.0)
        steps = list(evolve_with(shared, study(first, 60), dynamics))
        assert [step.stage for step in steps[1:]] == list(range(len(steps) - 1))


PROGRAM = """
import sys
from pathlib import Path
folder = Path(sys.argv[-1])
assert (folder / "wheel.prw").is_file() and not (folder / "rail.prr").exists()
km = float((folder / "distance.txt").read_text())
(folder / "states.csv").write_text("position.y, Fz, weight\\n%r, 8e4, 1\\n" % (1 + km))
"""


def test_a_program_finds_profiles_and_leaves_states(tmp_path):
    dynamics = Dynamics([sys.executable, "-c", PROGRAM], tmp_path)
    (one,) = states_of_stage(dynamics, 3, {"wheel": np.zeros((3, 2))}, 7.5)
    assert one.state.position.y == 8.5 and one.state.Fz == 8e4
    assert (tmp_path / "stage-003" / "states.csv").is_file()


@pytest.mark.parametrize(
    ("program", "match"),
    [
        ([sys.executable, "-c", "import sys; sys.exit('no track')"], "ended with 1: .*no track"),
        ([sys.executable, "-c", ""], "wrote no states"),
        (["/no/such/program"], "cannot be started"),
        ([sys.executable, "-c", "import sys; open(sys.argv[-1] + '/states.csv', 'w').write('Fz, weight\\n8e4\\n')"], "cannot be read, which are in .*refused.csv: .*line 2"),
    ],
)
def test_a_program_that_fails_is_named(tmp_path, program, match):
    with pytest.raises(InvalidArgument, match=match):
        states_of_stage(Dynamics(program, tmp_path), 0, {"wheel": np.zeros((3, 2))}, 0.0)
    assert not (tmp_path / "stage-000" / "states.csv").exists(), "a program that has been mended is called again"


@pytest.mark.parametrize("bound", ["depth", "conicity", "distance"])
def test_a_bound_of_dynamics_is_positive(tmp_path, bound):
    with pytest.raises(InvalidArgument, match=f"dynamics.{bound} is -1; it must be positive"):
        Dynamics(["program"], tmp_path, **{bound: -1})


def test_states_are_written_as_they_are_read(tmp_path):
    given = [*states(1.0), WeightedState(WheelRailState(position=WheelsetPosition(y=-1e-17), Fz=7e4), 0.25, "a, b", 0.2)]
    given += [replace(given[0], group=name) for name in ("5 % of all", "#7!", 'the "old" line; a\tb', "_")]
    write_states(tmp_path / "states.csv", given)
    assert read_states(tmp_path / "states.csv") == given
    with pytest.raises(InvalidArgument, match="have Fz in some states only"):
        write_states(tmp_path / "states.csv", [given[0], WeightedState(WheelRailState(), 1.0)])
