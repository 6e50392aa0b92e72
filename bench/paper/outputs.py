"""Writes the results of a part, and the page about all parts of a section."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

from .finding import PointMissing
from .page import render
from .rows import read_csv, write_csv
from .section import Section
from .store import ResultStore

Say = Callable[[str], None]


def write_part(section: Section, name: str, store: ResultStore, folder: Path, say: Say) -> None:
    """Writes the CSV files and the picture of a part, for the cases whose results are in the store."""
    rows = []
    for case in section.parts[name]():
        result = store.get(case.spec)
        if result is not None and "failure" in result:  # a failure has no point
            say(f"{name}: {case.curve}, {case.parameter} = {case.value:g} is left out: {result['failure']}")
        elif result is not None:
            rows.append(section.row(case, result))
    written = [folder / f"{name}.csv"]
    write_csv(written[0], rows, section.part_columns.get(name, section.columns))
    # The picture uses the file, like the page, so both always agree.
    rows = read_csv(written[0])
    if name in section.pictures:
        written.append(folder / f"{name}.png")
        section.pictures[name](rows, written[-1])
    if name in section.tables:
        table = section.tables[name]
        written.append(folder / f"{table.name}.csv")
        write_csv(written[-1], table.make(rows), table.columns)
    say("wrote " + ", ".join(str(path) for path in written))


def write_page(section: Section, folder: Path, version: str, say: Say) -> None:
    """Writes the page from the CSV files in the folder, regardless of the run that wrote them."""
    page = f"{section.name}.md"
    missing = [name for name in section.parts if not (folder / f"{name}.csv").is_file()]
    if missing:
        say(f"{page} is not written, because these parts are missing: {', '.join(missing)}")
        return
    try:
        text, surprises = render(section, {name: read_csv(folder / f"{name}.csv") for name in section.parts}, version)
    except (PointMissing, KeyError) as missing_point:
        say(f"{page} cannot be written without this point: {missing_point}")
        return
    (folder / page).write_text(text)
    say(f"wrote {folder / page}")
    for name in surprises:
        say(f"note: the result of '{name}' contradicts its text in bench/paper/{page}.in")
