"""Computes wear of a wheel or a rail in one passage."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import TYPE_CHECKING, Literal

import numpy as np

from ...errors import invalid
from ...refusals import public
from ..arrays import Array
from ..registry import extra
from ..representation import Rows, Shown

if TYPE_CHECKING:
    from matplotlib.axes import Axes

__all__ = ["PassageWear"]


@dataclass(frozen=True, eq=False, repr=False, kw_only=True)
class PassageWear(Shown):
    """The wear of a wheel or a rail by one law, summed over all patches. Depths are along the normals of the surface.

    Attributes:
        body: The worn body, "wheel" or "rail".
        law: Name of the law.
        T_gamma: T gamma of all patches, without spin (N).
        depth_per_passage: The largest depth removed from a row in one passage (mm).
        area_per_passage: The area removed from the section in one passage, the volume per distance rolled (mm^2).
        passages_per_km: Number of passages of a point of the section per km. For a wheel, 1e6/(2 pi r), with r the
            radius at the largest wear; for a rail NaN, because it depends on traffic.
        points: (y, z) of the section in the coordinates of its profile, z down (mm), shape [n, 2].
        depths: The depth removed at each of these points in one passage (mm), shape [n].
        depths_per_km: The same per km (mm), shape [n]; NaN for a rail.
        normals: Unit vectors at the points, into the body, shape [n, 2].
    """

    body: Literal["wheel", "rail"]
    law: str
    T_gamma: float
    depth_per_passage: float
    area_per_passage: float
    passages_per_km: float
    points: Array
    depths: Array
    depths_per_km: Array
    normals: Array

    @property
    def depth_per_km(self) -> float:
        """The largest wear depth of a wheel per km of this contact (mm). Raises InvalidArgument for a rail, whose wear
        is given per passage: see depth_per_passage.
        """
        self._check_wheel("depth_per_km")
        return self.depth_per_passage * self.passages_per_km

    @public
    def section(self, *, km: float | None = None, passages: float | None = None) -> Array:
        """Returns the worn section, (y, z) in the coordinates of the profile (mm), shape [n, 2]: of a wheel after `km`
        with this contact, or of either body after so many `passages`. The contact does not follow the wear; use
        `contactd.wear.evolve` for that.
        """
        if (km is None) == (passages is None):
            raise TypeError("section() requires either km or passages")
        if km is not None:
            self._check_wheel("km")
        name, many = ("passages", passages) if km is None else ("km", km)
        if many is None or not (math.isfinite(many) and many >= 0):
            raise invalid(name, f"is {many}; it must be at least 0 and finite")
        depths = (self.depths if km is None else self.depths_per_km) * many
        return np.asarray(self.points + depths[:, None] * self.normals)

    @public
    def plot(self, axes: Axes | None = None) -> Axes:
        """Plots the depth against y of the profile: of a wheel after a km, of a rail after a million passages.

        Draws into `axes` or a new figure, and returns the axes. Needs matplotlib ("contactd[pictures]").
        """
        drawn: Axes = extra("PassageWear.plot")(self, axes)
        return drawn

    def _check_wheel(self, name: str) -> None:
        if self.body == "rail":
            raise invalid(name, "applies to wheels only; a rail wears by passages. Use depth_per_passage, or section(passages=...)")

    def _title(self) -> str:
        return f"PassageWear of the {self.body} by {self.law}"

    def _rows(self) -> Rows:
        rows: Rows = [("T gamma", self.T_gamma), ("depth per passage", self.depth_per_passage)]
        rows.append(("area per passage", self.area_per_passage))
        return [*rows, ("depth per km", self.depth_per_km)] if self.body == "wheel" else rows
