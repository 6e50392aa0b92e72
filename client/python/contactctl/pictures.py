"""Pictures of contacts: pressure, and with friction the tangential tractions with adhesion and slip."""

from __future__ import annotations

from typing import Any

import numpy as np

__all__ = ["draw_contact", "draw_wheel_rail"]


def draw_contact(figure: Any, grid: dict[str, Any], solution: dict[str, Any], *, across: str = "y (mm)") -> None:
    """Fills `figure` with the arrays of a `solution` over its `grid`, both as the wire has them."""
    has_friction = "slip_x" in solution
    figure.set_size_inches(9.5 if has_friction else 5, 4)
    axes = figure.subplots(1, 2 if has_friction else 1, squeeze=False)[0]
    x, y = _edges(grid, "x"), _edges(grid, "y")
    outside = np.asarray(solution["element_division"]) == 0
    _map(figure, axes[0], x, y, np.ma.array(solution["pressure"], mask=outside), "pressure (N/mm^2)")
    if has_friction:
        size = np.hypot(solution["traction_x"], solution["traction_y"])
        _map(figure, axes[1], x, y, np.ma.array(size, mask=outside), "tangential traction (N/mm^2)")
        _arrows(axes[1], x, y, solution, outside)
        adhesion = np.asarray(solution["element_division"]) == 1
        if adhesion.any() and min(adhesion.shape) > 1:
            centres = (x[:-1] + x[1:]) / 2, (y[:-1] + y[1:]) / 2
            axes[1].contour(*centres, adhesion.astype(float), levels=[0.5], colors="black", linewidths=1)
            axes[1].set_title("inside the line: adhesion", fontsize=9)
    for each in axes:
        each.set(xlabel="x (mm)", ylabel=across, aspect="equal")


def draw_wheel_rail(figure: Any, answer: dict[str, Any]) -> None:
    """A row for each patch of an answer to wheelrail.solve."""
    patches = answer["patches"]
    if not patches:
        figure.set_size_inches(5, 2)
        figure.text(0.5, 0.5, "wheel and rail do not touch", ha="center")
        return
    rows = np.atleast_1d(figure.subfigures(len(patches), 1))
    for row, patch in zip(rows, patches):
        draw_contact(row_of(row), patch["place"]["grid"], patch["solution"], across="across (mm)")
        reference = patch["place"]["reference"]
        row.suptitle(f"y = {reference['y']:.2f} mm, {reference['angle']:.3f} rad", fontsize=10)
    figure.set_size_inches(9.5, 4 * len(patches))


class row_of:
    """A part of a figure, which has no size of its own."""

    def __init__(self, part: Any) -> None:
        self._part = part

    def set_size_inches(self, *_: float) -> None:
        """That of the whole says it."""

    def __getattr__(self, name: str) -> Any:
        return getattr(self._part, name)


def _edges(grid: dict[str, Any], axis: str) -> np.ndarray[Any, Any]:
    count, step = grid[f"n{axis}"], grid[f"d{axis}"]
    start = grid.get(f"{axis}0")
    edges: np.ndarray[Any, Any] = (-count * step / 2 if start is None else start) + step * np.arange(count + 1)
    return edges


def _map(figure: Any, axes: Any, x: Any, y: Any, values: Any, label: str) -> None:
    drawn = axes.pcolormesh(x, y, values, cmap="viridis")
    figure.colorbar(drawn, ax=axes, label=label, shrink=0.8)


def _arrows(axes: Any, x: Any, y: Any, solution: dict[str, Any], outside: Any) -> None:
    """Some twenty in each direction: tractions on the upper body."""
    every = max(1, min(outside.shape) // 20)
    part = (slice(None, None, every), slice(None, None, every))
    at_x, at_y = np.meshgrid((x[:-1] + x[1:]) / 2, (y[:-1] + y[1:]) / 2)
    masked = [np.ma.array(solution[name], mask=outside)[part] for name in ("traction_x", "traction_y")]
    axes.quiver(at_x[part], at_y[part], *masked, color="white", alpha=0.8)
