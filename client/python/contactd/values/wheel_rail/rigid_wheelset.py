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
    "PlacedProfiles",
    "ProfileOrigin",
    "ProfilesOfSides",
    "RigidContact",
    "WheelsetContacts",
    "WheelsetRoll",
]

WheelsetRoll = Literal["demanded", "neglected"]


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


@dataclass(frozen=True, eq=False)
class PlacedProfiles:
    """Profiles of one side, as the daemon has read them: points through which its curves go.

    Attributes:
        wheel: Points (y, z) of the wheel's profile (mm), shape [n, 2], cleaned and smoothed; straight lines between
            need not be the curve.
        rail: Points (y, z) of the rail's profile (mm), shape [n, 2], as the track's cant turns it.
        wheel_origin: Origin of the wheel's profile (mm): from the middle of the axle to the field side.
        rail_origin: Origin of the rail's profile, in the track.
    """

    wheel: Array
    rail: Array
    wheel_origin: float
    rail_origin: ProfileOrigin


@dataclass(frozen=True, eq=False)
class ProfilesOfSides:
    """Profiles of both sides.

    Attributes:
        left: The left side, as if it were a right one.
        right: The right side.
    """

    left: PlacedProfiles
    right: PlacedProfiles
