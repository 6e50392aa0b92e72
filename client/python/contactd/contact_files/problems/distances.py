"""The undeformed distance of a case on its elements (IBASE), and which elements may touch (IPLAN)."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np
import numpy.typing as npt

from ...values.grid import Grid

__all__ = ["EXCLUDED", "distance", "excluded", "quadratic_of"]

Floats = npt.NDArray[np.float64]
Values = Mapping[str, Any]

EXCLUDED = 1e6  #: the distance (mm) of elements outside of the planform: far beyond any approach, and no infinity


def distance(values: Values, grid: Grid) -> Floats:
    """h at the element centres (mm), shape [ny, nx], without the planform."""
    x, y = grid.x[None, :], grid.y[:, None]
    match values["IBASE"]:
        case 1:
            return _quadratic(quadratic_of(values), x, y)
        case 2:
            return np.asarray(_profile(values, grid.y)[:, None] + (x - values["XM"]) ** 2 / (2 * values["RM"]))
        case 3:
            b = [0.0, *(values[f"B{i}"] for i in range(1, 9))]
            waves = b[1] * np.sin(b[2] * (x - b[3])) - b[4] * np.sin(b[5] * (x - b[6]))
            return np.asarray(waves + x * x / b[7] + y * y / b[8])
        case _:
            return np.array(values["GAP"], dtype=np.float64).reshape(grid.shape)


def excluded(values: Values, grid: Grid) -> npt.NDArray[np.bool_] | None:
    """Elements that cannot touch, shape [ny, nx]; None: there are none."""
    x, y = grid.x[None, :], grid.y[:, None]
    match values["IPLAN"]:
        case 2:
            return np.asarray(_quadratic([values[f"P{i}"] for i in range(1, 7)], x, y) >= 0)
        case 3:
            inside = np.zeros(grid.shape, dtype=bool)
            for k in (1, 2):
                within_x = (x >= values[f"XL{k}"]) & (x <= values[f"XH{k}"])
                inside |= within_x & (y >= values[f"YL{k}"]) & (y <= values[f"YH{k}"])
            return ~inside
        case _:
            return None


def quadratic_of(values: Values) -> list[float]:
    """B1 to B6 of IBASE = 1."""
    return [values[f"B{i}"] for i in range(1, 7)]


def _quadratic(b: list[float], x: Floats, y: Floats) -> Floats:
    return np.asarray(b[0] * x * x + b[1] * x * y + b[2] * y * y + b[3] * x + b[4] * y + b[5] + 0 * (x + y))


def _profile(values: Values, y: Floats) -> Floats:
    """Heights at equal distances, straight lines between them and beyond the ends."""
    heights = np.array(values["HEIGHTS"], dtype=np.float64)
    if len(heights) == 1:
        return np.full(len(y), heights[0])
    place = (y - values["Y1"]) / values["DY1"]
    left = np.clip(np.floor(place).astype(int), 0, len(heights) - 2)
    return np.asarray(heights[left] + (place - left) * (heights[left + 1] - heights[left]))
