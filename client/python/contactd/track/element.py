"""Provides the rail of one bay as a spectral element: Gauss-Lobatto points, matrices, and its local compliance.

Deflections w (downwards) and rotations t interpolate their values at the Gauss-Lobatto points of order ORDER. The strain
energy is 1/2 int EI t'^2 + S (w' - t)^2, and integrals are exact (Timoshenko; Ostachowicz et al., Guided Waves in
Structures for SHM, chapter 2, for spectral elements).
"""

from __future__ import annotations

import numpy as np
from numpy.polynomial import legendre

from .checks import Array
from .parameters import Rail

__all__ = ["ORDER", "beam_matrices", "clamped_compliance", "values_at"]

ORDER = 10


def _lobatto_points() -> Array:
    inner = legendre.legroots(legendre.legder([0.0] * ORDER + [1.0]))
    return np.concatenate([[-1.0], np.sort(inner.real), [1.0]])


_POINTS = _lobatto_points()
#: Coefficients of the interpolating polynomials in Legendre polynomials, one column per point.
_COEFFICIENTS = np.linalg.inv(legendre.legvander(_POINTS, ORDER))


def values_at(shares: Array) -> Array:
    """Returns the interpolating polynomials [position, point] at shares of the bay, from 0 to 1."""
    found: Array = legendre.legvander(2 * np.asarray(shares) - 1, ORDER) @ _COEFFICIENTS
    return found


def beam_matrices(rail: Rail, length: float) -> tuple[Array, Array]:
    """Returns the mass and stiffness of a bay; the unknowns are w at all points, then t."""
    at, weights = legendre.leggauss(ORDER + 1)
    scaled = weights * length / 2
    value = legendre.legvander(at, ORDER) @ _COEFFICIENTS
    slope = (2 / length) * np.stack([legendre.legval(at, legendre.legder(column)) for column in _COEFFICIENTS.T], axis=1)
    shear = np.hstack([slope, -value])
    none = np.zeros_like(value)
    bend, w, t = np.hstack([none, slope]), np.hstack([value, none]), np.hstack([none, value])
    mass = rail.mass * (w.T * scaled) @ w + rail.rotary_inertia * (t.T * scaled) @ t
    stiffness = rail.shear_stiffness * (shear.T * scaled) @ shear + rail.bending_stiffness * (bend.T * scaled) @ bend
    return mass, stiffness


def clamped_compliance(rail: Rail, length: float, loaded: Array, seen: Array) -> Array:
    """Returns the exact static deflection at `seen` (m, along the bay) of a bay clamped at both ends, per unit force at
    `loaded`. Arrays of the same shape; Timoshenko's beam.
    """
    # The beam is symmetric, so that positions beyond the load are mirrored.
    mirrored = seen > loaded
    a = np.where(mirrored, length - loaded, loaded)
    s = np.where(mirrored, length - seen, seen)
    tiny = 1e-9 * length
    a = np.clip(a, tiny, length - tiny)
    left, right = _end_stiffness(rail, a), _end_stiffness(rail, length - a)
    k11, k12, k22 = left[0] + right[0], right[1] - left[1], left[2] + right[2]
    w = k22 / (k11 * k22 - k12**2)
    t = -k12 / (k11 * k22 - k12**2)
    # Left of the load t = b1 s + b2 s^2 and w' = t - (EI/S) t'', so w = b1 s^2/2 + b2 (s^3/3 - 2 (EI/S) s).
    ratio = rail.bending_stiffness / rail.shear_stiffness
    of_b1, of_b2 = a**2 / 2, a**3 / 3 - 2 * ratio * a
    b2 = (w - t * of_b1 / a) / (of_b2 - a * of_b1)
    b1 = t / a - b2 * a
    found: Array = b1 * s**2 / 2 + b2 * (s**3 / 3 - 2 * ratio * s)
    return found


def _end_stiffness(rail: Rail, length: Array) -> tuple[Array, Array, Array]:
    """Returns the stiffness of w, of w with t, and of t at the free end of a beam clamped at the other end."""
    bending = rail.bending_stiffness
    phi = 12 * bending / (rail.shear_stiffness * length**2)
    return 12 * bending / (length**3 * (1 + phi)), 6 * bending / (length**2 * (1 + phi)), (4 + phi) * bending / (length * (1 + phi))
