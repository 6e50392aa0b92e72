"""Determines depth and smoothing of steps for which no groove grows.

A groove z' reduces the relative pressure by pi E* z'/(L pm) if its wavelength L is shorter than the rows of a contact.
For longer waves, the row acts as a line load, and its stiffness hardly decreases: L is replaced by 2 l log(1 + L/(2
l)), with l the length of a row. So with short rows, waves as long as the width of a contact grow, too. Smoothing cannot
suppress them without widening the contact, so the depth of the step must be limited.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
import numpy.typing as npt

__all__ = ["LoadedRows", "Stiffness"]

Array = npt.NDArray[np.float64]

_MOST = 1.03  #: Fraction of a groove that a step may remove; times 1.65 in partial slip, and below 2.
_PARTIAL_SLIP = 1.65
_SHORTEST = 0.1  #: Wavelength (mm).


@dataclass(frozen=True)
class LoadedRows:
    """Holds the rows of a contact together.

    Attributes:
        area: The area that they remove, or a number proportional to it.
        pressure: Their mean pressure (N/mm^2).
        length: Their mean length along the track (mm).
        width: Their total width across the track (mm).
    """

    area: float
    pressure: float
    length: float
    width: float


class Stiffness:
    """Computes the relative reduction of a groove in a step of unit depth, by its wavelength: pi E* times the mean of
    1/(L pm) over contacts, weighted with their wear.
    """

    def __init__(self, contacts: Sequence[LoadedRows], modulus: float) -> None:
        total = sum(contact.area for contact in contacts)
        self.pressure = sum(contact.area * contact.pressure for contact in contacts) / total
        self._longest = max(sum(contact.area * contact.width for contact in contacts) / total, 2 * _SHORTEST)
        self._waves: Array = np.asarray(np.geomspace(_SHORTEST, self._longest, 200), dtype=np.float64)
        self._change = np.zeros(len(self._waves))
        for contact in contacts:
            effective = 2 * contact.length * np.log1p(self._waves / (2 * contact.length))
            self._change += contact.area / total * math.pi * modulus / (effective * contact.pressure)

    @property
    def deepest(self) -> float:
        """The deepest step (mm) that is stable for waves as long as contacts are wide."""
        return _MOST / float(self._change[-1])

    def smoothing(self, depth: float) -> float:
        """Returns the wavelength (mm) that smoothing must halve in a step of this depth, at most `deepest`."""
        low, high = 0.0, 2 * self._longest
        for _ in range(50):
            middle = 0.5 * (low + high)
            low, high = (middle, high) if self._largest(depth, middle) > _MOST else (low, middle)
        return high

    def is_stable(self, depth: float, length: float) -> bool:
        """Returns whether no groove grows in a step smoothed by a wavelength (mm), including partial slip."""
        return _PARTIAL_SLIP * self._largest(depth, length) <= 2

    def _largest(self, depth: float, length: float) -> float:
        return float((depth * self._change * np.exp(-math.log(2) * (length / self._waves) ** 2)).max())
