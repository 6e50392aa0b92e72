"""Provides random numbers and the parts of random contact problems, reproducible by a seed on every machine."""

from __future__ import annotations

import math
import random
from typing import Any

import numpy as np

#: Values for the wire, whose arrays are still numpy's.
Params = dict[str, Any]


class Dice(random.Random):
    def chance(self, probability: float) -> bool:
        return self.random() < probability

    def log_uniform(self, low: float, high: float) -> float:
        return math.exp(self.uniform(math.log(low), math.log(high)))

    def size(self, smallest: int, largest: int) -> int:
        return round(self.log_uniform(smallest, largest))


def random_grid(dice: Dice, smallest: int = 3, largest: int = 24) -> Params:
    nx = dice.size(smallest, largest)
    ny = nx if dice.chance(0.3) else dice.size(smallest, largest)
    dx = dice.log_uniform(0.01, 1)
    grid = {"nx": nx, "ny": ny, "dx": dx, "dy": dx * (1 if dice.chance(0.4) else dice.log_uniform(0.2, 5))}
    if dice.chance(0.4):
        grid["x0"] = -nx * dx * dice.uniform(0.3, 0.7)
    return grid


def random_material(dice: Dice) -> Params:
    return {"G": dice.log_uniform(1, 1e5), "nu": 0.5 if dice.chance(0.1) else dice.uniform(0, 0.5)}


def random_bodies(dice: Dice) -> Params:
    one = random_material(dice)
    if dice.chance(0.4):
        return {"upper": one} if dice.chance(0.5) else {"upper": one, "lower": one}
    if dice.chance(0.3):
        return dice.choice([{"upper": {"rigid": True}, "lower": one}, {"upper": one, "lower": {"rigid": True}}])
    return {"upper": one, "lower": {**random_material(dice), "G": one["G"] * dice.log_uniform(0.2, 5)}}


def random_paraboloid(dice: Dice, grid: Params) -> tuple[Params, float]:
    """Returns a gap, and a depth at which bodies with this gap touch in a part of the grid (mm)."""
    half_x, half_y = 0.5 * grid["nx"] * grid["dx"], 0.5 * grid["ny"] * grid["dy"]
    if dice.chance(0.3):
        a = half_x * dice.uniform(0.3, 0.9)
        b = a if dice.chance(0.3) else half_y * dice.uniform(0.3, 0.9)
        return {"semi_axes": {"a": a, "b": b}}, a * dice.log_uniform(1e-3, 1e-2)
    depth = half_x * dice.log_uniform(1e-3, 1e-2)
    gap = {"Rx": half_x**2 / (2 * depth), "Ry": half_y**2 / (2 * depth) * dice.log_uniform(0.5, 2)}
    return {"paraboloid": gap}, depth * dice.uniform(0.2, 0.9)


def random_surface(dice: Dice, grid: Params) -> tuple[Params, float]:
    """Does the same for a gap given as an array: rough, several bumps, conformal, flat, or a ridge."""
    x = np.linspace(-1, 1, grid["nx"])[None, :]
    y = np.linspace(-1, 1, grid["ny"])[:, None]
    bend = dice.log_uniform(0.3, 3)
    flat = 0 * x * y
    match dice.choice(["rough", "bumps", "conformal", "flat", "ridge"]):
        case "rough":
            noise = [dice.uniform(0, 1) for _ in range(flat.size)]
            distance = x**2 + bend * y**2 + dice.log_uniform(1e-2, 0.5) * np.reshape(noise, flat.shape)
        case "bumps":
            tops = [(dice.uniform(-1, 1), dice.uniform(-1, 1), dice.uniform(0, 0.3)) for _ in range(4)]
            distance = np.min([height + 4 * ((x - at) ** 2 + (y - to) ** 2) for at, to, height in tops], axis=0)
        case "conformal":
            distance = 0.1 * (x**4 + bend * y**2)
        case "flat":
            distance = flat
        case _:
            distance = bend * np.abs(x) + 0.1 * y
    scale = grid["nx"] * grid["dx"] * dice.log_uniform(1e-3, 1e-2)
    depth = dice.log_uniform(0.05, 0.8) * max(float(np.ptp(distance)), 0.1)
    return {"array": distance * scale}, (float(distance.min()) + depth) * scale
