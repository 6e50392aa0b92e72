"""Pictures of contacts: pressure, and with friction the tangential tractions with adhesion and slip."""

from __future__ import annotations

from typing import Any

import numpy as np

__all__ = ["draw_contact", "draw_wheel_rail"]

Array = np.ndarray[Any, Any]


def draw_contact(figure: Any, grid: dict[str, Any], solution: dict[str, Any]) -> None:
    """Fills `figure` with the arrays of a `solution` over its `grid`, both as the wire has them."""
    has_friction = "slip_x" in solution
    figure.set_size_inches(10 if has_friction else 5.5, 5)
    _draw_row(figure, figure.subplots(1, 2 if has_friction else 1, squeeze=False)[0], grid, solution, "y (mm)")


def draw_wheel_rail(figure: Any, answer: dict[str, Any]) -> None:
    """A row for each patch of an answer to wheelrail.solve."""
    patches = answer["patches"]
    if not patches:
        figure.set_size_inches(5, 2)
        figure.text(0.5, 0.5, "wheel and rail do not touch", ha="center")
        return
    columns = 2 if "slip_x" in patches[0]["solution"] else 1
    figure.set_size_inches(10 if columns == 2 else 5.5, 4.5 * len(patches))
    for row, patch in zip(figure.subplots(len(patches), columns, squeeze=False), patches):
        _draw_row(figure, row, patch["place"]["grid"], patch["solution"], "across the rail (mm)")
        reference = patch["place"]["reference"]
        row[0].set_title(f"patch at y = {reference['y']:.2f} mm, angle {reference['angle']:.3f} rad", fontsize=9)


def _draw_row(figure: Any, row: Any, grid: dict[str, Any], solution: dict[str, Any], across: str) -> None:
    x, y = _edges(grid, "x"), _edges(grid, "y")
    division = np.asarray(solution["element_division"])
    _map(figure, row[0], x, y, np.ma.array(solution["pressure"], mask=division == 0), "pressure (N/mm^2)")
    if len(row) > 1:
        size = np.hypot(solution["traction_x"], solution["traction_y"])
        _map(figure, row[1], x, y, np.ma.array(size, mask=division == 0), "tangential traction (N/mm^2)")
        _arrows(row[1], x, y, solution, division)
        _outline_adhesion(row[1], x, y, division)
    for axes in row:
        _look_at(axes, x, y, division)
        axes.set(xlabel="x (mm)", ylabel=across, aspect="equal")


def _edges(grid: dict[str, Any], axis: str) -> Array:
    count, step, start = grid[f"n{axis}"], grid[f"d{axis}"], grid.get(f"{axis}0")
    edges: Array = (-count * step / 2 if start is None else start) + step * np.arange(count + 1)
    return edges


def _centres(edges: Array) -> Array:
    centres: Array = (edges[:-1] + edges[1:]) / 2
    return centres


def _map(figure: Any, axes: Any, x: Array, y: Array, values: Any, label: str) -> None:
    drawn = axes.pcolormesh(x, y, values, cmap="viridis")
    figure.colorbar(drawn, ax=axes, label=label, location="bottom", shrink=0.8)


def _arrows(axes: Any, x: Array, y: Array, solution: dict[str, Any], division: Array) -> None:
    """At most some twenty in each direction: tractions on the upper body."""
    part = tuple(slice(None, None, 1 + count // 20) for count in division.shape)
    places = [place[part] for place in np.meshgrid(_centres(x), _centres(y))]
    tractions = [np.ma.array(solution[name], mask=division == 0)[part] for name in ("traction_x", "traction_y")]
    axes.quiver(*places, *tractions, color="white", alpha=0.8)


def _outline_adhesion(axes: Any, x: Array, y: Array, division: Array) -> None:
    adhesion = division == 1
    if adhesion.any() and min(adhesion.shape) > 1:
        axes.contour(_centres(x), _centres(y), adhesion.astype(float), levels=[0.5], colors="black", linewidths=1)
        axes.set_title("adhesion inside the line", fontsize=9)


def _look_at(axes: Any, x: Array, y: Array, division: Array) -> None:
    """The contact and two elements around it, of a grid that may be much larger."""
    rows, columns = np.nonzero(division)
    if len(rows):
        axes.set_xlim(x[max(columns.min() - 2, 0)], x[min(columns.max() + 3, len(x) - 1)])
        axes.set_ylim(y[max(rows.min() - 2, 0)], y[min(rows.max() + 3, len(y) - 1)])
