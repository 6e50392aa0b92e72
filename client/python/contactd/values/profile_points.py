"""How the points of a profile are written, which is in `profiles`."""

from __future__ import annotations

from typing import Any

import numpy.typing as npt

from ..errors import invalid
from .arrays import array_of

__all__ = ["MeasuredProfile"]


class MeasuredProfile:
    """A profile by its points."""

    @staticmethod
    def _write_points(given: npt.ArrayLike, field: str) -> Any:
        points = array_of(given)
        if points.ndim != 2 or points.shape[1] != 2:
            raise invalid(field, f"has shape {list(points.shape)}; it must be [n, 2]", "ARRAY_INVALID")
        return points
