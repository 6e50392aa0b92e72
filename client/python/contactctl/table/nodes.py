"""Solves nodes of creep-force tables: steady rolling on two grids, extrapolated to fine elements."""

from __future__ import annotations

import math
import time
from typing import Any

import numpy as np
import numpy.typing as npt

from contactd import (
    Client,
    ContactProblem,
    Friction,
    Grid,
    Material,
    Rolling,
    SemiAxes,
    StatusError,
)
from contactd.calls.answer_warnings import collected

from ..codes import Code, code_of
from .extension import table_nodes
from .plan import Row, TablePlan

__all__ = ["Reals", "extrapolated", "solved_row"]

Reals = npt.NDArray[np.float64]
Bools = npt.NDArray[np.bool_]

FN, MU, G, SIZE = 50_000.0, 0.3, 82_000.0, 5.0  #: Of all nodes; scaled forces do not depend on them.
UNIT = MU * FN / (G * SIZE**2)
MOST_ELEMENTS = 400_000  #: In a request, below half the usual limit of a daemon.
FALLBACK = (25, 50)  #: Square grids where the solver of a node has not converged.


def extrapolated(client: Client, states: Reals, nu: float, grids: tuple[int, int], square: bool = False) -> tuple[Reals, Bools]:
    """Returns (Fx, Fy, Mz/c)/(mu Fn) with the sign of the creepages, extrapolated linearly in 1/n, and which solves on both
    grids have converged. `states` has rows of a/b and the scaled creepages. Raises StatusError.
    """
    coarse, fine = (_forces(client, states, nu, n, square) for n in grids)
    weight = grids[0] / (grids[1] - grids[0])
    return fine[0] + weight * (fine[0] - coarse[0]), coarse[1] & fine[1]


def solved_row(client: Client, plan: TablePlan, row: Row) -> dict[str, Any]:
    """Returns a row of the journal: forces of its nodes, and the numbers of those that needed the fallback or have not
    converged. Raises errors of the connection.
    """
    began = time.monotonic()
    ratio, creepages = table_nodes(plan, row)
    is_pole = row.angle in (0, plan.cells[1])
    distinct = plan.cells[3] - 1 if is_pole else len(creepages)
    states = np.column_stack([np.full(distinct, ratio), creepages[:distinct]])
    try:
        forces, converged = extrapolated(client, states, row.nu, plan.grids)
        fallback = np.flatnonzero(~converged)
        unconverged = fallback
        if len(fallback):
            forces[fallback], again = extrapolated(client, states[fallback], row.nu, FALLBACK, square=True)
            unconverged = fallback[~again]
    except StatusError as error:
        return {"code": int(code_of(error)), "error": str(error), "seconds": time.monotonic() - began}
    repeated = np.tile(forces, (plan.cells[2] + 1, 1)) if is_pole else forces
    answers = {"forces": repeated.ravel().tolist(), "fallback": fallback.tolist(), "unconverged": unconverged.tolist()}
    code = Code.NOT_CONVERGED if len(unconverged) else Code.DONE
    return {"code": int(code), "answers": answers, "seconds": time.monotonic() - began}


def _problem(state: Reals, nu: float, n: int, square: bool) -> ContactProblem:
    ratio, xi, eta, phi = map(float, state)
    a, b = SIZE * math.sqrt(ratio), SIZE / math.sqrt(ratio)
    rolling = Rolling(xi=xi * UNIT, eta=eta * UNIT, phi=phi * UNIT / SIZE, spin_offset=1 / 6 if square else 0.25)
    return ContactProblem(
        grid=Grid.centred(n, n if square else 2 * n, 2 * a, 2 * b), upper=Material(G, nu), gap=SemiAxes(a, b), Fn=FN,
        friction=Friction(mu=MU, rolling=rolling),
    )  # fmt: skip


def _forces(client: Client, states: Reals, nu: float, n: int, square: bool) -> tuple[Reals, Bools]:
    forces: Reals = np.empty((len(states), 3))
    converged: Bools = np.empty(len(states), dtype=np.bool_)
    batch = min(max(MOST_ELEMENTS // (n * n * (1 if square else 2)), 1), 100)
    for first in range(0, len(states), batch):
        problems = [_problem(state, nu, n, square) for state in states[first : first + batch]]
        with collected():  # The contact touches the border of the grid, which is the box around its ellipse.
            solutions = client.solve_many(problems, fields=(), timeout=client.build_timeout)
        for i, solution in enumerate(solutions, first):
            if isinstance(solution, StatusError):
                raise solution
            forces[i] = -solution.Fx, -solution.Fy, -solution.Mz / SIZE
            converged[i] = solution.converged
    forces /= MU * FN
    return forces, converged
