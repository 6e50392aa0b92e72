"""Writes the results: tables, pictures, and the page, which depends on these alone."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from pathlib import Path

import pages
from paper.page import fill
from paper.rows import Row, read_csv, write_csv

from . import table, times
from .figures import draw, has_numbers
from .findings import find
from .given import GivenFile

__all__ = ["CASES", "PAGE", "TIMES", "Say", "render", "write_page", "write_tables"]

Say = Callable[[str], None]

CASES, TIMES, PAGE = "cases.csv", "times.csv", "validation.md"
TEMPLATE = Path(__file__).with_name(f"{PAGE}.in")
FOLDER = pages.ROOT / "docs" / "validation"  #: whose values other pages repeat


def write_tables(files: Sequence[GivenFile], cases: Sequence[Row], timed: Sequence[Row], folder: Path) -> list[Path]:
    """Writes both CSV files: new rows of computed families and old rows of the others, in the order of `files`."""
    order = [one.name for one in files]
    computed = {row["family"] for row in timed}
    for name, rows, columns in ((CASES, cases, table.COLUMNS), (TIMES, timed, times.COLUMNS)):
        path = folder / name
        kept = [row for row in read_csv(path) if row["family"] not in computed] if path.is_file() else []
        merged = sorted(
            [*kept, *rows], key=lambda row: order.index(row["file"]) if row["file"] in order else len(order)
        )
        write_csv(path, merged, columns)
    return [folder / CASES, folder / TIMES]


def write_page(folder: Path, say: Say) -> None:
    """Writes pictures to the folder with the tables, and the page next to that folder."""
    rows = read_csv(folder / CASES)
    written = []
    for family in dict.fromkeys(row["family"] for row in rows):
        own = [row for row in rows if row["family"] == family]
        if has_numbers(own):
            written.append(folder / f"{family}.png")
            draw(own, written[-1])
    text, surprises = render(folder)
    page = folder.parent / PAGE
    page.write_text(text)
    if folder.resolve() == FOLDER:
        pages.write_pages()
    say("wrote " + ", ".join(map(str, [*written, page])))
    for name in surprises:
        say(f"note: the result of '{name}' contradicts its text in bench/validation/{PAGE}.in")


def render(folder: Path) -> tuple[str, list[str]]:
    """Returns the page from the tables in the folder, and the verdicts that contradict its template."""
    values, verdicts = find(read_csv(folder / CASES), read_csv(folder / TIMES), folder.name)
    return fill(TEMPLATE.read_text(), values, verdicts)
