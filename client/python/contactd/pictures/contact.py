"""Plots one contact: a map of pressures and tractions, and a section through it."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from ..values.generated.grid import Grid
from ..values.solution import ContactSolution
from .canvas import ADHESION, COLOURS, INK, axes_or_new, bare, edges, legend_below, map_over

if TYPE_CHECKING:
    from matplotlib.axes import Axes

__all__ = ["draw_contact", "draw_section", "title_of"]

_ARROWS = 16  #: Largest number of arrows along the longer side, to keep the plot readable.


def draw_contact(solution: ContactSolution, axes: Axes | None = None) -> Axes:
    """Implements ContactSolution.plot."""
    grid = grid_of(solution)
    _check(solution, "pressure", "element_division")
    axes = axes_or_new(axes, 6.8, 5.4)
    map_over(axes, grid, np.ma.masked_equal(solution.pressure, 0), "pressure (N/mm$^2$)")
    axes.set_title(title_of(solution))
    _add_tractions(axes, grid, solution)
    contact, adhesion = solution.element_division != 0, solution.element_division == 1
    axes.add_collection(edges(contact, grid, color=INK, linewidth=0.9, label="edge of contact"))
    if adhesion.any():
        axes.add_collection(edges(adhesion, grid, color=ADHESION, linewidth=2.0, label="edge of adhesion"))
    legend_below(axes, ncols=2)
    return axes


def draw_section(solution: ContactSolution, y: float = 0.0, axes: Axes | None = None) -> Axes:
    """Implements ContactSolution.plot_section."""
    grid = grid_of(solution)
    _check(solution, "pressure", "element_division", "traction_x", "traction_y")
    axes = axes_or_new(axes)
    row = int(np.argmin(np.abs(grid.y - y)))
    if not abs(grid.y[row] - y) <= grid.dy / 2 * (1 + 1e-9):
        raise ValueError(f"y is {y}; the grid reaches from {grid.y[0] - grid.dy / 2:g} to {grid.y[-1] + grid.dy / 2:g} mm")
    adhesion = solution.element_division[row] == 1
    for start, end in _stretches(adhesion):
        ends = (grid.x[start] - grid.dx / 2, grid.x[end] + grid.dx / 2)
        axes.axvspan(*ends, color=ADHESION, alpha=0.09, lw=0, label=None if axes.patches else "adhesion")
    axes.plot(grid.x, solution.pressure[row], color=COLOURS[1], label="pressure")
    for name, color in (("traction_x", COLOURS[0]), ("traction_y", COLOURS[2])):
        if (values := getattr(solution, name)[row]).any():
            axes.plot(grid.x, values, color=color, label=f"traction along {name[-1]}, on the upper body")
    axes.set(xlabel="x (mm)", ylabel="N/mm$^2$", title=f"{title_of(solution)}\nalong x at y = {grid.y[row]:.3g} mm")
    axes.axhline(0, color=INK, lw=0.6)
    bare(axes)
    axes.legend(fontsize="small", frameon=False)
    return axes


def grid_of(solution: ContactSolution) -> Grid:
    """Returns the grid. Raises ValueError if it is unknown."""
    if solution.grid is None:
        raise ValueError("grid is None; only solutions of a client, which have a grid, can be drawn")
    return solution.grid


def title_of(solution: ContactSolution) -> str:
    """Returns a title with the forces."""
    names = ["Fn", *(name for name in ("Fx", "Fy") if abs(getattr(solution, name)) > 1e-9 * solution.Fn)]
    forces = [f"$F_{name[1]}$ = {getattr(solution, name):.5g} N" for name in names]
    return ", ".join(forces) + ("" if solution.converged else " (NOT CONVERGED)")


def _check(solution: ContactSolution, *names: str) -> None:
    if missing := [name for name in names if not hasattr(solution, name)]:
        raise ValueError(f"The solution has no {', '.join(missing)}: include it in `fields` when you request the solution.")


def _add_tractions(axes: Axes, grid: Grid, solution: ContactSolution) -> None:
    if not (hasattr(solution, "traction_x") and hasattr(solution, "traction_y")):
        return
    size = np.hypot(solution.traction_x, solution.traction_y)
    if not size.any():
        return
    touched = np.argwhere(solution.element_division != 0)
    spread = np.ptp(touched, axis=0) + 1
    steps = [max(1, round(n / max(4.0, _ARROWS * n / spread.max()))) for n in spread]
    pick = tuple(slice(first + (step - 1) // 2, None, step) for first, step in zip(touched.min(axis=0), steps))
    shown = size[pick] > 0.02 * size.max()
    x, y = np.meshgrid(grid.x, grid.y)
    scale = size.max() / (1.4 * max(steps) * max(grid.dx, grid.dy))
    if axes.get_aspect() == "auto":  # The arrows fit into the space in both directions.
        of_x, of_y = (np.abs(traction[pick]).max() for traction in (solution.traction_x, solution.traction_y))
        scale = max(of_x / (1.4 * steps[1] * grid.dx), of_y / (1.4 * steps[0] * grid.dy)) or scale
    label = f"traction on the upper body, up to {size.max():.4g} N/mm$^2$"
    axes.quiver(
        x[pick][shown], y[pick][shown], solution.traction_x[pick][shown], solution.traction_y[pick][shown],
        color=INK, angles="xy", scale_units="xy", scale=scale, pivot="middle",
        width=0.0036, headwidth=3.8, headlength=4.2,
    )  # fmt: skip
    axes.plot([], [], color=INK, ls="", marker=r"$\rightarrow$", ms=11, label=label)


def _stretches(mask: Any) -> list[tuple[int, int]]:
    """Returns the first and last index of each run of True."""
    changes = np.flatnonzero(np.diff(np.concatenate([[False], mask, [False]])))
    return [(int(a), int(b) - 1) for a, b in zip(changes[::2], changes[1::2])]
