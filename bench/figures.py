"""Finds the measured figures on the pages and compares them with the files that contain them.

A figure is a number with a unit of time or memory, a percentage, a multiple ("1.5 times", "0.6 of the time"), a number
of products, iterations or cases, or a small number after "within" and similar words, anywhere in the text of a page. In
a table, a row of numbers is one figure. Each figure is in one of these files:

* docs/recorded.csv, with the command, the commit and the machine of its measurement (`any`: no effect);
* docs/repeated.csv, with its source: a template (bench/pages.py) whose text is the figure;
* docs/given.csv, with the reason why it is not measured. There, `*` stands for all figures of a section or page;
* another CSV file, from which bench/pages.py fills it into the template of its page.

    python3 bench/figures.py                    lists figures that are in no file, and rows that are on no page
    python3 bench/figures.py --record COMMAND   records the former as measured by COMMAND now, and removes the latter
"""

from __future__ import annotations

import argparse
import re
import sys
from collections import Counter
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path

from pages import PLACE, TEMPLATES, Values, provenance, read, render, write

ROOT = Path(__file__).resolve().parent.parent
RECORDED, REPEATED, GIVEN = "docs/recorded.csv", "docs/repeated.csv", "docs/given.csv"
PAGES = ("*.md", "paper/*.md", "docs/*.md", "docs/developing/*.md", "client/*/*.md", "tests/*.md")
#: Generated pages, which tests/bench compares with their files as a whole.
GENERATED = ("docs/validation.md",)
NUMBER = r"[-+]?\d[\d,]*(?:\.\d+)?(?:e-?\d+)?"
LIST = rf"{NUMBER}(?:(?:,|;|,?\s+(?:to|and|or|of))\s+{NUMBER})*"
UNITS = (
    r"ns|us|ms|s|min|h|seconds?|minutes?|hours?|kB|MB|GB|KiB|MiB|GiB|%|times|of\s+the\s+time"
    r"|products|iterations|(?:public\s+)?cases|agree|differ"
)
#: Words before an error.
ERROR = r"within|agree\w*\s+to|differ\w*\s+by|errors?\s+(?:of|below)|accurate\s+to"
FIGURE = re.compile(
    rf"(?<![\w./^-]){LIST}\s*(?:{UNITS})(?![\w/^])"
    rf"|(?<![\w/])1/\d+\.\d+|\b(?:{ERROR})\s+\d[\d.]*e-\d+"
)
#: Names of columns whose numbers are not measured.
INPUTS = re.compile(r"\W*(aim|target|grid|elements|accuracy|n|default|range|unit|symbol)\W*", re.IGNORECASE)
#: A cell of measured numbers: no letters but those of units, ranges and exponents; "§" stands for a placeholder.
_PART = rf"(?:[\s\d§.,;:()/*+<-]|\b(?:{UNITS}|to|below)\b|%|(?<=\d)e(?=-?\d))*"
NUMBERS = re.compile(rf"{_PART}\d{_PART}")


@dataclass(frozen=True, order=True)
class Figure:
    """A figure as the page shows it, below the heading with the anchor `section`."""

    page: str
    section: str
    text: str


def anchor(heading: str) -> str:
    """Returns the anchor of a heading on the web: lower case, hyphens for spaces, no other signs."""
    return re.sub(r"[^\w\- ]", "", heading.lstrip("#").strip().lower()).replace(" ", "-")


def figures(page: str, text: str) -> Iterator[Figure]:
    """Yields the figures of a page or of its template, except those in code and the placeholders."""
    text = re.sub(r"^( *)```.*?^\1```", "", PLACE.sub("§", text), flags=re.MULTILINE | re.DOTALL)
    text = re.sub(r"\n\n(?:(?:    .*)?\n)+", "\n\n", text)
    text = re.sub(r"\]\([^)]*\)|\[", "", re.sub(r"`[^`]*`", "]", text))
    for part in re.split(r"^(?=#+ )", text, flags=re.MULTILINE):
        section = anchor(part.partition("\n")[0]) if part.startswith("#") else ""
        head: list[str] = []
        prose = []
        for line in part.splitlines():
            cells = _cells(line) if line.startswith("|") else []
            head = (head or cells) if cells else []
            named = [] if cells is head else zip(head[1:], cells[1:])
            numbers = [cell for name, cell in named if NUMBERS.fullmatch(cell) and not INPUTS.fullmatch(name)]
            if numbers:
                yield Figure(page, section, " | ".join(numbers))
                line = " ".join(cell for cell in cells if cell not in numbers)
            prose.append(line)
        for match in FIGURE.finditer("\n".join(prose)):
            yield Figure(page, section, " ".join(match[0].split()))


def _cells(line: str) -> list[str]:
    return [cell.strip() for cell in re.split(r"(?<!\\)\|", line)[1:-1]]


def found(root: Path = ROOT) -> dict[str, list[Figure]]:
    """Returns the figures of each page, or of the template that the page is written from."""
    paths = [str(path.relative_to(root)) for pattern in PAGES for path in sorted(root.glob(pattern))]
    texts = {page: (root / TEMPLATES.get(page, page)).read_text() for page in paths if page not in GENERATED}
    return {page: list(figures(page, text)) for page, text in texts.items()}


def listed(file: str, root: Path = ROOT) -> list[Figure]:
    return [Figure(row["page"], row["section"], row["figure"]) for row in read(root / file)]


def is_given(figure: Figure, exceptions: list[Figure]) -> bool:
    return any(
        one.page == figure.page and one.section in ("*", figure.section) and one.text in ("*", figure.text)
        for one in exceptions
    )


@dataclass
class Check:
    """Figures that are in no file, rows that are on no page, and rows that differ from their source."""

    unknown: list[Figure]
    stale: list[Figure]
    wrong: list[Figure]


def check(root: Path = ROOT) -> Check:
    exceptions, shown = listed(GIVEN, root), [figure for of_page in found(root).values() for figure in of_page]
    measured = Counter(figure for figure in shown if not is_given(figure, exceptions))
    known = Counter(listed(RECORDED, root) + listed(REPEATED, root))
    unused = [one for one in exceptions if not any(is_given(figure, [one]) for figure in shown)]
    values = Values(root / "docs")
    wrong = [
        Figure(row["page"], row["section"], row["figure"])
        for row in read(root / REPEATED)
        if render(row["source"], values) != row["figure"]
    ]
    return Check(list((measured - known).elements()), [*(known - measured).elements(), *unused], wrong)


def record(command: str, root: Path = ROOT) -> None:
    """Writes docs/recorded.csv in the order of the pages. Rows follow figures that moved to another section."""
    now = {"command": command, **provenance(root)}
    now["commit"] = now["commit"].removesuffix("-dirty")  # by the page with the figure
    rows, elsewhere, kept = read(root / RECORDED), listed(GIVEN, root) + listed(REPEATED, root), []
    for figure in (one for of_page in found(root).values() for one in of_page if not is_given(one, elsewhere)):
        same = [row for row in rows if (row["page"], row["figure"]) == (figure.page, figure.text)]
        row = next((row for row in same if row["section"] == figure.section), same[0] if same else None)
        if row:
            rows.remove(row)
        kept.append({**(row or now), "page": figure.page, "section": figure.section, "figure": figure.text})
    order = ("page", "section", "figure", "command", "commit", "machine", "date")
    write(root / RECORDED, [{name: row[name] for name in order} for row in kept])


def main() -> int:
    parser = argparse.ArgumentParser(description=(__doc__ or "").splitlines()[0])
    parser.add_argument("--record", metavar="COMMAND", help="the command that measured the figures that are in no file")
    if command := parser.parse_args().record:
        record(command)
    result = check()
    lists = {"in no file": result.unknown, "on no page": result.stale, "differs from its source": result.wrong}
    for words, rows in lists.items():
        for figure in rows:
            print(f"{figure.page}#{figure.section}: {figure.text}: {words}")
    return any(lists.values())


if __name__ == "__main__":
    sys.exit(main())
