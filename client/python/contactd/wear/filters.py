"""What a step may leave of a depth over the length of a section, so that steps are stable.

A groove z' of wavelength L takes off pressure pi E* z'/L, depths follow pressure, and so an explicit step of depth h multiplies
it by 1 - q, q = pi E* h/(L pm), pm the mean pressure: it grows where q > 2. Filters work on depths, never on sections, have
gain 1 for what is uniform, and reflect at both ends, so that no area is lost.
"""

from __future__ import annotations

import math
from collections.abc import Callable

import numpy as np
import numpy.typing as npt

__all__ = ["critical_depth", "exponential_step", "smoothed", "smoothing_length"]

Array = npt.NDArray[np.float64]


def critical_depth(wavelength: float, mean_pressure: float, modulus: float) -> float:
    """The largest depth of a step (mm) in which a groove of a wavelength (mm) does not grow, by pressure; partial slip bears
    1.65 times less. `modulus` is E*, 1/E* = sum (1 - nu^2)/E of both bodies (N/mm^2)."""
    return 2 * mean_pressure * wavelength / (math.pi * modulus)


def smoothing_length(depth: float, mean_pressure: float, modulus: float) -> float:
    """The wavelength (mm) of which a stable smoothing leaves half in a step of this depth."""
    return math.pi * modulus * depth / (2 * mean_pressure)


def exponential_step(depths: npt.ArrayLike, size: float, depth: float, mean_pressure: float, modulus: float) -> Array:
    """What a step of `depth` (mm) takes off while grooves wear down in it as in many small ones: each wavelength times
    (1 - exp(-q))/q. So a groove is left by the share exp(-q), and no step is too large for it. Of cells of one `size` (mm)."""
    scale = math.pi * modulus * depth / mean_pressure  # q times the wavelength

    def gain(waves: Array) -> Array:
        q = scale * waves
        return np.where(q > 0, -np.expm1(-q) / np.where(q > 0, q, 1.0), 1.0)

    return _filtered(depths, size, gain)


def smoothed(depths: npt.ArrayLike, size: float, length: float) -> Array:
    """Depths convolved with a Gaussian of sum 1, which leaves half the amplitude of waves of `length` (mm)."""
    return _filtered(depths, size, lambda waves: np.exp(-math.log(2) * (length * waves) ** 2))


def _filtered(depths: npt.ArrayLike, size: float, gain: Callable[[Array], Array]) -> Array:
    """Even continuation makes reflecting ends."""
    values = np.asarray(depths, dtype=np.float64)
    doubled = np.concatenate([values, values[::-1]])
    waves: Array = np.asarray(np.fft.rfftfreq(len(doubled), size), dtype=np.float64)
    return np.fft.irfft(np.fft.rfft(doubled) * gain(waves), len(doubled))[: len(values)]
