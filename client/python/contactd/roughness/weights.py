"""Weights of roughness in the approach of a contact.

In contact, the pressures satisfy A p = delta - h. To first order, a small roughness r, h = h0 - r, changes the approach
at constant force by

    r_eff = delta_smooth - delta_rough = sum w_i r_i,    w = (dp/d delta)/sum(dp/d delta),

which are the pressures of a flat punch with the outline of the contact. Those of an ellipse have a closed form (Johnson,
Contact Mechanics, 3.7 and 4.2): w = 1/(2 pi a b sqrt(1 - x^2/a^2 - y^2/b^2)), with the transform sin(kappa)/kappa,
kappa^2 = (kx a)^2 + (ky b)^2.
"""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np

from ..errors import invalid
from ..values.arrays import Array
from ..values.generated.materials import Material
from ..values.hertz import Load, compliance_of, ellipse_of_curvatures

__all__ = ["ContactWeights", "EllipseWeights", "hertz_weights"]

_LEVELS, _ANGLES = 24, 64  #: Points of an ellipse.


@dataclass(frozen=True, eq=False)
class ContactWeights:
    """Weights of points of a contact, or of several patches with a common approach.

    Attributes:
        x: Places along the rolling direction (mm), shape [points].
        y: Places across (mm), shape [points].
        values: Weights, with sum 1, shape [points].
        size: Size of the elements along x and y (mm); 0 for points without elements.
        stiffness: dFn/d(approach) (N/mm); None if unknown.
    """

    x: Array
    y: Array
    values: Array
    size: tuple[float, float] = (0.0, 0.0)
    stiffness: float | None = None

    def __post_init__(self) -> None:
        """Scales the weights to a sum of 1. Raises InvalidArgument naming an invalid field."""
        x, y, values = (np.array(part, dtype=float).ravel() for part in (self.x, self.y, self.values))
        if not len(x) == len(y) == len(values) > 0:
            raise invalid("values", f"= {len(values)} weights for {len(x)} x {len(y)} places: give one x and one y for each weight, at least one.")
        if not all(np.isfinite(part).all() for part in (x, y, values)) or not values.sum() > 0:
            raise invalid("values", f"= weights with the sum {values.sum():g}: places and weights must be finite and the sum positive. Check the contact.")
        for name, value in (("x", x), ("y", y), ("values", values / values.sum())):
            object.__setattr__(self, name, value)

    @property
    def reach(self) -> float:
        """The largest distance of a point from x = 0 (mm)."""
        return float(np.abs(self.x).max())

    @property
    def semi_axes(self) -> tuple[float, float]:
        """Semi-axes of the ellipse with the same second moments, a^2/3 and b^2/3 (mm)."""
        a, b = (math.sqrt(3 * float(self.values @ (part - self.values @ part) ** 2)) for part in (self.x, self.y))
        return a, b

    def points(self) -> ContactWeights:
        """Returns the weights themselves."""
        return self

    def transform(self, kx: Array, ky: Array) -> Array:
        """Returns sum w exp(i (kx x + ky y)) for wavenumbers (rad/mm) of shapes [n] and [n, m], shape [n, m]. Waves
        across that are shorter than two elements have no weight.
        """
        rows, of_row = np.unique(self.y, return_inverse=True)
        along = np.exp(1j * np.outer(kx, self.x)) * self.values
        by_row = np.stack([np.bincount(of_row.ravel(), part, len(rows)) for line in along for part in (line.real, line.imag)])
        across = np.exp(1j * ky[:, :, None] * rows)
        found = np.einsum("nmr,nr->nm", across, by_row[0::2] + 1j * by_row[1::2])
        return np.asarray(np.where(np.abs(ky) * self.size[1] <= math.pi, found, 0))


@dataclass(frozen=True)
class EllipseWeights:
    """Weights of an ellipse of contact, in closed form.

    Attributes:
        a: Semi-axis along the rolling direction (mm), > 0.
        b: Semi-axis across (mm), > 0.
        stiffness: dFn/d(approach) (N/mm); None if unknown.
    """

    a: float
    b: float
    stiffness: float | None = None

    def __post_init__(self) -> None:
        """Raises InvalidArgument naming an invalid semi-axis."""
        for name in ("a", "b"):
            if not (math.isfinite(getattr(self, name)) and getattr(self, name) > 0):
                raise invalid(name, f"= {getattr(self, name)} mm: a semi-axis must be positive. Give it in mm.")

    @property
    def reach(self) -> float:
        """The largest distance of a point from x = 0 (mm)."""
        return self.a

    @property
    def semi_axes(self) -> tuple[float, float]:
        """Both semi-axes (mm)."""
        return self.a, self.b

    def points(self) -> ContactWeights:
        """Returns points of the ellipse: its weights are the projection of a uniform hemisphere."""
        nodes, weights = np.polynomial.legendre.leggauss(_LEVELS)
        radius = np.sqrt(1 - ((nodes + 1) / 2) ** 2)
        angle = 2 * np.pi * np.arange(_ANGLES) / _ANGLES
        x, y = self.a * np.outer(radius, np.cos(angle)), self.b * np.outer(radius, np.sin(angle))
        return ContactWeights(x, y, np.repeat(weights, _ANGLES), stiffness=self.stiffness)

    def transform(self, kx: Array, ky: Array) -> Array:
        """Returns sin(kappa)/kappa for wavenumbers (rad/mm) of shapes [n] and [n, m], shape [n, m]."""
        return np.asarray(np.sinc(np.hypot(kx[:, None] * self.a, ky * self.b) / np.pi))


def hertz_weights(Fn: float, Rx: float, Ry: float, upper: Material, lower: Material | None = None) -> EllipseWeights:
    """Returns the weights of Hertz's contact under a force (N), for combined radii of curvature along the rolling
    direction and across (mm). Both must be positive. `lower` is by default the same as `upper`.
    """
    for name, value in (("Fn", Fn), ("Rx", Rx), ("Ry", Ry)):
        if not (math.isfinite(value) and value > 0):
            raise invalid(name, f"= {value}: it must be positive. Give forces in N and radii in mm.")
    lower = upper if lower is None else lower
    found = ellipse_of_curvatures(0.5 / Rx, 0.5 / Ry, Load(Fn, True, compliance_of((upper.nu, lower.nu), (upper.G, lower.G))))
    return EllipseWeights(found.aa, found.bb, 1.5 * Fn / found.approach)
