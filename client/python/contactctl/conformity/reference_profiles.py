"""Profiles of the benchmark of EN 15302: wheels A, B, H and I, and rail A, built from radii, joints and kinks."""

from __future__ import annotations

import math
from collections.abc import Iterable
from dataclasses import dataclass

import numpy as np

from contactd.values.arrays import Array

__all__ = ["RAIL", "WHEELS", "Outline", "points_of"]


@dataclass(frozen=True)
class Piece:
    """A straight line, or an arc. It is tangent to the previous piece unless `slope` is given.

    Attributes:
        end: y of its end (mm).
        radius: Radius (mm), positive where dz/dy grows with y; None for a straight line.
        slope: dz/dy behind a kink at its start; None without a kink.
    """

    end: float
    radius: float | None = None
    slope: float | None = None


@dataclass(frozen=True)
class Outline:
    """A profile through the origin, with y to the field side and z downwards.

    Attributes:
        slope: dz/dy at y = 0.
        inwards: Pieces from y = 0 towards the flange or the gauge face.
        outwards: Pieces from y = 0 towards the field side.
    """

    slope: float
    inwards: tuple[Piece, ...]
    outwards: tuple[Piece, ...]


_FLANGE = (Piece(-49.6625, -20), Piece(-62.7647, -12), Piece(-70, -20.5))


def _flange(start: float) -> tuple[Piece, ...]:
    """Returns the flange above its root, from the end of its straight line at 70 degrees."""
    return (Piece(start), *_FLANGE)


def _chamfer(slope: float) -> tuple[Piece, ...]:
    return Piece(60, slope=slope), Piece(65, slope=-1)


#: The shapes are facts of EN 15302, annexes D (2008) and I (2021), as the public package rohrbecka/EN15302 has them.
WHEELS = {
    "A": Outline(
        -18.4173 / math.sqrt(345**2 - 18.4173**2),
        (Piece(-10.8749, 345), Piece(-29.4591, 96.76055), Piece(-38.7372, 14), *_flange(-39.7645)),
        (Piece(18.4173, 345), Piece(30), *_chamfer(-1 / 15)),
    ),
    "B": Outline(
        -1 / 40,
        (Piece(-0.4787), Piece(-29.3505, 120), Piece(-38.7879, 14), *_flange(-39.764)),
        (Piece(30), *_chamfer(-1 / 20)),
    ),
    "H": Outline(
        -1 / 40,
        (Piece(-10.2297), Piece(-28.3119, slope=-1 / 5), Piece(-38.722, 14), *_flange(-39.7645)),
        (Piece(30), *_chamfer(-1 / 15)),
    ),
    "I": Outline(
        -5 / math.sqrt(120**2 - 5**2),
        (Piece(-29.9231, 120), Piece(-39.0486, 14, slope=-0.3006), *_flange(-39.764)),
        (Piece(5, 120), Piece(30), *_chamfer(-1 / 15)),
    ),
}  # fmt: skip
#: It is 60E1 inclined by 1/20, within 0.004 mm.
RAIL = Outline(
    -17.5966 / math.sqrt(300**2 - 17.5966**2),
    (Piece(-7.8749, 300), Piece(-23.2401, 80), Piece(-32.634, 13)),
    (Piece(13.0989, 300), Piece(28.6709, 80), Piece(39.2705, 13)),
)


def points_of(outline: Outline, spacing: float = 0.2) -> Array:
    """Returns points (y, z) of a profile at most `spacing` (mm) apart, from the flange or gauge face outwards, shape
    [n, 2]. Joints and kinks are points.
    """
    inwards, outwards = (_walk(outline.slope, pieces, spacing) for pieces in (outline.inwards, outline.outwards))
    return np.array([*reversed(inwards), (0.0, 0.0), *outwards])


def _walk(slope: float, pieces: Iterable[Piece], spacing: float) -> list[tuple[float, float]]:
    y, z, angle = 0.0, 0.0, math.atan(slope)
    points = []
    for piece in pieces:
        if piece.slope is not None:
            angle = math.atan(piece.slope)
        if piece.radius is None:
            length, run, rise = abs(piece.end - y) / math.cos(angle), piece.end - y, (piece.end - y) * math.tan(angle)
            count = math.ceil(length / spacing)
            points += [(y + run * k / count, z + rise * k / count) for k in range(1, count + 1)]
        else:
            radius, start = piece.radius, angle
            # Rounded data may reach slightly beyond the end of an arc.
            angle = math.asin(min(max(math.sin(start) + (piece.end - y) / radius, -1), 1))
            count = math.ceil(abs(radius * (angle - start)) / spacing)
            angles = [start + (angle - start) * k / count for k in range(1, count + 1)]
            points += [(y + radius * (math.sin(at) - math.sin(start)), z + radius * (math.cos(start) - math.cos(at))) for at in angles]
        y, z = points[-1]
    return points
