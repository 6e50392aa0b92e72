"""The processing of EN 15610:2009 before a spectrum: spikes are removed, and a small wheel is rolled over the record.

One source: its clauses 7.2 and 7.3 as described by the public package phonometry (jmrplens/phonometry).
"""

from __future__ import annotations

import math

import numpy as np

from ..errors import invalid
from ..values.arrays import Array
from .records import Record

__all__ = ["COARSEST", "RADIUS", "rolled", "without_spikes"]

COARSEST = 1.0  #: Largest distance of samples (mm).
RADIUS = 375.0  #: Radius of the rolled circle (mm).
_BEND = -1e-2  #: Second derivative below which a crest is a spike (1/mm).
_SLOPE = 5e-3  #: Slope below which the sides of a spike end.
_LENGTH = 3000.0  #: A spike of width w is removed if it is higher than w^2 over this length (mm).


def without_spikes(record: Record) -> Record:
    """Returns the record with its narrow upward spikes, which are dirt, replaced by straight lines (EN 15610, 7.2).

    A spike is a crest with a second derivative below -1e7 um/m^2. Its sides end where the slope is below 5e3 um/m. It
    is removed if it is higher above the line between these places than w^2/(3 m) for the width w. Passes are repeated
    until none is found. Raises InvalidArgument if samples are more than 1 mm apart.
    """
    _check(record)
    lines = np.array(record.heights)
    for line in lines:
        while found := _spikes(line, record.spacing):
            for left, right in found:
                line[left : right + 1] = np.linspace(line[left], line[right], right - left + 1)
    return record.with_heights(lines)


def rolled(record: Record, radius: float = RADIUS) -> Record:
    """Returns the path of a circle that is rolled over the record (EN 15610, 7.3), by which a wheel bridges pits that a
    probe reaches: r'(x) = max over u of r(x + u) - (R - sqrt(R^2 - u^2)).

    Full solves compute the bridging themselves: give them the record before the circle. Raises InvalidArgument if
    samples are more than 1 mm apart.
    """
    _check(record)
    if not radius > 0:
        raise invalid("radius", f"= {radius} mm: the radius of the circle must be positive. Use {RADIUS:g} mm as in EN 15610.")
    size = record.heights.shape[1]
    highest = np.array(record.heights)
    depth = min(float(np.ptp(record.heights, axis=1).max()), radius)
    reach = min(int(math.sqrt(depth * (2 * radius - depth)) / record.spacing), size - 1)
    for k in range(1, reach + 1):
        drop = radius - math.sqrt(radius**2 - (k * record.spacing) ** 2)
        np.maximum(highest[:, k:], record.heights[:, : size - k] - drop, out=highest[:, k:])
        np.maximum(highest[:, : size - k], record.heights[:, k:] - drop, out=highest[:, : size - k])
    return record.with_heights(highest)


def _check(record: Record) -> None:
    if record.spacing > COARSEST * (1 + 1e-9):
        raise invalid("spacing", f"= {record.spacing:g} mm: EN 15610 requires samples at most {COARSEST:g} mm apart. Omit its processing, or measure again.")


def _spikes(line: Array, spacing: float) -> list[tuple[int, int]]:
    """Returns the first and last samples of spikes that do not overlap; heights and spacing are in mm."""
    slope = np.gradient(line, spacing)
    bend = np.zeros_like(line)
    bend[1:-1] = (line[2:] - 2 * line[1:-1] + line[:-2]) / spacing**2
    crest = bend < _BEND * (1 + 1e-9)
    crest[1:-1] &= np.sign(slope[:-2]) != np.sign(slope[2:])
    flat = np.flatnonzero(np.abs(slope) < _SLOPE * (1 - 1e-9))
    found: list[tuple[int, int]] = []
    for at in np.flatnonzero(crest):
        before, after = np.searchsorted(flat, at), np.searchsorted(flat, at, side="right")
        left = int(flat[before - 1]) if before > 0 else 0
        right = int(flat[after]) if after < len(flat) else len(line) - 1
        base = line[left] + (line[right] - line[left]) * (at - left) / (right - left)
        if line[at] - base > ((right - left) * spacing) ** 2 / _LENGTH and (not found or found[-1][1] <= left):
            found.append((left, right))
    return found
