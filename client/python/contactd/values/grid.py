"""The potential contact area, arrays over it, and undeformed distances, such as the paraboloid of a Hertzian contact."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
import numpy.typing as npt

__all__ = ["Array", "Grid", "Paraboloid", "SemiAxes"]

Array = npt.NDArray[np.float64]


@dataclass(frozen=True)
class Grid:
    """The potential contact area: `nx` x `ny` elements of size `dx` x `dy` (mm), unknowns at their centres.

    `dx` and `dy` are those of one element; `Grid.centred` takes the size of the whole area.
    Arrays over the grid have shape `[ny, nx]`: the first index counts along y.

    Attributes:
        nx: Number of elements along x.
        ny: Number of elements along y.
        dx: Size of an element along x (mm), > 0.
        dy: Size of an element along y (mm), > 0.
        x0: x of the lower left corner (mm); None: centred on the origin.
        y0: y of the lower left corner (mm); None: centred on the origin.
    """

    nx: int
    ny: int
    dx: float
    dy: float
    x0: float | None = None
    y0: float | None = None

    @classmethod
    def centred(cls, nx: int, ny: int, width: float, height: float) -> Grid:
        """`nx` x `ny` elements that together fill a `width` x `height` rectangle (mm) around the origin.

        ``Grid.centred(40, 40, 2.4, 2.4)`` is ``Grid(40, 40, 0.06, 0.06)``.
        """
        if nx < 1 or ny < 1:
            raise ValueError(f"nx and ny are {nx} and {ny}; a rectangle is divided into at least one element each way.")
        return cls(nx, ny, width / nx, height / ny)

    @property
    def shape(self) -> tuple[int, int]:
        """Shape of arrays over the grid: (ny, nx)."""
        return (self.ny, self.nx)

    @property
    def x(self) -> Array:
        """Element centres along x (mm), shape [nx]."""
        return _centres(self.nx, self.dx, self.x0)

    @property
    def y(self) -> Array:
        """Element centres along y (mm), shape [ny]."""
        return _centres(self.ny, self.dy, self.y0)


def _centres(n: int, size: float, corner: float | None) -> Array:
    start = -0.5 * n * size if corner is None else corner
    return np.asarray(start + (np.arange(n) + 0.5) * size, dtype=np.float64)


@dataclass(frozen=True)
class Paraboloid:
    """Undeformed distance h = x^2/(2 Rx) + y^2/(2 Ry), without the approach. One direction may be flat, not both.

    Attributes:
        Rx: Radius of curvature along x (mm), negative where concave; None: flat.
        Ry: Radius of curvature along y (mm), negative where concave; None: flat.
    """

    Rx: float | None = None
    Ry: float | None = None


@dataclass(frozen=True)
class SemiAxes:
    """The paraboloid whose Hertzian contact, under the approach or force of the problem, has these semi-axes.

    Attributes:
        a: Semi-axis along x (mm), > 0.
        b: Semi-axis along y (mm), > 0.
    """

    a: float
    b: float
