"""Tests effects of collectives on wheels: bounded pressures, increasing conicity on straight track, converging
results."""

from __future__ import annotations

import random
from dataclasses import replace

import numpy as np
import pytest

from contactctl.wearing.convergence import settled
from contactd import EnergyWear, UsfdWear, WearLaw
from contactd.wear import WearStudy, WeightedState, conicities, evolve
from contactd.wear.evolution import place_of
from contactd.wear.states import mirrored
from contactd.wheel_rail import WheelRailSetup, WheelRailState, WheelsetPosition, WheelsetVelocity

USFD = WearLaw("usfd", "a test", "lower", (0, 1000), usfd=UsfdWear([(0, 0, 5.3), (10.4, 55, 0), (77.2, 55, 61.9)], 7850))
ENERGY = WearLaw("energy", "a test", "lower", (0, 1000), energy=EnergyWear(6.75e-4))
SPEED, RADIUS, HALF_BASE, CONICITY = 30e3, 460.0, 750.0, 0.18


def straight(count: int, seed: int = 1) -> list[WeightedState]:
    """Creates wheelsets that oscillate about the middle, with a fraction of the yaw rate of rolling cones."""
    chance = random.Random(seed)
    found = []
    for _ in range(count):
        y, yaw, load = chance.uniform(-2, 2), chance.uniform(-3e-4, 3e-4), 80e3 * chance.uniform(0.92, 1.08)
        rate = -0.7 * SPEED * CONICITY * y / (RADIUS * HALF_BASE)
        made = WheelRailState(
            position=WheelsetPosition(y=y, yaw=yaw), velocity=WheelsetVelocity(x=SPEED, pitch=-SPEED / RADIUS, yaw=rate), Fz=load
        )
        found.append(WeightedState(made, 1.0, "straight"))
    return found


def curves(count: int) -> list[WeightedState]:
    chance = random.Random(2)
    found = []
    for i in range(count):
        side = 1 if i % 2 else -1
        made = WheelRailState(
            position=WheelsetPosition(y=side * chance.uniform(5, 5.8), yaw=side * chance.uniform(1.5e-3, 2.2e-3)),
            velocity=WheelsetVelocity(x=SPEED, pitch=-SPEED / RADIUS), Fz=90e3 if side > 0 else 70e3,
        )  # fmt: skip
        found.append(WeightedState(made, count / 4, "curve"))
    return found


def test_straight_running_raises_the_conicity_at_5_mm(shared):
    study = WearStudy(WheelRailSetup(dx=0.8, dy=0.8), straight(24), "wheel", USFD, until=4000, depth=0.05)
    steps, place = list(evolve(shared, study)), place_of(shared, study)
    before, after = (conicities(shared, study, place, step)[1] for step in (steps[0], steps[-1]))
    assert before == pytest.approx(0.156, abs=2e-3)
    assert after > 1.1 * before


def test_the_largest_pressure_does_not_grow_in_twenty_steps(shared):
    study = WearStudy(WheelRailSetup(dx=0.8, dy=0.8), [*straight(12), *curves(4)], "wheel", USFD, until=1e6, depth=0.05)
    found = []
    for step in evolve(shared, study):
        found.append(step)
        if step.number == 20:
            break
    pressures = [step.pmax for step in found[1:]]
    assert max(pressures) <= 1.1 * pressures[0]
    assert found[-1].removed == pytest.approx(found[-1].area, rel=3e-4)


def test_what_auto_takes_off_is_near_the_finest(shared):
    study = WearStudy(WheelRailSetup(dx=0.6, dy=0.6), [*straight(8), *curves(2)], "wheel", ENERGY, until=400, depth=0.02)
    found = {one.name: one for one in settled(shared, study, 2, lambda *_: None, ["as given"])}
    assert found["finest"].difference == 0
    assert found["as given"].difference < 0.05
    assert found["as given"].area == pytest.approx(1, abs=0.03)


def test_a_mirrored_collective_wears_a_symmetric_wheelset(shared):
    study = WearStudy(WheelRailSetup(dx=0.8, dy=0.8), straight(4), "wheel", ENERGY, until=50, depth=0.05, symmetric=True)
    image = replace(study, states=[mirrored(one) for one in study.states])
    one, other = list(evolve(shared, study))[-1], list(evolve(shared, image))[-1]
    np.testing.assert_allclose(one.points, other.points, atol=1e-12)
