"""Describes irregularities of wheel and rail as heights along the path of the contact.

A height (m) is positive towards the other body: a bump of the rail, or a bump of the wheel. It adds to the approach.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Literal, Protocol

import numpy as np
import numpy.typing as npt

from ..errors import invalid
from .checks import Array, check_number, checked_array, refused

__all__ = ["DippedJoint", "Flat", "Irregularity", "Record", "height_at"]

_LENGTHS = {"m": 1.0, "mm": 1e-3, "um": 1e-6}
_HIGHEST = 0.05  #: Largest height of a record (m).
_MOST_POSITIONS = 1_000_000  #: Positions at which the resolution of a record is checked.


class Irregularity(Protocol):
    """A height along the rail."""

    def height(self, x: Array) -> Array:
        """Returns the height (m) at positions (m)."""

    def unresolved(self, step: float) -> float:
        """Returns the height (m) that steps of this length (m) miss."""


def height_at(irregularities: Sequence[Irregularity], x: npt.ArrayLike) -> Array:
    """Returns the sum of the heights (m) at positions (m)."""
    positions = np.asarray(x, dtype=np.float64)
    return sum((one.height(positions) for one in irregularities), np.zeros(positions.shape))


class Record:
    """A record of heights over positions: roughness, or the path of the contact over a crossing.

    Between samples the height is a cubic with the slopes of the neighbours; beyond its ends it is that of the end. To
    contain the filter of the contact, a record for Hertz's law must be filtered first. A positive height points to the
    other body: rail heights upwards, wheel radii outwards.

    Args:
        x: Increasing positions.
        heights: One height per position.
        x_unit: Unit of x.
        unit: Unit of heights.
    """

    def __init__(self, x: npt.ArrayLike, heights: npt.ArrayLike, *, x_unit: Literal["m", "mm"], unit: Literal["um", "mm", "m"]) -> None:
        for name, given, units in (("x_unit", x_unit, ("m", "mm")), ("unit", unit, ("um", "mm", "m"))):
            if given not in units:
                raise refused(name, given, f"give one of {', '.join(units)}.")
        self.x: Array = checked_array("x", x, 2) * _LENGTHS[x_unit]
        self.heights: Array = checked_array("heights", heights, 2) * _LENGTHS[unit]
        if len(self.x) != len(self.heights):
            raise invalid("heights", f"has {len(self.heights)} values for {len(self.x)} positions. Give one per position.")
        steps = np.diff(self.x)
        if (steps <= 0).any():
            index = int(np.argmax(steps <= 0)) + 1
            raise refused(f"x[{index}]", float(self.x[index]), "positions must increase. Sort the record, and remove repeated positions.")
        if (highest := float(np.abs(self.heights).max())) > _HIGHEST:
            raise refused("heights", highest, f"heights (m) must be below {_HIGHEST:g} m. Did you give another unit than {unit}?")
        self._slopes = np.gradient(self.heights, self.x)

    def height(self, x: Array) -> Array:
        """Returns the height (m) at positions (m)."""
        at = np.clip(x, self.x[0], self.x[-1])
        i = np.clip(np.searchsorted(self.x, at, side="right") - 1, 0, len(self.x) - 2)
        width = self.x[i + 1] - self.x[i]
        s = (at - self.x[i]) / width
        found: Array = (
            self.heights[i] * (1 + 2 * s) * (1 - s) ** 2 + self._slopes[i] * width * s * (1 - s) ** 2
            + self.heights[i + 1] * s**2 * (3 - 2 * s) - self._slopes[i + 1] * width * s**2 * (1 - s)
        )  # fmt: skip
        return found

    def unresolved(self, step: float) -> float:
        """Returns the root mean square (m) of what a cubic through the heights after steps (m) misses between them."""
        count = int((self.x[-1] - self.x[0]) / step)
        if count < 4:
            return float(np.std(self.heights))
        at = self.x[0] + step * np.arange(min(count, _MOST_POSITIONS))
        h, between = self.height(at), self.height(at[1:-2] + 0.5 * step)
        return float(np.sqrt(np.mean((between - (9 * (h[1:-2] + h[2:-1]) - h[:-3] - h[3:]) / 16) ** 2)))


@dataclass(frozen=True)
class Flat:
    """A flat of the wheel, as the drop of the wheel's centre while it rolls over it.

    "fresh": a chord with sharp edges, on which the wheel pivots about one edge and then the other: the drop is
    s^2/(2 R) to the middle, then mirrored. "rounded": d/2 (1 - cos(2 pi s/length)) with d = length^2/(16 R).

    Attributes:
        length: Length of the flat (m).
        radius: Radius of the wheel (m).
        at: Position (m) at which the flat begins to touch the rail.
        shape: Its shape.
        every_turn: Whether it returns with each turn of the wheel, also before `at`.
    """

    length: float
    radius: float
    at: float
    shape: Literal["fresh", "rounded"] = "rounded"
    every_turn: bool = False

    def __post_init__(self) -> None:
        """Raises InvalidArgument naming an invalid field."""
        check_number("flat.radius", self.radius, "m", 0.05, 2, "Did you give mm?")
        check_number("flat.length", self.length, "m", 1e-3, 0.5 * self.radius, "It is at most half the radius; did you give mm?")
        check_number("flat.at", self.at, "m", -1e6, 1e6)
        if self.shape not in ("fresh", "rounded"):
            raise refused("flat.shape", self.shape, "give fresh or rounded.")

    def unresolved(self, step: float) -> float:
        """Returns the depth (m) if steps are longer than a twentieth of its length."""
        return self.length**2 / (8 * self.radius) if step > self.length / 20 else 0.0

    def height(self, x: Array) -> Array:
        """Returns the height (m) at positions (m)."""
        s = x - self.at
        if self.every_turn:
            s = s % (2 * math.pi * self.radius)
        inside = (s > 0) & (s < self.length)
        if self.shape == "fresh":
            drop = np.minimum(s, self.length - s) ** 2 / (2 * self.radius)
        else:
            drop = self.length**2 / (32 * self.radius) * (1 - np.cos(2 * math.pi * s / self.length))
        return np.where(inside, -drop, 0.0)


@dataclass(frozen=True)
class DippedJoint:
    """A dipped joint: two straight ramps that meet at an angle.

    Attributes:
        at: Position of the joint (m).
        angle: Total angle between the ramps (rad), 2 alpha.
        ramp: Length of each ramp (m).
    """

    at: float
    angle: float
    ramp: float = 0.5

    def __post_init__(self) -> None:
        """Raises InvalidArgument naming an invalid field."""
        check_number("joint.at", self.at, "m", -1e6, 1e6)
        check_number("joint.angle", self.angle, "rad", 0, 0.1, "Did you give milliradians or degrees?")
        check_number("joint.ramp", self.ramp, "m", 0.01, 10)

    def unresolved(self, step: float) -> float:
        """Returns the depth (m) if steps are longer than a twentieth of a ramp."""
        return 0.5 * self.angle * self.ramp if step > self.ramp / 20 else 0.0

    def height(self, x: Array) -> Array:
        """Returns the height (m) at positions (m)."""
        found: Array = -0.5 * self.angle * np.maximum(self.ramp - np.abs(x - self.at), 0.0)
        return found
