"""Draws the pictures from the rows of the CSV files alone."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

import numpy as np

from ..drawing import BLUE, GREEN, INK, ORANGE, RED, Look, finish, new_figure, save
from ..rows import Row, select
from .findings import creep_forces, more
from .findings_checks import solid_seconds
from .persson import pressure

LOOKS = {
    "off": Look("one plane", INK, "o"),
    "half_space": Look("curved, half-spaces", ORANGE, "s"),
    "rotated": Look("curved, rotated half-spaces", BLUE, "^"),
}
QUANTITIES = {"pmax": ("largest pressure", RED, "o"), "approach": ("approach", BLUE, "s")}


def edges(rows: Sequence[Row], path: Path) -> None:
    figure, (axes,) = new_figure(1, 6)
    for quantity, (label, colour, marker) in QUANTITIES.items():
        pairs = more(rows, quantity, "block", "half-space")
        axes.plot([x for x, _ in pairs], [100 * y for _, y in pairs], color=colour, marker=marker, label=label)
    axes.axhline(0, color=INK, linewidth=0.8)
    axes.set_xlabel("centre of the ball from the edge (mm)")
    axes.legend(frameon=False)
    finish(axes, "Rigid ball of 50 mm under 5 kN near an edge of steel", "block over cut half-space (%)")
    save(figure, path)


def throat(rows: Sequence[Row], path: Path) -> None:
    figure, panels = new_figure(2, 5.6)
    for axes, title in zip(panels, ("largest pressure", "longitudinal force $F_x$ / ($\\mu F_z$)"), strict=True):
        for way, look in LOOKS.items():
            pairs = more(rows, "pmax", way, "fem") if axes is panels[0] else creep_forces(rows, way)
            axes.plot([x for x, _ in pairs], [100 * y for _, y in pairs], color=look.colour, marker=look.marker, label=look.label)
        axes.axhline(0, color=INK, linewidth=0.8)
        axes.set_yscale("symlog", linthresh=2)
        axes.yaxis.set_major_formatter("{x:g}")
        axes.set_xlabel("lateral shift of the wheelset (mm)")
        finish(axes, title, "difference to finite elements (%)")
    panels[0].legend(frameon=False)
    save(figure, path)


def tables(rows: Sequence[Row], path: Path) -> None:
    figure, (axes,) = new_figure(1, 8)
    names = list(dict.fromkeys(str(row["curve"]) for row in rows))
    for accuracy, colour in ((1e-2, RED), (1e-3, BLUE)):
        points = select(rows, value=accuracy)
        places = [names.index(str(row["curve"])) for row in points]
        axes.plot(places, [row["stated"] for row in points], "_", markersize=18, color=colour, label=f"{accuracy:g}: stated")
        axes.plot(places, [row["found"] for row in points], "o", color=colour, label=f"{accuracy:g}: found")
        axes.axhline(accuracy, color=colour, linewidth=0.8, linestyle=":")
    axes.set_yscale("log")
    axes.set_ylim(top=0.06)
    axes.set_xticks(range(len(names)), names, rotation=20, ha="right")
    axes.legend(frameon=False, ncols=2)
    finish(axes, "Errors of tables, over zz of the half-space on itself", "error")
    save(figure, path)


def persson(rows: Sequence[Row], path: Path) -> None:
    figure, (axes,) = new_figure(1, 6.4, 4.2)
    colours = dict(zip((30, 45, 60, 80), (BLUE, GREEN, ORANGE, RED), strict=True))
    for row in rows:
        if (degrees := int(row["value"])) not in colours:
            continue
        angles, pressures = (np.array([float(word) for word in str(row[name]).split()]) for name in ("angles", "pressures"))
        fine = np.linspace(-degrees, degrees, 801)
        axes.plot(fine, pressure(np.radians(degrees), np.radians(fine)), color=colours[degrees], linewidth=1.4)
        axes.plot(angles, pressures, "o", color=colours[degrees], markersize=2.6, label=f"{degrees}°")
    axes.plot([], [], color=INK, linewidth=1.4, label="Persson")
    axes.legend(title="half angle", frameon=False, fontsize=9)
    axes.set_xlabel("angle from the bottom (degrees)")
    axes.set_ylim(0, None)
    finish(axes, "a cylinder in a hole, strips of one degree", "pressure $p R/Q$")
    save(figure, path)


def solid(rows: Sequence[Row], path: Path) -> None:
    figure, (errors, costs) = new_figure(2, 5)
    orders = [row["value"] for row in rows]
    errors.semilogy(orders, [row["found"] for row in rows], "o-", color=BLUE, label="three dimensions")
    errors.axhline(rows[0]["stated"], color=RED, linestyle=":", label="the transform's stated error")
    paper = [row for row in rows if row["iterations"] > 0]  # those of the paper's solver
    costs.semilogy([row["value"] for row in paper], [solid_seconds(row) for row in paper], "o-", color=BLUE, label="three dimensions, estimated")
    costs.semilogy(orders, [row["transform_seconds"] for row in rows], "s-", color=RED, label="transform to 1e-3")
    for axes in (errors, costs):
        axes.set_xticks(orders)
        axes.set_xlabel("order of the elements in three dimensions")
        axes.legend(frameon=False)
    finish(errors, "a strip beside an edge", "difference to the transform, over zz")
    finish(costs, "80 strips, three directions", "processor time (s)")
    save(figure, path)
