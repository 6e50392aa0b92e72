"""Computes states of a wheel of the bogie on worn profiles for contactctl wear: straight track and two curves. See
docs/damage.md.

Run: python3 client/python/examples/bogie/wear_states.py [--seconds 2] [--speed 50] [--integrator exudyn] FOLDER

FOLDER contains wheel.prw, written by contactctl wear. The program writes states.csv of the leading right wheel there.
It solves with contactd_local or a daemon, like the bogie example.
"""

from __future__ import annotations

import argparse
import sys
from collections.abc import Sequence
from dataclasses import replace
from pathlib import Path

sys.path.append(str(Path(__file__).parents[1]))  # for railway, which the examples share

from line import Line
from railway.track import IrregularTrack, Track
from railway.wheels import OnWheelset, SessionWheels
from runs import INTEGRATORS, Integrate, integrator, simulate

import contactd
from contactd import Client
from contactd.wear import WeightedState
from contactd.wear.dynamics import write_states
from contactd.wheel_rail import ProfileFile, WheelRailSetup, WheelRailState

RIGHT = 1  #: Index of the leading wheelset's right wheel.
SETTLED = 0.4  #: Fraction of the time from which states are used.


class HeardWheels:
    """Solves wheels with a worn profile; records the states and forces of one of them."""

    def __init__(self, client: Client, setups: Sequence[WheelRailSetup], wheel: ProfileFile) -> None:
        self._wheels = SessionWheels(client, [setup.replace(wheel=wheel) for setup in setups])
        self.kept: list[WheelRailState] = []

    def __call__(self, states: Sequence[WheelRailState]) -> list[OnWheelset]:
        answers = self._wheels(states)
        load = -float(answers[RIGHT].force[2])
        if load > 0:
            self.kept.append(replace(states[RIGHT], Fz=load))
        return answers

    def __enter__(self) -> HeardWheels:
        return self

    def __exit__(self, *of_an_error: object) -> None:
        self._wheels.__exit__(None, None, None)


def run(
    client: Client, wheel: ProfileFile, line: Line, track: Track, speed: float, seconds: float, integrate: Integrate
) -> list[WheelRailState]:
    """Returns the states of the leading right wheel, in the order of evaluation."""
    kept: list[WheelRailState] = []

    def open_wheels(client: Client, setups: Sequence[WheelRailSetup]) -> HeardWheels:
        wheels = HeardWheels(client, setups, wheel)
        wheels.kept = kept
        return wheels

    found = simulate(
        client, "fastsim", speed, seconds, integrate=integrate, line=line, track=track, open_wheels=open_wheels
    )
    if found.derailed:
        raise SystemExit(f"The bogie left the track at {speed:g} m/s after {found.times[-1]:.2f} s.")
    return kept


def states_of(
    client: Client, wheel: ProfileFile, speed: float, seconds: float, count: int, radius: float, integrate: Integrate
) -> list[WeightedState]:
    """Returns states on straight track, four fifths of the distance, and in a curve to each side (m)."""
    parts = [
        ("straight", 0.8, Line(), IrregularTrack(), speed),
        ("right curve", 0.1, _curve(radius), Track(), 30.0),
        ("left curve", 0.1, _curve(-radius), Track(), 30.0),
    ]
    found = []
    for group, weight, line, track, at in parts:
        kept = run(client, wheel, line, track, at, seconds, integrate)
        kept = kept[int(SETTLED * len(kept)) :]
        chosen = [kept[i * len(kept) // count] for i in range(count)]
        found += [WeightedState(state, weight / count, group) for state in chosen]
    return found


def _curve(radius: float) -> Line:
    """Returns a curve that begins immediately, so that a short run reaches it."""
    return Line(curvature=1e-3 / radius, cant=100.0, begin=1e3, transition=20e3, length=400e3)


def main() -> None:
    parser = argparse.ArgumentParser(prog="wear_states.py", description=(__doc__ or "").split("\n")[0])
    parser.add_argument("folder", type=Path, help="folder with wheel.prw, in which states.csv is written")
    parser.add_argument("--seconds", type=float, default=2.0, help="simulated time of each part (s); default: %(default)g")
    parser.add_argument("--speed", type=float, default=50.0, help="speed on straight track (m/s); default: %(default)g")
    parser.add_argument("--radius", type=float, default=600.0, help="radius of both curves (m); default: %(default)g")
    parser.add_argument("--count", type=int, default=20, help="states of each part; default: %(default)s")
    parser.add_argument(
        "--integrator", choices=INTEGRATORS, default="runge-kutta", help="default: %(default)s, which needs no Exudyn"
    )
    options = parser.parse_args()
    integrate = integrator(options.integrator)
    with contactd.local() as client:
        wheel = ProfileFile(options.folder / "wheel.prw")
        found = states_of(client, wheel, options.speed, options.seconds, options.count, options.radius, integrate)
    write_states(options.folder / "states.csv", found)


if __name__ == "__main__":
    main()
