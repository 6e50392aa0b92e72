"""Creates tables of influence coefficients, closed forms and small finite-element builds, their files, and stresses
inside bodies."""

from __future__ import annotations

from typing import Any

import numpy as np

from .contacts import TRACTIONS, Play, half_spaces, scale_of, solve, with_friction
from .dice import Dice, Params, random_bodies, random_material, random_paraboloid
from .motions import shift
from .wire import Request

COMPONENTS = [i + j for i in "xyz" for j in "xyz"]
#: Offsets of all finite-element tables, so that few are built.
FEM_GRID = {"nx": 8, "ny": 6, "dx": 0.8, "dy": 0.8}


def offsets(dice: Dice) -> Params:
    dx = dice.log_uniform(0.01, 1)
    return {"nx": dice.size(1, 30), "ny": dice.size(1, 30), "dx": dx, "dy": dx * dice.log_uniform(0.1, 10)}


def analytic(dice: Dice) -> Params:
    """Parameters of ic.get."""
    grid = offsets(dice)
    ics: Params = {"source": "analytic", "load_shape": dice.choice(["constant", "bilinear"])}
    if dice.chance(0.2):
        grid["ny"] = 1
        ics["line_contact"] = {"datum": grid["nx"] * grid["dx"] * dice.log_uniform(1.1, 100)}
    return {"material": random_material(dice), "grid": grid, "ics": ics}


def get_analytic(dice: Dice) -> Play:
    """Requests a table, a part of it, and the table again from memory."""
    params = analytic(dice)
    yield Request("ic.get", params)
    first = dice.randrange(params["grid"]["ny"])
    part: Params = {"rows": {"first": first, "count": dice.randint(1, params["grid"]["ny"] - first)}}
    if dice.chance(0.5):
        part["components"] = dice.sample(COMPONENTS, dice.randint(1, 9))
    yield Request("ic.get", params | part, {"arrays": dice.choice(["frame", "list"])})


def export(dice: Dice) -> Play:
    params = analytic(dice)
    yield Request("ic.export", params | {"format": "hdf5"})
    if dice.chance(0.5):
        params["lower"] = random_material(dice)
    yield Request("ic.export", params | {"format": "contact"})


def small_mesh(dice: Dice) -> Params:
    """Requests coefficients by finite elements that take a fraction of a second."""
    mesh = dice.choice(["hex", "hex", "prism", "adaptive"])
    ics: Params = {
        "source": "fem", "mesh": mesh, "order": dice.choice([1, 1, 2]), "L_over_h": dice.choice([20, 33.3, 50]),
        "f": dice.choice([1.5, 1.7, 2.5]), "h_over_hs": dice.choice([2, 4]), "l_over_h": dice.choice([1, 1.5, 2]),
    }  # fmt: skip
    options: dict[str, list[Any]] = {
        "body": ["half_space", "block"], "load_shape": ["constant", "bilinear"], "t1_over_hs": [0, 0.7, 1.5],
        "diagonal": ["outward", "across"], "max_dofs": [1000, 3000], "sampling": ["fem", "linear", "linear_nodes"],
        "far_boundary": ["clamped", "half_space"], "solver": ["auto", "amg_pcg", "direct"],
        "stopping_criterion": ["residual", "update"], "tolerance": [1e-6, 1e-10], "max_iterations": [3, 500],
        "strength_threshold": [0.25, 0.5],
    }  # fmt: skip
    ics |= {name: dice.choice(values) for name, values in options.items() if dice.chance(0.4)}
    if mesh == "adaptive":
        ics["max_dofs"] = 2000
        if ics.get("solver") == "direct":
            del ics["solver"]
    if ics.get("body") == "block":
        ics.pop("far_boundary", None)
    return ics


def preset(dice: Dice) -> Params:
    name = dice.choice(["paper-test2", "paper-test3", "paper-mesh2-test2", "paper-mesh2-test3"])
    return {"source": "fem", "preset": name, "order": 1, "L_over_h": 40, "h_over_hs": 2, "f": 2}


def chosen_mesh(dice: Dice) -> Params:
    """Requests an accuracy, of a half-space, of a block, or for any Poisson's ratio."""
    ics: Params = {"source": "fem", "accuracy": dice.choice([1e-1, 3e-2])}
    if dice.chance(0.5):
        ics |= {"body": "block", "L_over_h": dice.choice([10, 20])}
    elif dice.chance(0.3):
        ics["any_nu"] = True
    return ics


def get_fem(dice: Dice) -> Play:
    """Requests a table that is built, then from memory at another scale, and as a file."""
    ics = dice.choice([small_mesh, small_mesh, small_mesh, preset, chosen_mesh])(dice)
    material = {"G": dice.log_uniform(1, 1e5), "nu": dice.choice([0, 0.28, 0.45])}
    built = yield Request("ic.get", {"material": material, "grid": FEM_GRID, "ics": ics})
    if not built.ok:
        return
    scaled = FEM_GRID | {"nx": 5, "dx": 0.1, "dy": 0.1}
    yield Request("ic.get", {"material": material | {"G": 80.0}, "grid": scaled, "ics": ics})
    if dice.chance(0.5):
        yield Request("ic.export", {"material": material, "grid": FEM_GRID, "ics": ics, "format": "hdf5"})


def contact_of_fem(dice: Dice) -> Play:
    """Shifts bodies whose coefficients are built."""
    bodies = {"upper": {"G": 200, "nu": 0.28}, "lower": {"G": 900, "nu": dice.choice([0.28, 0.45])}}
    ics = {"source": "fem", "preset": "paper-test2", "order": 1, "L_over_h": 40, "h_over_hs": 2}
    problem: Params = {"grid": FEM_GRID, "bodies": bodies, "ics": ics}
    problem["gap"], problem["approach"] = random_paraboloid(dice, FEM_GRID)
    yield from with_friction(dice, problem, shift)


def stored(dice: Dice) -> Play:
    """Lists the store's current contents."""
    yield Request("ic.list", {})


def subsurface(dice: Dice) -> Play:
    """Computes stresses under a contact with friction, on a block of points and at arbitrary points."""
    problem = half_spaces(dice, 10) | {"bodies": random_bodies(dice)}
    problem["ics"] = {"source": "analytic"}
    first = yield solve(dice, problem)
    if not first.ok:
        return
    friction = shift(dice, problem["grid"], scale_of(problem, first))
    second = yield solve(dice, problem | {"friction": friction})
    if not second.ok:
        return
    size = problem["grid"]["nx"] * problem["grid"]["dx"]
    params: Params = {"grid": problem["grid"], "nu": dice.uniform(0, 0.5), "body": dice.choice(["lower", "upper"])}
    params |= {name: second.array(name) for name in TRACTIONS}
    depths = np.array([0.0, *(-size * dice.log_uniform(1e-3, 2) for _ in range(3))])
    along = np.array([dice.uniform(-size, size) for _ in range(4)])
    yield Request("contact.subsurface", params | {"block": {"x": along, "y": along[:2], "z": depths}})
    points = np.array(
        [[dice.uniform(-size, size), dice.uniform(-size, size), -dice.uniform(0, size)] for _ in range(5)]
    )
    yield Request("contact.subsurface", params | {"points": points}, {"arrays": "list"})
