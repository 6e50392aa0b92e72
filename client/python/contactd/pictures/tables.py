"""Plots a table of influence coefficients: its components against the distance from the load."""

from __future__ import annotations

from collections.abc import Iterable
from typing import TYPE_CHECKING

import numpy as np

from ..values.tables import IcTable
from .canvas import COLOURS, axes_or_new, bare

if TYPE_CHECKING:
    from matplotlib.axes import Axes

__all__ = ["draw_table"]


def draw_table(table: IcTable, components: Iterable[str] = ("xx", "yy", "zz", "xz"), axes: Axes | None = None) -> Axes:
    """Implements IcTable.plot."""
    axes = axes_or_new(axes, 7.0, 4.8)
    grid = table.spec.grid
    along_x, along_y = np.arange(grid.nx) * grid.dx, np.arange(grid.ny) * grid.dy
    for component, color in zip(components, [*COLOURS] * 2):
        values = np.abs(table[component])
        values[values == 0] = np.nan  # Odd components vanish on an axis.
        if not np.isnan(values[0]).all():
            axes.plot(along_x, values[0], "o-", ms=3, color=color, label=f"|{component}| along x")
        if not np.isnan(values[:, 0]).all():
            axes.plot(along_y, values[:, 0], "s--", ms=3, mfc="none", color=color, label=f"|{component}| along y")
    axes.set(
        yscale="log",
        xlabel="distance from the loaded element (mm)",
        ylabel="displacement by a unit traction (mm$^3$/N)",
        title=f"Influence coefficients, {grid.nx} x {grid.ny} offsets\n{dict(table._rows())['source']}",
    )
    bare(axes)
    axes.legend(fontsize="small", frameon=False, ncols=2)
    return axes
