"""Stresses and displacements inside both bodies, at the points of a case."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import Any, Literal

import numpy as np
import numpy.typing as npt

from ...values.generated.grid import Grid, Paraboloid
from ...values.generated.problem import ContactProblem, Estimate
from ...values.generated.subsurface import StressBlock, SubsurfaceStress
from ..problems.bodies import Pair

__all__ = ["COMPONENTS", "Body", "StressField", "Stresses", "stress_field", "surface_displacement"]

Floats = npt.NDArray[np.float64]
Body = Literal["lower", "upper"]
#: Computes stresses and displacements in a body of a problem under tractions, on a block of points.
Stresses = Callable[[ContactProblem, Estimate, Body, StressBlock], SubsurfaceStress]

COMPONENTS = ("xx", "xy", "xz", "yy", "yz", "zz")
_ANY = Paraboloid(Rx=1.0, Ry=1.0)  #: stresses follow from tractions, whatever surfaces made them


@dataclass(frozen=True, eq=False)
class StressField:
    """Results at points z, y, x, with x running fastest; z >= 0 in body 1.

    Attributes:
        x: Positions along x (mm).
        y: Positions along y (mm).
        z: Positions along z (mm).
        displacement: Displacements, shape [nz, ny, nx, 3] (mm).
        stress: Stresses by COMPONENTS, shape [6, nz, ny, nx] (N/mm^2), tension positive.
    """

    x: Floats
    y: Floats
    z: Floats
    displacement: Floats
    stress: Floats

    @cached_property
    def principal(self) -> Floats:
        """Returns the principal stresses in ascending order, shape [3, nz, ny, nx] (N/mm^2)."""
        xx, xy, xz, yy, yz, zz = self.stress
        tensors = np.stack([np.stack(row, axis=-1) for row in ((xx, xy, xz), (xy, yy, yz), (xz, yz, zz))], axis=-2)
        return np.moveaxis(np.linalg.eigvalsh(tensors), -1, 0)

    @property
    def hydrostatic(self) -> Floats:
        """Returns the mean of the normal stresses (N/mm^2)."""
        return np.asarray((self.stress[0] + self.stress[3] + self.stress[5]) / 3)

    @property
    def von_mises(self) -> Floats:
        """Returns the von Mises stress (N/mm^2)."""
        first, second, third = self.principal
        return np.asarray(np.sqrt(((first - second) ** 2 + (second - third) ** 2 + (third - first) ** 2) / 2))

    @property
    def tresca(self) -> Floats:
        """Returns the largest minus the smallest principal stress (N/mm^2)."""
        return np.asarray(self.principal[2] - self.principal[0])


def stress_field(block: Mapping[str, Any], grid: Grid, tractions: Floats, pair: Pair, stresses: Stresses) -> StressField:
    """Computes the field on a block of points as read. `tractions` act on body 1, along x, y and z, shape [3, ny,
    nx].
    """
    x, y, z = _places(block, grid)
    displacement, stress = np.zeros((len(z), len(y), len(x), 3)), np.zeros((6, len(z), len(y), len(x)))
    problem = ContactProblem(grid=grid, upper=pair.upper, lower=pair.lower, gap=_ANY, approach=1.0)
    acting = Estimate(tractions[2], tractions[0], tractions[1])
    # In the mirrored frame of the upper body, displacements along z and shear stresses with z change sign.
    bodies: tuple[tuple[Body, npt.NDArray[np.bool_], int], ...] = (("upper", z >= 0, -1), ("lower", z < 0, 1))
    for body, inside, mirror in bodies:
        if not inside.any():
            continue
        found = stresses(problem, acting, body, StressBlock(x, y, -np.abs(z[inside])))
        mirrored = {"xz": mirror, "yz": mirror}
        stress[:, inside] = [mirrored.get(name, 1) * getattr(found, name) for name in COMPONENTS]
        moved = [np.asarray(part) for part in (found.displacement_x, found.displacement_y, found.displacement_z)]
        displacement[inside] = np.stack(moved, axis=-1) * [1, 1, mirror]
    return StressField(x, y, z, displacement, stress)


def surface_displacement(grid: Grid, tractions: Floats, pair: Pair, stresses: Stresses) -> Floats:
    """Returns surface displacements of body 1 minus those of body 2, shape [3, ny, nx] (mm), under the same tractions."""
    problem = ContactProblem(grid=grid, upper=pair.upper, lower=pair.lower, gap=_ANY, approach=1.0)
    acting = Estimate(tractions[2], tractions[0], tractions[1])
    sides: tuple[tuple[Body, int, int], ...] = (("upper", 1, -1), ("lower", -1, 1))
    moved = np.zeros((3, grid.ny, grid.nx))
    for body, sign, mirror in sides:
        found = stresses(problem, acting, body, StressBlock(grid.x, grid.y, [0.0]))
        parts = (found.displacement_x, found.displacement_y, found.displacement_z)
        moved += sign * np.stack([np.asarray(part)[0] for part in parts]) * np.array([1, 1, mirror])[:, None, None]
    return moved


def _places(block: Mapping[str, Any], grid: Grid) -> tuple[Floats, Floats, Floats]:
    z = np.array(block["Z"], dtype=np.float64)
    if "X" in block:
        return np.array(block["X"], dtype=np.float64), np.array(block["Y"], dtype=np.float64), z
    return _elements(grid.x, block.get("IX")), _elements(grid.y, block.get("IY")), z


def _elements(centres: Floats, numbers: Sequence[int] | None) -> Floats:
    """Returns the existing elements among the requested ones, counted from 1; None requests all."""
    if numbers is None:
        return centres
    return centres[[int(number) - 1 for number in numbers if 1 <= number <= len(centres)]]
