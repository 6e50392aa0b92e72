"""Implements methods of the wear of a contact; `result` declares the fields."""

from __future__ import annotations

from typing import Any

import numpy as np
import numpy.typing as npt

__all__ = ["ContactWearMethods"]


class ContactWearMethods:
    """Methods of ContactWear."""

    @property
    def y(self: Any) -> npt.NDArray[np.float64]:
        """y of the middles of the rows (mm)."""
        return np.array([row.y for row in self.rows])

    @property
    def z(self: Any) -> npt.NDArray[np.float64]:
        """z of the middles of the rows (mm)."""
        return np.array([row.z for row in self.rows])

    @property
    def angle(self: Any) -> npt.NDArray[np.float64]:
        """The inclinations of the rows (rad)."""
        return np.array([row.angle for row in self.rows])

    @property
    def dissipation_of_rows(self: Any) -> npt.NDArray[np.float64]:
        """The integrals of |t s| along the rows (N/mm)."""
        return np.array([row.dissipation for row in self.rows])

    @property
    def pressure_slip_of_rows(self: Any) -> npt.NDArray[np.float64]:
        """The integrals of p |s| along the rows (N/mm)."""
        return np.array([row.pressure_slip for row in self.rows])

    def depth(self: Any, law: str) -> npt.NDArray[np.float64]:
        """Returns the depth removed from the rows in one passage by a law (mm), by its name. Raises KeyError if it was
        not requested.
        """
        names = [one.name for one in self.laws]
        if law not in names:
            raise KeyError(f"{law} is not a law of this wear; it has {', '.join(names) or 'none'}.")
        index = names.index(law)
        return np.array([row.depths[index] for row in self.rows])
