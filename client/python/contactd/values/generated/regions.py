"""Regions of the potential contact area.

Written by ./dev generate from proto/schema: edit it there.
"""

from __future__ import annotations

from dataclasses import dataclass, field

import numpy.typing as npt

from ..params import HasParams
from ..region_methods import RegionMethods

__all__ = ["ContactRegions", "RegionLimits"]


@dataclass(frozen=True)
class RegionLimits(HasParams):
    """A rectangle of the potential contact area, in coordinates of the grid.

    ::

        RegionLimits(x=(-3, -1), y=(-2, 2))

    Attributes:
        x: Interval along x (mm).
        y: Interval along y (mm).
    """

    x: tuple[float, float]
    y: tuple[float, float]


@dataclass(frozen=True, eq=False)
class ContactRegions(RegionMethods):
    """Regions in which bodies may touch, and the influence of the pressures of each region on the others.

    An element belongs to the first region that contains its centre; elements outside all regions cannot touch. Shares
    do not change displacements due to tractions, or tangential displacements.

    ::

        ContactRegions([RegionLimits((-3, -1), (-2, 2)), RegionLimits((1, 3), (-2, 2))], [[1, 0.4], [0.4, 1]])

    Attributes:
        limits: The regions. An element belongs to the first region that contains its centre; elements outside all
            regions cannot touch.
        shares: Shares [regions, regions], or row by row, of the normal displacements by the pressures of the column's
            region that act on the row's region; symmetric, 1 on the diagonal.
    """

    limits: tuple[RegionLimits, ...]
    shares: npt.ArrayLike = field(metadata={"array": ""})
