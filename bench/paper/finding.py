"""How numbers are looked up and written in the page."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence

from .rows import Row

Rows = Mapping[str, Sequence[Row]]
Found = tuple[dict[str, str], dict[str, bool]]

TARGET = 0.01
NEGLIGIBLE = TARGET / 10  # what does not show beside the target


def percent(value: float) -> str:
    """Two significant digits, without a sign."""
    size = abs(value) * 100
    digits = max(0, 1 - math.floor(math.log10(size))) if size > 0 else 1
    return f"{size:.{min(digits, 6)}f} %"


def number(value: float) -> str:
    return f"{value:.3g}"


def origin(row: Row) -> float:
    return abs(float(row["origin_zz"]))


class PointMissing(Exception):
    """The page speaks of a point that is in no file: its computation did not converge."""


def at(rows: Sequence[Row], curve: str, L: float) -> Row:
    # L comes from L/h times h, and through the digits of a file.
    for row in rows:
        if row["curve"] == curve and math.isclose(row["L"], L, rel_tol=1e-4):
            return row
    raise PointMissing(f"{curve}, L = {L:g}")


def first_within(points: Sequence[Row]) -> Row | None:
    """Where the target is met from there on."""
    for i, row in enumerate(points):
        if all(origin(later) < TARGET for later in points[i:]):
            return row
    return None


def signed(points: Sequence[Row]) -> str:
    """The errors at the origin, one behind the other."""
    return ", ".join(f"{100 * row['origin_zz']:+.3f} %" for row in points)


def ratio_text(*rows: Row | None) -> str:
    """The L/h of these points, once when it is the same."""
    found = [f"{row['L'] / row['h']:.0f}" if row else "none that was tried" for row in rows]
    return "L/h = " + ", ".join(found if len(set(found)) > 1 else found[:1])
