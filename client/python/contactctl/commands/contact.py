"""Implements contact, which computes cases of the CONTACT program's input files."""

from __future__ import annotations

import os
from collections import Counter
from collections.abc import Sequence
from pathlib import Path
from typing import Annotated, Any, Literal

import click
import typer

from contactd import Client
from contactd.contact_files.out_file import out_text
from contactd.contact_files.out_reader import printed_cases
from contactd.contact_files.python_text import python_text
from contactd.contact_files.runner import Runner, chains_of, requests_of

from ..cases.comparing import compared_rows
from ..cases.converting import as_yaml
from ..cases.files import CaseFiles, read_printed
from ..cases.reading import ReadFile, read_cases
from ..cases.rows import case_name, code_of_status, keys_of, row_values
from ..cases.running import run_requests
from ..codes import Code, Ended
from ..common import Command, Group, connected, setting
from ..files import writable, write_text
from ..output import emit, listing, note, warn_of
from ..progress import Bar
from ..study.journal import Journal

__all__ = ["add_to"]

File = Annotated[Path, typer.Argument(help="An input file of the CONTACT program (.inp).")]
_MOST_SHOWN = 40  #: Statuses that need an explanation.
_ELEMENTS = {"reid": "result element", "cpid": "contact problem"}  #: Optional columns next to the number of a case.


def add_to(app: typer.Typer) -> None:
    """Adds the commands of this family."""
    family = typer.Typer(cls=Group, help="Cases of the CONTACT program's input files.", rich_markup_mode=None)
    family.command(cls=Command)(check)
    family.command(cls=Command)(run)
    family.command(cls=Command)(convert)
    app.add_typer(family, name="contact")


def check(file: File) -> None:
    """Show which cases can be computed, and why others cannot.

    Exit codes: 4 if cases need unsupported features, 2 if the file has errors.
    """
    with connected(local_unless_named=True) as client:
        read_file = _read(file, client)
        found = read_file.runner(client, file.name).checked(read_file.content.cases)
    rows = [{**_named(row_values(one.case)), "status": _status_text(one.status), "why": one.sentence} for one in found]
    counts = Counter(str(row["status"]) for row in rows)
    remarks = [row for row in rows if row["why"]]
    emit(setting().json, {"cases": rows}, *_listed(remarks, f"{_cases(len(rows))}: {_counted(counts)}"))
    _end([str(one.status) for one in found], read_file)


def run(
    file: File,
    compare: Annotated[Path | None, typer.Option("--compare", metavar="FILE.out", help="Compare the numbers with those printed in an .out file.")] = None,
    output: Annotated[Path | None, typer.Option("--output", "-o", metavar="FILE.out", help="Output file or folder. Default: next to the input file.")] = None,
    workers: Annotated[int, typer.Option("--workers", "-w", min=1, max=128, help="Number of cases at a time.")] = os.cpu_count() or 1,
    wheel: Annotated[str, typer.Option("--wheel", help="Wheel surface: exact, or bilinear as in the CONTACT program.")] = "exact",
    fresh: Annotated[bool, typer.Option("--fresh", help="Compute all cases again.")] = False,
) -> None:
    """Compute the cases of a file, and write its .out, .mat and .subs files.

    If it is killed and started again, it continues. Exit codes: 5 if cases did not converge or numbers differ, 4 if
    cases need unsupported features or are refused, 2 if the file has errors.
    """
    if wheel not in ("exact", "bilinear"):
        raise click.UsageError(f"--wheel {wheel}: it must be exact or bilinear.")
    surface: Literal["exact", "bilinear"] = "exact" if wheel == "exact" else "bilinear"
    if not file.name:  # A folder has no extension.
        raise click.UsageError(f"{file} is a folder; it must be an input file of CONTACT.")
    place = writable("--output", output or file.with_suffix(".out"))
    printed = None if compare is None else printed_cases(read_printed(compare))
    if printed is not None and not printed:
        raise click.UsageError(f"--compare {compare}: the file has no printed case; give an .out file of CONTACT.")
    with connected(workers=workers, local_unless_named=True) as client:
        read_file = _read(file, client)
        cases = read_file.content.cases
        options = {"wheel": wheel, "files": read_file.files.digests(cases)}
        files = CaseFiles(place)
        files.check(cases)
        runner = read_file.runner(client, file.name, surface)
        rows = _computed(runner, read_file, options, Path(f"{place}.rows"), workers, fresh, files)
    ordered = [rows[id(case)] for case in cases]
    write_text(place, out_text(row["answers"]["lines"] for row in ordered))
    Path(f"{place}.rows").unlink(missing_ok=True)
    statuses = _show(ordered, place, None if printed is None else compared_rows(ordered, printed))
    _end(statuses, read_file)


def convert(
    file: File,
    output: Annotated[Path, typer.Argument(help="FILE.yaml for one case, FILE.py for all.")],
    case: Annotated[int | None, typer.Option("--case", metavar="N", help="The N-th case of the file.")] = None,
) -> None:
    """Convert cases to YAML for contactctl solve, or to a Python program.

    A program names the cases that it does not contain. Exit codes: 4 if these need unsupported features, 2 if the file
    has errors.
    """
    if output.suffix not in (".yaml", ".py"):
        raise click.UsageError(f"{output}: the name must end in .yaml or .py.")
    place = writable("convert", output)
    with connected(local_unless_named=True) as client:
        read_file = _read(file, client)
        cases = read_file.content.cases
        if case is not None and not 1 <= case <= len(cases):
            raise click.UsageError(f"--case {case}: {file} has {_cases(len(cases))}.")
        chosen = cases if case is None else cases[case - 1 : case]
        if output.suffix == ".yaml" and len(chosen) != 1:
            raise click.UsageError(f"YAML can contain one case, but {file} has {len(chosen)}: choose one with --case.")
        converted = list(read_file.runner(client, file.name).converted(chosen))
    text = as_yaml(converted[0]) if output.suffix == ".yaml" else python_text(f"Cases of {file.name}, by contactd.", converted)
    write_text(place, text)
    _end([str(one.status) for one in converted], read_file)


def _read(file: Path, client: Client) -> ReadFile:
    """Reads a file with cases."""
    found = read_cases(file, client)
    if not found.content.cases:
        raise Ended(Code.USAGE, f"{file} has no cases.")
    return found


def _computed(
    runner: Runner, read_file: ReadFile, options: dict[str, Any], path: Path, workers: int, fresh: bool, files: CaseFiles
) -> dict[int, dict[str, Any]]:
    """Returns the rows of all cases. Complete chains of a journal are not computed again."""
    chains, total = chains_of(read_file.content.cases), len(read_file.content.cases)
    with Journal(path) as journal:
        if fresh:
            journal.forget(set(journal.rows))
        keys = {id(case): key for chain in chains for case, key in zip(chain, keys_of(chain, options))}
        if known := len(set(keys.values()) & journal.rows.keys()):
            note(f"{known} of {total} cases are in {path}.")
        with Bar("cases") as bar:

            def on_row() -> None:
                done = len(set(keys.values()) & journal.rows.keys())
                bar.show(done / max(1, total), f"{done} of {total} cases")

            try:
                todo = [chain for chain in chains if any(keys[id(case)] not in journal.rows for case in chain)]
                requests = requests_of(todo, read_file.text)
                run_requests(runner, requests, keys, journal, min(workers, max(1, len(requests))), files.keep, on_row)
            except BaseException:
                note(f"{len(set(keys.values()) & journal.rows.keys())} of {total} cases are in {path}; repeat the command to continue.")
                raise
        return {case: journal.rows[key] for case, key in keys.items()}


def _show(rows: Sequence[dict[str, Any]], place: Path, differences: Sequence[list[str]] | None) -> list[str]:
    """Shows the results of the cases; returns their statuses."""
    shown = []
    for index, row in enumerate(rows):
        values, answers = row["values"], row["answers"]
        apart = [] if differences is None else differences[index]
        why = " ".join([answers["sentence"], *(f"{sentence}." for sentence in apart)]).strip()
        status = "differs" if apart and answers["status"] == "solved" else answers["status"]
        more = {"warnings": answers["warnings"]} if "warnings" in answers else {}
        shown.append({**_named(values), "status": status, "why": why, **more})
    counts = Counter(row["status"] for row in shown)
    remarks = [row for row in shown if row["why"]]
    answer = {"cases": [{**row, "numbers": full["answers"].get("numbers")} for row, full in zip(shown, rows)], "output": str(place)}
    emit(setting().json, answer, *_listed(remarks, f"{_cases(len(rows))}: {_counted(counts)}. They are in {place}."))
    warn_of("case", ((case_name(row["values"]), sentence) for row in rows for sentence in row["answers"].get("warnings", ())))
    return [row["status"] for row in shown]


def _named(values: dict[str, Any]) -> dict[str, Any]:
    """Returns the columns that identify a case; older journals have no contact problems."""
    return {"case": values["number"], **{name: values.get(name) for name in _ELEMENTS}, "line": values["line"], "module": values["module"]}


def _status_text(status: str) -> str:
    return "can be computed" if status == "read" else status


def _cases(count: int) -> str:
    return "1 case" if count == 1 else f"{count} cases"


def _counted(counts: Counter[str]) -> str:
    return ", ".join(f"{count} {status}" for status, count in counts.most_common())


def _listed(remarks: Sequence[dict[str, Any]], last: str) -> list[Any]:
    named = [name for name in _ELEMENTS if any(row[name] is not None for row in remarks)]
    columns = ["case", *named, "line", "module", "status", "why"]
    lines = [[row[name] for name in columns] for row in remarks[:_MOST_SHOWN]]
    heading = [_ELEMENTS.get(name, name) for name in columns]
    more = [f"... {len(remarks) - _MOST_SHOWN} more: --json lists all"] if len(remarks) > _MOST_SHOWN else []
    return [*([listing(None, heading, lines)] if lines else []), *more, last]


def _end(statuses: Sequence[str], read_file: ReadFile) -> None:
    """Ends with the code of the worst problem, in the cases or between them."""
    statuses = [*statuses, *("wrong" for _ in read_file.content.errors)]
    bad = Counter(status for status in statuses if status not in ("solved", "read"))
    if not bad:
        return
    codes = {Code.NOT_CONVERGED if status == "differs" else code_of_status(status) for status in bad}
    code = next(one for one in (Code.USAGE, Code.FAILED, Code.REFUSED, Code.NOT_CONVERGED) if one in codes)
    raise Ended(code, f"{_counted(bad)}.")
