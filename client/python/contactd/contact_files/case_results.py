"""Computes results of a contact that output files print, from the values of its case and the answer of the service."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass
from functools import cached_property
from typing import Any

import numpy as np

from ..values.arrays import Array
from ..values.generated.contact_files import ComputedPatch
from ..values.generated.wheel_rail.result import WheelRailPatch
from .case import Case

__all__ = ["COMPONENTS", "LETTERS", "Elements", "Pair", "StressField", "is_right", "is_roller", "pair_of", "rolling_step", "step_on"]

COMPONENTS = ("XX", "XY", "XZ", "YY", "YZ", "ZZ")
LETTERS = "abcdefghijklmnopqrstuvwxyz"  #: Letters of patches in file names.

_SHIFT, _TRANSIENT, _STEADY = 1, 2, 3  #: T
_SLIP = 2  #: IGS
_NEAR = 0.01  #: Largest angle (rad) of a rolling direction along an axis.
_ALIKE = 1e-4  #: Difference below which bodies are quasi-identical.


@dataclass(frozen=True)
class Pair:
    """Holds combined constants of two bodies.

    Attributes:
        nu: Poisson's ratio: nu/G is the mean of both.
        G: Shear modulus (N/mm^2): 1/G is the mean of both.
        difference: G/4 ((1 - 2 nu1)/G1 - (1 - 2 nu2)/G2), of dissimilar bodies (AK).
    """

    nu: float
    G: float
    difference: float

    @property
    def is_quasi_identical(self) -> bool:
        """Returns whether normal and tangential contact are independent."""
        return abs(self.difference) < _ALIKE


def pair_of(values: Mapping[str, Any], moduli: tuple[float, float] | None = None) -> Pair:
    """Returns the constants of the bodies of a case, or of bodies with other shear `moduli`."""
    nu1, nu2 = values["POISS1"], values["POISS2"]
    g1, g2 = moduli or (values["GG1"], values["GG2"])
    G = 2 / (1 / g1 + 1 / g2)
    return Pair(G * (nu1 / g1 + nu2 / g2) / 2, G, G / 4 * ((1 - 2 * nu1) / g1 - (1 - 2 * nu2) / g2))


def rolling_step(case: Case, patch: ComputedPatch) -> tuple[float, float]:
    """Returns CHI and DQ of basic contact as printed: steady rolling is along x by elements, unless ConvexGS solves
    it.
    """
    values, tangential = case.values, case.digits["T"]
    is_along_x = (tangential == _STEADY and values["GAUSEI"] != 2) or case.digits["M"] in (3, 5)
    if not is_along_x or tangential not in (_TRANSIENT, _STEADY):
        return values["CHI"], values["DQ"]
    goes_back = abs(abs(math.remainder(values["CHI"], 2 * math.pi)) - math.pi) < _NEAR
    return (math.pi if goes_back else 0.0), patch.grid.dx


def step_on(case: Case, patch: ComputedPatch) -> float:
    """Returns the distance that the step of a wheel rolls (mm); a shift has 1."""
    if case.digits["T"] == _SHIFT:
        return 1.0
    share = case.values["DQREL"]
    return float(share * case.values["DX"]) if case.digits["T"] == _TRANSIENT and share != 1 else patch.grid.dx


def is_roller(case: Case) -> bool:
    """Returns whether the wheel is on a roller."""
    return case.digits["C1"] >= 4


def is_right(case: Case) -> bool:
    """Returns whether the wheel is a right one."""
    return case.digits["C1"] % 4 == 1


@dataclass(frozen=True, eq=False)
class Elements:
    """Arrays of a contact over its grid, by CONTACT's names.

    Attributes:
        case: The case.
        patch: The contact, with its arrays.
        on_rail: The same contact of a wheel on its rail; None for basic contact.
    """

    case: Case
    patch: ComputedPatch
    on_rail: WheelRailPatch | None = None

    def __getitem__(self, name: str) -> Array:
        assert self.patch.arrays is not None, "arrays were not requested"
        return self.patch.arrays[name]

    def pairs_of(self, *pairs: tuple[str, ...]) -> list[Array]:
        """Returns the arrays of those groups of names that the contact has."""
        return [self[name] for names in pairs if names[0] in (self.patch.arrays or ()) for name in names]

    @property
    def is_frictionless(self) -> bool:
        """Returns whether the contact has no adhesion and slip."""
        return self.case.digits["T"] == 0 or (self.on_rail is not None and self.on_rail.place.creepages.velocity <= 0)

    @property
    def chi(self) -> float:
        """Returns the rolling direction (rad)."""
        return rolling_step(self.case, self.patch)[0] if self.on_rail is None else self.on_rail.place.creepages.chi

    @cached_property
    def division(self) -> Any:
        """Returns IGS as integers."""
        return self["IGS"].astype(np.uint8)

    @cached_property
    def traction_size(self) -> Array:
        """Returns the size of the tangential traction (N/mm^2)."""
        return np.hypot(self["PX"], self["PY"])

    @cached_property
    def bound(self) -> Array:
        """Returns the traction bound (N/mm^2). The traction of a slipping element equals it for every friction law."""
        return np.where(self.division >= _SLIP, self.traction_size, self["MU"] * self["PN"])

    @property
    def found(self) -> tuple[float, float]:
        """Returns the creepages or the shift (mm) that prescribed forces require, in addition to the rigid slip."""
        moves = "CREEP" if self.case.digits["T"] >= _TRANSIENT else "SHIFT"
        x, y = (self.patch.numbers.get(f"{moves} {axis}", 0.0) for axis in "XY")
        return x, y


class StressField:
    """Holds displacements (mm) and stresses (N/mm^2) at a block of points, shape [nz, ny, nx], by CONTACT's names."""

    def __init__(self, block: Mapping[str, Array]) -> None:
        self.block = block
        self.x, self.y, self.z = (block[axis] for axis in "XYZ")
        self.stress = np.stack([block[f"SIG{name}"] for name in COMPONENTS])

    @cached_property
    def principal(self) -> Array:
        """Returns the principal stresses in ascending order, shape [3, nz, ny, nx] (N/mm^2)."""
        xx, xy, xz, yy, yz, zz = self.stress
        tensors = np.stack([np.stack(row, axis=-1) for row in ((xx, xy, xz), (xy, yy, yz), (xz, yz, zz))], axis=-2)
        return np.moveaxis(np.linalg.eigvalsh(tensors), -1, 0)

    @property
    def hydrostatic(self) -> Array:
        """Returns the mean of the normal stresses (N/mm^2)."""
        return np.asarray((self.stress[0] + self.stress[3] + self.stress[5]) / 3)

    @property
    def von_mises(self) -> Array:
        """Returns the von Mises stress (N/mm^2)."""
        first, second, third = self.principal
        return np.asarray(np.sqrt(((first - second) ** 2 + (second - third) ** 2 + (third - first) ** 2) / 2))

    @property
    def tresca(self) -> Array:
        """Returns the largest minus the smallest principal stress (N/mm^2)."""
        return np.asarray(self.principal[2] - self.principal[0])
