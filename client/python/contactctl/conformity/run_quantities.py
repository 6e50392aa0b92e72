"""Quantities of EN 14363 of a run: sums of lateral forces, and Y/Q, as sliding means with their limits."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass

import numpy as np

from contactd.values.arrays import Array

from .limits import prudhomme_limit
from .sliding_means import sliding_means

__all__ = ["Assessment", "Run", "RunLimits", "WheelsetForces", "assessed"]

_WINDOW, _STEP = 2000.0, 500.0  #: mm
_PERCENTILES = (0.15, 99.85)


@dataclass(frozen=True, eq=False)
class WheelsetForces:
    """Forces of a wheelset on its rails (N), shape [n] each.

    Attributes:
        name: Name of the wheelset; empty if the run has one.
        Yr, Yl: Lateral forces of the right and the left wheel, positive to the right.
        Qr, Ql: Vertical forces, positive downwards, above 0.
    """

    name: str
    Yr: Array
    Yl: Array
    Qr: Array
    Ql: Array


@dataclass(frozen=True, eq=False)
class Run:
    """A run.

    Attributes:
        distance: Distance along the track (mm), increasing, shape [n].
        wheelsets: Forces of its wheelsets.
    """

    distance: Array
    wheelsets: Sequence[WheelsetForces]


@dataclass(frozen=True)
class RunLimits:
    """Limits of a run.

    Attributes:
        ratio: Largest Y/Q.
        axle_load: Static vertical force of a wheelset (N); None: the mean over the run.
        track_factor: Factor of Prud'homme's limit.
    """

    ratio: float
    axle_load: float | None = None
    track_factor: float = 1.0


@dataclass(frozen=True, eq=False)
class Assessment:
    """Sliding means of a quantity, and their verdict.

    Attributes:
        name: Name of the quantity, with its wheelset.
        is_force: True for a sum of lateral forces (N), False for a ratio.
        places: Centres of the windows (mm), shape [m].
        means: Means over the windows, shape [m].
        extreme: Value to be compared with the limit: the largest size of a force, the largest ratio.
        place: Its place (mm).
        percentile: The same, without the 0.15 % of the means at each end.
        limit: Its limit.
    """

    name: str
    is_force: bool
    places: Array
    means: Array
    extreme: float
    place: float
    percentile: float
    limit: float

    @property
    def is_inside(self) -> bool:
        """Whether the extreme value does not exceed the limit."""
        return self.extreme <= self.limit


def assessed(run: Run, limits: RunLimits) -> list[Assessment]:
    """Returns the quantities of all wheelsets. Raises ValueError for a run shorter than a window."""
    return [one for wheelset in run.wheelsets for one in _of_wheelset(run.distance, wheelset, limits)]


def _of_wheelset(distance: Array, forces: WheelsetForces, limits: RunLimits) -> Iterator[Assessment]:
    load = float(_mean(distance, forces.Qr + forces.Ql)) if limits.axle_load is None else limits.axle_load
    of = f" of wheelset {forces.name}" if forces.name else ""
    yield _assessment(f"sum of Y{of}", distance, forces.Yr + forces.Yl, prudhomme_limit(load, limits.track_factor), is_force=True)
    # The flange pushes outwards, which is to the left for the left wheel.
    for side, ratio in (("right", forces.Yr / forces.Qr), ("left", -forces.Yl / forces.Ql)):
        yield _assessment(f"Y/Q, {side} wheel{of}", distance, ratio, limits.ratio, is_force=False)


def _assessment(name: str, distance: Array, values: Array, limit: float, *, is_force: bool) -> Assessment:
    places, means = sliding_means(distance, values, _WINDOW, _STEP)
    low, high = np.percentile(means, _PERCENTILES)
    sizes = np.abs(means) if is_force else means
    worst = int(np.argmax(sizes))
    percentile = max(abs(float(low)), abs(float(high))) if is_force else float(high)
    return Assessment(name, is_force, places, means, float(sizes[worst]), float(places[worst]), percentile, limit)


def _mean(distance: Array, values: Array) -> float:
    widths = np.diff(distance)
    return float(np.sum(widths * (values[1:] + values[:-1]) / 2) / np.sum(widths))
