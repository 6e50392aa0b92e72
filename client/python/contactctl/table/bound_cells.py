"""Cells of a table that have one bound of its errors each."""

from __future__ import annotations

import math

import numpy as np
import numpy.typing as npt

from .plan import Reals

__all__ = ["BOUND_CELLS", "Bools", "Integers", "adjacent", "cell_numbers", "is_apex", "touches_apex"]

Bools = npt.NDArray[np.bool_]
Integers = npt.NDArray[np.int64]

BOUND_CELLS = (8, 8, 4, 8)  #: Of log(a/b), both angles and u.


def cell_numbers(ends: Reals, points: Reals) -> Integers:
    """Returns the numbers of the cells of points, in the order of the file. `ends` are those of the axes."""
    low, high = ends
    indices = np.clip((points - low) / (high - low) * BOUND_CELLS, 0, np.array(BOUND_CELLS) - 1).astype(np.int64)
    numbers: Integers = np.ravel_multi_index(tuple(indices.T), BOUND_CELLS).astype(np.int64)
    return numbers


def touches_apex(angle_a: Integers, angle_b: Integers, length: Integers) -> Bools:
    """Returns which cells of the angles and u touch pure spin at full slip."""
    touches: Bools = np.isin(angle_a, (3, 4)) & (angle_b == BOUND_CELLS[2] - 1) & np.isin(length, (3, 4))
    return touches


def is_apex(ends: Reals) -> Bools:
    """Returns which cells touch the apex: pure spin at full slip, with a/b above 2 in the middle of the cell."""
    ratio, *others = np.indices(BOUND_CELLS).reshape(4, -1)
    low, high = ends[:, 0]
    is_long: Bools = low + (ratio + 0.5) * (high - low) / BOUND_CELLS[0] > math.log(2)
    return is_long & touches_apex(*others)


def adjacent(values: Reals) -> Reals:
    """Returns the largest values in the cells that share a face with each cell. `values` has the shape [cells, any]."""
    given = values.reshape(*BOUND_CELLS, -1)
    found: Reals = np.full(given.shape, -np.inf)
    for axis in range(len(BOUND_CELLS)):
        of, to = np.moveaxis(given, axis, 0), np.moveaxis(found, axis, 0)
        np.maximum(to[1:], of[:-1], out=to[1:])
        np.maximum(to[:-1], of[1:], out=to[:-1])
    return found.reshape(values.shape)
