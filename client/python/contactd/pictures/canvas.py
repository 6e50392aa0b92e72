"""Provides common parts of plots: axes, colours, maps over grids."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, Literal

import numpy as np

from ..errors import MissingExtra
from ..values.arrays import Array
from ..values.generated.grid import Grid

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

__all__ = ["ADHESION", "COLOURS", "INK", "aspect_of", "axes_or_new", "bare", "colour_bar", "edges", "extent", "legend_below", "map_over", "new_figure", "plain", "pyplot", "warm"]

INK = "#1d1d2b"
ADHESION = "#1449b8"
_LEGEND = (7, 38)  #: Offset of a legend's upper left corner from the axes, to the left and downwards (points).
COLOURS = ("#1449b8", "#c8553d", "#0f8b8d", "#b8860b", "#6a4c93", "#5c5c66")


def pyplot() -> Any:
    """Returns the module. Raises MissingExtra if it is not installed."""
    try:
        import matplotlib.pyplot as plt
    except ImportError:
        raise MissingExtra("A picture", "matplotlib", "pictures", "python3-matplotlib") from None
    return plt


def new_figure(width: float, height: float) -> Figure:
    """Returns an empty figure (size in inches) that pyplot shows."""
    figure: Figure = pyplot().figure(figsize=(width, height), layout="constrained")
    return figure


def plain(name: str, most: int = 40) -> str:
    """Returns a file name that matplotlib draws unchanged: without formulas between dollar signs or a prefix that
    legends omit, and limited to `most` characters.
    """
    cut = name if len(name) <= most else f"{name[: most - 3].rstrip()}..."
    return (f" {cut}" if cut.startswith("_") else cut).replace("$", r"\$")


def axes_or_new(axes: Axes | None, width: float = 6.4, height: float = 4.8) -> Axes:
    """Returns the given axes, or those of a new figure of that size (inches)."""
    if axes is not None:
        return axes
    made: Axes = new_figure(width, height).subplots()
    return made


def warm() -> Any:
    """Returns a colour map from yellow to red, light enough for dark symbols on it."""
    colours = pyplot().get_cmap("YlOrRd")(np.linspace(0.0, 0.8, 256))
    from matplotlib.colors import LinearSegmentedColormap

    return LinearSegmentedColormap.from_list("contactd-warm", colours)


def bare(axes: Axes) -> None:
    """Removes the upper and right side of the frame, and adds a light grid."""
    axes.grid(color="#e4e1da", lw=0.6)
    axes.set_axisbelow(True)
    axes.spines[["top", "right"]].set_visible(False)


def extent(grid: Grid) -> tuple[float, float, float, float]:
    """Returns the extent of an image of the grid: left, right, bottom, top (mm)."""
    x, y = grid.x, grid.y
    return (x[0] - grid.dx / 2, x[-1] + grid.dx / 2, y[0] - grid.dy / 2, y[-1] + grid.dy / 2)


def map_over(axes: Axes, grid: Grid, values: Array, label: str) -> None:
    """Draws `values` >= 0 over the grid, shape [ny, nx], with a colour bar."""
    image = axes.imshow(values, origin="lower", extent=extent(grid), cmap=warm(), vmin=0, interpolation="nearest")
    colour_bar(axes, image, label)
    axes.set(xlabel="x (mm)", ylabel="y (mm)", aspect=aspect_of(grid.nx * grid.dx, grid.ny * grid.dy), facecolor="#f4f4f6")


def aspect_of(width: float, height: float) -> Literal["equal", "auto"]:
    """Returns the aspect of a plot of that size: true to scale unless the plot would become too flat."""
    return "equal" if 0.25 <= width / height <= 4 else "auto"


def colour_bar(axes: Axes, image: Any, label: str) -> None:
    """Draws a colour bar as high as the axes, whatever their aspect."""
    axes.figure.colorbar(image, cax=axes.inset_axes((1.03, 0, 0.04, 1)), label=label)


def legend_below(axes: Axes, **options: Any) -> None:
    """Draws a legend below the tick labels and the axis label, for axes of any height."""
    from matplotlib.transforms import ScaledTranslation

    (left, right), (bottom, top) = axes.get_xlim(), axes.get_ylim()
    is_narrow = axes.get_aspect() != "auto" and abs(top - bottom) > 1.5 * abs(right - left)  # makes the legend wider
    place, at, shift = ("upper center", 0.5, 0.0) if is_narrow else ("upper left", 0.0, _LEGEND[0])
    below = axes.transAxes + ScaledTranslation(-shift / 72, -_LEGEND[1] / 72, axes.figure.dpi_scale_trans)
    axes.legend(loc=place, bbox_to_anchor=(at, 0), bbox_transform=below, fontsize="small", frameon=False, **options)


def edges(mask: Any, grid: Grid, **style: Any) -> Any:
    """Returns the borders between elements inside and outside `mask`, shape [ny, nx], as lines."""
    from matplotlib.collections import LineCollection

    padded = np.pad(mask, 1)
    left, _, bottom, _ = extent(grid)
    upright = np.argwhere(padded[1:-1, 1:] != padded[1:-1, :-1])
    level = np.argwhere(padded[1:, 1:-1] != padded[:-1, 1:-1])

    def corner(i: int, j: int) -> tuple[float, float]:
        return (left + i * grid.dx, bottom + j * grid.dy)

    sides = [[corner(i, j), corner(i, j + 1)] for j, i in upright] + [[corner(i, j), corner(i + 1, j)] for j, i in level]
    return LineCollection(sides, **style)
