"""Creates contact problems of every kind. Each plays a few requests, of which later ones use earlier results."""

from __future__ import annotations

import math
from collections.abc import Generator

import numpy as np

from .dice import Dice, Params, random_bodies, random_grid, random_material, random_paraboloid, random_surface
from .motions import MakeFriction, Scale, rolling, shift, transient
from .wire import Answer, Raw, Request

Play = Generator[Request | Raw, Answer, None]
TRACTIONS = ("pressure", "traction_x", "traction_y")


def solve(dice: Dice, problem: Params) -> Request:
    return Request("contact.solve", problem, {"arrays": dice.choice(["frame", "frame", "list"])})


# --- what a problem consists of -----------------------------------------------------------------------------------------


def half_spaces(dice: Dice, largest: int = 24) -> Params:
    grid = random_grid(dice, 3, largest)
    problem: Params = {"grid": grid, "bodies": random_bodies(dice), "ics": {"source": "analytic"}}
    if dice.chance(0.3):
        problem["ics"]["load_shape"] = "bilinear"
    return normal_load(dice, problem)


def line_contact(dice: Dice) -> Params:
    grid = random_grid(dice, 6, 40) | {"ny": 1, "dy": dice.log_uniform(0.1, 100)}
    datum = grid["nx"] * grid["dx"] * dice.log_uniform(1.1, 100)
    ics = {"source": "analytic", "line_contact": {"datum": datum}}
    problem = {"grid": grid, "bodies": random_bodies(dice), "ics": ics}
    radius = (grid["nx"] * grid["dx"]) ** 2 / dice.log_uniform(1e-2, 1)
    problem["gap"] = {"paraboloid": {"Rx": radius}}
    problem["approach"] = (0.5 * grid["nx"] * grid["dx"]) ** 2 / (2 * radius) * dice.uniform(0.2, 2)
    return problem


def normal_load(dice: Dice, problem: Params, arrays: bool = True) -> Params:
    """Adds a gap and an approach, and sometimes settings."""
    make = random_surface if arrays and dice.chance(0.4) else random_paraboloid
    problem["gap"], depth = make(dice, problem["grid"])
    problem["approach"] = depth * (-1 if dice.chance(0.03) else 1)
    if dice.chance(0.2):
        problem["settings"] = {
            "normal": {"tolerance": dice.log_uniform(1e-9, 1e-4)},
            "tangential": {"tolerance": dice.log_uniform(1e-8, 1e-3), "max_iterations": dice.choice([5, 1000])},
            "outer": {"max_iterations": dice.choice([2, 100])},
        }
    return problem


# --- how a problem is played ------------------------------------------------------------------------------------------


def scale_of(problem: Params, answer: Answer) -> Scale:
    found = answer.result
    area = max(found["area"]["contact"], problem["grid"]["dx"] * problem["grid"]["dy"])
    largest = max(abs(found["approach"]), 1e-6)
    return Scale(0.5 * largest, math.sqrt(area), found["forces"]["Fn"])


def normal(dice: Dice, problem: Params) -> Play:
    """Prescribes the approach, then a force near the resulting one, with or without an estimate."""
    first = yield solve(dice, problem)
    if not first.ok:
        return
    force = first.result["forces"]["Fn"] * dice.uniform(0.6, 1.4)
    again = {key: value for key, value in problem.items() if key != "approach"} | {"Fn": force}
    if dice.chance(0.5):
        again["initial"] = {"pressure": first.array("pressure")}
    yield solve(dice, again)


def with_friction(dice: Dice, problem: Params, make: MakeFriction, history: bool = True) -> Play:
    """Solves without friction, with friction, and in half of the cases one more step from there."""
    first = yield solve(dice, problem)
    if not first.ok:
        return
    scale = scale_of(problem, first)
    if dice.chance(0.4) and scale.Fn > 0:
        problem = {key: value for key, value in problem.items() if key != "approach"} | {"Fn": scale.Fn}
    second = yield solve(dice, problem | {"friction": make(dice, problem["grid"], scale)})
    if not second.ok or not history or dice.chance(0.5):
        return
    tractions = {name: second.array(name) for name in TRACTIONS}
    place = dice.choice(["previous", "previous", "initial"])
    yield solve(dice, problem | {"friction": make(dice, problem["grid"], scale), place: tractions})


def quick(dice: Dice, model: str, make: MakeFriction) -> Play:
    """Closed forms: hertz, fastsim."""
    problem = normal_load(dice, {"grid": random_grid(dice), "bodies": random_bodies(dice)}, arrays=False)
    problem.pop("settings", None)
    yield from with_friction(dice, problem | {"model": model}, make, history=False)


def given_table(dice: Dice, make: MakeFriction) -> Play:
    """Provides coefficients of the pair in the request, from those of two materials."""
    grid = random_grid(dice, 3, 16)
    offsets = {name: grid[name] for name in ("nx", "ny", "dx", "dy")}
    tables = []
    for _ in range(2):
        answer = yield Request(
            "ic.get", {"material": random_material(dice), "grid": offsets, "ics": {"source": "analytic"}}
        )
        tables.append(answer.array("table"))
    upper, lower = tables[0], tables[dice.choice([0, 1])]
    pair = upper + lower
    for i, j in ((0, 2), (2, 0), (1, 2), (2, 1)):
        pair[i, j] = lower[i, j] - upper[i, j]
    ics = {"source": "table", "table": pair, "dx": grid["dx"], "dy": grid["dy"]}
    yield from with_friction(dice, normal_load(dice, {"grid": grid, "ics": ics}), make)


def many(dice: Dice) -> Play:
    """Sends several problems in one request, sometimes with an impossible one."""
    problems = [half_spaces(dice, 12) for _ in range(dice.choice([2, 3, 5]))]
    for problem in problems:
        if dice.chance(0.7):
            scale = Scale(0.5 * abs(problem["approach"]), 0.3 * problem["grid"]["nx"] * problem["grid"]["dx"], 1)
            problem["friction"] = dice.choice([shift, rolling, transient])(dice, problem["grid"], scale)
    if dice.chance(0.3):
        problems[-1]["gap"] = {"array": np.zeros((2, 2))}
    yield Request("contact.solve_many", {"problems": problems})
