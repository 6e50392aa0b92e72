"""Hertz's contact of two curved surfaces: relations between curvatures and semi-axes.

The distance of the surfaces is h = a1 x^2 + b1 y^2. With p0 the largest pressure and 1/E* the sum of both bodies' (1 -
nu)/(2 G) (Johnson, Contact Mechanics, 4.2(b), its elliptic integrals in Carlson's symmetric form),

    a1 = p0 a b/(3 E*) R_D(0, b^2, a^2),    b1 = p0 a b/(3 E*) R_D(0, a^2, b^2),    approach = p0 a b/E* R_F(0, a^2, b^2).
"""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass

__all__ = ["Ellipse", "Load", "compliance_of", "ellipse_of_axes", "ellipse_of_curvatures", "ellipse_of_ratio"]

_SLENDEREST = 1e6  #: Largest ratio of semi-axes; use a line contact beyond it.


@dataclass(frozen=True)
class Load:
    """A normal force or an approach.

    Attributes:
        value: Normal force (N), or approach (mm).
        is_force: Whether it is a force.
        compliance: 1/E* (mm^2/N).
    """

    value: float
    is_force: bool
    compliance: float


@dataclass(frozen=True)
class Ellipse:
    """The ellipse of Hertz's contact.

    Attributes:
        a1: Half the curvature along x (1/mm).
        b1: Half the curvature along y (1/mm).
        aa: Semi-axis along x (mm).
        bb: Semi-axis along y (mm).
        approach: Approach (mm).
    """

    a1: float
    b1: float
    aa: float
    bb: float
    approach: float

    @property
    def rho(self) -> float:
        """Effective radius of curvature, 2/(a1 + b1) (mm)."""
        return 2 / (self.a1 + self.b1)

    @property
    def cp(self) -> float:
        """Effective semi-axis, sqrt(a b) (mm)."""
        return math.sqrt(self.aa * self.bb)


def compliance_of(nu: tuple[float, float], G: tuple[float, float]) -> float:
    """Returns 1/E* of two half-spaces (mm^2/N)."""
    return sum((1 - n) / (2 * g) for n, g in zip(nu, G))


def ellipse_of_axes(aa: float, bb: float, load: Load) -> Ellipse:
    """Returns the ellipse with these semi-axes."""
    rf = _rf(0, aa * aa, bb * bb)
    strength = load.value / rf if not load.is_force else load.value * load.compliance * 3 / (2 * math.pi)
    return Ellipse(strength / 3 * _rd(0, bb * bb, aa * aa), strength / 3 * _rd(0, aa * aa, bb * bb), aa, bb, strength * rf)


def ellipse_of_ratio(a1: float, ratio: float, load: Load) -> Ellipse:
    """Returns the ellipse with this ratio a/b and the curvature a1 along x. Curvatures are proportional to 1/b^3 for a
    given force, and to 1/b^2 for a given approach.
    """
    of_one = ellipse_of_axes(ratio, 1.0, load).a1
    bb = (of_one / a1) ** (1 / 3 if load.is_force else 1 / 2)
    return ellipse_of_axes(ratio * bb, bb, load)


def ellipse_of_curvatures(a1: float, b1: float, load: Load) -> Ellipse:
    """Returns the ellipse of these curvatures, both positive."""
    requested = math.log(a1 / b1)

    def excess(of_log: float) -> float:
        squared = math.exp(2 * of_log)
        return math.log(_rd(0, 1, squared) / _rd(0, squared, 1)) - requested

    return ellipse_of_ratio(a1, math.exp(_root(excess, math.log(_SLENDEREST))), load)


def _root(excess: Callable[[float], float], reach: float) -> float:
    """Returns the zero of a decreasing function, by bisection to rounding accuracy."""
    low, high = -reach, reach
    for _ in range(80):
        middle = 0.5 * (low + high)
        if excess(middle) > 0:
            low = middle
        else:
            high = middle
    return 0.5 * (low + high)


def _rf(x: float, y: float, z: float) -> float:
    """Returns Carlson's R_F by his duplication theorem."""
    while True:
        mean = (x + y + z) / 3
        if max(abs(mean - part) for part in (x, y, z)) < 1e-4 * mean:
            dx, dy = 1 - x / mean, 1 - y / mean
            dz = -dx - dy
            e2, e3 = dx * dy - dz * dz, dx * dy * dz
            return (1 - e2 / 10 + e3 / 14 + e2 * e2 / 24 - 3 * e2 * e3 / 44) / math.sqrt(mean)
        step = math.sqrt(x * y) + math.sqrt(y * z) + math.sqrt(z * x)
        x, y, z = (x + step) / 4, (y + step) / 4, (z + step) / 4


def _rd(x: float, y: float, z: float) -> float:
    """Returns Carlson's R_D by his duplication theorem."""
    total, share = 0.0, 1.0
    while True:
        mean = (x + y + 3 * z) / 5
        if max(abs(mean - part) for part in (x, y, z)) < 1e-4 * mean:
            break
        roots = math.sqrt(x), math.sqrt(y), math.sqrt(z)
        step = roots[0] * roots[1] + roots[1] * roots[2] + roots[2] * roots[0]
        total += share / (roots[2] * (z + step))
        share /= 4
        x, y, z = (x + step) / 4, (y + step) / 4, (z + step) / 4
    dx, dy, dz = 1 - x / mean, 1 - y / mean, 1 - z / mean
    ea, eb = dx * dy, dz * dz
    ec, ed = ea - eb, ea - 6 * eb
    ef = ed + 2 * ec
    series = 1 + ed * (-3 / 14 + 9 / 88 * ed - 9 / 52 * dz * ef) + dz * (ef / 6 + dz * (-9 / 22 * ec + dz * 3 / 26 * ea))
    return 3 * total + share * series / (mean * math.sqrt(mean))
