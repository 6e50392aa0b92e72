"""Draws pictures that the paper does not have: accuracy against time, and adaptive refinement."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import Any

import matplotlib.pyplot as plt

from ..drawing import (
    BLUE,
    GREEN,
    GREY,
    INK,
    ORANGE,
    PURPLE,
    RED,
    SKY,
    Look,
    draw_target,
    finish,
    new_figure,
    plain_log,
    save,
)
from ..rows import Row, select

LIGHT = "#b4b4bd"
ACCURACY = {
    "test1, linear, clamped": Look("Mesh1, linear, TEST 1, $u=0$", LIGHT, "^", ":"),
    "test2, linear, clamped": Look("Mesh1, linear, TEST 2, $u=0$", LIGHT, "s", ":"),
    "test3, linear, clamped": Look("Mesh1, linear, TEST 3, $u=0$", LIGHT, "o", ":"),
    "test1, quadratic, clamped": Look("Mesh1, TEST 1, $u=0$", GREY, "^", "-"),
    "test2, quadratic, clamped": Look("Mesh1, TEST 2, $u=0$", GREY, "s", "-"),
    "test3, quadratic, clamped": Look("Mesh1, TEST 3, $u=0$ (the paper's choice)", BLUE, "o", "-"),
    "test3, quadratic, clamped, auto": Look("the same with the solver auto", BLUE, "o", "--"),
    "mesh2 test2, clamped": Look("Mesh2, TEST 2, $u=0$ (the paper's choice)", ORANGE, "D", "-"),
    "mesh1, half_space": Look("Mesh1, half-space boundary, $f$ = 2 to 1.1", SKY, "v", "-"),
    "order 3, half_space": Look("order 3, half-space boundary", GREEN, "P", "-"),
    "order 4, half_space": Look("order 4, half-space boundary", RED, "X", "-"),
    "adaptive, half_space": Look("adaptive, half-space boundary", PURPLE, "h", "--"),
    "accuracy": Look("accuracy: 1e-2, 1e-3, 1e-4", INK, "*", "-"),
}
ADAPTIVE = {
    "hex": Look("Mesh1, $f$ = 3 to 1.2, then (b, c) $h/h_s$ = 6 and 8", BLUE, "o"),
    "prism": Look("Mesh2, $f$ = 3 to 1.2", ORANGE, "D"),
    "adaptive": Look("adaptive", PURPLE, "h"),
}


def table_error(row: Row) -> float:
    """Returns the largest error of zz and xx over the table."""
    return float(max(row["largest_zz"], row["largest_xx"]))


def _curve(axes: Any, x: Sequence[float], y: Sequence[float], look: Look) -> None:
    size = 11 if look.marker == "*" else 6.5
    order = {"zorder": 5} if look.marker == "*" else {}
    style = {"color": look.colour, "marker": look.marker, "linestyle": look.line, "label": look.label}
    axes.plot(x, y, markersize=size, linewidth=1.4, **style, **order)


def accuracy(rows: Sequence[Row], path: Path) -> None:
    figure, axes = plt.subplots(1, 2, figsize=(13.2, 6.6), layout="constrained", sharey=True)
    for panel, table in zip(axes, (10, 40)):
        for curve, look in ACCURACY.items():
            points = select(rows, curve=curve, table=table)
            _curve(panel, [row["cpu_seconds"] for row in points], [table_error(row) for row in points], look)
        panel.set(xscale="log", yscale="log", xlabel="CPU time of all load cases (s)")
        plain_log(panel.xaxis)
        draw_target(panel)
        finish(panel, f"{table} × {table} offsets", "largest relative error of $A^{zz}$ and $A^{xx}$")
    axes[1].set_ylabel("")
    handles, labels = axes[0].get_legend_handles_labels()
    figure.legend(handles, labels, loc="outside lower center", ncols=4, fontsize=9, frameon=False)
    title = "Accuracy over the whole table against time; quadratic elements where no order is named"
    figure.suptitle(title, fontsize=12)
    save(figure, path)


def _adaptive_panel(axes: Any, rows: Sequence[Row], boundary: str, x: str, error: str) -> None:
    for mesh, look in ADAPTIVE.items():
        points = select(rows, curve=f"{mesh}, {boundary}")
        values = [abs(row["origin_zz"]) if error == "origin" else table_error(row) for row in points]
        _curve(axes, [row[x] for row in points], values, look)
    axes.set(xscale="log", yscale="log")
    plain_log(axes.xaxis, "k" if x == "dofs" else "")
    axes.set_xlabel("unknowns" if x == "dofs" else "CPU time of all load cases (s)")
    draw_target(axes)


def adaptive(rows: Sequence[Row], path: Path) -> None:
    figure, (left, middle, right) = new_figure(3, 5.2, 5.0)
    _adaptive_panel(left, rows, "clamped", "dofs", "origin")
    finish(left, "(a) the paper's block: $u=0$ at $L$ = 1024 mm", "relative error of $A^{zz}$ at the origin")
    _adaptive_panel(middle, rows, "half_space", "dofs", "table")
    finish(middle, "(b) half-space boundary, 10 × 10 offsets", "largest relative error of $A^{zz}$ and $A^{xx}$")
    _adaptive_panel(right, rows, "half_space", "cpu_seconds", "table")
    finish(right, "(c) as (b), against time", "largest relative error of $A^{zz}$ and $A^{xx}$")
    handles, labels = left.get_legend_handles_labels()
    figure.legend(handles, labels, loc="outside lower center", ncols=3, frameon=False)
    figure.suptitle("Adaptive refinement beside the paper's meshes, quadratic elements", fontsize=12)
    save(figure, path)
