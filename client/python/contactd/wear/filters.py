"""Filters of wear depths along a section that make steps stable.

A groove z' of wavelength L reduces the pressure by pi E* z'/L, and wear depths follow the pressure. So an explicit step
of depth h multiplies the groove by 1 - q, q = pi E* h/(L pm), with pm the mean pressure; it grows if q > 2. Filters are
applied to depths, never to sections. They keep uniform depths, and reflect at both ends, so that the area is conserved.
"""

from __future__ import annotations

import math
from collections.abc import Callable

import numpy as np
import numpy.typing as npt

__all__ = ["critical_depth", "exponential_step", "smoothed", "smoothing_length"]

Array = npt.NDArray[np.float64]


def critical_depth(wavelength: float, mean_pressure: float, modulus: float) -> float:
    """Returns the largest depth of a step (mm) for which a groove of a wavelength (mm) does not grow due to pressure;
    partial slip allows 1.65 times less. `modulus` is E*, 1/E* = sum (1 - nu^2)/E of both bodies (N/mm^2).
    """
    return 2 * mean_pressure * wavelength / (math.pi * modulus)


def smoothing_length(depth: float, mean_pressure: float, modulus: float) -> float:
    """Returns the wavelength (mm) that a stable smoothing must halve in a step of this depth."""
    return math.pi * modulus * depth / (2 * mean_pressure)


def exponential_step(depths: npt.ArrayLike, size: float, depth: float, mean_pressure: float, modulus: float) -> Array:
    """Returns the depths removed in a step of `depth` (mm) if grooves decay as in many small steps: each wavelength is
    multiplied by (1 - exp(-q))/q. A groove then decays by exp(-q), and no step is too large for it. `size` is that of
    the cells (mm).
    """
    scale = math.pi * modulus * depth / mean_pressure  # q times the wavelength

    def gain(waves: Array) -> Array:
        q = scale * waves
        return np.where(q > 0, -np.expm1(-q) / np.where(q > 0, q, 1.0), 1.0)

    return _filtered(depths, size, gain)


def smoothed(depths: npt.ArrayLike, size: float, length: float) -> Array:
    """Returns the depths convolved with a Gaussian of sum 1, which halves the amplitude of waves of `length` (mm)."""
    return _filtered(depths, size, lambda waves: np.exp(-math.log(2) * (length * waves) ** 2))


def _filtered(depths: npt.ArrayLike, size: float, gain: Callable[[Array], Array]) -> Array:
    """Filters with an even continuation, which reflects at the ends."""
    values = np.asarray(depths, dtype=np.float64)
    doubled = np.concatenate([values, values[::-1]])
    waves: Array = np.asarray(np.fft.rfftfreq(len(doubled), size), dtype=np.float64)
    return np.fft.irfft(np.fft.rfft(doubled) * gain(waves), len(doubled))[: len(values)]
