"""Contains the common parts of the findings of section 3."""

from __future__ import annotations

from collections.abc import Sequence

from ..rows import Row

TARGET = 0.01  # the paper's (3.1)
NEGLIGIBLE = TARGET / 10  # negligible beside the target


def origin(row: Row) -> float:
    return abs(float(row["origin_zz"]))


def first_within(points: Sequence[Row]) -> Row | None:
    """Returns the first point from which all points meet the target."""
    for i, row in enumerate(points):
        if all(origin(later) < TARGET for later in points[i:]):
            return row
    return None


def signed(points: Sequence[Row]) -> str:
    """Returns a list of the errors at the origin."""
    return ", ".join(f"{100 * row['origin_zz']:+.3f} %" for row in points)


def ratio_text(*rows: Row | None) -> str:
    """Returns the L/h of these points, or a single value if they are equal."""
    found = [f"{row['L'] / row['h']:.0f}" if row else "none of the tested ones" for row in rows]
    return "L/h = " + ", ".join(found if len(set(found)) > 1 else found[:1])
