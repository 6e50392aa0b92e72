"""Draws a wheelset across the track: profiles with contacts, forces and pressures, and one patch."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import matplotlib

matplotlib.use("Agg")

import matplotlib.pyplot as plt
import numpy as np
from manchester import KNOWN, POSITIONS
from profiles import placed_rail, placed_wheel

from contactd.pictures.canvas import INK, warm
from contactd.wheel_rail import WheelRailPatch, WheelRailSolution

Sweep = dict[str, list[WheelRailSolution]]
COLOURS = {"left": "#1449b8", "right": "#c8553d"}
SHIFTS = [y for y, _, _ in POSITIONS]
SHOWN_PATCH = 5  # a patch of the right wheel: two regions of overlap with a weighted interaction


def draw_wheelset(path: Path, sweep: Sweep) -> None:
    """Writes the picture as PNG; creates missing folders."""
    style = {"font.size": 10, "axes.edgecolor": INK, "text.color": INK, "axes.labelcolor": INK, "figure.dpi": 140}
    with plt.rc_context(style):
        figure = plt.figure(figsize=(13.6, 8.4), layout="constrained")
        top, bottom = figure.subfigures(2, 1, height_ratios=(0.78, 1))
        for axes, side in zip(top.subplots(1, 2), ("left", "right"), strict=True):
            image = _draw_profiles(axes, side, sweep[side])
        top.colorbar(image, ax=top.axes, label="shift of the wheelset (mm)", shrink=0.8)
        forces, pressures, patch = bottom.subplots(1, 3, width_ratios=(1, 1, 0.9))
        _draw_forces(forces, sweep)
        _draw_pressures(pressures, sweep)
        _draw_patch(bottom, patch, sweep["right"][SHOWN_PATCH].patches[0])
        figure.suptitle(
            "A wheelset across the track: S1002 on 60E1 at 1/40, 10 kN a wheel, yaw 2.4 mrad/mm\n"
            "the Manchester contact benchmark, case A-2.2; circles: an established program",
            fontsize=12,
        )
        path.parent.mkdir(parents=True, exist_ok=True)
        figure.savefig(path)
        plt.close(figure)


def _draw_profiles(axes: Any, side: str, solutions: list[WheelRailSolution]) -> Any:
    colours = plt.get_cmap("viridis_r")
    rail = placed_rail(side)
    rail = rail[np.argsort(rail[:, 0])]
    axes.fill(rail[:, 0], rail[:, 1], color="#e4e1da", lw=0)
    axes.plot(rail[:, 0], rail[:, 1], color=INK, lw=1.1)
    for index in (0, len(POSITIONS) - 1):
        y, roll, _ = POSITIONS[index]
        wheel = placed_wheel(side, y, solutions[index].z, roll)
        axes.plot(wheel[:, 0], wheel[:, 1], color=colours(y / SHIFTS[-1]), lw=1.0)
    for (y, _, _), solution in zip(POSITIONS, solutions, strict=True):
        for patch in solution.patches:
            for y_from, y_to in _across(patch):
                along = np.linspace(y_from, y_to, 20)
                height = np.interp(along, rail[:, 0], rail[:, 1])
                axes.plot(along, height, color=colours(y / SHIFTS[-1]), lw=3.2, solid_capstyle="butt")
    axes.set(xlabel="y (mm)", ylabel="z (mm)", title=f"{side} wheel: the contacts, and the wheel at both ends of the way")
    centre = rail[:, 0].mean()
    axes.set(xlim=(centre - 46, centre + 46), ylim=(31, -8), aspect="equal")
    return matplotlib.cm.ScalarMappable(plt.Normalize(0, SHIFTS[-1]), colours)


def _across(patch: WheelRailPatch) -> list[tuple[float, float]]:
    """Returns the ends of each part of the contact in y of the track."""
    grid, at = patch.place.grid, patch.place.reference
    touches = (patch.solution.element_division != 0).any(axis=1)
    changes = np.flatnonzero(np.diff(np.concatenate([[False], touches, [False]])))
    ends = at.y + np.cos(at.angle) * (grid.y[0] + (changes - 0.5) * grid.dy)
    return list(zip(ends[::2], ends[1::2], strict=True))


def _draw_forces(axes: Any, sweep: Sweep) -> None:
    for side, solutions in sweep.items():
        for name, line in (("Fy", "-"), ("Fx", "--")):
            values = [getattr(solution.forces.track, name) / 1000 for solution in solutions]
            axes.plot(SHIFTS, values, line, color=COLOURS[side], lw=1.4, label=f"$F_{name[1]}$, {side}")
            known = [getattr(each, name) / 1000 for each in KNOWN[side]]
            axes.plot(SHIFTS, known, "o", mfc="none", color=COLOURS[side], ms=5, clip_on=False)
    _finish(axes, "kN", "Forces on the rails, in track coordinates")


def _draw_pressures(axes: Any, sweep: Sweep) -> None:
    for side, solutions in sweep.items():
        values = [max(patch.solution.pmax for patch in solution.patches) / 1000 for solution in solutions]
        axes.plot(SHIFTS, values, color=COLOURS[side], lw=1.4, label=f"$p_{{max}}$ (kN/mm$^2$), {side}")
        axes.plot(SHIFTS, [each.pmax / 1000 for each in KNOWN[side]], "o", mfc="none", color=COLOURS[side], ms=5, clip_on=False)
        angles = [abs(solution.patches[0].place.reference.angle) for solution in solutions]
        axes.plot(SHIFTS, angles, "--", color=COLOURS[side], lw=1.4, label=f"angle (rad), {side}")
        axes.plot(SHIFTS, [abs(each.angle) for each in KNOWN[side]], "o", mfc="none", color=COLOURS[side], ms=5, clip_on=False)
    _finish(axes, "kN/mm$^2$, rad", "Largest pressure, and size of the contact angle")


def _finish(axes: Any, unit: str, title: str) -> None:
    axes.set(xlabel="shift of the wheelset (mm)", ylabel=unit, title=title, xlim=(0, SHIFTS[-1]))
    axes.grid(color="#e4e1da", lw=0.6)
    axes.legend(fontsize=8.5, frameon=False)
    for side in ("top", "right"):
        axes.spines[side].set_visible(False)


def _draw_patch(figure: Any, axes: Any, patch: WheelRailPatch) -> None:
    solution, grid = patch.solution, patch.place.grid
    extent = (grid.x[0] - grid.dx / 2, grid.x[-1] + grid.dx / 2, grid.y[0] - grid.dy / 2, grid.y[-1] + grid.dy / 2)
    pressure = np.ma.masked_equal(solution.pressure, 0)
    image = axes.imshow(pressure, origin="lower", extent=extent, cmap=warm(), vmin=0, interpolation="nearest")
    figure.colorbar(image, ax=axes, label="pressure (N/mm$^2$)", shrink=0.9)
    axes.set(xlabel="x (mm)", ylabel="y in the contact plane (mm)", aspect="equal")
    axes.set_title(f"Right wheel at y = {SHIFTS[SHOWN_PATCH]:g} mm: tread and throat")
