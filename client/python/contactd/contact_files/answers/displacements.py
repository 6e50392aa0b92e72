"""Displacements of the surfaces at the elements, which solutions do not have: tractions times influence coefficients."""

from __future__ import annotations

from collections.abc import Callable
from functools import lru_cache

import numpy as np
import numpy.typing as npt

from ...values.grid import Grid
from ...values.ics import AnalyticIcs
from ...values.materials import Material
from ..problems.bodies import Pair

__all__ = ["Displacements"]

Floats = npt.NDArray[np.float64]
#: The influence coefficients of a body, shape [3, 3, ny, nx] (mm^3/N).
Coefficients = Callable[[Material, Grid, AnalyticIcs], Floats]

_KEPT = 4
_ODD_X = np.array([[1, -1, -1], [-1, 1, 1], [-1, 1, 1]])
_ODD_Y = np.array([[1, -1, 1], [-1, 1, -1], [1, -1, 1]])
#: Between two bodies the coefficients of one direction add, those of a tangential and a normal one are lower less upper.
_OF_UPPER = np.array([[1, 1, -1], [1, 1, -1], [-1, -1, 1]])


class Displacements:
    """Makes them by coefficients; those used last are kept."""

    def __init__(self, coefficients: Coefficients) -> None:
        self._coefficients = coefficients
        self._symbol = lru_cache(maxsize=_KEPT)(self._make_symbol)

    def between(self, pair: Pair, grid: Grid, ics: AnalyticIcs, tractions: Floats) -> Floats:
        """Displacements of body 1 less those of body 2 (mm), shape [3, ny, nx], axes x, y, z with z into body 1, of
        `tractions` on body 1 of that shape."""
        symbol = self._symbol(pair.upper, pair.lower, Grid(grid.nx, grid.ny, grid.dx, grid.dy), ics)
        extent = (2 * grid.ny, 2 * grid.nx)
        spectrum = np.fft.rfft2(tractions, extent)
        found = np.fft.irfft2(np.einsum("ijkl,jkl->ikl", symbol, spectrum), extent)
        return np.asarray(found[:, : grid.ny, : grid.nx])

    def _make_symbol(self, upper: Material, lower: Material | None, grid: Grid, ics: AnalyticIcs) -> npt.NDArray[np.complex128]:
        of_upper = self._coefficients(upper, grid, ics)
        of_lower = of_upper if lower is None else self._coefficients(lower, grid, ics)
        table = of_lower + _OF_UPPER[:, :, None, None] * of_upper
        return np.asarray(np.fft.rfft2(_all_offsets(table)))


def _all_offsets(table: Floats) -> Floats:
    """Coefficients of negative offsets, too, where the transform looks for them; shape [3, 3, 2 ny, 2 nx]."""
    ny, nx = table.shape[2:]
    whole = np.zeros((3, 3, 2 * ny, 2 * nx))
    whole[:, :, :ny, :nx] = table
    whole[:, :, :ny, nx + 1 :] = table[:, :, :, :0:-1] * _ODD_X[:, :, None, None]
    whole[:, :, ny + 1 :, :] = whole[:, :, ny - 1 : 0 : -1, :] * _ODD_Y[:, :, None, None]
    return whole
