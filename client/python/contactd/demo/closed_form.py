"""Evaluates closed forms of Hertz and Cattaneo: a sphere on a plane of the same material (Johnson, Contact
Mechanics)."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np
import numpy.typing as npt

Array = npt.NDArray[np.float64]


@dataclass(frozen=True)
class Sphere:
    """Both bodies have shear modulus `G` (N/mm^2) and Poisson's ratio `nu`; `radius` and `approach` in mm."""

    G: float
    nu: float
    radius: float
    approach: float
    mu: float
    shift: float  #: rigid shift (mm)

    @property
    def contact_radius(self) -> float:
        return math.sqrt(self.radius * self.approach)

    @property
    def normal_force(self) -> float:
        # 4/3 E* a^3 / R; equal bodies have E* = G / (1 - nu).
        return 4 / 3 * self.G / (1 - self.nu) * self.contact_radius**3 / self.radius

    @property
    def pmax(self) -> float:
        return 1.5 * self.normal_force / self.area

    @property
    def area(self) -> float:
        return math.pi * self.contact_radius**2

    @property
    def adhesion_radius(self) -> float:
        # The shift at which everything slips, 3 mu Fn (2 - nu) / (8 G a) for two equal bodies, ends adhesion.
        full = 3 * self.mu * self.normal_force * (2 - self.nu) / (8 * self.G * self.contact_radius)
        return self.contact_radius * math.sqrt(max(0.0, 1 - self.shift / full))

    @property
    def tangential_force(self) -> float:
        return self.mu * self.normal_force * (1 - (self.adhesion_radius / self.contact_radius) ** 3)

    def pressure(self, r: Array) -> Array:
        """Returns the pressure (N/mm^2) at the distance `r` (mm) from the centre."""
        return self._ellipse(r, self.contact_radius)

    def traction(self, r: Array) -> Array:
        """Returns the size of the tangential traction (N/mm^2)."""
        return self.mu * (self._ellipse(r, self.contact_radius) - self._ellipse(r, self.adhesion_radius))

    def _ellipse(self, r: Array, radius: float) -> Array:
        height = self.pmax * radius / self.contact_radius
        return np.asarray(height * np.sqrt(np.maximum(0, 1 - (r / radius) ** 2)))
