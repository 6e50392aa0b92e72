"""Plots one case with several models: pressures, forces, errors and computing times."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from ..values.generated.grid import Grid
from ..values.wheel_rail.comparison import ComparedModel, ModelComparison
from ..values.wheel_rail.solution import WheelRailSolution
from .canvas import ADHESION, COLOURS, INK, bare, edges, extent, new_figure, warm

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

__all__ = ["draw_comparison"]

_WIDTH = 2.1  #: Size of a map (inches).
_ROUNDING = 1e-12  #: Fraction of the normal force, as in tables of the command line.
_MARKERS = "os^DvP*X"
_NORMAL_MODELS = {"of_model": INK, "kp": COLOURS[1], "kpec": COLOURS[2], "analyn": COLOURS[3]}


def draw_comparison(comparison: ModelComparison) -> Figure:
    """Implements ModelComparison.plot: a row of maps for each model of pressures, a column for each model of
    tractions.
    """
    shown = comparison.computed
    rows = list(dict.fromkeys(one.normal_model for one in shown))
    columns = list(dict.fromkeys(one.model for one in shown))
    window = _window(shown)
    height = _WIDTH * min(3.0, max(0.3, (window[3] - window[2]) / (window[1] - window[0]))) + 0.35
    figure = new_figure(max(9.5, _WIDTH * len(columns) + 1.2), height * len(rows) + 4.4)
    above, below = figure.subfigures(2, 1, height_ratios=(height * len(rows) + 0.3, 4.1))
    panels = above.subplots(len(rows), len(columns), squeeze=False, sharex=True, sharey=True)
    largest = max((_pmax(one) for one in shown), default=0.0) or 1.0
    image = None
    for panel in panels.ravel():
        panel.set_visible(False)
    for one in shown:
        panel = panels[rows.index(one.normal_model), columns.index(one.model)]
        panel.set_visible(True)
        image = _draw_pressures(panel, one, comparison, largest) or image
        panel.set(xlim=window[:2], ylim=window[2:])
    if image is not None:
        above.colorbar(image, ax=list(panels.ravel()), label="pressure (N/mm$^2$)", fraction=0.03, pad=0.01)
    above.supxlabel("x (mm); thin: edge of contact of the full theory, blue: edge of adhesion", fontsize="small")
    above.supylabel("y (mm)", fontsize="small")
    forces, costs = below.subplots(1, 2)
    has_friction = any(one.errors is not None and one.errors.force is not None for one in shown)
    _draw_forces(forces, shown, has_friction)
    _draw_costs(costs, shown, comparison, has_friction)
    return figure


def _window(shown: tuple[ComparedModel, ...]) -> tuple[float, float, float, float]:
    """Returns left, right, bottom and top of all contacts, with a margin."""
    found = []
    for one in shown:
        for grid, solution, place in _contacts(one):
            rows, columns = np.nonzero(solution.pressure > 0)
            if len(rows):
                x, y = grid.x[columns], grid.y[rows] + place
                found.append([x.min() - grid.dx / 2, x.max() + grid.dx / 2, y.min() - grid.dy / 2, y.max() + grid.dy / 2])
    if not found:
        return -1.0, 1.0, -1.0, 1.0
    left, bottom = (min(one[side] for one in found) for side in (0, 2))
    right, top = (max(one[side] for one in found) for side in (1, 3))
    edge = 0.12 * max(right - left, top - bottom, 1e-9)
    return float(left - edge), float(right + edge), float(bottom - edge), float(top + edge)


def _contacts(one: ComparedModel) -> list[tuple[Grid, Any, float]]:
    """Returns grid, solution and lateral position of each contact."""
    if isinstance(one.solution, WheelRailSolution):
        return [(patch.place.grid, patch.solution, patch.place.reference.y) for patch in one.solution.patches]
    assert one.solution is not None and one.solution.grid is not None
    return [(one.solution.grid, one.solution, 0.0)]


def _pmax(one: ComparedModel) -> float:
    return max((float(solution.pmax) for _, solution, _ in _contacts(one)), default=0.0)


def _draw_pressures(axes: Axes, one: ComparedModel, comparison: ModelComparison, largest: float) -> Any:
    image = None
    for grid, solution, y in _contacts(one):
        left, right, bottom, top = extent(grid)
        pressure = np.ma.masked_equal(solution.pressure, 0)
        image = axes.imshow(
            pressure, origin="lower", extent=(left, right, bottom + y, top + y), cmap=warm(), vmin=0, vmax=largest,
            interpolation="nearest",
        )  # fmt: skip
        _add_edges(axes, solution.element_division == 1, grid, y, color=ADHESION, linewidth=1.0)
    full = comparison.models[0]
    for grid, solution, y in _contacts(full) if full.solution is not None else ():
        _add_edges(axes, solution.pressure > 0, grid, y, color=INK, linewidth=0.7)
    axes.set_aspect("equal")
    axes.set_facecolor("#f4f4f6")
    assert one.solution is not None
    axes.set_title(one.name + ("" if one.solution.converged else ", NOT CONVERGED"), fontsize="small")
    axes.tick_params(labelsize="x-small")
    return image


def _add_edges(axes: Axes, inside: Any, grid: Grid, y: float, **style: Any) -> None:
    if not np.any(inside):
        return
    lines = edges(inside, grid, **style)
    lines.set_segments([np.add(segment, (0, y)) for segment in lines.get_segments()])
    axes.add_collection(lines)


def _forces(one: ComparedModel) -> tuple[float, float]:
    """Returns longitudinal and lateral forces without rounding errors, which would scale an axis."""
    assert one.solution is not None
    if isinstance(one.solution, WheelRailSolution):
        found = one.solution.forces.track
        Fx, Fy, normal = found.Fx, found.Fy, found.Fz
    else:
        Fx, Fy, normal = one.solution.Fx, one.solution.Fy, one.solution.Fn
    least = _ROUNDING * abs(normal)
    return (Fx if abs(Fx) > least else 0.0), (Fy if abs(Fy) > least else 0.0)


def _style(one: ComparedModel, shown: tuple[ComparedModel, ...]) -> dict[str, Any]:
    """Returns a symbol for each model, and a colour for each model of pressures."""
    models = list(dict.fromkeys(other.model for other in shown))
    marker = _MARKERS[models.index(one.model) % len(_MARKERS)]
    return {
        "marker": marker,
        "color": _NORMAL_MODELS.get(one.normal_model, COLOURS[4]),
        "ls": "",
        "mfc": "none",
        "ms": 7,
    }


def _draw_forces(axes: Axes, shown: tuple[ComparedModel, ...], has_friction: bool) -> None:
    """Draws tangential forces, or the largest pressures without friction."""
    for one in shown:
        Fx, Fy = _forces(one)
        at = (Fx / 1e3, Fy / 1e3) if has_friction else (_area(one), _pmax(one))
        axes.plot(*at, label=one.name, **_style(one, shown))
    on_wheel = any(isinstance(one.solution, WheelRailSolution) for one in shown)
    whose = "on the rail, in track coordinates" if on_wheel else "on the upper body"
    if has_friction:
        axes.set(xlabel="$F_x$ (kN)", ylabel="$F_y$ (kN)", title=f"Tangential forces {whose}")
    else:
        axes.set(xlabel="area of contact (mm$^2$)", ylabel="largest pressure (N/mm$^2$)", title="Areas and pressures")
    axes.locator_params(axis="x", nbins=6)
    bare(axes)
    axes.margins(0.15)


def _area(one: ComparedModel) -> float:
    return sum(float(solution.area.contact) for _, solution, _ in _contacts(one))


def _draw_costs(axes: Axes, shown: tuple[ComparedModel, ...], comparison: ModelComparison, has_friction: bool) -> None:
    from matplotlib.ticker import LogLocator

    for one in shown:
        if one.errors is None or one.seconds is None:
            continue
        error = 100 * abs(one.errors.pmax if one.errors.force is None else one.errors.force)
        axes.plot(1e3 * one.seconds, error, label=one.name, **_style(one, shown))
    axes.axvline(1e3 * comparison.request_seconds, color="#9a978f", lw=0.8, ls=":")
    axes.set_xscale("log")
    axes.xaxis.set_major_locator(LogLocator(subs=(1.0, 2.0, 5.0)))  # Times usually span less than a decade.
    axes.xaxis.set_major_formatter("{x:g}")
    axes.xaxis.set_minor_formatter("")
    axes.set_ylim(bottom=-0.03 * axes.get_ylim()[1])
    axes.set(
        xlabel="time of a request (ms); dotted: a request without computation",
        ylabel="error of the force, % of $\\mu F_n$" if has_friction else "error of the largest pressure, %",
        title="Errors against the full theory, and costs",
    )
    bare(axes)
    axes.legend(
        loc="upper left", bbox_to_anchor=(1.01, 1.02), fontsize="x-small", frameon=False, ncols=-(-len(shown) // 18)
    )
