"""Writes what a part has to show, and the page about all of them."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from pathlib import Path

from . import diagrams, figures
from .cases import PARTS, Case
from .finding import PointMissing
from .page import render
from .recommended import RANGE_COLUMNS, ranges
from .rows import Row, read_csv, rows_of, write_csv
from .store import ResultStore

Say = Callable[[str], None]

#: Parts with a picture; the other ones are tables.
PICTURES: dict[str, Callable[[Sequence[Row], Path], None]] = {
    "fig5": figures.fig5, "fig6": figures.fig6, "fig7": figures.fig7, "fig8": figures.fig8,
    "accuracy": diagrams.accuracy, "adaptive": diagrams.adaptive,
}  # fmt: skip


def write_part(name: str, cases: Sequence[Case], store: ResultStore, folder: Path, say: Say) -> None:
    """The CSV file and the picture of a part, whose cases are all in the store."""
    rows = rows_of(cases, store)
    for case in cases:
        if "failure" in (result := store.get(case.spec) or {}):
            say(f"{name}: {case.curve}, {case.parameter} = {case.value:g} is left out: {result['failure']}")
    written = [folder / f"{name}.csv"]
    write_csv(written[0], rows)
    # From the file, as the page: picture and page cannot differ.
    rows = read_csv(written[0])
    if name in PICTURES:
        written.append(folder / f"{name}.png")
        PICTURES[name](rows, written[-1])
    if name == "table3":
        written.append(folder / "table3-ranges.csv")
        write_csv(written[-1], ranges(rows), RANGE_COLUMNS)
    say("wrote " + ", ".join(str(path) for path in written))


def write_page(folder: Path, version: str, say: Say) -> None:
    """From the CSV files in the folder, whichever run wrote them."""
    missing = [name for name in PARTS if not (folder / f"{name}.csv").is_file()]
    if missing:
        say(f"fem.md is written when these parts are there, too: {', '.join(missing)}")
        return
    try:
        text, surprises = render({name: read_csv(folder / f"{name}.csv") for name in PARTS}, version)
    except (PointMissing, KeyError) as missing_point:
        say(f"fem.md cannot be written without this point: {missing_point}")
        return
    (folder / "fem.md").write_text(text)
    say(f"wrote {folder / 'fem.md'}")
    for name in surprises:
        say(f"note: '{name}' came out otherwise than its text in bench/paper/fem.md.in was written for")
