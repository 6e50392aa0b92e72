"""Represents the section of a worn wheel or rail: positions of rows on it, their wear, and the new shape."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

import numpy as np
import numpy.typing as npt

from ..errors import invalid

__all__ = ["Section", "WornPart", "deposit"]

Array = npt.NDArray[np.float64]
WornPart = Literal["wheel", "rail"]

_FARTHEST = 5.0  #: Largest distance of a row from the section (mm): planes of patches leave it in hollows.


@dataclass(frozen=True, eq=False)
class Section:
    """A profile given by its points.

    Attributes:
        points: (y, z) from the gauge side to the field side (mm), z down, shape [n, 2].
        body: The side of the material: above the curve for a wheel, below it for a rail.
    """

    points: Array
    body: WornPart

    @classmethod
    def of(cls, points: npt.ArrayLike, body: WornPart, spacing: float | None = None) -> Section:
        """Creates the section through points from either end. With `spacing` (mm), adds points on a smooth curve until
        none are farther apart. Raises InvalidArgument if the points are not a curve.
        """
        given = np.array(points, dtype=np.float64)
        if given.ndim != 2 or given.shape[1] != 2 or len(given) < 3:
            raise invalid("points", f"has shape {list(given.shape)}; a section has at least three points (y, z)", "ARRAY_INVALID")
        if not np.isfinite(given).all():
            raise invalid("points", "contains numbers that are not finite", "ARRAY_INVALID")
        if given[-1, 0] < given[0, 0]:
            given = given[::-1]
        if (np.linalg.norm(np.diff(given, axis=0), axis=1) == 0).any():
            raise invalid("points", "has the same point twice in a row", "ARRAY_INVALID")
        return cls(given if spacing is None else _refined(given, spacing), body)

    @property
    def lengths(self) -> Array:
        """The arc length of each point from the first one (mm)."""
        return np.concatenate([[0.0], np.cumsum(np.linalg.norm(np.diff(self.points, axis=0), axis=1))])

    @property
    def normals(self) -> Array:
        """Unit vectors at the points, into the body."""
        steps = np.diff(self.points, axis=0)
        sizes = np.linalg.norm(steps, axis=1)[:, None]
        directions = steps / sizes
        # Returns the tangent of the circle through a point and its neighbours.
        inner = directions[:-1] * sizes[1:] + directions[1:] * sizes[:-1]
        tangents = np.concatenate([directions[:1], inner, directions[-1:]])
        tangents /= np.linalg.norm(tangents, axis=1)[:, None]
        sign = 1.0 if self.body == "wheel" else -1.0
        return sign * np.stack([tangents[:, 1], -tangents[:, 0]], axis=1)

    def edges(self, size: float) -> Array:
        """Returns the ends of cells of equal length along the arc (mm), about `size` long."""
        length = self.lengths[-1]
        return np.linspace(0.0, length, max(round(length / size), 2) + 1)

    def nearest(self, points: npt.ArrayLike) -> Array:
        """Returns the arc lengths (mm) of the points nearest to (y, z). Raises InvalidArgument if one is farther away
        than a row of a contact can be.
        """
        needed = np.atleast_2d(np.asarray(points, dtype=np.float64))
        starts, steps = self.points[:-1], np.diff(self.points, axis=0)
        squares = (steps**2).sum(axis=1)
        away = needed[:, None, :] - starts[None, :, :]
        along = np.clip((away * steps).sum(axis=2) / squares, 0.0, 1.0)
        distances = np.linalg.norm(away - along[:, :, None] * steps, axis=2)
        best = distances.argmin(axis=1)
        rows = np.arange(len(needed))
        if len(rows) and (farthest := distances[rows, best].max()) > _FARTHEST:
            raise invalid("rows", f"lie up to {farthest:.3g} mm from the section; give them in its coordinates")
        return np.asarray(self.lengths[best] + along[rows, best] * np.sqrt(squares[best]))

    def resampled(self, spacing: float) -> Section:
        """Returns the section with the same number of equidistant points on a smooth curve, if the distance of points
        has become larger than 1.5 times the spacing (mm), or smaller than a fiftieth of it; otherwise returns it
        unchanged.
        """
        gaps = np.linalg.norm(np.diff(self.points, axis=0), axis=1)
        if gaps.max() <= 1.5 * spacing and gaps.min() >= 0.02 * spacing:
            return self
        fine = Section(_refined(self.points, 0.2 * spacing), self.body)
        places = np.linspace(0.0, fine.lengths[-1], max(len(self.points), round(fine.lengths[-1] / spacing) + 1))
        return Section(np.stack([np.interp(places, fine.lengths, column) for column in fine.points.T], axis=1), self.body)

    def area_above(self, other: Section) -> float:
        """Returns the area between this section and the worn one (mm^2), positive for removed material. The ends of
        both are on the same normals.
        """
        loop = np.concatenate([self.points, other.points[::-1]])
        y, z = loop[:, 0], loop[:, 1]
        doubled = float((y * np.roll(z, -1) - np.roll(y, -1) * z).sum())
        return -doubled / 2 if self.body == "wheel" else doubled / 2

    def depths_to(self, other: Section) -> Array:
        """Returns the distances of the points from another section (mm), which are the wear depths."""
        starts, steps = other.points[:-1], np.diff(other.points, axis=0)
        away = self.points[:, None, :] - starts[None, :, :]
        along = np.clip((away * steps).sum(axis=2) / (steps**2).sum(axis=1), 0.0, 1.0)
        return np.asarray(np.linalg.norm(away - along[:, :, None] * steps, axis=2).min(axis=1))

    def worn(self, depths: npt.ArrayLike, area: float | None = None) -> Section:
        """Returns the section after each point has moved along its normal by a depth (mm). With `area` (mm^2), depths
        are multiplied by a factor near 1 so that this area is removed: on a curved surface, rows overlap below it.
        """
        moves = np.asarray(depths, dtype=np.float64)[:, None] * self.normals
        factor = 1.0
        if area is not None and area != 0:
            for _ in range(4):  # The area is nearly linear in the factor.
                if not (taken := self._area_below(factor * moves)):  # below rounding errors
                    break
                factor *= area / taken
        return Section(self.points + factor * moves, self.body)

    def _area_below(self, moves: Array) -> float:
        """Returns the area swept by the points (mm^2), to relative rounding even if it is small."""
        steps = np.diff(self.points, axis=0)
        crossed = _cross(steps, moves[:-1] + moves[1:]) + _cross(moves[1:], moves[:-1])
        return float(crossed.sum()) / 2 * (-1.0 if self.body == "wheel" else 1.0)


def _cross(one: Array, other: Array) -> Array:
    return np.asarray(one[:, 0] * other[:, 1] - one[:, 1] * other[:, 0])


def deposit(edges: npt.ArrayLike, centres: npt.ArrayLike, width: float, depths: npt.ArrayLike) -> Array:
    """Returns the depths of cells between `edges` (mm) for rows of one width at their centres. The area of each row is
    distributed over the cells that it covers, and is conserved. Raises InvalidArgument for worn rows beyond the edges.
    """
    ends = np.asarray(edges, dtype=np.float64)
    middles, taken = np.asarray(centres, dtype=np.float64), np.asarray(depths, dtype=np.float64)
    low, high = middles - width / 2, middles + width / 2
    beyond = (taken != 0) & ((low < ends[0] - 1e-9) | (high > ends[-1] + 1e-9))
    if beyond.any():
        raise invalid(
            "profile",
            f"ends at {ends[0]:.4g} and {ends[-1]:.4g} mm of its length, but the contact reaches from {low[beyond].min():.4g} to "
            f"{high[beyond].max():.4g} mm; give a longer profile, or omit the state",
        )
    covered = np.clip(ends[None, :], low[:, None], high[:, None])
    return np.asarray((taken[:, None] * np.diff(covered, axis=1)).sum(axis=0) / np.diff(ends))


def _refined(points: Array, spacing: float) -> Array:
    """Returns more points on cubics whose slopes are those of the circles through neighbours."""
    steps = np.diff(points, axis=0)
    sizes = np.linalg.norm(steps, axis=1)
    directions = steps / sizes[:, None]
    inner = (directions[:-1] * sizes[1:, None] + directions[1:] * sizes[:-1, None]) / (sizes[:-1] + sizes[1:])[:, None]
    slopes = np.concatenate([directions[:1], inner, directions[-1:]])
    parts = [points[:1]]
    for i, size in enumerate(sizes):
        t = np.linspace(0.0, 1.0, max(int(np.ceil(size / spacing - 1e-9)), 1) + 1)[1:, None]
        parts.append(
            (2 * t**3 - 3 * t**2 + 1) * points[i]
            + (3 * t**2 - 2 * t**3) * points[i + 1]
            + size * (t**3 - 2 * t**2 + t) * slopes[i]
            + size * (t**3 - t**2) * slopes[i + 1]
        )
    return np.concatenate(parts)
