"""Draws the solution of the Cattaneo problem: a map of the contact, and a section through its middle."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np

from ..pictures.canvas import ADHESION, INK, edges, extent, pyplot, warm
from ..values.generated.grid import Grid
from ..values.solution import ContactSolution
from .closed_form import Sphere

__all__ = ["draw"]

_ADHESION = 1  #: of element_division


def draw(path: Path, grid: Grid, solution: ContactSolution, sphere: Sphere, subtitle: str) -> None:
    """Writes the picture in the format given by its name. Creates missing folders."""
    plt = pyplot()
    style = {"font.size": 10, "axes.edgecolor": INK, "text.color": INK, "axes.labelcolor": INK, "figure.dpi": 150}
    with plt.rc_context(style):
        figure, (left, right) = plt.subplots(1, 2, figsize=(12.4, 5.6), width_ratios=(1.12, 1), layout="constrained")
        _draw_map(figure, left, grid, solution)
        _draw_cut(right, grid, solution, sphere)
        figure.suptitle(f"Cattaneo shift: a sphere pressed on a plane and shifted along x\n{subtitle}", fontsize=12)
        path.parent.mkdir(parents=True, exist_ok=True)
        figure.savefig(path)
        plt.close(figure)


def _draw_map(figure: Any, axes: Any, grid: Grid, solution: ContactSolution) -> None:
    pressure = np.ma.masked_equal(solution.pressure, 0)
    image = axes.imshow(pressure, origin="lower", extent=extent(grid), cmap=warm(), vmin=0, interpolation="nearest")
    figure.colorbar(image, ax=axes, label="pressure $p_z$ (N/mm$^2$)", shrink=0.92)
    axes.set_facecolor("#f4f4f6")

    # Arrows at every second element only, to keep the picture readable.
    pick = (slice(None, None, 2), slice(None, None, 2))
    size = np.hypot(solution.traction_x, solution.traction_y)
    shown = size[pick] > 0.02 * size.max()
    x, y = np.meshgrid(grid.x, grid.y)
    place = (x[pick][shown], y[pick][shown])
    traction = (solution.traction_x[pick][shown], solution.traction_y[pick][shown])
    shape = {"width": 0.0036, "headwidth": 3.8, "headlength": 4.2, "pivot": "middle"}
    arrows = axes.quiver(*place, *traction, color=INK, scale=17 * size.max(), **shape)
    axes.quiverkey(arrows, 0.82, 0.045, 1.0, "1 N/mm$^2$", labelpos="E", coordinates="axes", labelsep=0.08)
    adhesion, contact = solution.element_division == _ADHESION, solution.element_division != 0
    axes.add_collection(edges(adhesion, grid, color=ADHESION, linewidth=2.2, label="adhesion | slip"))
    axes.add_collection(edges(contact, grid, color=INK, linewidth=0.9, label="edge of contact"))
    axes.legend(loc="upper left", fontsize=8.5, framealpha=0.9)
    axes.set(
        xlabel="x (mm)", ylabel="y (mm)", title="Pressure, and tangential traction on the upper body", aspect="equal"
    )


def _draw_cut(axes: Any, grid: Grid, solution: ContactSolution, sphere: Sphere) -> None:
    row = int(np.argmin(np.abs(grid.y)))
    fine = np.linspace(grid.x[0], grid.x[-1], 801)
    distance = np.hypot(fine, grid.y[row])
    friction, pressure = "#0f8b8d", "#c8553d"
    axes.axvspan(-sphere.adhesion_radius, sphere.adhesion_radius, color=friction, alpha=0.09, lw=0)
    axes.text(0, 0.03 * sphere.pmax, "adhesion", ha="center", color=friction)
    axes.plot(fine, sphere.pressure(distance), color=pressure, lw=1.2, label="pressure: Hertz")
    contact = solution.element_division[row] != 0
    axes.plot(grid.x[contact], solution.pressure[row][contact], "o", color=pressure, ms=3.6, label="pressure: contactd")
    bound = sphere.mu * sphere.pressure(distance)
    axes.plot(fine, bound, "--", color="#8a8a8a", lw=1, label=r"friction bound $\mu\,p_z$")
    axes.plot(fine, sphere.traction(distance), color=friction, lw=1.2, label="traction: Cattaneo")
    size = np.hypot(solution.traction_x[row], solution.traction_y[row])
    axes.plot(grid.x[contact], size[contact], "s", color=friction, ms=3.4, label="traction: contactd")
    axes.set(xlabel="x (mm)", ylabel="N/mm$^2$", title=f"Along x at y = {grid.y[row]:.2f} mm")
    axes.set(xlim=(grid.x[0], grid.x[-1]), ylim=(0, 1.32 * sphere.pmax))
    axes.grid(color="#e4e1da", lw=0.6)
    axes.legend(fontsize=8.5, loc="upper center", ncols=3, frameon=False)
    for side in ("top", "right"):
        axes.spines[side].set_visible(False)
