"""Computes third-octave spectra of forces."""

from __future__ import annotations

import math

import numpy as np
import numpy.typing as npt

from ..errors import invalid
from ..values.periodogram import mean_squares
from .checks import Array, check_number, checked_array

__all__ = ["third_octaves"]


def third_octaves(values: npt.ArrayLike, rate: float, low: float = 20.0, high: float = 5000.0, segment: float = 0.5) -> tuple[Array, Array]:
    """Returns centre frequencies (Hz) and root mean squares of third octaves (base ten), without the mean.

    Periodograms of Hann-weighted segments, half overlapping, are averaged; bands share the lines at their edges.

    Args:
        values: Equidistant values, such as the force (N).
        rate: Values per second (Hz).
        low: Centre of the lowest band (Hz), at least 4 over the length of a segment.
        high: Centre of the highest band (Hz), at most 0.4 of the rate.
        segment: Length of segments (s); at most that of the values.
    """
    given = checked_array("values", values, 16)
    check_number("rate", rate, "Hz", 1e-3, 1e9)
    count = min(len(given), max(16, round(segment * rate)))
    check_number("low", low, "Hz", 4 * rate / count * (1 - 1e-9), 0.4 * rate, "Use longer segments, or a longer run.")
    check_number("high", high, "Hz", low, 0.4 * rate, "Use a higher sampling rate.")
    starts = range(0, len(given) - count + 1, max(1, count // 2))
    centred = given - given.mean()
    power = mean_squares(np.stack([centred[start : start + count] for start in starts]))
    edges = rate / count * (np.arange(len(power) + 1) - 0.5)
    centres = 10 ** (np.arange(math.ceil(10 * math.log10(low) - 0.5), math.floor(10 * math.log10(high) + 0.5) + 1) / 10)
    sums = np.concatenate([[0.0], np.cumsum(power)])
    bands = [np.diff(np.interp([centre * 10**-0.05, centre * 10**0.05], edges, sums))[0] for centre in centres]
    if not len(centres):
        raise invalid("high", "leaves no band. Give a larger range of frequencies.")
    return centres, np.sqrt(np.maximum(bands, 0.0))
