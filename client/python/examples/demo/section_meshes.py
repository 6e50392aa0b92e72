"""Makes meshes for tables of cross-sections, by contactd-ic."""

from __future__ import annotations

import json
import subprocess
import tempfile
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np

from contactd import Grid, Material


@dataclass(frozen=True)
class SectionMesh:
    """Triangles of a cross-section."""

    points: Any  #: y and z, upwards (mm), shape [n, 2]
    triangles: Any  #: their corners, shape [m, 3]
    columns: Any  #: y and z of the middles of the columns, shape [ny, 2]


def section_mesh(binaries: Path, material: Material, grid: Grid, ics: dict[str, Any], frames: Any) -> SectionMesh:
    """Meshes a longitudinally uniform body, whose columns are the rows of `grid`, at `frames`."""
    spec = {
        "material": {"G": material.G, "nu": material.nu},
        "grid": {"nx": grid.nx, "ny": grid.ny, "dx": grid.dx, "dy": grid.dy},
        "ics": {"source": "fem", "body": "longitudinally_uniform", **ics},
    }
    with tempfile.TemporaryDirectory() as folder:
        file = Path(folder, "section.vtk")
        command = [str(binaries / "contactd-ic"), "-", "--mesh", str(file)]
        subprocess.run(command, input=json.dumps(spec), text=True, check=True, stdout=subprocess.DEVNULL)
        words = file.read_text().split()
    numbers = words.index("POINTS") + 3, words.index("CELLS") + 3
    points = np.array(words[numbers[0] : numbers[0] + 3 * int(words[numbers[0] - 2])], dtype=float).reshape(-1, 3)
    cells = np.array(words[numbers[1] : numbers[1] + 4 * int(words[numbers[1] - 2])], dtype=int).reshape(-1, 4)
    return SectionMesh(points[:, :2], cells[:, 1:], np.asarray(frames)[:, :2])
