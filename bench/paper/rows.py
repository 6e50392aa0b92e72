"""Reads and writes CSV files with one row for each point of a curve. Pictures and pages read these files only."""

from __future__ import annotations

import csv
from collections.abc import Iterable, Sequence
from pathlib import Path
from typing import Any

Row = dict[str, Any]

_TEXTS = {"curve", "parameter", "solver", "commit"}


def write_csv(path: Path, rows: Iterable[Row], columns: Sequence[str]) -> None:
    path.parent.mkdir(parents=True, exist_ok=True)
    part = path.with_suffix(".part")
    with part.open("w", newline="") as file:
        writer = csv.DictWriter(file, columns, restval="", lineterminator="\n")
        writer.writeheader()
        for item in rows:
            writer.writerow({name: _text(name, value) for name, value in item.items()})
    part.replace(path)


def _text(name: str, value: Any) -> Any:
    if not isinstance(value, float):
        return value
    # Errors need enough digits to show the difference between two solvers.
    return f"{value:.4g}" if name.endswith(("_seconds", "_mib")) else f"{value:.12g}"


def read_csv(path: Path) -> list[Row]:
    with path.open(newline="") as file:
        return [{name: _value(name, text) for name, text in item.items()} for item in csv.DictReader(file)]


def _value(name: str, text: str) -> Any:
    if name in _TEXTS or text == "":
        return text
    try:
        return float(text)
    except ValueError:
        return text


def select(rows: Iterable[Row], **values: Any) -> list[Row]:
    """Returns the rows with these values, in the order of the file."""
    return [item for item in rows if all(item[name] == value for name, value in values.items())]
