"""Compares a cylinder in a hole of nearly its own radius with Persson's closed form.

Both tables are built by contactd-ic. Wavenumber zero of their transforms is plane strain, which the closed form
assumes. The contact is solved here by linear equations alone. This checks the tables, not contactd's solvers;
tests/core/fem/section/test_conformal_cylinders.cpp compares those with the same closed form.
"""

from __future__ import annotations

import json
import subprocess
import tempfile
from functools import cached_property
from pathlib import Path
from typing import Any

import h5py
import numpy as np
import numpy.typing as npt

Array = npt.NDArray[np.float64]

STRIP = np.radians(1)  # lengths are over the width of a strip
RADIUS, STRIPS, NU = 1 / STRIP, 168, 0.28
BODIES = {
    "disc": {"radius": RADIUS, "core": 0.005 * RADIUS},
    "plate_hole": {"radius": RADIUS, "plate_radius": 50 * RADIUS},
}


def clearance(half_angle: float) -> float:
    """Returns E' (R2 - R1)/Q of identical cylinders under the force Q per length, E' = 2 G/(1 - nu)."""
    b2 = np.tan(half_angle / 2) ** 2
    return float((2 - np.log(1 + b2) - 2 * b2**2) / (np.pi * b2 * (1 + b2)))


def pressure(half_angle: float, angle: Array) -> Array:
    """Returns p R/Q of the strips in contact."""
    b, y = np.tan(half_angle / 2), np.tan(angle / 2)
    q, s = np.sqrt(1 + b**2), np.sqrt(np.maximum(b**2 - y**2, 0))
    return np.asarray(2 * s / (np.pi * q * (1 + y**2)) + np.log((q + s) / (q - s)) / (2 * np.pi * b**2 * (1 + b**2)))


def plane_strain(binaries: Path, folder: Path, shape: str) -> tuple[Array, Array]:
    """Returns angles of the strips, and normal displacements for normal tractions, shape [strip, loaded strip], for G = 1."""
    file = folder / f"{shape}.h5"
    ics = {"source": "fem", "body": "longitudinally_uniform", "accuracy": 1e-2, "section": {shape: BODIES[shape]}}
    grid = {"nx": 1, "ny": STRIPS, "dx": 1, "dy": 1}
    spec = json.dumps({"material": {"G": 1, "nu": NU}, "grid": grid, "ics": ics})
    command = [str(binaries / "contactd-ic"), "-", "--output", str(file)]
    subprocess.run(command, input=spec.encode(), check=True, stdout=subprocess.DEVNULL)
    with h5py.File(file) as table:
        packed, angles = table["transform"][0], table["frames"][:, 2]
    full = np.zeros((3 * STRIPS, 3 * STRIPS))
    full[np.tril_indices(3 * STRIPS)] = packed
    full += np.tril(full, -1).T
    return angles, full[2::3, 2::3]


def solve(compliance: Array, cosines: Array, gap: Array) -> Array:
    """Returns pressures of strips of width 1 under the force 1. They satisfy h + A p = delta cos where they are positive."""
    touching = np.ones(len(gap), dtype=bool)
    while True:
        inside = np.flatnonzero(touching)
        count = len(inside)
        matrix = np.zeros((count + 1, count + 1))
        matrix[:count, :count] = compliance[np.ix_(inside, inside)]
        matrix[:count, count] = -cosines[inside]
        matrix[count, :count] = cosines[inside]
        found = np.linalg.solve(matrix, np.append(-gap[inside], 1))
        p = np.zeros(len(gap))
        p[inside] = found[:count]
        if (p >= 0).all():
            return p
        touching &= p > 0


def half_angle_of(angles: Array, p: Array) -> float:
    """Extrapolates the end of the contact, where the square of the pressure, linear near the end, is zero, from strips
    that are fully in contact."""
    last = int(np.flatnonzero(p > 0)[-1])
    outer, inner = p[last - 1] ** 2, p[last - 3] ** 2
    return float(abs(angles[last - 1] + outer * (angles[last - 1] - angles[last - 3]) / (inner - outer)))


class Cylinders:
    """Provides both bodies, built at their first use."""

    def __init__(self, programs: Path) -> None:
        self._programs = programs

    @cached_property
    def _built(self) -> tuple[Array, Array]:
        with tempfile.TemporaryDirectory() as folder:
            (angles, hole), (_, disc) = (
                plane_strain(self._programs, Path(folder), shape) for shape in ("plate_hole", "disc")
            )
        return angles, hole + disc[::-1, ::-1]  # the disc's strips are numbered the other way

    def measure(self, degrees: float) -> dict[str, Any]:
        """Solves with the clearance of a half angle. Returns the resulting half angle and largest pressure, and
        pressures p R/Q of the strips in contact."""
        angles, compliance = self._built
        half_angle = np.radians(degrees)
        gap = clearance(half_angle) * (1 - NU) / 2 * (1 - np.cos(angles))
        p = solve(compliance, np.cos(angles), gap)
        touching = p > 0
        return {
            "p0": float(p.max() * RADIUS),
            "p0_exact": float(pressure(half_angle, np.zeros(1))[0]),
            "half_angle": float(np.degrees(half_angle_of(angles, p))),
            "angles": " ".join(f"{angle:.6g}" for angle in np.degrees(angles[touching])),
            "pressures": " ".join(f"{value:.6g}" for value in p[touching] * RADIUS),
        }
