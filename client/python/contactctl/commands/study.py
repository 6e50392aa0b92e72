"""Implements study, which solves a problem for many values of its parameters."""

from __future__ import annotations

import os
from collections import Counter
from collections.abc import Sequence
from pathlib import Path
from typing import Annotated, Any

import click
import typer

from ..codes import Code, Ended
from ..common import Command, connected, setting
from ..files import writable, write_text
from ..output import above_rounding, emit, listing, note, warn, warn_of
from ..progress import Bar
from ..saving import need
from ..study.by_dask import run_by_dask
from ..study.hdf5 import write_hdf5
from ..study.here import run_here
from ..study.journal import Journal
from ..study.plan import Case, Plan, read_plan
from ..study.shares import Rows, Share, best, check_ended, rows_beside, share_of
from ..writing.csv_files import csv_text

__all__ = ["add_to"]

_SHOWN = 40  # rows of a printed table; use a file for more


def add_to(app: typer.Typer) -> None:
    """Adds the commands of this family."""
    app.command(cls=Command)(study)


def study(
    file: Annotated[str, typer.Argument(help="JSON or YAML: problem, vary, together, answers, method.")],
    rows: Annotated[Path | None, typer.Option("--rows", help="File of the rows. Default: FILE.rows next to it.")] = None,
    workers: Annotated[int, typer.Option("--workers", "-w", min=1, max=128, help="Number of requests at a time.")] = os.cpu_count() or 1,
    share: Annotated[str | None, typer.Option("--share", metavar="INDEX/COUNT", help="Solve a share of the rows: 0/16 to 15/16 are all.")] = None,
    dask: Annotated[str | None, typer.Option("--dask", metavar="SCHEDULER", help="Use the workers of a Dask cluster, such as tcp://host:8786.")] = None,
    table: Annotated[Path | None, typer.Option("--csv", help="Write all rows to a CSV file.")] = None,
    arrays: Annotated[Path | None, typer.Option("--hdf5", help="Write all rows to an HDF5 file, as arrays over the varied fields.")] = None,
    fresh: Annotated[bool, typer.Option("--fresh", help="Solve all rows again.")] = False,
    retry: Annotated[bool, typer.Option("--retry", help="Solve rows again that failed or did not converge.")] = False,
) -> None:
    """Solve a problem for many values of its parameters.

    If it is killed and started again, it continues.

    Exit codes: 5 if rows did not converge; 4, 7 or 8 if rows failed.
    """
    plan = read_plan(file)
    if rows is None:
        if file == "-":
            raise click.UsageError("A study from standard input requires --rows, the file for its rows.")
        rows = Path(f"{file}.rows")
    part = None if share is None else share_of(share)
    _check_output(part, table, arrays, plan)
    cases = plan.cases if part is None else part.cases(plan.cases)
    with Journal(rows if part is None else part.file(rows)) as journal:
        if part is None:
            check_ended(rows)
        found = _solved(plan, cases, journal, {} if fresh else rows_beside(rows, journal.path), workers, dask, fresh, retry)
    if arrays is not None:
        write_hdf5(arrays, plan, found)
    _show(plan, found, table, range(1, len(plan.cases) + 1) if part is None else part.numbers(len(plan.cases)))


def _columns(plan: Plan) -> list[str]:
    return [*plan.names, *(name for name in plan.answers if name not in plan.names)]


def _check_output(part: Share | None, table: Path | None, arrays: Path | None, plan: Plan) -> None:
    """Checks the output before anything is solved."""
    for option, path in (("--csv", table), ("--hdf5", arrays)):
        if path is None:
            continue
        if part is not None:
            raise click.UsageError(f"{option} requires all rows. Give it to a command without --share when all shares are done.")
        writable(option, path, [*_columns(plan), "error"] if option == "--csv" else None)
    if arrays is not None:
        need("h5py", "HDF5 files", "hdf5")


def _solved(
    plan: Plan, cases: Sequence[Case], journal: Journal, beside: Rows, workers: int, dask: str | None, fresh: bool, retry: bool
) -> list[dict[str, Any]]:
    """Returns the rows of these cases; `beside` contains those of other files."""
    keys = {case.key for case in cases}
    there = best(journal.rows, beside)
    unwanted = keys if fresh else {key for key in keys if retry and there.get(key, {}).get("code")}
    if unwanted & journal.rows.keys():
        journal.forget(unwanted)
    there = {key: there[key] for key in (keys & there.keys()) - unwanted}

    def reported() -> str:
        return f"{len(keys & (there.keys() | journal.rows.keys()))} of {len(keys)} rows are in {journal.path}"

    if there:
        note(f"{reported()}{' and beside it' if there.keys() - journal.rows.keys() else ''}.")
    try:
        _solve(plan, [case for case in cases if case.key not in there], len(there), journal, workers, dask)
    except BaseException:
        note(f"{reported()}; repeat the command to continue.")
        raise
    found = best(journal.rows, there)
    return [found[case.key] for case in cases]


def _solve(plan: Plan, todo: Sequence[Case], there: int, journal: Journal, workers: int, dask: str | None) -> None:
    """Solves the cases, except the rows in `there`."""
    if not todo:
        return
    known = len(journal.rows)
    with Bar("study") as bar:

        def on_row() -> None:
            done = there + len(journal.rows) - known
            bar.show(done / (there + len(todo)), f"{done} of {there + len(todo)} rows")

        on_row()
        if dask is not None:
            run_by_dask(dask, setting(), plan, todo, journal, on_row)
            return
        with connected(workers=workers, local_unless_named=True) as client:
            run_here(client, plan, todo, journal, min(workers, len(todo)), on_row)


def _show(plan: Plan, rows: list[dict[str, Any]], table: Path | None, numbers: Sequence[int]) -> None:
    """Shows rows with their numbers in the study."""
    answers = [name for name in plan.answers if name not in plan.names]
    columns = _columns(plan)
    cells = [[*row["values"].values(), *(row.get("answers", {}).get(name) for name in answers)] for row in rows]
    shown = [_shown(columns, line) for line in cells[:_SHOWN]]
    if table is not None:
        write_text(table, csv_text([[*columns, "error"], *([*line, row.get("error", "")] for line, row in zip(cells, rows))]))
    codes = Counter(row["code"] for row in rows)
    given = f"{len(rows)} rows: {codes.pop(Code.DONE, 0)} done"
    unconverged = codes.pop(Code.NOT_CONVERGED, 0)
    given += f", {unconverged} not converged" if unconverged else ""
    given += f", {codes.total()} failed" if codes else ""
    more = [f"... {len(rows) - _SHOWN} more rows: {table or '--csv FILE'} lists all"] if len(rows) > _SHOWN else []
    emit(setting().json, {"rows": rows}, listing(None, columns, shown), *more, "", given)
    solved = [row["answers"] for row in rows if "answers" in row]
    warn(f"no answer has {name}" for name in answers if solved and all(found[name] is None for found in solved))
    warn_of("row", ((_named(number, row), str(sentence)) for number, row in zip(numbers, rows) for sentence in row.get("warnings", ())))
    for row in [row for row in rows if "error" in row][:5]:
        note(f"failed: {row['values']}: {row['error']}")
    if codes:
        raise Ended(Code(min(codes)), f"{codes.total()} rows failed; --retry solves them again.")
    if unconverged:
        raise Ended(Code.NOT_CONVERGED, f"{unconverged} rows did not converge.")


def _named(number: int, row: dict[str, Any]) -> str:
    values = ", ".join(f"{name} = {value}" for name, value in row["values"].items() if not isinstance(value, (dict, list)))
    return f"{number} ({values})" if values else str(number)


def _shown(columns: list[str], cells: list[Any]) -> list[Any]:
    """Returns printed values; forces without rounding errors."""
    forces = [name.startswith("forces.") and isinstance(cell, float) for name, cell in zip(columns, cells)]
    largest = max((abs(cell) for cell, is_force in zip(cells, forces) if is_force), default=0.0)
    return [above_rounding(cell, largest) if is_force else cell for cell, is_force in zip(cells, forces)]
