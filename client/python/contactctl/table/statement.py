"""States the errors of a table in words and numbers, and writes them into its file."""

from __future__ import annotations

import json
from collections.abc import Sequence
from typing import Any

import click
import numpy as np

from contactd.creep_tables import extension

from .bound_cells import BOUND_CELLS, cell_numbers, is_apex
from .check_plan import CANDIDATES, ROUNDS, CheckPlan, Search
from .checking import Findings
from .plan import Reals, opened

__all__ = ["certify"]


def certify(
    plan: CheckPlan, findings: Findings, searches: Sequence[Search], found: Sequence[dict[str, Any]], write: bool
) -> dict[str, Any]:
    """Returns the errors and the statement, and writes them with the bounds into the file of the table."""
    points = np.array([row["answers"]["point"] for row in found]).reshape(-1, 4)
    errors = np.array([row["answers"]["errors"] for row in found]).reshape(-1, 2)
    at_apex = is_apex(plan.ends)[cell_numbers(plan.ends, points)]
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
        "bounds": {"away": _range(bounds[~is_apex(plan.ends)]), "at_apex": _range(bounds[is_apex(plan.ends)])},
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


def _spread(errors: Reals) -> dict[str, Any]:
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

    ends = [plan.nu] if plan.nu is not None else sorted({plan.table.nu[0], plan.table.nu[-1]})
    of_apex = [
        "No state around the apex, pure spin at full slip with a/b above 2, was checked." if not result["errors"]["around the apex"]["states"] else
        f"Around the apex, pure spin at full slip with a/b above 2, the largest difference is {pair(result['largest_at_apex'])}, and the uncertainty {pair(result['solver_at_apex'])}.",
    ]  # fmt: skip
    sentences = [
        f"Against the full theory of half-spaces, nu {' to '.join(f'{nu:g}' for nu in ends)}, in parts of mu Fn (moments in brackets, of mu Fn c):",
        f"99.9 % of {result['points']} random states at {result['contacts']} random a/b are within {pair(result['errors']['random']['99.9 %'])}.",
        f"The largest difference of {result['states']} states, and of {result['searches']} searches of {result['solves_per_search']} solves from the worst, is {pair(result['largest'])}.",
        f"The uncertainty of the solves is {pair(result['solver'])}.",
        *(of_apex if is_apex(plan.ends).any() else []),
        f"Seed {plan.seed}, recipe {plan.recipe.text}; {result['unconverged']} states without a converged solve are left out.",
        "Other states may have larger differences.",
    ]  # fmt: skip
    return " ".join(sentences)
