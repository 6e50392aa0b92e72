"""Forces of rolling over creepages, as `creep_curve` answers them."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np
import numpy.typing as npt

from ..errors import StatusError
from ..refusals import public
from .arrays import Array
from .grid import Grid
from .registry import extra
from .representation import Rows, Shown

if TYPE_CHECKING:
    from matplotlib.axes import Axes

__all__ = ["CreepCurve"]


@dataclass(frozen=True, eq=False, repr=False, kw_only=True)
class CreepCurve(Shown):
    """Forces of steady rolling, point by point. All arrays have one shape, that of xi, eta and phi broadcast together.

    Forces are those on the upper body, so that they oppose the creepages: Fx < 0 where xi > 0. Points that failed are NaN.

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
        converged: Whether every solver of the point reached its tolerance; False where it failed.
        errors: The exceptions of the points that failed, by their indices.
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
        """Draws -Fx/Fn and -Fy/Fn over the creepage that varies, of a curve of one dimension.

        Into `axes`, or a figure of its own; returns the axes. Needs matplotlib ("contactd[pictures]").
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
