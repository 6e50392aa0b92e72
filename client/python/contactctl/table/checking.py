"""Compares a table with fresh solves, and states bounds of its errors."""

from __future__ import annotations

import json
from collections.abc import Sequence
from typing import Any

import click
import numpy as np
import numpy.typing as npt

from contactd.creep_tables import CreepTable, extension

from .check_plan import BOUND_CELLS, CANDIDATES, RANDOM, ROUNDS, CheckPlan, Search, cell_numbers, is_apex, measure
from .nodes import interpolated
from .plan import Reals, digest, opened

__all__ = ["Findings", "certify"]

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
        self.cells = cell_numbers(plan, self.points)
        self.near = is_apex(plan)[self.cells]
        shared, near = _pairs(np.vstack(shares)), is_apex(plan)[cell_numbers(plan, np.vstack(at_shares))]
        self.share = np.quantile(shared[~near], 0.99, axis=0)
        self.apex_share = np.maximum(shared[near].max(axis=0, initial=0), APEX_SHARE)

    def searches(self, count: int) -> list[Search]:
        """Returns searches from the worst states."""
        measured = measure(self.by_component)
        worst = np.argsort(-measured, kind="stable")[:count]
        starts = [(float(self.nu[i]), tuple(self.points[i].tolist()), float(measured[i])) for i in worst]
        return [Search(digest(self.plan.samples[0].key, *start), *start) for start in starts]

    def bounds(self, searched: tuple[Reals, Reals]) -> Reals:
        """Returns the bounds of all cells, of shape [cells, 2]: the solver's share, and the largest of twice the sampled
        differences and of those found by searches. Cells without a state have the largest bound.
        """
        largest: Reals = np.full((np.prod(BOUND_CELLS), 2), -1.0)
        np.maximum.at(largest, self.cells, FACTOR * self.errors)
        np.maximum.at(largest, cell_numbers(self.plan, searched[0]), searched[1])
        largest[largest < 0] = np.broadcast_to(largest.max(axis=0), largest.shape)[largest < 0]
        bounds: Reals = largest + np.where(is_apex(self.plan)[:, None], self.apex_share, self.share)
        return bounds


def certify(
    plan: CheckPlan, findings: Findings, searches: Sequence[Search], found: Sequence[dict[str, Any]], write: bool
) -> dict[str, Any]:
    """Returns the errors and the statement, and writes them with the bounds into the file of the table."""
    points = np.array([row["answers"]["point"] for row in found]).reshape(-1, 4)
    errors = np.array([row["answers"]["errors"] for row in found]).reshape(-1, 2)
    at_apex = is_apex(plan)[cell_numbers(plan, points)]
    bounds = findings.bounds((points, errors))
    random, near, all_errors = findings.random, findings.near, findings.errors
    small, no_spin = findings.points[:, 3] < 1, findings.points[:, 2] == 0
    worst = np.vstack([all_errors, errors])
    away, apex = (worst[part].max(axis=0, initial=0) for part in (~np.append(near, at_apex), np.append(near, at_apex)))
    result = {
        "nu": list(plan.table.nu) if plan.nu is None else plan.nu, "states": len(all_errors), "contacts": len(plan.samples), "points": int(random.sum()),
        "seed": plan.seed, "recipe": plan.recipe.described, "searches": len(searches), "solves_per_search": ROUNDS * CANDIDATES, "unconverged": findings.unconverged,
        "errors": {
            "random": _spread(all_errors[random]), "below full slip": _spread(all_errors[random & small & ~near]), "without spin": _spread(all_errors[random & no_spin]),
            "by cell": _spread(all_errors[~random & ~near]), "around the apex": _spread(all_errors[near]),
        },
        "largest": away.tolist(), "largest_at_apex": apex.tolist(), "solver": findings.share.tolist(), "solver_at_apex": findings.apex_share.tolist(),
        "bounds": {"away": _range(bounds[~is_apex(plan)]), "at_apex": _range(bounds[is_apex(plan)])},
    }  # fmt: skip
    result["statement"] = _statement(plan, result)
    if write:
        _write(plan, bounds, result)
    return result


def _write(plan: CheckPlan, bounds: Reals, result: dict[str, Any]) -> None:
    table = opened(plan.path)[0]
    description = {
        **table.description,
        "check": {key: value for key, value in result.items() if key != "statement"},
        "statement": result["statement"],
    }
    library = extension()
    try:
        library.certify_creep_table(
            str(plan.path.absolute()), BOUND_CELLS, bounds.tobytes(), json.dumps(description, allow_nan=False).encode()
        )
    except (library.Error, ValueError) as error:
        raise click.UsageError(str(error)) from None


def _pairs(errors: Reals) -> Reals:
    return np.column_stack([errors[:, :2].max(axis=1), errors[:, 2]])


def _spread(errors: npt.NDArray[np.float64]) -> dict[str, Any]:
    """Returns pairs of numbers for forces and moments; empty without states."""
    if not len(errors):
        return {"states": 0}
    quantiles = zip(("90 %", "99 %", "99.9 %"), np.quantile(errors, [0.9, 0.99, 0.999], axis=0).tolist(), strict=True)
    return {
        "states": len(errors),
        "mean": errors.mean(axis=0).tolist(),
        **dict(quantiles),
        "largest": errors.max(axis=0).tolist(),
    }


def _range(bounds: Reals) -> dict[str, list[float]]:
    if not len(bounds):
        return {}
    return {"median": np.median(bounds, axis=0).tolist(), "largest": bounds.max(axis=0).tolist()}


def _statement(plan: CheckPlan, result: dict[str, Any]) -> str:
    def pair(values: Sequence[float]) -> str:
        return "{:.2g} ({:.2g})".format(*values)

    nu = (
        f"{plan.nu:g}"
        if plan.nu is not None
        else " to ".join(f"{value:g}" for value in sorted({plan.table.nu[0], plan.table.nu[-1]}))
    )
    sentences = [
        f"Against the full theory of half-spaces, nu {nu}, in parts of mu Fn (moments in brackets, of mu Fn c):",
        f"99.9 % of {result['points']} random states at {result['contacts']} random a/b are within {pair(result['errors']['random']['99.9 %'])}.",
        f"The largest difference of {result['states']} states, and of {result['searches']} searches of {result['solves_per_search']} solves from the worst, is {pair(result['largest'])};",
        f"around the apex, pure spin at full slip with a/b above 2, it is {pair(result['largest_at_apex'])}.",
        f"The uncertainty of the solves is {pair(result['solver'])}, at the apex {pair(result['solver_at_apex'])}.",
        f"Seed {plan.seed}, recipe {plan.recipe.text}; {result['unconverged']} states without a converged solve are left out.",
        "Other states may have larger differences.",
    ]  # fmt: skip
    return " ".join(sentences)
