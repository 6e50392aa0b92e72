"""Draws a picture for each family: the difference of every compared number over its tolerance."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from pathlib import Path
from typing import Any

from matplotlib.lines import Line2D

from paper.drawing import BLUE, INK, ORANGE, RED, finish, new_figure, save
from paper.rows import Row

from .quantities import GROUPS, QUANTITIES

__all__ = ["draw", "has_numbers"]

LEAST, MOST = 1e-3, 1e4  #: larger values are drawn here
TICKS = {LEAST: "less", 1e-2: "0.01", 1e-1: "0.1", 1.0: "1", 1e1: "10", 1e2: "100", 1e3: "1000", MOST: "more"}
WIDTH = 0.36  #: of the points of a group, to either side
SMALL = {
    "agrees": (BLUE, "o", "case agrees"),
    "known": (ORANGE, "^", "differs, with a reason"),
    "unknown": (RED, "D", "differs"),
}


def has_numbers(rows: Sequence[Row]) -> bool:
    """Returns whether any of the cases was computed."""
    return any(row["over"] != "" for row in rows)


def draw(rows: Sequence[Row], path: Path) -> None:
    """Draws the rows of a family."""
    figure, (axes,) = new_figure(1, width=9.0, height=4.0)
    seen = set()
    for place, group in enumerate(GROUPS):
        points = list(_points(rows, group))
        for number, (over, look) in enumerate(points):
            colour, marker, _ = SMALL[look]
            seen.add(look)
            # Points are placed side by side in the order of the file.
            x = place + WIDTH * (2 * (number + 0.5) / len(points) - 1)
            axes.plot(
                x, min(MOST, max(LEAST, over)), marker, color=colour, markersize=3.2, markeredgewidth=0, alpha=0.75
            )
    axes.axhline(1, color=INK, linestyle=(0, (6, 4)), linewidth=1.1)
    axes.annotate(
        "tolerance", (1, 1), fontsize=9, xycoords=("axes fraction", "data"), xytext=(3, -3), textcoords="offset points"
    )
    axes.set_yscale("log")
    axes.set_xlim(-0.5, len(GROUPS) - 0.5)
    axes.set_ylim(LEAST / 1.5, max(10.0, 1.5 * axes.dataLim.y1))
    axes.set_xticks(range(len(GROUPS)), GROUPS)
    axes.set_yticks(
        [tick for tick in TICKS if tick <= axes.get_ylim()[1]],
        [word for tick, word in TICKS.items() if tick <= axes.get_ylim()[1]],
    )
    finish(axes, "", "difference / tolerance")
    axes.grid(False, axis="x")
    _legend(figure, [look for look in SMALL if look in seen])
    save(figure, path)


def _points(rows: Sequence[Row], group: str) -> Iterator[tuple[float, str]]:
    names = [quantity.name for quantity in QUANTITIES if quantity.group == group]
    for row in rows:
        look = "agrees" if row["status"] == "agrees" else "known" if row["reason"] else "unknown"
        for name in names:
            if row[f"{name}_over"] != "":
                yield row[f"{name}_over"], look


def _legend(figure: Any, looks: Sequence[str]) -> None:
    """Places the legend above the axes, where it hides no point."""
    handles = []
    for look in looks:
        colour, marker, label = SMALL[look]
        handles.append(Line2D([], [], color=colour, marker=marker, linestyle="", markersize=6, label=label))
    figure.legend(handles=handles, loc="outside upper center", ncols=len(handles), frameon=False, fontsize=9)
