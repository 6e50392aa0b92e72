"""Holds forces of rolling against creepages, returned by `creep_curve`."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np
import numpy.typing as npt

from ..errors import StatusError
from ..refusals import public
from .arrays import Array
from .generated.grid import Grid
from .registry import extra
from .representation import Rows, Shown

if TYPE_CHECKING:
    from matplotlib.axes import Axes

__all__ = ["CreepCurve"]


@dataclass(frozen=True, eq=False, repr=False, kw_only=True)
class CreepCurve(Shown):
    """Forces of steady rolling, point by point. All arrays have one shape, that of xi, eta and phi broadcast together.

    Forces act on the upper body, so they oppose the creepages: Fx < 0 for xi > 0. Failed points are NaN.

    Attributes:
        grid: The grid that all points were solved on.
        xi: Longitudinal creepage.
        eta: Lateral creepage.
        phi: Spin creepage (rad/mm).
        Fn: Normal force (N).
        Fx: Tangential force along x (N).
        Fy: Tangential force along y (N).
        Mz: Moment of the tractions about z at the origin (N mm).
        pmax: Largest pressure (N/mm^2).
        converged: Whether every solver of the point reached its tolerance; False for failed points.
        errors: The exceptions of failed points by their indices.
    """

    grid: Grid
    xi: Array
    eta: Array
    phi: Array
    Fn: Array
    Fx: Array
    Fy: Array
    Mz: Array
    pmax: Array
    converged: npt.NDArray[np.bool_]
    errors: Mapping[tuple[int, ...], StatusError]

    @public
    def plot(self, axes: Axes | None = None) -> Axes:
        """Plots -Fx/Fn and -Fy/Fn against the creepage that varies, for one-dimensional arrays.

        Draws into `axes` or a new figure, and returns the axes. Needs matplotlib ("contactd[pictures]").
        """
        drawn: Axes = extra("CreepCurve.plot")(self, axes)
        return drawn

    def _title(self) -> str:
        return f"CreepCurve of {self.xi.size} points on {self.grid.nx} x {self.grid.ny} elements"

    def _rows(self) -> Rows:
        rows: Rows = [(name, _range(getattr(self, name))) for name in ("xi", "eta", "phi", "Fx", "Fy", "Mz")]
        failed = f"{len(self.errors)} failed, " if self.errors else ""
        return [*rows, ("points", f"{failed}{np.count_nonzero(self.converged)} of {self.xi.size} converged")]


def _range(values: Array) -> str:
    there = values[np.isfinite(values)]
    if not there.size:
        return "none"
    return f"{there.min():.5g}" if np.ptp(there) == 0 else f"{there.min():.5g} to {there.max():.5g}"
