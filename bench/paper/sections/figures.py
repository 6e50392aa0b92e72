"""The pictures, drawn from the rows of the CSV files alone."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

from ..drawing import BLUE, INK, ORANGE, RED, Look, finish, new_figure, save
from ..rows import Row, select
from .findings import creep_forces, more

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
