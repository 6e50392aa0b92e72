"""Solves states of steady rolling on several grids, and extrapolates their forces."""

from __future__ import annotations

import math
import time
from typing import Any

import numpy as np
import numpy.typing as npt

from contactd import Client, ContactProblem, CreepTable, Friction, Grid, Material, Rolling, SemiAxes, StatusError
from contactd.calls.answer_warnings import collected

from ..codes import Code, code_of
from .plan import Reals, Row, TablePlan
from .recipes import FALLBACK, Recipe

__all__ = ["Bools", "extrapolated", "interpolated", "node_row", "with_fallback"]

Bools = npt.NDArray[np.bool_]

FN, MU, G, SIZE = 50_000.0, 0.3, 82_000.0, 5.0  #: Of all solves; scaled forces do not depend on them.
UNIT = MU * FN / (G * SIZE**2)
MOST_ELEMENTS = 400_000  #: In a request, below half the usual limit of a daemon.


def extrapolated(client: Client, states: Reals, nu: float, recipe: Recipe) -> tuple[Reals, Bools]:
    """Returns (Fx, Fy, Mz/c)/(mu Fn) with the sign of the creepages, and which solves on all grids have converged.
    `states` has rows of a/b and the scaled creepages. Raises StatusError.
    """
    forces, converged = np.zeros((len(states), 3)), np.ones(len(states), dtype=np.bool_)
    for n, weight in zip(recipe.grids, recipe.weights):
        of_grid, are_good = _forces(client, states, nu, n, recipe)
        forces += weight * of_grid
        converged &= are_good
    return forces, converged


def with_fallback(client: Client, states: Reals, nu: float, recipe: Recipe) -> dict[str, list[Any]]:
    """Returns the answers of a row: the forces, and the numbers of the states that needed the coarser grids of the
    fallback, and of those that did not converge there either. Raises StatusError.
    """
    forces, converged = extrapolated(client, states, nu, recipe)
    fallback = np.flatnonzero(~converged)
    unconverged = fallback
    if len(fallback):
        forces[fallback], again = extrapolated(client, states[fallback], nu, FALLBACK)
        unconverged = fallback[~again]
    return {
        "forces": [*map(float, forces.ravel())],
        "fallback": [*map(int, fallback)],
        "unconverged": [*map(int, unconverged)],
    }


def node_row(client: Client, row: Row, plan: TablePlan) -> dict[str, Any]:
    """Returns a row of the journal. Raises errors of the connection."""
    began = time.monotonic()
    try:
        answers = with_fallback(client, plan.states(row), row.nu, plan.recipe)
    except StatusError as error:
        return {"code": int(code_of(error)), "error": str(error), "seconds": time.monotonic() - began}
    code = Code.NOT_CONVERGED if answers["unconverged"] else Code.DONE
    return {"code": int(code), "answers": answers, "seconds": time.monotonic() - began}


def interpolated(table: CreepTable, states: Reals) -> Reals:
    """Returns the forces of a table for these states, like `extrapolated`."""
    ratio, xi, eta, phi = states.T
    a, b = SIZE * np.sqrt(ratio), SIZE / np.sqrt(ratio)
    with collected():  # Creepages may be larger than those of any contact.
        found = table.forces(a, b, G, MU, FN, xi * UNIT, eta * UNIT, phi * UNIT / SIZE)
    return -np.column_stack([found.Fx, found.Fy, found.Mz / SIZE]) / (MU * FN)


def _problem(state: Reals, nu: float, n: int, recipe: Recipe) -> ContactProblem:
    ratio, xi, eta, phi = map(float, state)
    a, b = SIZE * math.sqrt(ratio), SIZE / math.sqrt(ratio)
    rolling = Rolling(xi=xi * UNIT, eta=eta * UNIT, phi=phi * UNIT / SIZE, spin_offset=recipe.spin_offset)
    return ContactProblem(
        grid=Grid.centred(n, recipe.across * n, 2 * a, 2 * b), upper=Material(G, nu), gap=SemiAxes(a, b), Fn=FN,
        friction=Friction(mu=MU, rolling=rolling),
    )  # fmt: skip


def _forces(client: Client, states: Reals, nu: float, n: int, recipe: Recipe) -> tuple[Reals, Bools]:
    forces: Reals = np.empty((len(states), 3))
    converged: Bools = np.empty(len(states), dtype=np.bool_)
    batch = min(max(MOST_ELEMENTS // (n * n * recipe.across), 1), 100)
    for first in range(0, len(states), batch):
        problems = [_problem(state, nu, n, recipe) for state in states[first : first + batch]]
        with collected():  # The contact touches the border of the grid, which is the box around its ellipse.
            solutions = client.solve_many(problems, fields=(), timeout=client.build_timeout)
        for i, solution in enumerate(solutions, first):
            if isinstance(solution, StatusError):
                raise solution
            forces[i] = -solution.Fx, -solution.Fy, -solution.Mz / SIZE
            converged[i] = solution.converged
    forces /= MU * FN
    return forces, converged
