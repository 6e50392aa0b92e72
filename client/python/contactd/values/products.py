"""Multiplies tables of influence coefficients by tractions, with numpy's FFT."""

from __future__ import annotations

from typing import Any

import numpy as np
import numpy.typing as npt

from ..errors import invalid
from .arrays import Array, array_of

__all__ = ["displacements_by", "transposed"]

_NORMAL = 2


def displacements_by(table: Array, tractions: npt.ArrayLike) -> Array:
    """Returns the displacements for a table of shape [3, 3, ny, nx], or of columns [3, 3, ny, ny, nx], as `apply` does.
    Raises InvalidArgument for other shapes.
    """
    given = np.asarray(array_of(tractions))
    is_pressure = given.ndim == 2
    loads = np.asarray(given[None] if is_pressure else given, dtype=np.float64)
    ny, nx = table.shape[-2:]
    fits = loads.ndim == 3 and loads.shape[0] == (1 if is_pressure else 3) and 0 < loads.shape[1] <= ny and 0 < loads.shape[2] <= nx
    if table.ndim == 5:
        fits = fits and loads.shape[1] == ny
    if not fits:
        most = f"at most [{ny}, {nx}]" if table.ndim == 4 else f"[{ny}, nx], nx at most {nx}"
        raise invalid("tractions", f"has shape {list(given.shape)}; it must be [ny, nx], {most}, or [3, ny, nx]", "ARRAY_INVALID")
    if not np.isfinite(loads).all():
        raise invalid("tractions", "contains numbers that are not finite", "ARRAY_INVALID")
    axes = [_NORMAL] if is_pressure else [0, 1, 2]
    found = np.zeros_like(loads)
    for row, i in enumerate(axes):
        for column, j in enumerate(axes):
            if loads[column].any():
                found[row] += _product(table[i, j], loads[column], _parities(i, j))
    return np.asarray(found[0] if is_pressure else found)


def transposed(table: Array) -> Array:
    """Returns the table of the transposed matrix: loads and displacements are exchanged, and offsets change sign."""
    is_of_columns = table.ndim == 5
    found = np.array(table.transpose(1, 0, 3, 2, 4) if is_of_columns else table.swapaxes(0, 1))
    for i in range(3):
        for j in range(3):
            along, across = _parities(i, j)
            found[i, j] *= along if is_of_columns else along * across
    return found


def _parities(i: int, j: int) -> tuple[float, float]:
    """Returns the signs for negative offsets along x and y: -1 for odd components."""
    along, across = (-1.0 if i != j and axis in (i, j) else 1.0 for axis in range(2))
    return along, across


def _product(component: Any, load: Array, parities: tuple[float, float]) -> Array:
    """Returns the displacements by one component, [ny, nx]."""
    ny, nx = load.shape
    if component.ndim == 3:  # Columns are convolved along x and summed over the loaded ones.
        kernel = np.fft.rfft(_both_ways(component[..., :nx], parities[0], -1), axis=-1)
        spectra = np.einsum("ijk,jk->ik", kernel, np.fft.rfft(load, 2 * nx, axis=-1))
        return np.asarray(np.fft.irfft(spectra, 2 * nx, axis=-1)[:, :nx])
    offsets = _both_ways(_both_ways(component[:ny, :nx], parities[0], -1), parities[1], -2)
    size = (2 * ny, 2 * nx)
    return np.asarray(np.fft.irfft2(np.fft.rfft2(offsets) * np.fft.rfft2(load, size), size)[:ny, :nx])


def _both_ways(values: Array, parity: float, axis: int) -> Array:
    """Returns offsets 0 to n - 1, one unused offset, then -(n - 1) to -1, for circular convolution."""
    moved = np.moveaxis(values, axis, 0)
    backwards = parity * moved[:0:-1]
    if parity < 0:  # Odd components are zero at zero offset, apart from rounding in the table.
        moved = np.concatenate([np.zeros_like(moved[:1]), moved[1:]])
    return np.moveaxis(np.concatenate([moved, np.zeros_like(moved[:1]), backwards]), 0, axis)
