"""table: tables of creep forces, built, described and checked."""

from __future__ import annotations

import os
from functools import partial
from pathlib import Path
from typing import Annotated, Any

import click
import typer

from ..codes import Code, Ended
from ..common import Command, Group, setting
from ..files import writable
from ..output import counted, emit, facts, size
from ..table.check_plan import CheckPlan, Search
from ..table.checking import Findings
from ..table.nodes import node_row
from ..table.plan import TablePlan, opened
from ..table.recipes import RECIPES, recipe_named
from ..table.statement import certify
from ..table.work import Work

__all__ = ["add_to"]

File = Annotated[Path, typer.Argument(metavar="FILE", help="The file of the table.")]
Workers = Annotated[int, typer.Option("--workers", "-w", min=1, max=128, help="Number of requests at a time.")]
Grids = Annotated[
    tuple[int, int] | None,
    typer.Option(
        "--grids", metavar="N N", help="Other numbers of elements along the contact for a recipe of two grids."
    ),
]
RowsFile = Annotated[
    Path | None, typer.Option("--rows", help="File of the solved rows. Default: FILE.rows, or FILE.check.rows.")
]
ShareText = Annotated[
    str | None, typer.Option("--share", metavar="INDEX/COUNT", help="Solve a share of the rows: 0/16 to 15/16 are all.")
]
Dask = Annotated[
    str | None,
    typer.Option("--dask", metavar="SCHEDULER", help="Use the workers of a Dask cluster, such as tcp://host:8786."),
]
Retry = Annotated[bool, typer.Option("--retry", help="Solve rows again that failed or did not converge.")]
_PROCESSORS = os.cpu_count() or 1
_NAMES = ", ".join(RECIPES)


def add_to(app: typer.Typer) -> None:
    """Adds the commands of this family."""
    family = typer.Typer(cls=Group, help="Tables of creep forces.", rich_markup_mode=None)
    for command in (build, show, check):
        family.command(cls=Command)(command)
    app.add_typer(family, name="table")


def build(
    file: File,
    nu: Annotated[
        list[float], typer.Option("--nu", help="Poisson's ratio; repeat it for a table that interpolates.")
    ] = [0.28],  # noqa: B006
    ratios: Annotated[tuple[float, float], typer.Option("--ratios", metavar="A/B A/B", help="Range of a/b.")] = (
        0.05,
        20,
    ),
    cells: Annotated[
        tuple[int, int, int, int],
        typer.Option("--cells", metavar="N N N N", help="Cells of a/b, two angles, and creepage."),
    ] = (32, 40, 16, 32),
    recipe: Annotated[str, typer.Option("--recipe", help=f"Grids of the solves: {_NAMES}.")] = "double",
    grids: Grids = None,
    rows: RowsFile = None,
    workers: Workers = _PROCESSORS,
    share: ShareText = None,
    dask: Dask = None,
    retry: Retry = False,
) -> None:
    """Build a table of creep forces.

    If it is killed and started again, it continues. With --share, it only solves; without, it writes the table.

    Exit codes: 5 if nodes did not converge, which the table states; 4, 7 or 8 if rows failed.
    """
    plan = TablePlan(tuple(nu), ratios, cells, recipe_named(recipe, grids))
    writable("FILE", file)
    work = Work(rows or Path(f"{file}.rows"), share, workers, dask, retry)
    counts = [{"forces": 3 * row.nodes, "fallback": -1, "unconverged": -1} for row in plan.rows]
    found = work.solved(partial(node_row, plan=plan), plan.rows, counts)
    if work.part is not None:
        value: dict[str, Any] = {"file": None, "rows": len(work.part.cases(plan.rows))}
        emit(setting().json, value, f"{counted(value['rows'], 'row')} of {len(plan.rows)}")
        return
    assert found is not None, "Without shares, all rows are solved."
    plan.write(file, found)
    nodes, unconverged = sum(row.nodes for row in plan.rows), sum(len(row["answers"]["unconverged"]) for row in found)
    value = {"file": str(file), "rows": len(found), "nodes": nodes, "unconverged": unconverged}
    emit(setting().json, value, f"{file}: {size(file.stat().st_size)}, {counted(nodes, 'node')}")
    if unconverged:
        raise Ended(
            Code.NOT_CONVERGED,
            f"{counted(unconverged, 'node')} did not converge; the description of the table lists them.",
        )


def show(file: File) -> None:
    """Show the description of a table, after checking its digest."""
    table, plan = opened(file)
    rows = [
        ("Poisson's ratios", ", ".join(f"{value:g}" for value in plan.nu)),
        ("a/b", "{:g} to {:g}".format(*plan.ratios)),
        ("cells", " x ".join(map(str, plan.cells))),
        ("nodes", table.description["nodes"]),
        ("coarser grids", len(table.description["fallback"])),
        ("not converged", len(table.description["unconverged"])),
        ("recipe", plan.recipe.text),
        ("made by", table.description["program"]),
    ]
    rows.append(("errors", table.statement or "not checked; contactctl table check does this"))
    emit(setting().json, table.description, facts(file.name, rows))


def check(
    file: File,
    nu: Annotated[
        float | None, typer.Option("--nu", help="Only this Poisson's ratio. Default: random ones of the table.")
    ] = None,
    points: Annotated[
        int,
        typer.Option(
            "--points", min=10, max=10_000_000, help="Number of random states; about as many cover the cells."
        ),
    ] = 10_000,
    seed: Annotated[int, typer.Option("--seed", min=0, max=2**63 - 1, help="Seed of the states.")] = 7,
    searches: Annotated[
        int, typer.Option("--searches", min=0, max=100_000, help="Number of searches from the worst states.")
    ] = 100,
    recipe: Annotated[
        str | None,
        typer.Option(
            "--recipe", help=f"Grids of the solves, not those of the table: {_NAMES}. Default: square or fine."
        ),
    ] = None,
    grids: Grids = None,
    rows: RowsFile = None,
    workers: Workers = _PROCESSORS,
    share: ShareText = None,
    dask: Dask = None,
    retry: Retry = False,
) -> None:
    """Compare a table with fresh solves, and write bounds of its errors into its file.

    If it is killed and started again, it continues. With --share, it only solves: first the states, then, once all
    shares have solved theirs and the command is repeated, the searches. With --nu, it does not write into a table of
    several Poisson's ratios.
    """
    table, plan = opened(file, nu)
    writable("FILE", file)
    named = recipe_named(recipe or ("fine" if plan.recipe.name == "square" else "square"), grids)
    if named.name == plan.recipe.name:
        raise click.UsageError(f"--recipe is {named.name}, which built this table; give another one of {_NAMES}.")
    second = RECIPES["fine" if named.name == "square" else "square"]
    checked = CheckPlan(file.absolute(), plan, None if nu is None else table.nu, points, seed, named, second)
    work = Work(rows or Path(f"{file}.check.rows"), share, workers, dask, retry)
    states = work.solved(checked.solved, checked.samples, [checked.counts] * len(checked.samples))
    found: list[dict[str, Any]] | None = None
    starts: list[Search] = []
    if states is not None:
        findings = Findings(checked, states)
        starts = findings.searches(searches)
        found = work.solved(checked.solved, starts, [{"point": 4, "errors": 2}] * len(starts))
    if work.part is not None:
        parts = {"samples": len(work.part.cases(checked.samples)), "searches": len(work.part.cases(starts))}
        left = "" if found is not None else "; repeat the command when all shares have ended"
        emit(setting().json, parts, ", ".join(f"{count} {name}" for name, count in parts.items()) + left)
        return
    assert found is not None, "Without shares, all rows are solved."
    result = certify(checked, findings, starts, found, write=nu is None or len(plan.nu) == 1)
    lines = [(name, _spread(of)) for name, of in result["errors"].items()]
    lines.append(("statement", result["statement"]))
    emit(setting().json, result, facts(f"Errors of {file.name}: forces, moments", lines))


def _spread(of: dict[str, Any]) -> str:
    pairs = ((name, pair) for name, pair in of.items() if name != "states")
    return "; ".join(
        ["{} states".format(of["states"]), *("{} {:.2g}, {:.2g}".format(name, *pair) for name, pair in pairs)]
    )
