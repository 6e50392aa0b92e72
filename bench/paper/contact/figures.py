"""Draws the pictures of section 4 with the paper's axes, from the rows of the CSV files alone."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from pathlib import Path
from typing import Any

from matplotlib.lines import Line2D

from ..drawing import (
    BLUE,
    GREEN,
    GREY,
    INK,
    ORANGE,
    PURPLE,
    RED,
    Look,
    block_sizes,
    doubling,
    finish,
    new_figure,
    save,
)
from ..rows import Row, select

NAMES = {"Fz": "normal force $F_z$", "pmax": "maximal pressure", "area": "contact area", "Fx": "tangential force $F_x$"}
NORMAL = ("Fz", "pmax", "area")
FIG9 = {"Fz": Look("$F_z$", BLUE, "o"), "pmax": Look("$p_{max}$", RED, "s"), "area": Look("area", GREEN, "^")}
GRIDS = {
    f"{n}x{n}": Look(f"{n} × {n}", colour, marker)
    for n, colour, marker in ((10, RED, "s"), (40, BLUE, "o"), (160, INK, "^"))
}
ALL_GRIDS = {**GRIDS, **{f"{curve}, fem": Look("", look.colour, look.marker, ":") for curve, look in GRIDS.items()}}
COMPARED = {
    "analytic": Look("analytic, PC", INK, "*"),
    "analytic, Bi": Look("analytic, Bi", GREY, "P", "--"),
    "mesh1, PC": Look("Mesh1, PC", BLUE, "o"),
    "mesh1, Bi": Look("Mesh1, Bi", GREEN, "v", "--"),
    "mesh2, PC": Look("Mesh2, PC", RED, "s"),
    "mesh2, Bi": Look("Mesh2, Bi", ORANGE, "D", "--"),
    "mesh1, PC, fem": Look("Mesh1, PC, function", BLUE, "o", ":"),
    "mesh2, PC, fem": Look("Mesh2, PC, function", PURPLE, "s", ":"),
}


def _curve(axes: Any, points: Sequence[Row], x: str, column: str, look: Look) -> None:
    """Draws filled markers for values that are too large and open ones for values that are too small."""
    values, errors = [row[x] for row in points], [row[column] for row in points]
    axes.plot(values, [abs(error) for error in errors], color=look.colour, linestyle=look.line, linewidth=1.4)
    size = 10 if look.marker == "*" else 6.5
    for positive, face in ((True, look.colour), (False, "white")):
        chosen = [(value, abs(error)) for value, error in zip(values, errors) if (error > 0) is positive]
        style = {"color": look.colour, "marker": look.marker, "markersize": size, "markerfacecolor": face}
        axes.plot([x for x, _ in chosen], [y for _, y in chosen], linestyle="", **style)


def _panel(axes: Any, rows: Sequence[Row], looks: Mapping[str, Look], quantity: str, title: str) -> None:
    x = rows[0]["parameter"]
    for curve, look in looks.items():
        _curve(axes, select(rows, curve=curve), x, f"error_{quantity}", look)
    axes.set_yscale("log")
    _abscissa(axes, rows)
    finish(axes, title, "relative error")


def _abscissa(axes: Any, rows: Sequence[Row]) -> None:
    if rows[0]["parameter"] == "L":
        block_sizes(axes, rows)
    else:
        doubling(axes.xaxis, {row["n"] for row in rows})
        axes.set_xlabel("elements along an edge of the contact grid")


def _legend(figure: Any, looks: Mapping[str, Look], kinds: Sequence[tuple[str, str]] = ()) -> None:
    """Places the legend below the panels, where it covers nothing; `kinds` are line styles with their meaning."""
    handles = [
        Line2D([], [], color=look.colour, marker=look.marker, linestyle=look.line, label=look.label)
        for look in looks.values()
    ]
    handles += [Line2D([], [], color=GREY, linestyle=line, label=label) for line, label in kinds]
    style: dict[str, Any] = {"color": GREY, "marker": "o", "linestyle": ""}
    handles += [
        Line2D([], [], **style, label="too large"), Line2D([], [], **style, markerfacecolor="white", label="too small"),
    ]  # fmt: skip
    columns = len(handles) if len(handles) < 8 else (len(handles) + 1) // 2
    figure.legend(handles=handles, loc="outside lower center", ncols=columns, fontsize=9, frameon=False)


def fig9(rows: Sequence[Row], path: Path) -> None:
    figure, (axes,) = new_figure(1, 7.0, 5.0)
    for quantity, look in FIG9.items():
        _curve(axes, rows, "n", f"error_{quantity}", look)
    axes.set_yscale("log")
    _abscissa(axes, rows)
    finish(axes, "Figure 9: normal problem, analytic ICs", "relative error")
    _legend(figure, FIG9)
    save(figure, path)


READ = [("-", "read linearly between nodes (the paper)"), (":", "read from the finite-element function")]


def _against_L(what: str) -> Callable[[Sequence[Row], Path], None]:
    def draw(rows: Sequence[Row], path: Path) -> None:
        figure, panels = new_figure(3, height=4.9)
        for letter, axes, quantity in zip("abc", panels, NORMAL):
            _panel(axes, rows, ALL_GRIDS, quantity, f"({letter}) {NAMES[quantity]}")
        _legend(figure, GRIDS, READ)
        figure.suptitle(what, fontsize=12)
        save(figure, path)

    return draw


fig10 = _against_L("Figure 10: normal problem, constant load on hexahedron Mesh1")
fig11 = _against_L("Figure 11: normal problem, constant load on prismatic Mesh2")


def bilinear(rows: Sequence[Row], path: Path) -> None:
    """Draws figures that the paper omits: one row of panels like figure 10 and one like figure 11."""
    figure, panels = new_figure(3, height=4.5, rows=2)
    meshes = {"mesh1": "hexahedron Mesh1", "mesh2": "prismatic Mesh2"}
    for number, (mesh, words) in enumerate(meshes.items()):
        looks = {f"{mesh} {curve}": look for curve, look in GRIDS.items()}
        for axes, quantity in zip(panels[3 * number :], NORMAL):
            _panel(axes, rows, looks, quantity, f"{NAMES[quantity]}, {words}")
    _legend(figure, GRIDS)
    figure.suptitle("Normal problem, bilinear load", fontsize=12)
    save(figure, path)


def fig12(rows: Sequence[Row], path: Path) -> None:
    figure, panels = new_figure(3, height=5.2)
    for letter, axes, quantity in zip("abc", panels, NORMAL):
        _panel(axes, rows, COMPARED, quantity, f"({letter}) {NAMES[quantity]}")
    _legend(figure, COMPARED)
    figure.suptitle("Figure 12: normal problem, Mesh1 with $L$ = 1024 and Mesh2 with $L$ = 128", fontsize=12)
    save(figure, path)


def fig13(rows: Sequence[Row], path: Path) -> None:
    figure, panels = new_figure(2, width=6.4, height=5.0)
    titles = {"mesh1": "(a) hexahedron Mesh1", "mesh2": "(b) prismatic Mesh2"}
    for axes, (mesh, title) in zip(panels, titles.items()):
        looks = {f"{mesh} {curve}": look for curve, look in ALL_GRIDS.items()}
        _panel(axes, rows, looks, "Fx", title)
    _legend(figure, GRIDS, READ)
    figure.suptitle("Figure 13: tangential force $F_x$, constant load", fontsize=12)
    save(figure, path)


def fig14(rows: Sequence[Row], path: Path) -> None:
    figure, (axes,) = new_figure(1, 7.6, 5.6)
    _panel(axes, rows, COMPARED, "Fx", "Figure 14: tangential force $F_x$, Mesh1 with $L$ = 1024, Mesh2 with $L$ = 128")
    _legend(figure, COMPARED)
    save(figure, path)
