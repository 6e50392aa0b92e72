"""Contact positions of a wheel on its rail, from profiles and positions. Lengths are in mm, angles in rad.

Written by ./dev generate from proto/schema: edit it there.
"""

from __future__ import annotations

from dataclasses import dataclass

from ..grid import Grid

__all__ = [
    "ContactPlace",
    "ContactRadii",
    "ContactReference",
    "ContactRow",
    "Creepages",
    "OverlapRegion",
    "ProfileFrame",
    "RailPlace",
    "WheelRailGeometry",
]


@dataclass(frozen=True)
class ContactReference:
    """The reference of a contact: a point of the rail in track coordinates, and the angle of the contact's plane.

    Attributes:
        x: Position x, forwards (mm).
        y: Position y, positive to the right (mm).
        z: Position z, positive down (mm).
        angle: Angle by which the track's axes are rotated about x, positive if the rail falls to the right (rad).
    """

    x: float
    y: float
    z: float
    angle: float


@dataclass(frozen=True)
class RailPlace:
    """Position of the reference along and across the rail. Elements of a shift lie at multiples of dx and dy from the
    point where both are 0, those of transient rolling from position.x.

    Attributes:
        along: Position forwards, including position.x of the state (mm).
        across: Arc length to the right from y = 0 of the rail's profile or, if the profile doubles back, from its point
            nearest to the origin (mm).
    """

    along: float
    across: float


@dataclass(frozen=True)
class OverlapRegion:
    """Region where the undeformed profiles overlap, seen from above.

    Attributes:
        reference: Weighted centre of the region.
        x: Interval forwards, in track coordinates (mm).
        y: Interval to the right (mm).
        z: z of the rail at this point (mm).
        penetration: Largest vertical overlap (mm).
        size: Integral of the vertical penetration squared (mm^4).
    """

    reference: ContactReference
    x: tuple[float, float]
    y: tuple[float, float]
    z: tuple[float, float]
    penetration: float
    size: float


@dataclass(frozen=True)
class Creepages:
    """Velocities of the rail relative to the wheel over the rolling velocity, in contact coordinates.

    Attributes:
        xi: Longitudinal creepage.
        eta: Lateral creepage.
        phi: Spin (rad/mm).
        chi: Rolling direction (rad): 0 forwards, pi backwards.
        velocity: Rolling velocity (mm/s); 0 if the wheel does not roll.
    """

    xi: float
    eta: float
    phi: float
    chi: float
    velocity: float


@dataclass(frozen=True)
class ContactRadii:
    """Radii of curvature at the reference (mm), positive where convex. None where straight.

    Attributes:
        wheel_along: Radius of the wheel along x (mm).
        wheel_across: Radius of the wheel along y (mm).
        rail_along: Radius of the rail along x (mm).
        rail_across: Radius of the rail along y (mm).
    """

    wheel_along: float | None = None
    wheel_across: float | None = None
    rail_along: float | None = None
    rail_across: float | None = None


@dataclass(frozen=True)
class ContactRow:
    """A row of elements of a contact that is curved across the track, half-way between rail and wheel.

    Attributes:
        y: y of the middle of the row in track coordinates, positive to the right (mm).
        z: z of the middle of the row in track coordinates, positive down (mm).
        angle: Inclination of the row (rad). Tractions are along axes rotated about x by this angle.
    """

    y: float
    z: float
    angle: float


@dataclass(frozen=True)
class ContactPlace:
    """A place where wheel and rail are in contact. Contact coordinates have their origin at the reference: x forwards,
    y along the rail's surface to the right, z into the rail.

    Attributes:
        reference: Origin of the contact coordinates on the rail, and the angle of the contact's plane.
        on_rail: Position of the reference along and across the rail. Elements of a shift lie at multiples of dx and dy
            from the point where both are 0, those of transient rolling from position.x.
        regions: Regions where the undeformed profiles overlap, from right to left. Several regions interact with a
            weight.
        shares: Weights of the interaction of regions: the fraction of the displacements of each region that acts on
            each other region, row by row; 1 on the diagonal.
        grid: The potential contact area, in contact coordinates.
        approach: Largest penetration along z at the elements (mm).
        penetration: Largest vertical penetration (mm).
        creepages: Velocities of the rail relative to the wheel over the rolling velocity, in contact coordinates.
        radii: Radii of curvature at the reference (mm), positive where convex. None where straight.
        rows: Rows of elements of a contact that is curved across the track. None where it is plane.
    """

    reference: ContactReference
    on_rail: RailPlace
    regions: tuple[OverlapRegion, ...]
    shares: tuple[float, ...]
    grid: Grid
    approach: float
    penetration: float
    creepages: Creepages
    radii: ContactRadii
    rows: tuple[ContactRow, ...] = ()


@dataclass(frozen=True)
class ProfileFrame:
    """Axes of the wheel's profile.

    Attributes:
        x: Position x of the origin, forwards (mm).
        y: Position y of the origin, positive to the right (mm).
        z: Position z of the origin, positive down (mm).
        roll: Rotation about x, from y to z (rad).
        yaw: Rotation about z, from x to y (rad).
    """

    x: float
    y: float
    z: float
    roll: float
    yaw: float


@dataclass(frozen=True, eq=False)
class WheelRailGeometry:
    """Results of the profiles and positions without a solve.

    Attributes:
        z: z of the wheelset (mm).
        wheel_frame: Axes of the wheel's profile.
        rail_frame: Axes of the rail's profile, with the rail's deviation and deflection; for a roller at its top.
        places: Possible contact patches, from right to left. Empty if wheel and rail do not overlap.
        clearance: Smallest vertical distance of wheel and rail at this z, negative where they overlap (mm). None if
            they are not above each other.
        warnings: Warnings.
    """

    z: float
    wheel_frame: ProfileFrame
    rail_frame: ProfileFrame
    places: tuple[ContactPlace, ...]
    clearance: float | None = None
    warnings: tuple[str, ...] = ()
