"""Shows how errors of coefficients affect a contact on flat and curved surfaces: section 5 of the paper, plane strain.

Flat: a cylinder between two deep slabs, which are equal. Curved: a cylinder in a hole of nearly its own radius. Both
have the same strips, and meshes of the same densities (bench/section_strips.cpp). The reference is a mesh so fine that
refining it changes nothing. The contact is solved as in persson.py, by linear equations alone.
"""

from __future__ import annotations

import json
import subprocess
from functools import cache
from pathlib import Path
from typing import Any

import numpy as np
import numpy.typing as npt

from .persson import NU, RADIUS, STRIPS, clearance, half_angle_of, pressure, solve

Array = npt.NDArray[np.float64]

PROGRAM = "section_strips"
#: Orders of elements, and edges per strip; the paper's are 2 and 4.
MESHES = [(order, edges) for order in (1, 2) for edges in (1, 2, 4, 8) if order * edges > 1]
FINEST = (5, 4)
HALF_ANGLE = np.radians(60)  # half-angle of contact in the hole
HALF_WIDTH = 60.3  # half-width of contact on the flat surface, in the same number of strips


def gap_of(body: str, angles: Array) -> Array:
    if body == "curved":
        return np.asarray(clearance(float(HALF_ANGLE)) * (1 - NU) / 2 * (1 - np.cos(angles)))
    radius = HALF_WIDTH**2 * np.pi / (4 * (1 - NU))  # Hertz, under a force of 1
    return np.asarray((angles / (angles[1] - angles[0])) ** 2 / (2 * radius))


def closed_form(body: str) -> float:
    """Returns the largest pressure under a force of 1."""
    if body == "curved":
        return float(pressure(HALF_ANGLE, np.zeros(1))[0] / RADIUS)
    return float(2 / (np.pi * HALF_WIDTH))


def symmetric(lower: list[float], size: int) -> Array:
    """Returns the symmetric matrix whose lower half has these values, row by row."""
    full = np.zeros((size, size))
    full[np.tril_indices(size)] = lower
    return np.asarray(full + np.tril(full, -1).T)


class Propagation:
    """Compliances, computed at their first use."""

    def __init__(self, programs: Path) -> None:
        self._programs = programs
        self._compliance = cache(self._compute)

    def _normal(self, shape: str, order: int, edges: int) -> dict[str, Any]:
        options = {"shape": shape, "radius": RADIUS, "strips": STRIPS, "edges": edges, "order": order}
        arguments = [part for name, value in options.items() for part in (f"--{name}", str(value))]
        command = [str(self._programs / PROGRAM), *arguments]
        result: dict[str, Any] = json.loads(subprocess.run(command, check=True, capture_output=True, text=True).stdout)
        return {**result, "normal": symmetric(result["normal"], STRIPS)}

    def _compute(self, body: str, order: int, edges: int) -> tuple[Array, Array, int]:
        """Returns angles of the strips (on the flat surface: positions over the radius), compliance of both bodies, and
        unknowns."""
        if body == "flat":
            slab = self._normal("slab", order, edges)
            return (np.arange(STRIPS) - (STRIPS - 1) / 2) / RADIUS, 2 * slab["normal"], slab["unknowns"]
        hole, disc = self._normal("plate_hole", order, edges), self._normal("disc", order, edges)
        # The disc's strips are numbered the other way.
        both = hole["normal"] + disc["normal"][::-1, ::-1]
        return np.array(hole["angles"]), both, hole["unknowns"] + disc["unknowns"]

    def measure(self, body: str, order: int, edges: int) -> dict[str, Any]:
        """Returns errors against the finest mesh: those of the coefficients, over the coefficient under the load, in
        the contact, and those of the contact. Also returns the error of the finest mesh's largest pressure against the
        closed form."""
        angles, found, unknowns = self._compliance(body, order, edges)
        _, exact, _ = self._compliance(body, *FINEST)
        solutions = [contact(body, angles, compliance) for compliance in (found, exact)]
        inside = np.flatnonzero(solutions[1]["p"] > 0)
        error, own = (found - exact)[np.ix_(inside, inside)], float(np.mean(np.diag(exact)[inside]))
        errors = {
            f"{name}_error": float(solutions[0][name] / solutions[1][name] - 1) for name in ("p0", "extent", "approach")
        }
        return {
            "unknowns": unknowns,
            "ic_origin": float(np.mean(np.diag(error)) / own),
            "ic_largest": float(np.abs(error).max() / own),
            **errors,
            "finest_error": float(solutions[1]["p0"] / closed_form(body) - 1),
        }


def contact(body: str, angles: Array, compliance: Array) -> dict[str, Any]:
    """Returns pressures under a force of 1, their maximum, half of the extent of contact, and the approach."""
    cosines = np.cos(angles) if body == "curved" else np.ones(len(angles))
    gap = gap_of(body, angles)
    p = solve(compliance, cosines, gap)
    touching = p > 0
    approach = float(np.mean((gap + compliance @ p)[touching] / cosines[touching]))
    return {"p": p, "p0": float(p.max()), "extent": half_angle_of(angles, p), "approach": approach}
