"""Draws pictures with the axes of the paper's figures, from the rows of the CSV files alone."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

from matplotlib.lines import Line2D

from ..drawing import (
    BLUE,
    GREEN,
    GREY,
    INK,
    ORANGE,
    RED,
    Look,
    block_sizes,
    draw_target,
    finish,
    new_figure,
    plain_log,
    save,
)
from ..rows import Row, select

FIG5 = {"linear": Look("linear elements", RED, "s"), "quadratic": Look("quadratic elements", BLUE, "o")}
FIG6 = {"test2": Look("TEST 2", RED, "s"), "test3": Look("TEST 3", BLUE, "o")}
FIG7 = {
    "20x20": Look("20 × 20", RED, "o"), "40x40": Look("40 × 40", BLUE, "s"), "80x80": Look("80 × 80", INK, "*"),
}  # fmt: skip
ORDERS = {
    "test1, linear": Look("linear, TEST 1", GREEN, "^"), "test2, linear": Look("linear, TEST 2", RED, "s"),
    "test3, linear": Look("linear, TEST 3", ORANGE, "D"), "test2, quadratic": Look("quadratic, TEST 2", BLUE, "o"),
}  # fmt: skip
FIG8 = {
    "test1": Look("TEST 1", GREEN, "^"), "test2": Look("TEST 2", RED, "s"), "test3": Look("TEST 3", BLUE, "o"),
    "test2, across": Look("TEST 2, other diagonals", ORANGE, "D", "--"),
}  # fmt: skip


def _errors(axes: Any, rows: Sequence[Row], looks: Mapping[str, Look], title: str) -> None:
    for curve, look in looks.items():
        points = select(rows, curve=curve)
        L = [row["L"] for row in points]
        style = {"color": look.colour, "marker": look.marker, "markersize": 6.5 if look.marker != "*" else 10}
        axes.plot(L, [abs(row["origin_zz"]) for row in points], linestyle=look.line, **style)
        largest = [row["largest_zz"] for row in points]
        axes.plot(L, largest, linestyle=":", markerfacecolor="white", linewidth=1.1, **style)
    block_sizes(axes, rows)
    axes.set_yscale("log")
    draw_target(axes)
    finish(axes, title, "relative error of $A^{zz}$")


def _legend(figure: Any, looks: Mapping[str, Look]) -> None:
    """Places the legend below the panels, where it covers nothing."""
    curves = [
        Line2D([], [], color=look.colour, marker=look.marker, linestyle=look.line, label=look.label)
        for look in looks.values()
    ]
    kinds = [
        Line2D([], [], color=GREY, marker="o", label="at the origin"),
        Line2D([], [], color=GREY, marker="o", markerfacecolor="white", linestyle=":", label="largest over the table"),
    ]
    handles = curves + kinds
    figure.legend(handles=handles, loc="outside lower center", ncols=len(handles), fontsize=9, frameon=False)


def _against_L(
    axes: Any, rows: Sequence[Row], looks: Mapping[str, Look], column: str, title: str, label: str, log: bool = False
) -> None:
    for curve, look in looks.items():
        points = select(rows, curve=curve)
        style = {"color": look.colour, "marker": look.marker, "markersize": 6.5 if look.marker != "*" else 10}
        axes.plot([row["L"] for row in points], [row[column] for row in points], linestyle=look.line, **style)
    block_sizes(axes, rows)
    if log:
        axes.set_yscale("log")
        plain_log(axes.yaxis)
    else:
        axes.set_ylim(bottom=0)
    finish(axes, title, label)


def fig5(rows: Sequence[Row], path: Path) -> None:
    figure, (axes,) = new_figure(1, 7.0, 5.0)
    _errors(axes, rows, FIG5, "Figure 5: TEST 1 on hexahedron Mesh1")
    _legend(figure, FIG5)
    save(figure, path)


def _three_panels(rows: Sequence[Row], path: Path, looks: Mapping[str, Look], what: str, log: bool = False) -> None:
    figure, (left, middle, right) = new_figure(3, height=4.7)
    _errors(left, rows, looks, "(a) relative error")
    _against_L(middle, rows, looks, "elements", "(b) number of elements", "elements", log)
    _against_L(right, rows, looks, "cpu_seconds", "(c) CPU time of all load cases", "seconds", log)
    _legend(figure, looks)
    figure.suptitle(what, fontsize=12)
    save(figure, path)


def fig6(rows: Sequence[Row], path: Path) -> None:
    what = "Figure 6: TEST 2 and TEST 3 on hexahedron Mesh1, 10 × 10 contact grid"
    _three_panels(rows, path, FIG6, what)


def fig7(rows: Sequence[Row], path: Path) -> None:
    what = "Figure 7: TEST 3 on hexahedron Mesh1, finer contact grids on the same area"
    _three_panels(rows, path, FIG7, what)


def fig8(rows: Sequence[Row], path: Path) -> None:
    what = "Figure 8: prismatic Mesh2, 10 × 10 contact grid"
    _three_panels(rows, path, FIG8, what, log=True)


def orders(rows: Sequence[Row], path: Path) -> None:
    figure, (axes,) = new_figure(1, 10.5, 5.0)
    _errors(axes, rows, ORDERS, "Linear and quadratic elements on prismatic Mesh2")
    _legend(figure, ORDERS)
    save(figure, path)


def mesh2_grids(rows: Sequence[Row], path: Path) -> None:
    what = "TEST 2 on prismatic Mesh2, finer contact grids on the same area"
    _three_panels(rows, path, FIG7, what, log=True)
