"""study: a sweep over the parameters of a problem."""

from __future__ import annotations

import csv
import io
import os
from collections import Counter
from pathlib import Path
from typing import Annotated, Any

import click
import typer

from ..codes import Code, Ended
from ..common import Command, connected, setting
from ..files import write_text
from ..output import above_rounding, emit, listing, note
from ..progress import Bar
from ..study.by_dask import run_by_dask
from ..study.here import run_here
from ..study.journal import Journal
from ..study.plan import Plan, read_plan

__all__ = ["add_to"]

_SHOWN = 40  # rows of a table for people; more go to a file


def add_to(app: typer.Typer) -> None:
    """Adds the commands of this family."""
    app.command(cls=Command)(study)


def study(
    file: Annotated[str, typer.Argument(help="JSON or YAML: problem, vary, together, answers, method.")],
    rows: Annotated[Path | None, typer.Option("--rows", help="Where rows are kept; else FILE.rows beside it.")] = None,
    workers: Annotated[int, typer.Option("--workers", "-w", min=1, max=128, help="Requests at a time.")] = os.cpu_count() or 1,
    dask: Annotated[str | None, typer.Option("--dask", metavar="SCHEDULER", help="By the workers of a Dask cluster, such as tcp://host:8786.")] = None,
    table: Annotated[Path | None, typer.Option("--csv", help="Write all rows to a CSV file, too.")] = None,
    fresh: Annotated[bool, typer.Option("--fresh", help="Solve all rows, also those that are there.")] = False,
    retry: Annotated[bool, typer.Option("--retry", help="Solve those again that failed or did not converge.")] = False,
) -> None:
    """Solve a problem for many values of its parameters.

    Killed at any moment and started again, it goes on where it was.

    Ends with 5 when rows did not converge, and with 4, 7 or 8 when rows failed.
    """
    plan = read_plan(file)
    if rows is None:
        if file == "-":
            raise click.UsageError("A study from standard input needs --rows, where its rows are kept.")
        rows = Path(f"{file}.rows")
    with Journal(rows) as journal:
        keys = {case.key for case in plan.cases}
        unwanted = keys if fresh else {key for key in keys if retry and journal.rows.get(key, {}).get("code")}
        if unwanted & journal.rows.keys():
            journal.forget(unwanted)
        if before := len(keys & journal.rows.keys()):
            note(f"{before} of {len(keys)} rows are in {rows}.")
        try:
            _solve(plan, journal, workers, dask)
        except BaseException:
            note(f"{len(keys & journal.rows.keys())} of {len(keys)} rows are in {rows}; the same command goes on.")
            raise
        found = [journal.rows[case.key] for case in plan.cases]
    _show(plan, found, table)


def _solve(plan: Plan, journal: Journal, workers: int, dask: str | None) -> None:
    todo = [case for case in plan.cases if case.key not in journal.rows]
    if not todo:
        return
    there = len(plan.cases) - len(todo)
    known = len(journal.rows)
    with Bar("study") as bar:

        def on_row() -> None:
            done = there + len(journal.rows) - known
            bar.show(done / len(plan.cases), f"{done} of {len(plan.cases)} rows")

        on_row()
        if dask is not None:
            run_by_dask(dask, setting(), plan, todo, journal, on_row)
            return
        with connected(workers=workers if setting().local else None) as client:
            run_here(client, plan, todo, journal, min(workers, len(todo)), on_row)


def _show(plan: Plan, rows: list[dict[str, Any]], table: Path | None) -> None:
    answers = [name for name in plan.answers if name not in plan.names]
    columns = [*plan.names, *answers]
    cells = [[*row["values"].values(), *(row.get("answers", {}).get(name) for name in answers)] for row in rows]
    shown = [_shown(columns, line) for line in cells[:_SHOWN]]
    if table is not None:
        written = io.StringIO()
        csv.writer(written, lineterminator="\n").writerows([[*columns, "error"], *([*line, row.get("error", "")] for line, row in zip(cells, rows))])
        write_text(table, written.getvalue())
    codes = Counter(row["code"] for row in rows)
    said = f"{len(rows)} rows: {codes.pop(Code.DONE, 0)} done"
    unconverged = codes.pop(Code.NOT_CONVERGED, 0)
    said += f", {unconverged} not converged" if unconverged else ""
    said += f", {codes.total()} failed" if codes else ""
    more = [f"... {len(rows) - _SHOWN} more rows: --csv FILE writes them all"] if len(rows) > _SHOWN else []
    emit(setting().json, {"rows": rows}, listing(None, columns, shown), *more, "", said)
    for row in [row for row in rows if "error" in row][:5]:
        note(f"failed: {row['values']}: {row['error']}")
    if codes:
        raise Ended(Code(min(codes)), f"{codes.total()} rows failed; --retry solves them again.")
    if unconverged:
        raise Ended(Code.NOT_CONVERGED, f"{unconverged} rows did not converge.")


def _shown(columns: list[str], cells: list[Any]) -> list[Any]:
    """For people, without what rounding leaves of forces."""
    forces = [name.startswith("forces.") and isinstance(cell, float) for name, cell in zip(columns, cells)]
    largest = max((abs(cell) for cell, is_force in zip(cells, forces) if is_force), default=0.0)
    return [above_rounding(cell, largest) if is_force else cell for cell, is_force in zip(cells, forces)]
