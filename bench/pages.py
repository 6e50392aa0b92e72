"""Writes docs/performance.md and docs/benchmarks.md from their templates, bench/*.md.in, and the CSV files in docs.

    python3 bench/pages.py        (./dev bench --page measures first; ./dev validate renews the pages too)

{{row quantity}} in a template stands for a value of docs/benchmarks.csv. `row(a,b)` stands for the rows `rowa` and
`rowb`, separated by commas, and `row*` for the range of all rows that match. The other values are

* {{scaling.model/elements quantity}}: docs/performance.csv;
* {{validation name}}: a value of docs/validation.md, from its CSV files;
* {{on page text}}: this text, which must be on the generated page;
* {{recorded page#section n}}: the n-th figure of this section in docs/recorded.csv; n.m is the m-th cell of a row;
* {{provenance}}: the commits and machines of docs/benchmarks.csv.
"""

from __future__ import annotations

import csv
import re
import subprocess
from collections import Counter
from collections.abc import Iterable
from datetime import date
from fnmatch import fnmatchcase
from functools import cached_property
from pathlib import Path

from paper.finding import markdown
from paper.rows import read_csv

ROOT = Path(__file__).resolve().parent.parent
TEMPLATES = {
    "docs/performance.md": "bench/performance.md.in",
    "docs/benchmarks.md": "bench/benchmarks.md.in",
}
PLACE = re.compile(r"\{\{([^{}]+)\}\}")
Rows = list[dict[str, str]]


def read(path: Path) -> Rows:
    """Returns the rows as text, so that a page shows the digits of the file."""
    with path.open(newline="") as file:
        return list(csv.DictReader(file))


def write(path: Path, rows: Rows) -> None:
    with path.open("w", newline="") as file:
        writer = csv.DictWriter(file, list(rows[0]), lineterminator="\n")
        writer.writeheader()
        writer.writerows(rows)


def provenance(root: Path = ROOT) -> dict[str, str]:
    """Returns commit, machine and date of a measurement that is made now."""
    command = ["git", "-C", str(root), "describe", "--always", "--dirty", "--exclude=*"]
    commit = subprocess.run(command, check=True, capture_output=True, text=True).stdout.strip()
    lines = Path("/proc/cpuinfo").read_text().splitlines()
    models = [line.partition(":")[2].strip() for line in lines if line.startswith("model name")] or ["unknown"]
    return {"commit": commit, "machine": f"{models[0]}, {len(models)} processors", "date": date.today().isoformat()}


def digits(value: float) -> str:
    """Returns three significant digits, without an exponent."""
    shown = f"{value:.3g}"
    return f"{float(shown):.0f}" if "e+" in shown else shown


def expanded(key: str) -> list[str]:
    """Returns the keys of a placeholder with a group, or the key itself."""
    group = re.search(r"\(([^()]*)\)", key)
    return [key.replace(group[0], one) for one in group[1].split(",")] if group else [key]


def needed(root: Path = ROOT) -> list[str]:
    """Returns the keys and patterns of docs/benchmarks.csv that the templates use, in their order."""
    places = [key for template in TEMPLATES.values() for key in PLACE.findall((root / template).read_text())]
    others = ("provenance", "validation ", "recorded ", "on ", "scaling.")
    return list(dict.fromkeys(one for key in places if not key.startswith(others) for one in expanded(key)))


def spread(texts: Iterable[str]) -> str:
    """Returns the range of all numbers in the texts."""
    values = [float(number) for text in texts for number in re.findall(r"[\d.]+(?:e[+-]?\d+)?", text)]
    return " to ".join(dict.fromkeys(map(digits, (min(values), max(values)))))


class Values:
    """The values of all placeholders. `value` raises KeyError for one that is in no file."""

    def __init__(self, docs: Path) -> None:
        self.docs = docs
        self.rows = read(docs / "benchmarks.csv")
        self.measured = {f"{row['row']} {row['quantity']}": row["value"] for row in self.rows}
        self.recorded = read(docs / "recorded.csv")
        for row in read(docs / "performance.csv"):
            for quantity in ("us", "us_per_element", "products", "iterations"):
                if row[quantity]:
                    name = f"scaling.{row['model']}/{row['elements']} {quantity}"
                    self.measured[name] = digits(float(row[quantity]))

    def value(self, key: str) -> str:
        kind, _, name = key.partition(" ")
        if key == "provenance":
            return self._provenance()
        if kind == "validation":
            return self._validation[name]
        if kind == "on":
            return self._on(*name.split(" ", 1))
        if kind == "recorded":
            return self._recorded(*name.split())
        if "*" in key:
            found = [value for name, value in self.measured.items() if fnmatchcase(name, key)]
            if not found:
                raise KeyError(key)
            return spread(found)
        return ", ".join(self.measured[one] for one in expanded(key))

    def _provenance(self) -> str:
        counts = Counter((row["commit"], row["date"], row["machine"]) for row in self.rows)
        lines = [[*run, str(count)] for run, count in sorted(counts.items(), key=lambda item: (item[0][1], item[0][0]))]
        table = markdown(["commit", "date", "machine", "values"], lines)
        if len(lines) == 1:
            return table
        link = "[faster transforms](findings.md#faster-transforms)"
        note = f"The values are from several versions, between which {link} changed the\nproduct."
        return f"{table}\n\n{note} Compare values of one commit only."

    @cached_property
    def _validation(self) -> dict[str, str]:
        from validation.findings import find  # needs matplotlib

        folder = self.docs / "validation"
        return find(read_csv(folder / "cases.csv"), read_csv(folder / "times.csv"), folder.name)[0]

    def _on(self, page: str, text: str) -> str:
        if text not in (self.docs.parent / page).read_text():
            raise KeyError(f"on {page} {text}")
        return text

    def _recorded(self, place: str, number: str) -> str:
        page, _, section = place.partition("#")
        figures = [row["figure"] for row in self.recorded if (row["page"], row["section"]) == (page, section)]
        row, _, cell = number.partition(".")
        try:
            return figures[int(row) - 1].split(" | ")[int(cell) - 1] if cell else figures[int(row) - 1]
        except IndexError:
            raise KeyError(f"recorded {place} {number}") from None


def render(template: str, values: Values) -> str:
    return PLACE.sub(lambda match: values.value(match[1]), template)


def rendered(root: Path = ROOT) -> dict[str, str]:
    """Returns the text of each page that has a template."""
    values = Values(root / "docs")
    return {page: render((root / template).read_text(), values) for page, template in TEMPLATES.items()}


def write_pages(root: Path = ROOT) -> None:
    for page, text in rendered(root).items():
        (root / page).write_text(text)
        print(f"written: {root / page}")


if __name__ == "__main__":
    write_pages()
