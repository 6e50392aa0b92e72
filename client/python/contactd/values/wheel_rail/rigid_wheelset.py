"""A rigid wheelset on rigid rails: the answers of `Client.wheelset_contacts`, `Client.equivalent_conicity` and
`Client.placed_profiles`. Lengths in mm, angles in rad.

Written by ./dev generate from proto/schema: edit it there.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

from ..arrays import Array

__all__ = [
    "EquivalentConicity",
    "OrientedBy",
    "PlacedProfiles",
    "ProfileEvidence",
    "ProfileFormat",
    "ProfileOrigin",
    "ProfilePlace",
    "ProfileReading",
    "ProfilesOfSides",
    "RigidContact",
    "WheelLandmarks",
    "WheelsetContacts",
    "WheelsetRoll",
]

WheelsetRoll = Literal["demanded", "neglected"]
ProfileFormat = Literal["simpack", "miniprof", "columns"]
OrientedBy = Literal["file", "shape", "request"]


@dataclass(frozen=True)
class RigidContact:
    """A contact of a rigid wheel with a rigid rail.

    Attributes:
        y: Position in track coordinates, to the right (mm).
        z: Position in track coordinates, down (mm).
        angle: Angle of the rail's tangent (rad): negative at the right wheel's flange.
        radius: Rolling radius of the wheel (mm).
        height: z of the wheelset that brings this contact, against wheels that touch z = 0 with the nominal radius of
            this one (mm).
        wheel_y: y in the wheel's profile (mm).
        rail_y: y in the rail's profile, as the track's cant turns it (mm).
        at_end: Whether the wheel's or the rail's profile ends before the bodies part.
    """

    y: float
    z: float
    angle: float
    radius: float
    height: float
    wheel_y: float
    rail_y: float
    at_end: bool


@dataclass(frozen=True)
class WheelsetContacts:
    """Where both wheels touch at one shift.

    Attributes:
        shift: Shift of the wheelset, to the right (mm).
        roll: Roll of the wheelset, from y to z (rad); 0 where it is neglected.
        radius_difference: Rolling radius of the right wheel less that of the left one (mm).
        left: The contact of the left wheel.
        right: The contact of the right wheel.
    """

    shift: float
    roll: float
    radius_difference: float
    left: RigidContact
    right: RigidContact


@dataclass(frozen=True)
class EquivalentConicity:
    """The conicity of the cones on which a wheelset would roll with the same wavelength, for one amplitude.

    Attributes:
        amplitude: Half of the way from side to side (mm).
        integrated: Conicity by the wavelength of the kinematic motion; 0 where there is no radius difference, None
            where the wheelset does not swing.
        harmonic: Conicity by the first harmonic of the radius difference; None where there is no centre to swing
            around.
        wavelength: Wavelength of the kinematic motion (mm); None where the wheelset does not swing, or has no conicity.
    """

    amplitude: float
    integrated: float | None = None
    harmonic: float | None = None
    wavelength: float | None = None


@dataclass(frozen=True)
class ProfileOrigin:
    """Origin of the rail's profile, in the track.

    Attributes:
        y: Position from the middle of the track to the field side (mm).
        z: Down from the plane of the track (mm).
    """

    y: float
    z: float


@dataclass(frozen=True)
class ProfilePlace:
    """A place on a profile, or beside it.

    Attributes:
        y: To the field side (mm).
        z: Downwards (mm).
    """

    y: float
    z: float


@dataclass(frozen=True)
class WheelLandmarks:
    """Places by which a wheel is known.

    Attributes:
        tip: Tip of the flange, the lowest point.
        throat: The hollowest point between flange and tread.
        tread: The tread at the running circle, 55 mm beside the tip.
    """

    tip: ProfilePlace
    throat: ProfilePlace
    tread: ProfilePlace


@dataclass(frozen=True)
class ProfileReading:
    """What a file of a profile was taken for.

    Attributes:
        format: Format of the file.
        unit: Length of a unit of its points (mm).
        mirror_y: Whether y of its points was turned, all told.
        mirror_z: Whether z of its points was turned, all told.
        oriented_by: What says which way z points: the file, the shape of its points, or the request.
        lines_left_out: Number of lines that are neither points nor keys with a meaning here; comments are not counted.
    """

    format: ProfileFormat
    unit: float
    mirror_y: bool
    mirror_z: bool
    oriented_by: OrientedBy
    lines_left_out: int


@dataclass(frozen=True)
class ProfileEvidence:
    """What became of the points of the wheel's profile.

    Attributes:
        points_given: Number of points that were given, or that stand for a formula.
        points_kept: Number of points after cleaning, through or near which the curve goes.
        spacing: Mean distance of these points (mm).
        rounded_to: Step that all given coordinates are multiples of, of 1, 0.1, 0.01 and 0.001 of their unit (mm); 0:
            of none.
        cut_off: Wavelength of which smoothing leaves half the amplitude (mm); 0: nothing is smoothed.
        largest_distance: Largest distance of these points from the smoothed curve (mm).
        rms_distance: Root of the mean square of these distances (mm).
        kinks: Kinks, at which the curve is broken: their y (mm).
        warnings: Sentences that a user should know.
        wheel: Places by which a wheel is known; None where no flange stands out by 10 mm.
        file: What a file was taken for; None where there was none.
    """

    points_given: int
    points_kept: int
    spacing: float
    rounded_to: float
    cut_off: float
    largest_distance: float
    rms_distance: float
    kinks: tuple[float, ...]
    warnings: tuple[str, ...]
    wheel: WheelLandmarks | None = None
    file: ProfileReading | None = None


@dataclass(frozen=True, eq=False)
class PlacedProfiles:
    """Profiles of one side, as the daemon has read them: points through which its curves go.

    Attributes:
        wheel: Points (y, z) of the wheel's profile (mm), shape [n, 2], cleaned and smoothed; straight lines between
            need not be the curve.
        rail: Points (y, z) of the rail's profile (mm), shape [n, 2], as the track's cant turns it.
        wheel_origin: Origin of the wheel's profile (mm): from the middle of the axle to the field side.
        rail_origin: Origin of the rail's profile, in the track.
        wheel_evidence: What became of the points of the wheel's profile.
        rail_evidence: What became of the points of the rail's profile.
    """

    wheel: Array
    rail: Array
    wheel_origin: float
    rail_origin: ProfileOrigin
    wheel_evidence: ProfileEvidence
    rail_evidence: ProfileEvidence


@dataclass(frozen=True, eq=False)
class ProfilesOfSides:
    """Profiles of both sides.

    Attributes:
        left: The left side, as if it were a right one.
        right: The right side.
    """

    left: PlacedProfiles
    right: PlacedProfiles
