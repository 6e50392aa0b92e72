"""Functions of the extension contactd_local for tables."""

from __future__ import annotations

import importlib
import json
from collections.abc import Sequence
from pathlib import Path
from typing import Any

import click
import numpy as np
import numpy.typing as npt

from contactd import MissingExtra
from contactd.transport.in_process import can_solve_here

from .plan import Row, TablePlan

__all__ = ["read_table", "table_nodes", "write_table"]

Reals = npt.NDArray[np.float64]


def _extension() -> Any:
    if not can_solve_here():
        raise MissingExtra("Tables of creep forces", "contactd_local", "local", "python3-contactd-local")
    return importlib.import_module("contactd_local")


def table_nodes(plan: TablePlan, row: Row) -> tuple[float, Reals]:
    """Returns a/b and the scaled creepages of the nodes of a row, of shape [nodes, 3]."""
    ratio, creepages = _extension().creep_table_nodes(plan.ratios, plan.cells, row.nu, row.ratio, row.angle)
    return ratio, np.frombuffer(creepages).reshape(-1, 3)


def write_table(path: Path, plan: TablePlan, rows: Sequence[dict[str, Any]]) -> None:
    """Fits the table to the forces of all rows, in the order of the plan, and writes its file."""
    forces = np.concatenate([np.array(row["answers"]["forces"]) for row in rows])
    description = json.dumps(plan.described(list(rows)), allow_nan=False)
    extension = _extension()
    try:
        extension.write_creep_table(
            str(path.absolute()), plan.ratios, plan.cells, np.array(plan.nu).tobytes(), forces.tobytes(), description.encode()
        )
    except extension.Error as error:
        raise click.UsageError(str(error)) from None


def read_table(path: Path, nu: float | None, states: Reals) -> tuple[float, dict[str, Any], Reals]:
    """Returns the Poisson's ratio and the description of a table, and its forces for rows of a/b and the scaled creepages.
    Without `nu`, the ratio is the first of the file. Raises click.UsageError.
    """
    extension = _extension()
    try:
        found, description, forces = extension.read_creep_table(str(path.absolute()), nu, np.ascontiguousarray(states).tobytes())
    except extension.Error as error:
        raise click.UsageError(str(error)) from None
    return found, _described(description, path), np.frombuffer(forces).reshape(-1, 3)


def _described(description: str, path: Path) -> dict[str, Any]:
    """Returns the description of a table. Another program may have written it, with a right digest."""
    try:
        described: dict[str, Any] = json.loads(description)
        (low, high), coarse_and_fine = described["ratios"], described["recipe"]["elements"]
        (n, m), (finer_n, finer_m) = coarse_and_fine
        numbers = [*described["nu"], *described["cells"], low, high, n, m, finer_n, finer_m, described["nodes"], described["unconverged"]]
        is_known = described["program"].isprintable() and 0 < low < high and all(0 <= number < 1e12 for number in numbers)
    except (ValueError, LookupError, TypeError, AttributeError, RecursionError):
        is_known = False
    if not is_known:
        raise click.UsageError(f"{path.name} lacks the description that contactctl table build writes.")
    return described
