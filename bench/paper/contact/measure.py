"""Makes one computation: a contact problem solved by a private daemon."""

from __future__ import annotations

from contextlib import AbstractContextManager
from pathlib import Path
from typing import Any

import numpy as np

from contactd import Client, ContactProblem, ContactSolution, Grid, InternalError, TableIcs

from ..measuring import measuring
from ..section import Measure
from .problem import BODY, Ics, Spec, contact_problem, ics_of

_TANGENTIAL = [(0, 0), (0, 1), (1, 0), (1, 1)]
_COUPLING = [(0, 2), (2, 0), (1, 2), (2, 1)]  # these vanish for a pair of equal bodies


def solver(programs: Path) -> AbstractContextManager[Measure]:
    """Provides a daemon during the `with` block."""
    return measuring(programs, lambda client: Solver(client).measure)


class Solver:
    """Solves requests with a daemon, one after the other."""

    def __init__(self, client: Client) -> None:
        self._client = client

    def measure(self, spec: Spec) -> dict[str, Any]:
        """Returns the values for the figures. If a table or a solve did not converge, returns {"failure": text}."""
        try:
            solution = self._client.solve(self._problem(spec))
        except InternalError as error:
            if "did not converge" not in error.message:
                raise
            return {"failure": error.message}
        if not solution.converged:
            return {"failure": "The contact problem did not converge."}
        return summary_of(solution)

    def _problem(self, spec: Spec) -> ContactProblem:
        problem = contact_problem(spec)
        if "tangential" not in spec and "no_xy" not in spec:
            return problem
        return problem.replace(upper=None, ics=self._mixed(problem.grid, spec))

    def _mixed(self, grid: Grid, spec: Spec) -> TableIcs:
        """Combines zz of one table with xx, xy, yx and yy of another."""
        array = 2 * self._table(grid, spec["ics"])  # two equal bodies
        if "tangential" in spec:
            other = 2 * self._table(grid, spec["tangential"])
            for pair in _TANGENTIAL:
                array[pair] = other[pair]
        for pair in [*_COUPLING, *([(0, 1), (1, 0)] if spec.get("no_xy") else [])]:
            array[pair] = 0
        return TableIcs(array, grid.dx, grid.dy)

    def _table(self, grid: Grid, ics: Ics) -> Any:
        return np.array(self._client.get_ic(BODY, grid, ics_of(ics)).array)


def summary_of(solution: ContactSolution) -> dict[str, Any]:
    evidence = solution.evidence
    assert evidence.tangential is not None
    table = next(iter(evidence.ics.values())).evidence  # the upper body; the lower one has the same
    return {
        "Fz": solution.Fn,
        "Fx": abs(solution.Fx),
        "Fy": solution.Fy,
        "pmax": solution.pmax,
        "area": solution.area.contact,
        "adhesion": solution.elements.adhesion,
        "slip": solution.elements.slip,
        "iterations_normal": evidence.normal.iterations,
        "iterations_tangential": evidence.tangential.iterations,
        "dofs": table.dofs,
        "origin_zz": table.errors.zz.origin if table.errors else 0.0,
    }
