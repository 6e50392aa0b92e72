"""Plots a wheel on a rail: its contacts with their forces and pressures."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from ..values.generated.wheel_rail.state import WheelsetPosition
from ..values.wheel_rail.origins import origin_of
from ..values.wheel_rail.solution import WheelRailPatch, WheelRailSolution
from .canvas import COLOURS, INK, bare, legend_below, map_over, new_figure
from .contact import draw_contact
from .profiles import draw_body, placed_rail, placed_wheel

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

__all__ = ["draw_wheel_rail"]

_ROUNDING = 1e-12  #: Fraction of the largest force, as in tables of the command line.


def draw_wheel_rail(solution: WheelRailSolution) -> Figure:
    """Implements WheelRailSolution.plot."""
    shown = [patch for patch in solution.patches if hasattr(patch.solution, "pressure")]
    figure = new_figure(6.0 + 5.6 * len(shown), 5.4)
    panels = figure.subplots(1, 1 + len(shown), squeeze=False)[0]
    _draw_cross_section(panels[0], solution)
    for number, (panel, patch) in enumerate(zip(panels[1:], shown), 1):
        _draw_patch(panel, patch, number)
    track = solution.forces.track
    largest = max(abs(track.Fx), abs(track.Fy), abs(track.Fz))
    Fx, Fy, Fz = (force / 1000 if abs(force) > _ROUNDING * largest else 0.0 for force in (track.Fx, track.Fy, track.Fz))
    state = "" if solution.converged else ", NOT CONVERGED"
    figure.suptitle(
        f"A wheel on a rail: Fx {Fx:.3g} kN, Fy {Fy:.3g} kN, Fz {Fz:.4g} kN on the "
        f"rail, at z = {solution.z:.4g} mm{state}"
    )
    return figure


def _draw_cross_section(axes: Axes, solution: WheelRailSolution) -> None:
    """Draws the contacts in the cross-section with their widths and the forces on the rail, and wheel and rail behind
    them if their profiles are available.
    """
    _draw_profiles(axes, solution)
    largest = max((_across(patch) for patch in solution.patches), default=1.0)
    for number, (patch, color) in enumerate(zip(solution.patches, [*COLOURS] * (len(solution.patches) + 1)), 1):
        at, force, width = patch.place.reference, patch.forces.track, patch.place.grid.ny * patch.place.grid.dy
        along = np.array([-width, width]) / 2
        axes.plot(at.y + np.cos(at.angle) * along, at.z + np.sin(at.angle) * along, color=color, lw=4, solid_capstyle="butt")
        scale = 15.0 / largest
        axes.annotate(
            "", xy=(at.y, at.z), xytext=(at.y - scale * force.Fy, at.z - scale * force.Fz),
            arrowprops={"arrowstyle": "-|>", "color": color, "lw": 1.6},
        )  # fmt: skip
        text = f"{number}: {_across(patch) / 1000:.3g} kN, {at.angle:.3f} rad, pmax {patch.solution.pmax:.0f} N/mm$^2$"
        axes.plot([], [], color=color, lw=4, label=text)
    if solution.patches:
        ys, zs = zip(*((patch.place.reference.y, patch.place.reference.z) for patch in solution.patches))
        middle, half = (min(ys) + max(ys)) / 2, max(20.0, (max(ys) - min(ys)) / 2 + 12)
        axes.set(xlim=(middle - half, middle + half), ylim=(max(zs) + 10, min(zs) - 20))
        legend_below(axes)
    else:
        axes.text(0.5, 0.5, "no contact", transform=axes.transAxes, ha="center", color=INK)
        axes.set(xticks=[], yticks=[])
    axes.set(xlabel="y of the track (mm)", ylabel="z of the track (mm), down", aspect="equal", title="Contacts, and forces on the rail")
    bare(axes)


def _draw_profiles(axes: Axes, solution: WheelRailSolution) -> None:
    origin = origin_of(solution)
    profiles = None if origin is None else origin.profiles()
    if origin is None or profiles is None:
        return
    position = WheelsetPosition(y=origin.position.y, z=solution.z, roll=origin.position.roll)
    side = origin.side or "right"
    draw_body(axes, placed_wheel(profiles, position, side, origin.nominal_radius), upwards=True)
    draw_body(axes, placed_rail(profiles, origin.rail, side), upwards=False)


def _across(patch: WheelRailPatch) -> float:
    return float(np.hypot(patch.forces.track.Fy, patch.forces.track.Fz))


def _draw_patch(axes: Axes, patch: WheelRailPatch, number: int) -> None:
    solution: Any = patch.solution
    if hasattr(solution, "element_division"):
        draw_contact(solution, axes)
    else:
        map_over(axes, patch.place.grid, np.ma.masked_equal(solution.pressure, 0), "pressure (N/mm$^2$)")
    axes.set(title=f"Contact {number}, on the rail", ylabel="y in the plane of contact (mm)")
