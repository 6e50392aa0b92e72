"""A measured creep curve."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
import numpy.typing as npt

from ..errors import invalid
from ..values.arrays import Array

__all__ = ["MeasuredCurve"]


@dataclass(frozen=True, eq=False)
class MeasuredCurve:
    """Points of a curve.

    Attributes:
        creepage: Creepages, shape [m].
        value: Traction coefficients or forces, positive where they oppose a positive creepage, shape [m].
        weight: Weights of the residuals, shape [m].
    """

    creepage: Array
    value: Array
    weight: Array

    @staticmethod
    def of(creepage: npt.ArrayLike, measured: npt.ArrayLike, uncertainty: npt.ArrayLike | None) -> MeasuredCurve:
        """Creates the curve. Raises InvalidArgument for invalid values."""
        x, value = _numbers(creepage, "creepage"), _numbers(measured, "measured")
        if len(x) != len(value):
            raise invalid("measured", f"has {len(value)} values, but creepage has {len(x)}; their numbers must be equal")
        scale = float(np.max(np.abs(value)))
        if scale == 0:
            raise invalid("measured", "is zero everywhere, so there is nothing to fit")
        if float(np.sum(x * value)) < 0:
            raise invalid(
                "measured",
                "is negative where the creepage is positive; give it as a traction coefficient, positive against the slip",
            )
        if uncertainty is None:
            return MeasuredCurve(x, value, np.full(len(x), 1 / scale))
        sigma = _numbers(uncertainty, "uncertainty")
        if len(sigma) != len(x):
            raise invalid("uncertainty", f"has {len(sigma)} values, but creepage has {len(x)}; their numbers must be equal")
        if not np.all(sigma > 0):
            index = int(np.argmax(sigma <= 0))
            raise invalid(f"uncertainty[{index}]", f"is {sigma[index]:g}; standard uncertainties must be above 0")
        return MeasuredCurve(x, value, 1 / sigma)

    def residuals(self, computed: Array) -> Array:
        """Returns the weighted differences of the measured values and others."""
        return (self.value - computed) * self.weight


def _numbers(given: npt.ArrayLike, name: str) -> Array:
    try:
        found = np.asarray(given, dtype=float)
    except (TypeError, ValueError):
        raise invalid(name, "is not a list of numbers") from None
    if found.ndim != 1 or not len(found):
        raise invalid(name, f"has shape {list(found.shape)}; it must be a list of numbers")
    if not np.all(np.isfinite(found)):
        index = int(np.argmin(np.isfinite(found)))
        raise invalid(f"{name}[{index}]", f"is {found[index]}; every value must be finite")
    return found
