"""The potential contact area, and undeformed distances, such as the paraboloid of a Hertzian contact.

Written by ./dev generate from proto/schema: edit it there.
"""

from __future__ import annotations

from dataclasses import dataclass

from ..grid_methods import GridMethods

__all__ = ["Grid", "HalfEllipses", "Paraboloid", "SemiAxes"]


@dataclass(frozen=True)
class Grid(GridMethods):
    """The potential contact area: `nx` x `ny` elements of size `dx` x `dy`, unknowns at their centres.

    `dx` and `dy` are those of one element; `Grid.centred` takes the size of the whole area. Arrays over the grid have
    shape `[ny, nx]`: the first index counts along y.

    Attributes:
        nx: Number of elements along x; nx*ny is at most limits.max_grid_elements of server.info.
        ny: Number of elements along y; nx*ny is at most limits.max_grid_elements of server.info.
        dx: Element size along x (mm), > 0.
        dy: Element size along y, 1/1000 to 1000 times dx (mm), > 0; 1e-6 to 1e6 times for constant loads on half-spaces
            in closed form; any length for a line contact.
        x0: x of the lower left corner (mm); without it the grid is centred on the origin.
        y0: y of the lower left corner (mm); without it the grid is centred on the origin.
    """

    nx: int
    ny: int
    dx: float
    dy: float
    x0: float | None = None
    y0: float | None = None


@dataclass(frozen=True)
class Paraboloid:
    """Undeformed distance h = x^2/(2 Rx) + y^2/(2 Ry), without the approach. One direction may be flat, not both.

    Attributes:
        Rx: Radius of curvature along x, negative if concave (mm). If None, flat.
        Ry: Radius of curvature along y, negative if concave (mm). If None, flat.
    """

    _key = "paraboloid"

    Rx: float | None = None
    Ry: float | None = None


@dataclass(frozen=True)
class SemiAxes:
    """Semi-axes of a Hertzian contact. The gap is the paraboloid that has this contact under the prescribed approach or
    force.

    Attributes:
        a: Semi-axis along x (mm), > 0.
        b: Semi-axis along y (mm), > 0.
    """

    _key = "semi_axes"

    a: float
    b: float


@dataclass(frozen=True)
class HalfEllipses:
    """Two half ellipses over which pressures are prescribed by normal_model elliptic or parabolic, under Fn (SDEC).
    They join at y = (b_negative - b_positive)/2.

    Attributes:
        a: Semi-axis along x (mm), > 0.
        b_negative: Semi-axis across, of the half towards -y (mm), > 0.
        b_positive: Semi-axis across, of the half towards +y (mm), > 0.
    """

    _key = "half_ellipses"

    a: float
    b_negative: float
    b_positive: float
