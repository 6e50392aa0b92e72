"""How deep a step may be, and how far it must be smoothed, so that no groove grows in it.

A groove z' takes off pressure pi E* z'/(L pm), of waves L that are short beside the rows of a contact; of longer ones the row is
a line load, whose stiffness hardly falls any more: L is 2 l log(1 + L/(2 l)) then, l the length of a row. So waves as long as a
contact is wide grow, too, where rows are short, and no smoothing that leaves the contact its width keeps them: the step must.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
import numpy.typing as npt

__all__ = ["LoadedRows", "Stiffness"]

Array = npt.NDArray[np.float64]

_MOST = 1.03  #: of a groove that a step may take off, by pressure; in partial slip it is up to 1.65 times that, and 2 is too much
_PARTIAL_SLIP = 1.65
_SHORTEST = 0.1  #: wave (mm)


@dataclass(frozen=True)
class LoadedRows:
    """The rows of a contact together.

    Attributes:
        area: What they wear off, or any number in proportion to it.
        pressure: Their mean pressure (N/mm^2).
        length: Their mean length, along the track (mm).
        width: How far they reach across it (mm).
    """

    area: float
    pressure: float
    length: float
    width: float


class Stiffness:
    """What a groove takes off, of its own size, in a step of unit depth, by its wavelength: pi E* times the mean of 1/(L pm) over
    contacts, by what they wear off."""

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
        """The deepest step (mm) that is stable with waves as long as contacts are wide."""
        return _MOST / float(self._change[-1])

    def smoothing(self, depth: float) -> float:
        """The wavelength (mm) of which half must be smoothed away in a step of this depth, which is not beyond `deepest`."""
        low, high = 0.0, 2 * self._longest
        for _ in range(50):
            middle = 0.5 * (low + high)
            low, high = (middle, high) if self._largest(depth, middle) > _MOST else (low, middle)
        return high

    def is_stable(self, depth: float, length: float) -> bool:
        """Tells if no groove grows in a step that is smoothed by a wavelength (mm), in partial slip neither."""
        return _PARTIAL_SLIP * self._largest(depth, length) <= 2

    def _largest(self, depth: float, length: float) -> float:
        return float((depth * self._change * np.exp(-math.log(2) * (length / self._waves) ** 2)).max())
