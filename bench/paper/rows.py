"""One row of a CSV file for each point of a curve; everything behind (pictures, page) reads these files only."""

from __future__ import annotations

import csv
from collections.abc import Iterable
from pathlib import Path
from typing import Any

from .cases import Case
from .store import ResultStore

Row = dict[str, Any]

COLUMNS = [
    "curve", "parameter", "value", "L", "h", "table", "elements", "dofs", "solver",
    "iterations_z", "iterations_x", "iterations_y",
    "origin_zz", "origin_xx", "origin_yy", "largest_zz", "largest_xx", "largest_yy", "scaled_xy", "scaled_xz",
    "cpu_seconds", "wall_seconds", "memory_mib",
]  # fmt: skip
_TEXTS = {"curve", "parameter", "solver"}


def row(case: Case, result: dict[str, Any]) -> Row | None:
    """None when the solve did not converge: there is no point then."""
    if "failure" in result:
        return None
    mesh = result["mesh"] or case.spec["ics"]  # an accuracy chooses its mesh
    errors = result["errors"][str(case.table)]
    relative = {
        f"{kind}_{name}": errors[name][kind] for kind in ("origin", "largest") for name in ("zz", "xx", "yy")
    }  # fmt: skip
    return {
        "curve": case.curve,
        "parameter": case.parameter,
        "value": case.value,
        "L": mesh["L_over_h"] * case.h,
        "h": case.h,
        "table": case.table,
        **{name: result[name] for name in ("elements", "dofs", "solver")},
        **{f"iterations_{load}": count for load, count in result["iterations"].items()},
        **relative,
        **{name: errors[name] for name in ("scaled_xy", "scaled_xz")},
        "cpu_seconds": result["cpu_seconds"],
        "wall_seconds": result["seconds"]["total"],
        "memory_mib": result["memory_mib"],
    }


def rows_of(cases: Iterable[Case], store: ResultStore) -> list[Row]:
    """Of the cases whose results are there."""
    pairs = [(case, store.get(case.spec)) for case in cases]
    found = [row(case, result) for case, result in pairs if result is not None]
    return [item for item in found if item is not None]


def write_csv(path: Path, rows: Iterable[Row], columns: list[str] = COLUMNS) -> None:
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
    # Errors with enough digits for the difference between two solvers.
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


def select(rows: Iterable[Row], **wanted: Any) -> list[Row]:
    """The rows that have these values, in the order of the file."""
    return [item for item in rows if all(item[name] == value for name, value in wanted.items())]
