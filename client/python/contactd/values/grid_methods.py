"""Implements methods of Grid; `grid` declares the fields."""

from __future__ import annotations

from typing import Any, TypeVar

import numpy as np
import numpy.typing as npt

__all__ = ["GridMethods"]

G = TypeVar("G", bound="GridMethods")


class GridMethods:
    """Methods of a Grid."""

    @classmethod
    def centred(cls: type[G], nx: int, ny: int, width: float, height: float) -> G:
        """Returns `nx` x `ny` elements that fill a `width` x `height` rectangle (mm) centred at the origin.

        ``Grid.centred(40, 40, 2.4, 2.4)`` is ``Grid(40, 40, 0.06, 0.06)``.
        """
        if nx < 1 or ny < 1:
            raise ValueError(f"nx and ny are {nx} and {ny}; a rectangle is divided into at least one element each way.")
        make: Any = cls
        made: G = make(nx, ny, width / nx, height / ny)
        return made

    @property
    def shape(self: Any) -> tuple[int, int]:
        """Shape of arrays over the grid: (ny, nx)."""
        return (self.ny, self.nx)

    @property
    def x(self: Any) -> npt.NDArray[np.float64]:
        """Element centres along x (mm), shape [nx]."""
        return _centres(self.nx, self.dx, self.x0)

    @property
    def y(self: Any) -> npt.NDArray[np.float64]:
        """Element centres along y (mm), shape [ny]."""
        return _centres(self.ny, self.dy, self.y0)


def _centres(n: int, size: float, corner: float | None) -> npt.NDArray[np.float64]:
    start = -0.5 * n * size if corner is None else corner
    return np.asarray(start + (np.arange(n) + 0.5) * size, dtype=np.float64)
