"""Runs bench/block_system.cpp: the paper's system of equations with the paper's solver, and its meshes."""

from __future__ import annotations

import json
import os
import subprocess
import tempfile
from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
import numpy.typing as npt

PROGRAM = "block_system"
Options = Mapping[str, Any]


@dataclass(frozen=True)
class Mesh:
    """Represents a quarter block with lengths over h. Boundary attributes are those of
    core/fem/mesh/block_mesh.hpp."""

    vertices: npt.NDArray[np.float64]  #: shape [vertices, 3]
    elements: list[list[int]]
    faces: list[tuple[int, list[int]]]  #: of the boundary: attribute and vertices


FRONT, RIGHT, FREE, LOADED, FAR = 1, 2, 3, 4, 5


def run(programs: Path, options: Options) -> str:
    """Returns the output of the program."""
    arguments = [part for name, value in options.items() for part in (f"--{name}", str(value))]
    environment = {**os.environ, "OMP_NUM_THREADS": "1", "OPENBLAS_NUM_THREADS": "1"}
    command = [str(programs / PROGRAM), *arguments]
    return subprocess.run(command, check=True, capture_output=True, text=True, env=environment).stdout


def solve(programs: Path, options: Options) -> dict[str, Any]:
    """Returns the result; for a solve that breaks down or takes too many iterations it is {"failure": text}."""
    result: dict[str, Any] = json.loads(run(programs, options))
    if result["indefinite"] or result["update"]["iterations"] == 0:
        return {"failure": "The incomplete factorisation is indefinite, or conjugate gradients do not converge."}
    return result


def mesh(programs: Path, options: Options) -> Mesh:
    with tempfile.TemporaryDirectory(prefix="contactd-paper-") as folder:
        path = Path(folder, "block.mesh")
        run(programs, {**options, "mesh": path})
        return read_mesh(path.read_text())


def read_mesh(text: str) -> Mesh:
    """Reads MFEM's format 1.0: sections with a name, a count and that number of lines."""
    lines = [line for line in (line.split("#")[0].strip() for line in text.splitlines()) if line]

    def section(name: str, skipped: int = 0) -> list[list[str]]:
        start = lines.index(name)
        count = int(lines[start + 1])
        return [line.split() for line in lines[start + 2 + skipped : start + 2 + skipped + count]]

    def connected(name: str) -> list[tuple[int, list[int]]]:
        return [(int(words[0]), [int(word) for word in words[2:]]) for words in section(name)]

    vertices = np.array(section("vertices", skipped=1), dtype=float)
    return Mesh(vertices, [vertices_of for _, vertices_of in connected("elements")], connected("boundary"))


def faces_to_draw(mesh: Mesh) -> dict[str, Any]:
    """Returns counts, and the faces on the planes x = 0, y = 0 and z = 0 as texts: x y z of every vertex, and faces
    separated by semicolons, each with its attribute and its vertices."""
    seen = [(attribute, face) for attribute, face in mesh.faces if attribute != FAR]
    return {
        "elements": len(mesh.elements),
        "vertices": len(mesh.vertices),
        "positions": " ".join(f"{value:.6g}" for value in mesh.vertices.ravel()),
        "faces": "; ".join(" ".join(map(str, (attribute, *face))) for attribute, face in seen),
    }
