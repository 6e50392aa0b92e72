"""Implements methods of stresses inside the bodies and of their blocks; `subsurface` declares the fields."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, Literal

import numpy as np

from ..refusals import public
from .registry import extra
from .representation import Rows

if TYPE_CHECKING:
    import xarray
    from matplotlib.axes import Axes

__all__ = ["Component", "StressBlockMethods", "SubsurfaceStressMethods"]

#: Fields of a stress with `invariants`.
INVARIANTS = ["hydrostatic", "principal_1", "principal_2", "principal_3", "tresca"]
Component = Literal[
    "von_mises", "xx", "yy", "zz", "xy", "xz", "yz", "hydrostatic", "principal_1", "principal_2", "principal_3", "tresca"
]


class StressBlockMethods:
    """Methods of a StressBlock."""

    @property
    def shape(self: Any) -> tuple[int, int, int]:
        """Shape of the stresses: (nz, ny, nx)."""
        return (np.size(self.z), np.size(self.y), np.size(self.x))


class SubsurfaceStressMethods:
    """Methods of a SubsurfaceStress."""

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
        """Plots a stress on a plane through a block, such as that at `y` (mm; uses the nearest points), or on a line.

        The default plane contains the largest von Mises stress. Draws into `axes` or a new figure, and returns the
        axes. Needs matplotlib ("contactd[pictures]").
        """
        drawn: Axes = extra("SubsurfaceStress.plot")(self, component, x=x, y=y, z=z, axes=axes)
        return drawn

    @public
    def to_xarray(self) -> xarray.Dataset:
        """Returns stresses against x, y and z of a block, or against points. Needs xarray ("contactd[xarray]")."""
        dataset: xarray.Dataset = extra("SubsurfaceStress.to_xarray")(self)
        return dataset

    def _title(self: Any) -> str:
        return f"SubsurfaceStress at {self.von_mises.size} points"

    def _rows(self: Any) -> Rows:
        at = self.largest
        return [("largest von Mises", at.von_mises), ("at x", at.x), ("y", at.y), ("z", at.z)]
