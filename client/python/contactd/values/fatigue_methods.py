"""Implements methods of the fatigue of a contact; `result` declares the fields."""

from __future__ import annotations

import math
from collections.abc import Iterable
from typing import Any

import numpy as np
import numpy.typing as npt

__all__ = ["ContactFatigueMethods"]


class ContactFatigueMethods:
    """Methods of ContactFatigue."""

    @property
    def y(self: Any) -> npt.NDArray[np.float64]:
        """y of the middles of the rows (mm)."""
        return np.array([row.y for row in self.rows])

    @property
    def z(self: Any) -> npt.NDArray[np.float64]:
        """z of the middles of the rows (mm)."""
        return np.array([row.z for row in self.rows])

    @property
    def shear_of_rows(self: Any) -> npt.NDArray[np.float64]:
        """The largest shear stress below each row (N/mm^2); NaN without a passage."""
        return _values(row.shear for row in self.rows)

    @property
    def dang_van_of_rows(self: Any) -> npt.NDArray[np.float64]:
        """The largest Dang Van stress below each row (N/mm^2); NaN without a passage and a_DV."""
        return _values(row.dang_van for row in self.rows)

    @property
    def crack_angles(self: Any) -> npt.NDArray[np.float64]:
        """The angle of a crack perpendicular to the force of each row on the body, from x towards the row's y (rad,
        from 0 to pi): a right angle for a force along x.
        """
        return np.array([(math.atan2(row.force_y, row.force_x) + math.pi / 2) % math.pi for row in self.rows])

    def damage(self: Any, function: str) -> float:
        """Returns the damage of a passage by a function, by its name. Raises KeyError if it was not requested."""
        found = {one.name: one.value for one in self.damages}
        if function not in found:
            raise KeyError(f"{function} is not a function of this fatigue; it has {', '.join(found) or 'none'}.")
        return float(found[function])


def _values(values: Iterable[float | None]) -> npt.NDArray[np.float64]:
    return np.array([math.nan if value is None else value for value in values])
