"""Measures the processor time of a state of a collective: a solve, wear by two laws, fatigue, and stresses of a
passage.

Run:  python3 bench/wear_states.py [--states 64] [--element 0.5]       (where contactd_local can be imported)

Every state is solved in process on the new profiles, with a prescribed force. Times of a development build are longer
than those of a production build.
"""

from __future__ import annotations

import argparse
import random
import time
from collections.abc import Iterator

import contactd
from contactd import (
    ArchardWear,
    DamageFunction,
    FatigueRequest,
    FatigueStrength,
    Passage,
    SeizureWear,
    SevereWear,
    UsfdWear,
    WearLaw,
    WearRequest,
)
from contactd.wheel_rail import WheelRailSetup, WheelRailState, WheelsetPosition, WheelsetVelocity

WEAR = WearRequest(
    [
        WearLaw("map", "a bench", "lower", (0, 1e6), archard=ArchardWear(3000, 3e-4, SevereWear(35e-4, (200, 700)), SeizureWear(350e-4, 0.8))),
        WearLaw("usfd", "a bench", "lower", (0, 1e6), usfd=UsfdWear([(0, 0, 5.3), (10.4, 55, 0), (77.2, 55, 61.9)], 7850)),
    ]
)
STRENGTH = FatigueStrength("steel", "a bench", 300, a_DV=1 / 3)
DAMAGE = DamageFunction("life", "a bench", (0, 1e6), [(0, 0, 0), (15, 0, 2e-7), (65, 1e-5, -9e-8)])


def states(count: int) -> Iterator[WheelRailState]:
    """Yields states on straight track, and a fifth of them in curves."""
    chance = random.Random(1)
    for i in range(count):
        side = chance.choice((-1, 1))
        y, yaw = (side * chance.uniform(5, 6), side * chance.uniform(1.5e-3, 2.5e-3)) if i % 5 == 0 else (chance.uniform(-2, 2), chance.gauss(0, 3e-4))
        speed = 30e3
        yield WheelRailState(
            position=WheelsetPosition(y=y, yaw=yaw), velocity=WheelsetVelocity(x=speed, pitch=-speed / 460), Fz=80e3 * chance.uniform(0.92, 1.08)
        )


def main() -> None:
    parser = argparse.ArgumentParser(description=(__doc__ or "").split("\n")[0])
    parser.add_argument("--states", type=int, default=64)
    parser.add_argument("--element", type=float, default=0.5, help="element size (mm)")
    options = parser.parse_args()
    size = {"dx": options.element, "dy": options.element}
    setups = {
        "no wear": WheelRailSetup(**size),
        "T gamma and wear by two laws": WheelRailSetup(**size, wear=WEAR),
        "and indices of fatigue": WheelRailSetup(**size, wear=WEAR, fatigue=FatigueRequest("lower", STRENGTH, [DAMAGE])),
        "and a passage at 6 depths": WheelRailSetup(**size, wear=WEAR, fatigue=FatigueRequest("lower", STRENGTH, [DAMAGE], Passage([0, 1, 2, 3, 4, 6]))),
    }
    given = list(states(options.states))
    with contactd.local(in_process=True) as client:
        for name, setup in setups.items():
            client.wheel_rail(setup, given[0], fields=[])
            began = time.process_time()
            for state in given:
                client.wheel_rail(setup, state, fields=[])
            print(f"{name:32} {1e3 * (time.process_time() - began) / len(given):7.2f} ms a state", flush=True)


if __name__ == "__main__":
    main()
