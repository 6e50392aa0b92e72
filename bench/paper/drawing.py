"""Defines the common parts of all pictures: colours, axes, the target line."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import matplotlib

matplotlib.use("Agg")

import matplotlib.pyplot as plt
from matplotlib.ticker import FuncFormatter, LogLocator, NullFormatter

from .rows import Row

INK = "#1d1d2b"
# These colours of Okabe and Ito are distinct for every kind of colour vision; markers differ, too.
BLUE, RED, GREEN, ORANGE, PURPLE, SKY, GREY = (
    "#0072B2", "#D55E00", "#009E73", "#E69F00", "#CC79A7", "#56B4E9", "#7a7a85",
)  # fmt: skip
TARGET = 0.01  # the paper's (3.1)


@dataclass(frozen=True)
class Look:
    label: str
    colour: str
    marker: str
    line: str = "-"


def new_figure(panels: int, width: float = 5.2, height: float = 4.4, rows: int = 1) -> tuple[Any, list[Any]]:
    """Creates a figure with `panels` per row and returns axes row by row. Width and height are per panel (inches)."""
    size = (width * panels, height * rows)
    figure, axes = plt.subplots(rows, panels, figsize=size, layout="constrained", squeeze=False)
    return figure, list(axes.flat)


def save(figure: Any, path: Path) -> None:
    path.parent.mkdir(parents=True, exist_ok=True)
    # The file omits the software version, so that the same rows give the same file.
    figure.savefig(path, dpi=110, metadata={"Software": None})
    plt.close(figure)


def finish(axes: Any, title: str, ylabel: str) -> None:
    axes.set_title(title, fontsize=11)
    axes.set_ylabel(ylabel)
    axes.grid(True, which="major", color="#dcdce2", linewidth=0.7)
    axes.set_axisbelow(True)
    for side in ("top", "right"):
        axes.spines[side].set_visible(False)


def draw_target(axes: Any) -> None:
    axes.axhline(TARGET, color=INK, linestyle=(0, (6, 4)), linewidth=1.1)
    # The label is next to the axes, where it hides no curve.
    place = {"xycoords": ("axes fraction", "data"), "xytext": (3, -3), "textcoords": "offset points"}
    axes.annotate("1 %", (1, TARGET), fontsize=9, **place)


def plain_log(axis: Any, unit: str = "") -> None:
    """Labels ticks 1, 2, 5, 10 instead of powers of ten; with the unit "k" in thousands."""
    size = 1000 if unit == "k" else 1
    axis.set_major_locator(LogLocator(subs=(1, 2, 5)))
    axis.set_major_formatter(FuncFormatter(lambda value, _: f"{value / size:g}{unit}"))
    axis.set_minor_formatter(NullFormatter())


def block_sizes(axes: Any, rows: Sequence[Row]) -> None:
    """Sets a logarithmic axis of block sizes with a tick at each of them."""
    doubling(axes.xaxis, {row["L"] for row in rows})
    axes.set_xlabel("block size $L$ (mm)")


def doubling(axis: Any, values: set[float]) -> None:
    """Sets a logarithmic axis with a tick for each of the values."""
    axis.axes.set_xscale("log", base=2)
    axis.set_ticks(sorted(values))
    axis.set_major_formatter(FuncFormatter(lambda value, _: f"{value:g}"))
    axis.set_minor_formatter(NullFormatter())
