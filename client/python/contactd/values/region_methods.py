"""Implements the wire format of regions; `regions` declares the fields."""

from __future__ import annotations

import numpy as np
import numpy.typing as npt

from .arrays import array_of
from .params import HasParams

__all__ = ["RegionMethods"]


class RegionMethods(HasParams):
    """Methods of ContactRegions."""

    @staticmethod
    def _write_shares(shares: npt.ArrayLike, field: str) -> list[float]:
        matrix = array_of(shares)
        if matrix.ndim == 2 and matrix.shape[0] != matrix.shape[1]:
            raise TypeError(f"{field} has the shape {matrix.shape}; it must be square, with a row and a column for each region")
        return [float(share) for share in np.ravel(matrix)]
