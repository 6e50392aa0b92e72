"""Creates sessions: steps with changing loads, states that are saved and restored, and refused requests."""

from __future__ import annotations

from typing import Any

from .contacts import TRACTIONS, Play, half_spaces, normal_load, scale_of, solve
from .dice import Dice, Params, random_bodies, random_grid, random_surface
from .motions import MakeFriction, Scale
from .wire import Request

FIELDS = ["element_division", *TRACTIONS, "slip_x", "slip_y"]


def full(dice: Dice, make: MakeFriction) -> Play:
    yield from _session(dice, half_spaces(dice, 16), make)


def quick(dice: Dice, model: str, make: MakeFriction) -> Play:
    problem = normal_load(dice, {"grid": random_grid(dice), "bodies": random_bodies(dice)}, arrays=False)
    problem.pop("settings", None)
    yield from _session(dice, problem | {"model": model}, make)


def _session(dice: Dice, problem: Params, make: MakeFriction) -> Play:
    first = yield solve(dice, problem)
    if not first.ok:
        return
    scale = scale_of(problem, first)
    opened = yield Request("session.open", opening(dice, problem, make, scale))
    if not opened.ok:
        return
    session = {"session": opened.result["session"]}

    def step(number: int) -> Request:
        return Request("session.step", session | {"step": number} | _change(dice, problem, make, scale))

    last = step(1)
    yield last
    yield last
    saved = yield Request("session.save", session)
    yield step(2)
    yield step(3)
    yield step(7)
    yield Request("session.restore", session | {"state": saved.result["state"]})
    yield step(saved.result["step"] + 1)
    yield Request("session.info", session)
    yield Request("session.forget", session | {"state": saved.result["state"]})
    yield Request("session.restore", session | {"state": saved.result["state"]})
    yield Request("session.close", session)
    yield step(3)


def opening(dice: Dice, problem: Params, make: MakeFriction, scale: Scale) -> Params:
    """Returns the common values of the steps; gap and load of the steps may differ."""
    opening = {**problem, "accept_unconverged": True, "lease_seconds": 600}
    if dice.chance(0.9):
        opening["friction"] = make(dice, problem["grid"], scale)
    for name in ("gap", "approach"):
        if dice.chance(0.3):
            del opening[name]
    return opening


def _change(dice: Dice, problem: Params, make: MakeFriction, scale: Scale) -> Params:
    change: dict[str, Any] = {"gap": problem["gap"]} if dice.chance(0.6) else {}
    if "model" not in problem and dice.chance(0.2):
        change["gap"], _ = random_surface(dice, problem["grid"])
    if dice.chance(0.7):
        change["approach"] = problem["approach"] * dice.uniform(0.7, 1.1)
    elif scale.Fn > 0:
        change["Fn"] = scale.Fn * dice.uniform(0.7, 1.3)
    if dice.chance(0.6):
        friction = make(dice, problem["grid"], scale)
        for name in [name for name in ("mu", "kinetic") if dice.chance(0.7)]:
            friction.pop(name, None)
        change["friction"] = friction
    if dice.chance(0.7):
        change["fields"] = dice.sample(FIELDS, dice.randint(1, 6))
    return change
