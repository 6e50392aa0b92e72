"""Stresses inside the bodies: what `Client.subsurface` takes and answers."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Literal

import numpy as np
import numpy.typing as npt

from ..refusals import public
from .arrays import Array
from .dictionaries import Saved
from .registry import extra
from .representation import Rows, Shown

if TYPE_CHECKING:
    import xarray
    from matplotlib.axes import Axes

__all__ = ["Component", "LargestStress", "StressBlock", "SubsurfaceStress"]

Component = Literal["von_mises", "xx", "yy", "zz", "xy", "xz", "yz"]


@dataclass(frozen=True, eq=False)
class StressBlock:
    """The points (x, y, z) with each of `x`, each of `y` and each of `z` (mm), in any order; a number stands for one.

    Costs less than as many points where coordinates are whole elements apart: ``StressBlock(grid.x, grid.y, z)``.

    Attributes:
        x: Places along x (mm).
        y: Places along y (mm).
        z: Places along z (mm), <= 0 inside the body, for the upper one too.
    """

    x: npt.ArrayLike
    y: npt.ArrayLike
    z: npt.ArrayLike

    @property
    def shape(self) -> tuple[int, int, int]:
        """Shape of the stresses: (nz, ny, nx)."""
        return (np.size(self.z), np.size(self.y), np.size(self.x))


@dataclass(frozen=True)
class LargestStress:
    """The place of the largest von Mises stress among the points asked for.

    Attributes:
        von_mises: N/mm^2.
        x: Mm.
        y: Mm.
        z: Mm, <= 0.
        depth: -z (mm).
    """

    von_mises: float
    x: float
    y: float
    z: float
    depth: float


@dataclass(frozen=True, eq=False, repr=False)
class SubsurfaceStress(Saved, Shown):
    """Stresses inside a body (N/mm^2), tension positive: read-only arrays of shape [n], of a block [nz, ny, nx].

    They are in the frame of the body, in which it is z <= 0 and x and y are those of the grid. The frame of the lower
    body is that of the contact problem; that of the upper one is its mirror image, so that xz and yz of the upper body
    change sign on the way to the frame of the problem.

    Attributes:
        xx: Normal stress along x.
        yy: Normal stress along y.
        zz: Normal stress along z.
        xy: Shear stress.
        xz: Shear stress.
        yz: Shear stress.
        von_mises: Von Mises' equivalent stress.
        largest: Where that is largest; the first place of equals.
        block: Where they are, which the client adds; None of single points.
        points: Where they are, shape [n, 3] (mm); None of a block.
    """

    xx: Array
    yy: Array
    zz: Array
    xy: Array
    xz: Array
    yz: Array
    von_mises: Array
    largest: LargestStress
    block: StressBlock | None = None
    points: Array | None = None

    @public
    def plot(
        self,
        component: Component = "von_mises",
        *,
        x: float | None = None,
        y: float | None = None,
        z: float | None = None,
        axes: Axes | None = None,
    ) -> Axes:
        """Draws a stress on a plane through a block, such as that at `y` (mm; the nearest points count), or on a line.

        Left out, the plane is that with the largest von Mises stress. Into `axes`, or a figure of its own; returns the axes.
        Needs matplotlib ("contactd[pictures]").
        """
        drawn: Axes = extra("SubsurfaceStress.plot")(self, component, x=x, y=y, z=z, axes=axes)
        return drawn

    @public
    def to_xarray(self) -> xarray.Dataset:
        """Stresses over x, y and z of a block, or over points. Needs xarray ("contactd[xarray]")."""
        labelled: xarray.Dataset = extra("SubsurfaceStress.to_xarray")(self)
        return labelled

    def _title(self) -> str:
        return f"SubsurfaceStress at {self.von_mises.size} points"

    def _rows(self) -> Rows:
        at = self.largest
        return [("largest von Mises", at.von_mises), ("at x", at.x), ("y", at.y), ("z", at.z)]
