"""The spectrum of segments of a record, which roughness and forces share."""

from __future__ import annotations

import numpy as np

from .arrays import Array

__all__ = ["mean_squares"]


def mean_squares(segments: Array) -> Array:
    """Returns the mean square of each line of the spectrum, the mean over segments of shape [segments, values].

    Segments are multiplied by a Hann window. The scale makes the sum over all lines the mean square of the values, on
    average. Line i has i waves in a segment.
    """
    size = segments.shape[-1]
    window = 0.5 - 0.5 * np.cos(2 * np.pi * np.arange(size) / size)
    squares = np.abs(np.fft.rfft(segments * window, axis=-1)) ** 2 * 2 / (size * float(window @ window))
    if size % 2 == 0:
        squares[:, -1] /= 2
    return np.asarray(squares.mean(axis=0))
