"""Stresses inside the bodies: arguments and answers of `Client.subsurface`.

Written by ./dev generate from proto/schema: edit it there.
"""

from __future__ import annotations

from dataclasses import dataclass, field

import numpy.typing as npt

from ..arrays import Array
from ..dictionaries import Saved
from ..representation import Shown
from ..subsurface_methods import StressBlockMethods, SubsurfaceStressMethods

__all__ = ["LargestStress", "StressBlock", "SubsurfaceStress"]


@dataclass(frozen=True, eq=False)
class StressBlock(StressBlockMethods):
    """All points (x, y, z) with the values in `x`, `y` and `z` (mm), in any order. A number is a single value.

    A block whose coordinates are whole elements apart is cheaper than single points: ``StressBlock(grid.x, grid.y,
    z)``.

    Attributes:
        x: Places along x (mm).
        y: Places along y (mm).
        z: Positions along z (mm), <= 0 inside the body, also for the upper body.
    """

    x: npt.ArrayLike = field(metadata={"array": ""})
    y: npt.ArrayLike = field(metadata={"array": ""})
    z: npt.ArrayLike = field(metadata={"array": ""})


@dataclass(frozen=True)
class LargestStress:
    """The point with the largest von Mises stress; the first of several equal ones.

    Attributes:
        von_mises: The von Mises stress at the point (N/mm^2).
        x: Requested x of the point (mm).
        y: Requested y of the point (mm).
        z: Requested z of the point (mm).
        depth: Distance from the surface, -z (mm).
    """

    von_mises: float
    x: float
    y: float
    z: float
    depth: float


@dataclass(frozen=True, eq=False, repr=False)
class SubsurfaceStress(SubsurfaceStressMethods, Saved, Shown):
    """Stresses inside a body (N/mm^2), tension positive: read-only arrays of shape [n] for points, [nz, ny, nx] for a
    block.

    They are in the frame of the body, which occupies z <= 0; x and y are those of the grid. The frame of the lower body
    is that of the contact problem. The frame of the upper body is its mirror image, so xz and yz of the upper body have
    the opposite sign in the frame of the problem.

    Attributes:
        xx: Normal stress along x.
        yy: Normal stress along y.
        zz: Normal stress along z.
        xy: Shear stress in the plane of x and y.
        xz: Shear stress in the plane of x and z.
        yz: Shear stress in the plane of y and z.
        von_mises: Von Mises' equivalent stress.
        largest: The point with the largest von Mises stress; the first of several equal ones.
        hydrostatic: Mean of the three normal stresses; with invariants.
        principal_1: Largest principal stress; with invariants.
        principal_2: Middle principal stress; with invariants.
        principal_3: Smallest principal stress; with invariants.
        tresca: Tresca's equivalent stress: the largest principal stress minus the smallest, twice the largest shear
            stress. Only with invariants.
        displacement_x: Displacement along x in the frame of the body (mm), zero far away; with G.
        displacement_y: Displacement along y (mm); with G.
        displacement_z: Displacement along z, out of the body (mm); with G.
        block: The block of points, which the client adds; None for single points.
        points: The points, shape [n, 3] (mm); None for a block.
    """

    xx: Array = field(metadata={"within": "stress"})
    yy: Array = field(metadata={"within": "stress"})
    zz: Array = field(metadata={"within": "stress"})
    xy: Array = field(metadata={"within": "stress"})
    xz: Array = field(metadata={"within": "stress"})
    yz: Array = field(metadata={"within": "stress"})
    von_mises: Array
    largest: LargestStress
    hydrostatic: Array | None = None
    principal_1: Array | None = None
    principal_2: Array | None = None
    principal_3: Array | None = None
    tresca: Array | None = None
    displacement_x: Array | None = None
    displacement_y: Array | None = None
    displacement_z: Array | None = None
    block: StressBlock | None = None
    points: Array | None = None
