"""Creates requests that are mostly refused, because errors are answers, too."""

from __future__ import annotations

import json
from collections.abc import Callable
from typing import Any

from load.messages import Messages

from . import contacts, motions, sessions, tables
from .contacts import Play
from .dice import Dice, Params
from .wire import Raw, Request

STEEL = {"G": 82000, "nu": 0.28}
GRID = {"nx": 6, "ny": 5, "dx": 0.8, "dy": 0.8}
MESH: Params = {"source": "fem", "order": 1, "L_over_h": 20, "f": 2}
#: Refused values of single fields.
WRONG: dict[str, list[Any]] = {
    "mesh": ["tet", 1], "order": [0, 7, 1.5], "l_over_h": [0, 0.4, 65, 1.13], "h_over_hs": [1, 3, 4.5, 130],
    "f": [0.5, 11, "1.2"], "t1_over_hs": [-1, 1e-4, 2000], "L_over_h": [0, 0.9, 2, 1e10], "diagonal": ["along"],
    "max_dofs": [10, 10**9], "far_boundary": ["free"], "sampling": ["none", None], "solver": ["lu"],
    "stopping_criterion": ["never"], "tolerance": [0, 1, 1e-14], "max_iterations": [0, -1], "strength_threshold": [-0.1, 1],
    "preset": ["paper-test4"], "body": ["sphere"], "load_shape": ["linear"], "any_nu": [1], "accuracy": [1e-5, 1, 1e-2],
    "line_contact": [{"datum": 100}], "unknown": [1],
}  # fmt: skip
#: Changes of ics, grid and material, each of which is refused before anything is built.
IMPOSSIBLE: list[dict[str, Any]] = [
    *({"ics": {**MESH, name: value}} for name, values in WRONG.items() for value in values),
    {"ics": {**MESH, "mesh": "adaptive", "solver": "direct"}},
    {"ics": {**MESH, "mesh": "adaptive", "any_nu": True}},
    {"ics": {**MESH, "body": "block", "far_boundary": "half_space"}},
    {"ics": {**MESH, "load_shape": "bilinear", "l_over_h": 0.5}},
    {"ics": {**MESH, "l_over_h": 32, "h_over_hs": 32}},
    {"ics": {**MESH, "h_over_hs": 64, "l_over_h": 2}},
    {"ics": MESH, "material": {"G": 1, "nu": 0.5}},
    {"ics": {**MESH, "any_nu": True}, "material": {"G": 1, "nu": 0.495}},
    {"ics": {"source": "fem", "accuracy": 1e-2}, "material": {"G": 1, "nu": 0.495}},
    {"ics": {"source": "fem", "accuracy": 1e-2}, "grid": {**GRID, "dy": 10}},
    {"ics": {"source": "fem", "accuracy": 1e-2, "body": "block", "L_over_h": 2}},
    {"ics": {"source": "fem", "accuracy": 1e-2, "L_over_h": 20}},
    {"ics": {"source": "analytic", "body": "block"}},
    {"ics": {"source": "analytic", "accuracy": 1e-2}},
    {"ics": {"source": "analytic", "any_nu": True}},
    {"ics": {"source": "analytic", "line_contact": {"datum": 100}}},
    {"ics": {"source": "analytic", "line_contact": {"datum": 1}}, "grid": {**GRID, "ny": 1}},
    {"ics": {"source": "analytic"}, "grid": {**GRID, "dy": 1e3}},
]  # fmt: skip


def impossible_tables(dice: Dice) -> Play:
    for change in dice.sample(IMPOSSIBLE, 3):
        yield Request("ic.get", {"material": STEEL, "grid": GRID, **change})


BEGINNINGS: list[Callable[[Dice], Play]] = [
    lambda dice: contacts.with_friction(dice, contacts.half_spaces(dice, 6), motions.shift),
    lambda dice: contacts.with_friction(dice, contacts.line_contact(dice), motions.rolling),
    contacts.many,
    tables.get_analytic,
    tables.export,
]


def damaged(dice: Dice) -> Play:
    """Returns the first request of another kind, with one or two errors."""
    request = next(dice.choice(BEGINNINGS)(dice))
    assert isinstance(request, Request)
    if request.method == "contact.solve" and dice.chance(0.7):
        friction = dice.choice([motions.shift, motions.rolling, motions.transient])
        scale = motions.Scale(1e-3, 1, 1)
        request.params["friction"] = friction(dice, request.params["grid"], scale)
    if request.method == "contact.solve" and dice.chance(0.3):
        request.params = sessions.opening(dice, request.params, motions.shift, motions.Scale(1e-3, 1, 1))
        request.method = "session.open"
    text, *frames = request.parts("damaged")
    envelope = json.loads(text)
    accidents = Messages({"components": {"schemas": {}}, "methods": []}, dice.randrange(2**32))
    for _ in range(dice.choice([1, 1, 2])):
        accidents.damage(envelope)
    text = json.dumps(envelope).encode("utf-8", "surrogatepass")
    yield Raw(request.method, [text, *frames[: len(frames) - dice.chance(0.1)]])
