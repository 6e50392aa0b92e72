"""Contains the common parts of the findings of section 4."""

from __future__ import annotations

from collections.abc import Sequence

from ..finding import PointMissing, percent
from ..rows import Row, select
from .cases import GRIDS

#: The curves of the paper's grids, the finest one first.
NAMES = [f"{n}x{n}" for n in GRIDS]


def size(row: Row, quantity: str) -> float:
    return abs(error(row, quantity))


def error(row: Row, quantity: str) -> float:
    return float(row[f"error_{quantity}"])


def on(rows: Sequence[Row], curve: str, n: int) -> Row:
    """Returns a point of a curve over n."""
    found = select(rows, curve=curve, n=n)
    if not found:
        raise PointMissing(f"{curve}, n = {n}")
    return found[0]


def signed(value: float) -> str:
    """Formats a percentage with two or three significant digits and its sign."""
    return ("+" if value > 0 else "−") + percent(value)


def listed(points: Sequence[Row], quantity: str) -> str:
    return ", ".join(signed(error(row, quantity)) for row in points)


def falls(points: Sequence[Row], quantity: str) -> bool:
    """Returns whether the size of the error decreases from point to point."""
    sizes = [size(row, quantity) for row in points]
    return all(b < a for a, b in zip(sizes, sizes[1:]))


def falls_then_rises(points: Sequence[Row], quantity: str) -> bool:
    """Returns whether the smallest value is between the ends."""
    sizes = [size(row, quantity) for row in points]
    return sizes.index(min(sizes)) not in (0, len(sizes) - 1)


def reversal(points: Sequence[Row], quantity: str) -> str:
    """Returns the values of L between which the error passes through zero."""
    for a, b in zip(points, points[1:]):
        if error(a, quantity) > 0 >= error(b, quantity):
            return f"L = {a['L']:.0f} and {b['L']:.0f}"
    return "no L that was tried"


def between(value: float, a: float, b: float, digit: float) -> bool:
    """Returns whether a number of the printed precision is between two others."""
    low, high = sorted((abs(a), abs(b)))
    return low - digit / 2 <= value <= high + digit / 2
