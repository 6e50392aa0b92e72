"""table: tables of creep forces, built, described and checked."""

from __future__ import annotations

import os
import time
from collections.abc import Sequence
from pathlib import Path
from typing import Annotated, Any

import numpy as np
import typer

from ..codes import Code, Ended
from ..common import Command, Group, connected, setting
from ..files import writable
from ..output import counted, emit, facts, note, size, span
from ..progress import Bar
from ..study.journal import Journal
from ..study.shares import Rows, best, check_ended, rows_beside, share_of
from ..table.building import build_by_dask, build_here
from ..table.checking import check_table
from ..table.extension import read_table, write_table
from ..table.plan import Row, TablePlan

__all__ = ["add_to"]

File = Annotated[Path, typer.Argument(metavar="FILE", help="The file of the table.")]
Workers = Annotated[int, typer.Option("--workers", "-w", min=1, max=128, help="Number of requests at a time.")]
Grids = Annotated[tuple[int, int], typer.Option("--grids", metavar="N N", help="Elements along the contact on both grids of each solve.")]
_PROCESSORS = os.cpu_count() or 1


def add_to(app: typer.Typer) -> None:
    """Adds the commands of this family."""
    family = typer.Typer(cls=Group, help="Tables of creep forces.", rich_markup_mode=None)
    for command in (build, show, check):
        family.command(cls=Command)(command)
    app.add_typer(family, name="table")


def build(
    file: File,
    nu: Annotated[list[float], typer.Option("--nu", help="Poisson's ratio; repeat it for a table that interpolates.")] = [0.28],  # noqa: B006
    ratios: Annotated[tuple[float, float], typer.Option("--ratios", metavar="A/B A/B", help="Range of a/b.")] = (0.05, 20),
    cells: Annotated[tuple[int, int, int, int], typer.Option("--cells", metavar="N N N N", help="Cells of a/b, two angles, and creepage.")] = (32, 40, 16, 32),
    grids: Grids = (36, 72),
    rows: Annotated[Path | None, typer.Option("--rows", help="File of the solved rows. Default: FILE.rows.")] = None,
    workers: Workers = _PROCESSORS,
    share: Annotated[str | None, typer.Option("--share", metavar="INDEX/COUNT", help="Solve a share of the rows: 0/16 to 15/16 are all.")] = None,
    dask: Annotated[str | None, typer.Option("--dask", metavar="SCHEDULER", help="Use the workers of a Dask cluster, such as tcp://host:8786.")] = None,
    retry: Annotated[bool, typer.Option("--retry", help="Solve rows again that failed or did not converge.")] = False,
) -> None:
    """Build a table of creep forces.

    If it is killed and started again, it continues. With --share, it only solves; without, it writes the table.

    Exit codes: 5 if nodes did not converge, which the table states; 4, 7 or 8 if rows failed.
    """
    plan = TablePlan(tuple(nu), ratios, cells, grids)
    writable("FILE", file)
    rows = rows or Path(f"{file}.rows")
    part = None if share is None else share_of(share)
    wanted = plan.rows if part is None else part.cases(plan.rows)
    with Journal(rows if part is None else part.file(rows)) as journal:
        if part is None:
            check_ended(rows)
        found = _solved(plan, wanted, journal, rows_beside(rows, journal.path), workers, dask, retry)
    failed = [row for row in found if "answers" not in row]
    if failed:
        raise Ended(Code(min(row["code"] for row in failed)), f"{counted(len(failed), 'row')} failed: {failed[0]['error']} --retry solves them again.")
    if part is None:
        write_table(file, plan, found)
    unconverged = sum(len(row["answers"]["unconverged"]) for row in found)
    nodes = len(found) * (cells[2] + 1) * (cells[3] - 1)
    value = {"file": None if part else str(file), "rows": len(found), "nodes": nodes, "unconverged": unconverged}
    emit(setting().json, value, f"{counted(len(found), 'row')}, {counted(nodes, 'node')}" if part else f"{file}: {size(file.stat().st_size)}, {counted(nodes, 'node')}")
    if unconverged:
        raise Ended(Code.NOT_CONVERGED, f"{counted(unconverged, 'node')} did not converge; the description of the table states their number.")


def _solved(
    plan: TablePlan, wanted: Sequence[Row], journal: Journal, beside: Rows, workers: int, dask: str | None, retry: bool
) -> list[dict[str, Any]]:
    """Returns the wanted rows; `beside` contains those of other files."""
    there = best(journal.rows, beside)
    keys = {row.key for row in wanted}
    unwanted = {key for key in keys & there.keys() if not plan.fits(there[key]) or (retry and there[key]["code"])}
    if unwanted & journal.rows.keys():
        journal.forget(unwanted)
    there = {key: there[key] for key in (keys & there.keys()) - unwanted}
    todo = [row for row in wanted if row.key not in there]
    if there:
        note(f"{len(there)} of {len(wanted)} rows are solved.")
    if todo:
        try:
            _solve(plan, todo, len(there), journal, workers, dask)
        except BaseException:
            note(f"{len(keys & (there.keys() | journal.rows.keys()))} of {len(wanted)} rows are solved; repeat the command to continue.")
            raise
    found = best(journal.rows, there)
    return [found[row.key] for row in wanted]


def _solve(plan: TablePlan, todo: Sequence[Row], there: int, journal: Journal, workers: int, dask: str | None) -> None:
    known, began = len(journal.rows), time.monotonic()
    with Bar("table") as bar:

        def on_row() -> None:
            done = len(journal.rows) - known
            left = f"about {span((time.monotonic() - began) / done * (len(todo) - done))} to go" if done else ""
            bar.show((there + done) / (there + len(todo)), f"{there + done} of {there + len(todo)} rows", left)

        on_row()
        if dask is not None:
            build_by_dask(dask, setting(), plan, todo, journal, on_row)
            return
        with connected(workers=workers, local_unless_named=True) as client:
            build_here(client, plan, todo, journal, min(workers, len(todo)), on_row)


def show(file: File) -> None:
    """Show the description of a table, after checking its digest."""
    _, described, _ = read_table(file, None, np.empty((0, 4)))
    cells = " x ".join(map(str, described["cells"]))
    rows = [
        ("Poisson's ratios", ", ".join(f"{value:g}" for value in described["nu"])),
        ("a/b", "{:g} to {:g}".format(*described["ratios"])),
        ("cells", cells),
        ("nodes", described["nodes"]),
        ("not converged", described["unconverged"]),
        ("elements", " and ".join(f"{n} x {m}" for n, m in described["recipe"]["elements"])),
        ("made by", described["program"]),
    ]
    emit(setting().json, described, facts(file.name, rows))


def check(
    file: File,
    nu: Annotated[float | None, typer.Option("--nu", help="Poisson's ratio. Default: the first of the table.")] = None,
    points: Annotated[int, typer.Option("--points", min=10, max=10_000_000, help="Number of random states.")] = 1000,
    seed: Annotated[int, typer.Option("--seed", min=0, help="Seed of the states.")] = 7,
    grids: Grids = (101, 201),
    workers: Workers = _PROCESSORS,
) -> None:
    """Compare a table with fresh solves of random states.

    The solves use square grids, which no table is built by.
    """
    with connected(workers=workers, local_unless_named=True) as client, Bar("check") as bar:
        found = check_table(client, file, nu, points, seed, grids, bar.show)
    rows = [
        ("states", f"{points} with Poisson's ratio {found['nu']:g}, seed {seed}"),
        ("solves", f"{grids[0]} x {grids[0]} and {grids[1]} x {grids[1]} elements, extrapolated"),
        *((name, f"mean {of['mean']:.2g}, 90 % {of['90 %']:.2g}, 99 % {of['99 %']:.2g}, largest {of['largest']:.2g}") for name, of in found["errors"].items()),
        ("not converged", found["unconverged"]),
    ]
    emit(setting().json, found, facts(f"Errors of {file.name}", rows))
