"""Computes Kalker's creepage coefficients and prints them as core/src/closed_forms/generated/kalker_table.hpp.

    python3 bench/kalker_coefficients.py > core/src/closed_forms/generated/kalker_table.hpp    (about five minutes)
    python3 bench/kalker_coefficients.py --converge                                (their convergence with the order)

Linear theory of rolling (Kalker 1967; 1990, section 3.1 and appendix E): no slip anywhere, so that du/dx = w with
u = A p, w = (xi - phi y, eta + phi x), rolling along +x, and no traction at the leading edge. On the ellipse
X^2 + Y^2 = 1, X = x/a, Y = y/b, the tractions are

    p = sqrt((l - X)/(l + X)) q(X, Y),   l = sqrt(1 - Y^2),   q a polynomial of total order M:

zero at the leading edge, with the square-root singularity at the trailing one. With s along the straight line through
the point at the angle alpha, the singularity of the half-space's kernel cancels:

    u(X0, Y0) = ab/(pi G) I_0^pi K(alpha)/r(alpha) I p ds dalpha,   r^2 = (a cos alpha)^2 + (b sin alpha)^2,

where K_xx = 1 - nu + nu (a cos alpha/r)^2, K_xy = nu ab cos alpha sin alpha/r^2. The integration uses Gauss-Chebyshev
points for s and equally spaced ones for alpha. u = w x + f(y), with an unknown polynomial f, is solved by least
squares; forces are integrals of p. C23 = -C32 holds for the exact solution. The table has their mean, and their
difference shows the error.
"""

from __future__ import annotations

import sys
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]
RATIOS = [2.0 ** (k / 2) for k in range(-10, 11)]
NUS = [0.0, 0.125, 0.25, 0.375, 0.5]


def legendre(order: int, x: Array) -> list[Array]:
    """Returns P_0 .. P_order at x."""
    values = [np.ones_like(x), x]
    for k in range(1, order):
        values.append(((2 * k + 1) * x * values[k] - k * values[k - 1]) / (k + 1))
    return values


def shapes(order: int, X: Array, Y: Array) -> tuple[list[Array], int]:
    """Returns p sqrt(1 - X^2 - Y^2) for each shape, those even in Y first, and the number of these."""
    lead = np.sqrt(np.maximum(1 - Y * Y, 0)) - X
    PX, PY = legendre(order, X), legendre(order, Y)
    halves = [[lead * PX[i] * PY[j] for j in range(odd, order + 1, 2) for i in range(order + 1 - j)] for odd in (0, 1)]
    return halves[0] + halves[1], len(halves[0])


@dataclass
class Ellipse:
    """Computes displacements and forces of all shapes on the ellipse with a/b = ratio and ab = 1, for G = 1."""

    ratio: float
    order: int

    def __post_init__(self) -> None:
        self.a, self.b = self.ratio**0.5, self.ratio**-0.5
        self._place_points()
        self._integrate_displacements()
        self._integrate_forces()

    def _place_points(self) -> None:
        # These points cover the upper half of the disc, with equal weights by area. The lower half follows by parity.
        node, weight = np.polynomial.legendre.leggauss(self.order)
        angle = (np.arange(2 * self.order) + 0.5) / (2 * self.order) * np.pi
        radius = np.sqrt((node + 1) / 2)
        self.X, self.Y = (np.outer(radius, f(angle)).ravel() for f in (np.cos, np.sin))
        self.weight = np.repeat(np.sqrt(weight), len(angle))

    def _integrate_displacements(self) -> None:
        angles, along = max(128, int(128 * abs(np.log2(self.ratio)))), 4 * self.order
        alpha = (np.arange(angles) + 0.5) * np.pi / angles
        c, s = np.cos(alpha), np.sin(alpha)
        r = np.hypot(self.a * c, self.b * s)
        kernels = np.stack([1 / r, (self.a * c) ** 2 / r**3, c * s / r**3]) / (angles * along) * np.pi
        chebyshev = np.cos((np.arange(along) + 0.5) * np.pi / along)
        self.integrals = []
        for X, Y in zip(self.X, self.Y):
            middle = -(X * c + Y * s)
            half = np.sqrt(1 - X * X - Y * Y + middle**2)
            position = middle[:, None] + half[:, None] * chebyshev
            values, self.even = shapes(self.order, X + position * c[:, None], Y + position * s[:, None])
            self.integrals.append(kernels @ np.stack([value.sum(1) for value in values], 1))
        self.integrals = np.array(self.integrals).transpose(1, 0, 2)

    def _integrate_forces(self, n: int = 400) -> None:
        psi = (np.arange(n) + 0.5) / n * np.pi
        X, Y = np.outer(np.sin(psi), np.cos(psi)), np.repeat(np.cos(psi)[:, None], n, 1)
        weight = (np.pi / n) ** 2 * np.sin(psi)[:, None]
        values = shapes(self.order, X, Y)[0]
        self.force, self.force_x, self.force_y = (
            np.array([(value * weight * lever).sum() for value in values]) for lever in (np.ones_like(X), X, Y)
        )

    def coefficients(self, nu: float) -> tuple[float, float, float, float, float]:
        """Returns C11, C22, C23, -C32, C33."""
        even, odd = slice(0, self.even), slice(self.even, None)
        x, y, none = self.a * self.X, self.b * self.Y, 0 * self.X
        p, _ = self._solve(nu, even, odd, x, none)
        C11 = -self.force[even] @ p
        py = self._solve(nu, odd, even, none, x)
        C22, C32 = -self.force[even] @ py[1], self._moment(py)
        py = self._solve(nu, odd, even, -x * y, x * x / 2)
        return C11, C22, -self.force[even] @ py[1], -C32, self._moment(py)

    def _moment(self, p: tuple[Array, Array]) -> float:
        even, odd = slice(0, self.even), slice(self.even, None)
        return -(self.a * self.force_x[even] @ p[1] - self.b * self.force_y[odd] @ p[0])

    def _solve(self, nu: float, px: slice, py: slice, ux: Array, uy: Array) -> tuple[Array, Array]:
        """Returns the shares of shapes of the given parities in px and py so that u = (ux, uy) + (f(y), g(y))."""
        one, cc, cs = self.integrals
        xx, yy, xy = (1 - nu) * one + nu * cc, one - nu * cc, nu * cs
        PY = legendre(self.order + 2, self.Y)
        # In each direction u has the parity of the traction in that direction.
        f, g = (np.stack(PY[int(part.start > 0) :: 2], 1) for part in (px, py))
        zero_f, zero_g = np.zeros_like(f), np.zeros_like(g)
        system = np.block([[xx[:, px], xy[:, py], f, zero_g], [xy[:, px], yy[:, py], zero_f, g]])
        weight = np.tile(self.weight, 2)
        share = np.linalg.lstsq(system * weight[:, None], np.concatenate([ux, uy]) * weight, rcond=1e-13)[0]
        n = xx[:, px].shape[1]
        return share[:n], share[n : n + xx[:, py].shape[1]]


def converge() -> None:
    print("a/b nu order C11 C22 C23 -C32 C33")
    for ratio in (RATIOS[0], 0.1, 1.0, 10.0, RATIOS[-1]):
        for order in (8, 10, 12, 14, 16):
            ellipse = Ellipse(ratio, order)
            for nu in (0.0, 0.25, 0.5):
                print(ratio, nu, order, *(f"{c:.5f}" for c in ellipse.coefficients(nu)), flush=True)


def table() -> None:
    print("// Lists Kalker's creepage coefficients. Generated by bench/kalker_coefficients.py; do not edit.")
    print("#pragma once\n\n#include <array>\n\nnamespace contactd {\n")
    print("inline constexpr double kalker_log2_step = 0.5;  // between rows, whose first log2(a/b) is -5")
    print(f"inline constexpr std::array<double, {len(NUS)}> kalker_nu{{{', '.join(map(str, NUS))}}};\n")
    print("// [a/b][nu] of C11, C22, C23, C33; -C32 = C23.")
    print(f"inline constexpr double kalker_table[{len(RATIOS)}][{len(NUS)}][4] = {{")
    for ratio in RATIOS:
        ellipse = Ellipse(ratio, 16)
        print(f"    // a/b = {ratio:.6g}")
        rows = []
        for nu in NUS:
            C11, C22, C23, C32, C33 = ellipse.coefficients(nu)
            rows.append("{" + ", ".join(f"{c:.6g}" for c in (C11, C22, (C23 + C32) / 2, C33)) + "}")
        print("    {" + ",\n     ".join(rows) + "},", flush=True)
    print("};\n\n}  // namespace contactd")


if __name__ == "__main__":
    converge() if sys.argv[1:] == ["--converge"] else table()
