"""Finds and formats the numbers of a page."""

from __future__ import annotations

import math
from collections.abc import Iterable, Mapping, Sequence

from .rows import Row

Rows = Mapping[str, Sequence[Row]]
#: Values for the page, and verdicts computed from the rows: True where we agree with the paper.
Found = tuple[dict[str, str], dict[str, bool]]


def merge(found: Iterable[Found]) -> Found:
    """Merges all findings into one."""
    values: dict[str, str] = {}
    verdicts: dict[str, bool] = {}
    for more, judged in found:
        values.update(more)
        verdicts.update(judged)
    return values, verdicts


class PointMissing(Exception):
    """Raised when the page uses a point that is in no file because its computation did not converge."""


def percent(value: float) -> str:
    """Formats a percentage with two significant digits, without a sign."""
    size = abs(value) * 100
    digits = max(0, 1 - math.floor(math.log10(size))) if size > 0 else 1
    return f"{size:.{min(digits, 6)}f} %"


def number(value: float) -> str:
    return f"{value:.3g}"


def at(rows: Sequence[Row], curve: str, L: float) -> Row:
    # L is L/h times h, rounded to the digits in a file.
    for row in rows:
        if row["curve"] == curve and math.isclose(row["L"], L, rel_tol=1e-4):
            return row
    raise PointMissing(f"{curve}, L = {L:g}")


def markdown(head: Sequence[str], body: Sequence[Sequence[str]]) -> str:
    """Returns a table in Markdown."""
    lines = [head, ["---"] * len(head), *body]
    return "\n".join("| " + " | ".join(line) + " |" for line in lines)
