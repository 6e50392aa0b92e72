"""Describes a varied parameter; its position between its bounds is a number from 0 to 1."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

from ..errors import invalid
from ..refusals import did_you_mean
from ..values.field_paths import get, parts

__all__ = ["VariedParameter", "varied"]

_RELATIVE_STEP = 1e-2  #: Step of differences: above the jumps when elements begin to slip, below the curvature.
_LINEAR_STEP = 3e-3


@dataclass(frozen=True)
class VariedParameter:
    """A field and its bounds.

    Attributes:
        path: Its field.
        low: Least value.
        high: Largest value.
        start: Start of the search, or None.
    """

    path: str
    low: float
    high: float
    start: float | None

    @property
    def is_logarithmic(self) -> bool:
        return self.low > 0

    @property
    def _span(self) -> float:
        return math.log(self.high / self.low) if self.is_logarithmic else self.high - self.low

    def value(self, place: float) -> float:
        """Returns the value at a position, which may be outside the bounds."""
        try:
            return self.low * math.exp(place * self._span) if self.is_logarithmic else self.low + place * self._span
        except OverflowError:
            return math.inf

    def place(self, value: float) -> float:
        """Returns the position of a value."""
        return (math.log(value / self.low) if self.is_logarithmic else value - self.low) / self._span

    def slope(self, place: float) -> float:
        """Returns the derivative of the value with respect to the position."""
        return self._span * (self.value(place) if self.is_logarithmic else 1.0)

    @property
    def step(self) -> float:
        """Returns the step of differences, as a change of the position."""
        return min(0.05, _RELATIVE_STEP / self._span) if self.is_logarithmic else _LINEAR_STEP


def varied(
    parameters: Mapping[str, tuple[float, float]], start: Mapping[str, float], params: Mapping[str, Any]
) -> list[VariedParameter]:
    """Returns the parameters of a fit. Without `start`, a parameter starts at its value in the problem if it is within
    the bounds. Raises InvalidArgument.
    """
    if not parameters:
        raise invalid("parameters", "is empty; give at least one field with its bounds, such as friction.mu: (0.1, 0.6)")
    if unknown := [path for path in start if path not in parameters]:
        raise invalid("start", f"has {unknown[0]}, which is not one of the parameters {', '.join(parameters)}.{did_you_mean(unknown[0], parameters)}")
    return [_varied(path, bounds, start.get(path), params) for path, bounds in parameters.items()]


def _varied(path: str, bounds: Any, start: float | None, params: Mapping[str, Any]) -> VariedParameter:
    try:
        parts(path)
    except ValueError as error:
        raise invalid("parameters", f"has an invalid name: {error}") from None
    try:
        low, high = (float(bound) for bound in bounds)
    except (TypeError, ValueError):
        raise invalid(f"parameters[{path!r}]", f"is {bounds!r}; it must be two numbers, the bounds") from None
    if not (math.isfinite(low) and math.isfinite(high) and low < high):
        raise invalid(f"parameters[{path!r}]", f"is {low:g} to {high:g}; it must be two finite numbers, the lower one first")
    if start is not None:
        if not low <= start <= high:
            raise invalid(f"start[{path!r}]", f"is {start:g}, outside its bounds {low:g} to {high:g}")
        return VariedParameter(path, low, high, float(start))
    there = get(params, path)
    is_number = isinstance(there, (int, float)) and not isinstance(there, bool)
    return VariedParameter(path, low, high, float(there) if is_number and low <= there <= high else None)
