"""Draws figure 4: Mesh1 and Mesh2, seen from above the loaded corner."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import Any

import numpy as np
import numpy.typing as npt
from matplotlib.collections import PolyCollection

from ..drawing import INK, RED, new_figure, save
from ..rows import Row
from .block_system import FREE, FRONT, LOADED, RIGHT

Array = npt.NDArray[np.float64]
TITLES = {"hex": "(a) hexahedron Mesh1", "prism": "(b) prismatic Mesh2"}
SHADES = {FRONT: "#e6eaf2", RIGHT: "#d3dae8", FREE: "#f7f8fb", LOADED: RED}
NAMES = {FRONT: "front, $x=0$", RIGHT: "right, $y=0$", FREE: "top, $z=0$"}


def projected(positions: Array) -> Array:
    """Projects to the isometric view from the octant where x, y and z are positive: x points to the lower left, y to
    the right, and z up."""
    x, y, z = positions.T
    return np.column_stack([(y - x) * np.sqrt(3) / 2, z - (x + y) / 2])


def faces_of(row: Row) -> list[tuple[int, Array]]:
    """Returns attribute and corners of each face in a row of meshes.csv."""
    positions = np.array([float(word) for word in str(row["positions"]).split()]).reshape(-1, 3)
    faces = [[int(word) for word in text.split()] for text in str(row["faces"]).split(";")]
    return [(attribute, positions[vertices]) for attribute, *vertices in faces]


def meshes(rows: Sequence[Row], path: Path) -> None:
    figure, panels = new_figure(2, width=6.0, height=6.0)
    for axes, row in zip(panels, rows, strict=True):
        _draw(axes, row)
    figure.suptitle("Figure 4: TEST 2 in a block of $L$ = 8 mm; the quarter of the loaded element is filled", fontsize=12)
    save(figure, path)


def _draw(axes: Any, row: Row) -> None:
    faces = faces_of(row)
    for part, shade in SHADES.items():
        polygons = [projected(corners) for attribute, corners in faces if attribute == part]
        axes.add_collection(PolyCollection(polygons, facecolors=shade, edgecolors=INK, linewidths=0.5))
    size = max(float(np.abs(corners).max()) for _, corners in faces)
    for part, (right, up) in {FRONT: (-0.62, -0.9), RIGHT: (0.62, -0.9), FREE: (0.62, 0.84)}.items():
        axes.annotate(NAMES[part], (right * size, up * size), ha="center", fontsize=10, color=INK)
    axes.set_aspect("equal")
    axes.set(xlim=(-1.05 * size, 1.05 * size), ylim=(-1.05 * size, 1.05 * size))
    axes.set_axis_off()
    axes.set_title(f"{TITLES[str(row['curve'])]}: {row['elements']:.0f} elements", fontsize=11)
