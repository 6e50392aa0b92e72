"""A rigid wheelset on rigid rails: the answers of `Client.wheelset_contacts`, `Client.equivalent_conicity` and
`Client.placed_profiles`. Lengths are in mm, angles in rad.

Written by ./dev generate from proto/schema: edit it there.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

from ...arrays import Array

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
        height: z of the wheelset that produces this contact, relative to wheels that touch z = 0 with the nominal
            radius of this wheel (mm).
        wheel_y: y in the wheel's profile (mm).
        rail_y: y in the rail's profile, rotated by the track's cant (mm).
        at_end: True if the wheel's or the rail's profile ends before the bodies separate.
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
    """Contacts of both wheels at one shift.

    Attributes:
        shift: Shift of the wheelset, to the right (mm).
        roll: Roll of the wheelset, from y to z (rad); 0 where it is neglected.
        radius_difference: Rolling radius of the right wheel minus that of the left one (mm).
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
    """Equivalent conicity for one amplitude: that of cones on which a wheelset rolls with the same wavelength.

    Attributes:
        amplitude: Amplitude (mm): half of the distance from side to side.
        integrated: Conicity from the wavelength of the kinematic motion; 0 without a radius difference. None if the
            wheelset does not oscillate.
        harmonic: Conicity from the first harmonic of the radius difference. None if there is no equilibrium to
            oscillate about.
        wavelength: Wavelength of the kinematic motion (mm). None if the wheelset does not oscillate or has zero
            conicity.
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
        z: Position below the plane of the track (mm).
    """

    y: float
    z: float


@dataclass(frozen=True)
class ProfilePlace:
    """A position on or near a profile.

    Attributes:
        y: Coordinate y, positive to the field side (mm).
        z: Coordinate z, positive down (mm).
    """

    y: float
    z: float


@dataclass(frozen=True)
class WheelLandmarks:
    """Characteristic points of a wheel.

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
    """Detected properties of a profile file.

    Attributes:
        format: Format of the file.
        unit: Length of a unit of its points (mm).
        mirror_y: True if y of the points was mirrored in total.
        mirror_z: True if z of the points was mirrored in total.
        oriented_by: Source of the direction of z: the file, the shape of the points, or the request.
        lines_left_out: Number of ignored lines: neither points nor supported keys, without comments.
    """

    format: ProfileFormat
    unit: float
    mirror_y: bool
    mirror_z: bool
    oriented_by: OrientedBy
    lines_left_out: int


@dataclass(frozen=True)
class ProfileEvidence:
    """Results of processing the points of the wheel's profile.

    Attributes:
        points_given: Number of points in the input, or of points that represent a formula.
        points_kept: Number of points after cleaning that the curve interpolates or approximates.
        spacing: Mean distance of these points (mm).
        rounded_to: Rounding step of the coordinates in the input (mm): 1, 0.1, 0.01 or 0.001 of their unit; 0: not
            rounded.
        cut_off: Wavelength at which smoothing halves the amplitude (mm); 0: not smoothed.
        largest_distance: Largest distance of these points from the smoothed curve (mm).
        rms_distance: Root of the mean square of these distances (mm).
        kinks: Kinks, at which the curve is broken: their y (mm).
        warnings: Warnings.
        wheel: Characteristic points of a wheel. None if no flange protrudes by 10 mm.
        file: Detected properties of the file. None if there was no file.
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
    """Profiles of one side, as the daemon read them: points on the curves.

    Attributes:
        wheel: Points (y, z) of the wheel's profile (mm), shape [n, 2], cleaned and smoothed. The curve between them is
            not a straight line in general.
        rail: Points (y, z) of the rail's profile (mm), shape [n, 2], rotated by the track's cant.
        wheel_origin: Origin of the wheel's profile (mm): from the middle of the axle to the field side.
        rail_origin: Origin of the rail's profile, in the track.
        wheel_evidence: Results of processing the points of the wheel's profile.
        rail_evidence: Results of processing the points of the rail's profile.
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
        left: The left side, as if it were a right side.
        right: The right side.
    """

    left: PlacedProfiles
    right: PlacedProfiles
