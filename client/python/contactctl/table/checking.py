"""Compares a table with fresh solves, and computes bounds of its errors."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np

from contactd import CreepTable

from .bound_cells import BOUND_CELLS, adjacent, cell_numbers, is_apex
from .check_plan import RANDOM, CheckPlan, Search, measure
from .nodes import interpolated
from .plan import Reals, digest, opened

__all__ = ["Findings"]

FACTOR = 2.0  #: Of sampled differences, for the states between them: searches raised these 1.2 to 2.2 times.
LEAST_SHARE = 5e-5  #: The solver's share beside half the difference of two recipes.
APEX_SHARE = 1e-3  #: The solver's share at the apex, at least.


class Findings:
    """The differences of a table to the solves of all samples.

    Attributes:
        points: Points of all states, of shape [states, 4].
        nu: Poisson's ratio of each state.
        errors: Differences of (Fx, Fy)/(mu Fn), the larger one, and of Mz/(mu Fn c), of shape [states, 2].
        unconverged: Number of states that are left out, because their solves have not converged.
    """

    def __init__(self, plan: CheckPlan, rows: Sequence[dict[str, Any]]) -> None:
        self.plan = plan
        points, nus, errors, random, shares, at_shares = [], [], [], [], [], []
        self.unconverged = 0
        table: CreepTable | None = None
        for sample, row in zip(plan.samples, rows, strict=True):
            nu, at = plan.sampled(sample)
            table = table if table is not None and table.nu == nu else opened(plan.path, nu)[0]
            answers = row["answers"]
            solved = np.reshape(answers["forces"], (-1, 3))
            found = np.abs(interpolated(table, plan.table.states_at(at, nu)) - solved)
            second = np.reshape(answers["second"], (-1, 3))
            shares.append(np.abs(second - solved[RANDOM : RANDOM + len(second)]) / 2 + LEAST_SHARE)
            at_shares.append(at[RANDOM : RANDOM + len(second)])
            are_good = np.ones(len(at), dtype=np.bool_)
            are_good[answers["unconverged"]] = False
            self.unconverged += len(answers["unconverged"])
            points.append(at[are_good])
            nus.append(np.full(int(are_good.sum()), nu))
            errors.append(found[are_good])
            random.append((np.arange(len(at)) < RANDOM)[are_good])
        self.points, self.nu, self.by_component = np.vstack(points), np.concatenate(nus), np.vstack(errors)
        self.errors, self.random = _pairs(self.by_component), np.concatenate(random)
        self.cells = cell_numbers(plan.ends, self.points)
        self.near = is_apex(plan.ends)[self.cells]
        shared, near = _pairs(np.vstack(shares)), is_apex(plan.ends)[cell_numbers(plan.ends, np.vstack(at_shares))]
        self.share = np.quantile(shared[~near] if not near.all() else shared, 0.99, axis=0)
        self.apex_share = np.maximum(shared[near].max(axis=0, initial=0), APEX_SHARE)

    def searches(self, count: int) -> list[Search]:
        """Returns searches from the worst states."""
        measured = measure(self.by_component)
        worst = np.argsort(-measured, kind="stable")[:count]
        starts = [(float(self.nu[i]), tuple(self.points[i].tolist()), float(measured[i])) for i in worst]
        return [Search(digest(self.plan.samples[0].key, *start), *start) for start in starts]

    def bounds(self, searched: tuple[Reals, Reals]) -> Reals:
        """Returns the bounds of all cells, of shape [cells, 2]: the solver's share, and the largest of these differences:
        twice the sampled ones in the cell, those in adjacent cells except the apex, because a cell has few states, and
        those found by searches. Cells without a state have the largest bound.
        """
        sampled: Reals = np.full((np.prod(BOUND_CELLS), 2), -1.0)
        np.maximum.at(sampled, self.cells, self.errors)
        at_apex = is_apex(self.plan.ends)[:, None]
        largest = np.maximum(FACTOR * sampled, adjacent(np.where(at_apex, -1, sampled)))
        np.maximum.at(largest, cell_numbers(self.plan.ends, searched[0]), searched[1])
        largest = np.where(sampled < 0, largest.max(axis=0), largest)
        bounds: Reals = largest + np.where(at_apex, self.apex_share, self.share)
        return bounds


def _pairs(errors: Reals) -> Reals:
    """Returns the larger error of Fx and Fy, and that of Mz."""
    return np.column_stack([errors[:, :2].max(axis=1), errors[:, 2]])
