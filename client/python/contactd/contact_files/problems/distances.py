"""The undeformed distance of a case on its elements (IBASE), the elements that may touch, and their interaction
(IPLAN).
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from typing import Any

import numpy as np
import numpy.typing as npt

from ...values.generated.grid import Grid
from ...values.generated.regions import ContactRegions, RegionLimits

__all__ = ["EXCLUDED", "distance", "excluded", "quadratic_of", "regions_of"]

Floats = npt.NDArray[np.float64]
Values = Mapping[str, Any]

EXCLUDED = 1e6  #: Distance (mm) of elements outside the planform: far beyond any approach, but finite.


def distance(values: Values, grid: Grid) -> Floats:
    """Returns h at the element centres (mm), shape [ny, nx], without the planform."""
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
    """Returns the elements that cannot touch, shape [ny, nx]; None if there are none."""
    x, y = grid.x[None, :], grid.y[:, None]
    match values["IPLAN"]:
        case 2:
            return np.asarray(_quadratic([values[f"P{i}"] for i in range(1, 7)], x, y) >= 0)
        case 3:
            return _outside(((values[f"XL{k}"], values[f"XH{k}"], values[f"YL{k}"], values[f"YH{k}"]) for k in (1, 2)), x, y)
        case 4:
            return _outside(_limits_of_patches(values), x, y)
        case _:
            return None


def regions_of(values: Values) -> ContactRegions | None:
    """Returns the patches of IPLAN = 4 and the shares of their displacements."""
    if values["IPOTCN"] <= 0 or values["IPLAN"] != 4:
        return None
    limits = tuple(RegionLimits((xl, xh), (yl, yh)) for xl, xh, yl, yh in _limits_of_patches(values))
    above = np.zeros((len(limits), len(limits)))
    above[np.triu_indices(len(limits), 1)] = values["PATCH_FACTORS"]
    shares = np.eye(len(limits)) + above + above.T
    return ContactRegions(limits, tuple(float(share) for share in shares.ravel()))


def _limits_of_patches(values: Values) -> list[list[float]]:
    """Returns XL XH YL YH of each patch of IPLAN = 4."""
    return [[float(end) for end in limits] for limits in np.reshape(values["PATCH_LIMITS"], (-1, 4))]


def _outside(limits: Iterable[Sequence[float]], x: Floats, y: Floats) -> npt.NDArray[np.bool_]:
    """Returns the elements outside all rectangles."""
    inside = np.zeros((y.size, x.size), dtype=bool)
    for xl, xh, yl, yh in limits:
        inside |= (x >= xl) & (x <= xh) & (y >= yl) & (y <= yh)
    return ~inside


def quadratic_of(values: Values) -> list[float]:
    """Returns B1 to B6 of IBASE = 1."""
    return [values[f"B{i}"] for i in range(1, 7)]


def _quadratic(b: list[float], x: Floats, y: Floats) -> Floats:
    return np.asarray(b[0] * x * x + b[1] * x * y + b[2] * y * y + b[3] * x + b[4] * y + b[5] + 0 * (x + y))


def _profile(values: Values, y: Floats) -> Floats:
    """Returns heights at equal distances, with linear interpolation and extrapolation."""
    heights = np.array(values["HEIGHTS"], dtype=np.float64)
    if len(heights) == 1:
        return np.full(len(y), heights[0])
    place = (y - values["Y1"]) / values["DY1"]
    left = np.clip(np.floor(place).astype(int), 0, len(heights) - 2)
    return np.asarray(heights[left] + (place - left) * (heights[left + 1] - heights[left]))
