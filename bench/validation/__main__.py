"""Computes the given cases of the CONTACT program and compares them with its printed results.

    ./dev validate
    ./dev validate --only testbank
    ./dev validate --cases FOLDER

The files are in ../shared/contact, beside the repository. The page, docs/validation.md, is made from the CSV files
in docs/validation.
"""

from __future__ import annotations

import argparse
import signal
import sys
import warnings
from collections.abc import Sequence
from pathlib import Path

from contactd import ContactdError, ContactWarning
from paper.rows import Row

from . import table, times
from .given import FilesMissing, GivenFile, families, given_files
from .measure import Computed, Run, compute
from .outputs import Say, write_page, write_tables

ROOT = Path(__file__).parents[2]


def say(line: str) -> None:
    print(line, file=sys.stderr, flush=True)


def arguments_of(words: list[str] | None) -> argparse.Namespace:
    parser = argparse.ArgumentParser(prog="./dev validate", description=(__doc__ or "").splitlines()[0])
    parser.add_argument(
        "--bin", type=Path, required=True, help="folder with the programs; contactd_local is in ../lib/python"
    )
    parser.add_argument(
        "--cases", type=Path, default=ROOT.parent / "shared" / "contact", help="default: ../shared/contact"
    )
    parser.add_argument("--output", type=Path, default=ROOT / "docs" / "validation", help="default: docs/validation")
    parser.add_argument("--only", metavar="FAMILY,...", help="mbench, testbank and so on; the results of the others are kept")
    return parser.parse_args(words)


def chosen(files: Sequence[GivenFile], only: str | None) -> list[GivenFile]:
    """Returns the files of the named families, separated by commas, or without names all. Raises ValueError."""
    if only is None:
        return list(files)
    names = [name.strip() for name in only.split(",")]
    for name in names:
        if name not in families(files):
            raise ValueError(f"'{name}' is not a family; use {', '.join(families(files))}")
    return [one for one in files if one.family in names]


def computed_rows(file: GivenFile, preset: str, say: Say) -> tuple[list[Row], Row]:
    """Returns the rows of a file in both tables. Raises FilesMissing if the printed results are incomplete."""
    printed = file.printed()
    run = compute(file.path, "bilinear")
    if len(run.cases) != len(printed):
        raise FilesMissing(f"{file.reference} prints {len(printed)} cases, and {file.path} has {len(run.cases)}")
    has_rails = any(one.case.module == 1 and one.numbers is not None for one in run.cases)
    exact: Run | None = compute(file.path, "exact") if has_rails else None
    others: Sequence[Computed | None] = exact.cases if exact else [None] * len(printed)
    rows = [
        row for one, theirs, other in zip(run.cases, printed, others) for row in table.rows_of(file, one, theirs, other)
    ]
    timed = times.row_of(file, run, exact, preset)
    say(
        f"{file.name}: {timed['computed']} of {timed['cases']} cases, {run.seconds:.1f} s, printed {timed['printed_seconds']} s"
    )
    return rows, timed


def validate(folder: Path, only: str | None, output: Path, preset: str, say: Say) -> None:
    """Computes the cases in the folder and writes tables, pictures and the page. Raises before it writes anything."""
    files = given_files(folder)
    found = [computed_rows(one, preset, say) for one in chosen(files, only)]
    cases, timed = [row for rows, _ in found for row in rows], [row for _, row in found]
    say("wrote " + ", ".join(map(str, write_tables(files, cases, timed, output))))
    write_page(output, say)


def main(words: list[str] | None = None) -> int:
    arguments = arguments_of(words)
    warnings.simplefilter("ignore", ContactWarning)  # the grids of the given cases cannot be changed
    for number in (signal.SIGINT, signal.SIGTERM):
        signal.signal(number, signal.default_int_handler)
    try:
        validate(arguments.cases, arguments.only, arguments.output, arguments.bin.resolve().parent.name, say)
    except (FilesMissing, ValueError, ContactdError, OSError) as error:
        say(f"validate: {error}")
        return 1
    except KeyboardInterrupt:
        say("validate: interrupted; nothing is written")
        return 130
    return 0


if __name__ == "__main__":
    sys.exit(main())
