"""Chooses the length of a step, and computes the wear of a section in it."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence

import numpy as np
import numpy.typing as npt

from .filters import exponential_step, smoothed
from .section import WornPart
from .stability import LoadedRows, Stiffness

__all__ = ["PartStep", "common_distance"]

Array = npt.NDArray[np.float64]


class PartStep:
    """Represents a step of a section, of any distance up to its maximum."""

    def __init__(
        self, rate: Array, size: float, contacts: Sequence[LoadedRows], modulus: float, depth: float, smoothing: float | str
    ) -> None:
        """Takes the wear `rate` of cells of a `size` (mm) per unit of distance, and the largest `depth` of a step
        (mm).
        """
        self._rate, self._size, self._modulus, self._depth, self._smoothing = rate, size, modulus, depth, smoothing
        self._stiffness = Stiffness(contacts, modulus) if contacts else None

    @property
    def pressure(self) -> float:
        """The mean pressure for the stability criterion (N/mm^2)."""
        return 0.0 if self._stiffness is None else self._stiffness.pressure

    @property
    def is_bounded_by_stability(self) -> bool:
        """True if stability limits the depth of a step more than its maximum does."""
        return self._stiffness is not None and self._is_free and self._stiffness.deepest < self._depth

    @property
    def farthest(self) -> float:
        """The distance at which the step has its largest depth; infinite without wear."""
        if self._stiffness is None:
            return math.inf
        deepest = min(self._depth, self._stiffness.deepest) if self._is_free else self._depth
        taken, _ = self._filtered(deepest)
        return float(deepest / taken.max())

    def taken(self, distance: float) -> tuple[Array, float, list[str]]:
        """Returns the depths of a step over a distance up to the farthest, the smoothed wavelength, and sentences about
        limitations.
        """
        stiffness = self._stiffness
        if stiffness is None:
            return np.zeros(len(self._rate)), 0.0, []
        if distance == self.farthest:
            deepest = min(self._depth, stiffness.deepest) if self._is_free else self._depth
            taken, length = self._filtered(deepest)
        else:  # A shorter step is smoothed less.
            taken, length = self._filtered(distance * float(self._rate.max()))
            for _ in range(3):
                taken, length = self._filtered(distance * float(taken.max()))
        depth = distance * float(taken.max())
        warnings = []
        if not self._is_free and not stiffness.is_stable(depth, length):
            warnings.append(
                f"In a step of {depth:.3g} mm under {stiffness.pressure:.3g} N/mm^2 grooves grow that smoothing by {length:g} mm does not remove: " "use smaller steps, or smoothing auto."
            )
        return np.asarray(taken * distance), float(length), warnings

    @property
    def _is_free(self) -> bool:
        return self._smoothing in ("auto", "exponential_step")

    def _filtered(self, depth: float) -> tuple[Array, float]:
        stiffness = self._stiffness
        assert stiffness is not None
        if self._smoothing == "exponential_step":
            return exponential_step(self._rate, self._size, depth, stiffness.pressure, self._modulus), 0.0
        if self._smoothing == "auto":
            length = stiffness.smoothing(min(depth, stiffness.deepest))
        else:
            length = float(self._smoothing)
        return (smoothed(self._rate, self._size, length) if length > 0 else self._rate), length


def common_distance(parts: Mapping[WornPart, PartStep], left: float, most: float | None) -> tuple[float, str]:
    """Returns the distance of a step of all parts together, and the reason for its end (WornStep.ended_by). `left` is
    the distance to the study's end, `most` the largest distance of a step.
    """
    bounds = [(left, "until"), (math.inf if most is None else most, "distance")]
    for name, part in parts.items():
        bound = "stability" if part.is_bounded_by_stability else "depth"
        bounds.append((part.farthest, bound if len(parts) == 1 else f"{bound} of the {name}"))
    return min(bounds, key=lambda bound: bound[0])
