"""Creates friction of every kind: shifts and rolling, with creepages or forces of the problem's magnitude."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

import numpy as np

from .dice import Dice, Params

#: Creates the friction of a problem on a grid, from the size of its contact.
MakeFriction = Callable[[Dice, Params, "Scale"], Params]


@dataclass
class Scale:
    """Derives scales from a frictionless solution, so that motions and forces are neither tiny nor huge."""

    shift: float  # mm; about full slip, divided by the friction coefficient
    length: float  # mm; of the contact
    Fn: float


def coefficient(dice: Dice, grid: Params) -> Any:
    """Returns friction as a number, or as an array that varies a little from element to element."""
    mu = 0 if dice.chance(0.05) else dice.uniform(0.05, 1)
    if dice.chance(0.8):
        return mu
    values = [mu * dice.uniform(0.97, 1.1) for _ in range(grid["nx"] * grid["ny"])]
    return np.reshape(values, (grid["ny"], grid["nx"]))


def with_kinetic_or_force(dice: Dice, friction: Params, motion: Params, scale: Scale, velocity: float) -> None:
    """Adds slip-weakening friction or a prescribed force, each to some of the problems."""
    mu = float(np.max(friction["mu"]))
    if dice.chance(0.3):
        size, angle = dice.uniform(0, 0.95) * mu * scale.Fn, dice.uniform(0, 2 * math.pi)
        force = [size * math.cos(angle), size * math.sin(angle)]
        motion["force"] = dice.choice([force, [force[0], None], [None, force[1]]])
    elif dice.chance(0.2) and mu > 0:
        law = dice.choice(["linear", "exponential"])
        kinetic = float(np.min(friction["mu"])) * dice.uniform(0.5, 0.9)
        friction["kinetic"] = {"law": law, "mu": kinetic, "slip_velocity": 10 * mu * velocity}


def shift(dice: Dice, grid: Params, scale: Scale) -> Params:
    friction: Params = {"mu": coefficient(dice, grid)}
    size = float(np.max(friction["mu"])) * scale.shift * dice.log_uniform(0.05, 4)
    angle = dice.uniform(0, 2 * math.pi)
    friction["rigid_shift"] = [size * math.cos(angle), 0 if dice.chance(0.3) else size * math.sin(angle)]
    if dice.chance(0.4):
        friction["rotation"] = size / scale.length * dice.uniform(-1, 1)
    duration = friction["duration"] = dice.log_uniform(0.1, 10)
    with_kinetic_or_force(dice, friction, friction, scale, scale.shift / duration)
    return friction


def rolling(dice: Dice, grid: Params, scale: Scale) -> Params:
    friction: Params = {"mu": coefficient(dice, grid)}
    size = float(np.max(friction["mu"])) * scale.shift / scale.length * dice.log_uniform(0.02, 4)
    angle, velocity = dice.uniform(0, 2 * math.pi), dice.log_uniform(0.1, 1000)
    motion = {"xi": size * math.cos(angle), "eta": size * math.sin(angle), "velocity": velocity}
    if dice.chance(0.5):
        motion |= {"phi": size / scale.length * dice.uniform(-1, 1), "spin_offset": dice.uniform(0, 1)}
    if dice.chance(0.4):
        motion["chi"] = dice.uniform(-math.pi, math.pi)
    if dice.chance(0.4):
        motion["dq"] = grid["dx"] * dice.uniform(0.4, 2)
    friction["rolling"] = motion
    with_kinetic_or_force(dice, friction, motion, scale, velocity * scale.shift / scale.length)
    return friction


def transient(dice: Dice, grid: Params, scale: Scale) -> Params:
    friction = rolling(dice, grid, scale)
    friction["rolling"] |= {"kind": "transient", "steps": dice.choice([1, 2, 4])}
    return friction


def without(make: MakeFriction, *names: str) -> MakeFriction:
    """Creates friction with one coefficient and without these fields, for models that do not support them."""

    def made(dice: Dice, grid: Params, scale: Scale) -> Params:
        friction = make(dice, grid, scale)
        for part in (friction, friction.get("rolling", {})):
            for name in names:
                part.pop(name, None)
        return friction | {"mu": float(np.max(friction["mu"]))}

    return made
