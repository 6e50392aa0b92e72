"""Means over a window that slides along the track."""

from __future__ import annotations

import numpy as np

from contactd.values.arrays import Array

__all__ = ["sliding_means"]


def sliding_means(distance: Array, values: Array, window: float, step: float) -> tuple[Array, Array]:
    """Returns the centres of windows inside the run, `step` apart, and the means of the values over them. The values
    are linear between their places, and their integrals exact. `distance` increases. Shape [m] each.

    Raises ValueError if the run is shorter than the window.
    """
    length = float(distance[-1] - distance[0])
    if length < window:
        raise ValueError(f"it is {length:g} mm long, shorter than a window of {window:g} mm")
    count = int((length - window) / step * (1 + 1e-12)) + 1
    starts = distance[0] + step * np.arange(count)
    ends = np.minimum(starts + window, distance[-1])
    means = (_integral(distance, values, ends) - _integral(distance, values, starts)) / (ends - starts)
    centres: Array = (starts + ends) / 2
    return centres, means


def _integral(distance: Array, values: Array, places: Array) -> Array:
    """Returns the integrals from the first distance to each place."""
    widths = np.diff(distance)
    whole = np.concatenate(([0.0], np.cumsum(widths * (values[1:] + values[:-1]) / 2)))
    interval = np.clip(np.searchsorted(distance, places, side="right") - 1, 0, len(widths) - 1)
    into = places - distance[interval]
    slope = (values[interval + 1] - values[interval]) / widths[interval]
    found: Array = whole[interval] + into * (values[interval] + into / 2 * slope)
    return found
