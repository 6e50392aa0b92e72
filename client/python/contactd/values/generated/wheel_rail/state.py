"""Position and motion of a wheelset. Lengths are in mm, angles in rad, forces in N.

Written by ./dev generate from proto/schema: edit it there.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

from ...dictionaries import Saved

__all__ = [
    "RailDeviation",
    "WheelDeviation",
    "WheelRailMotion",
    "WheelRailState",
    "WheelsetPosition",
    "WheelsetState",
    "WheelsetVelocity",
]

WheelRailMotion = Literal["steady_rolling", "transient_rolling", "shift"]


@dataclass(frozen=True, kw_only=True)
class WheelsetPosition:
    """Position of the wheelset's centre, relative to the central position with its tape circles on the plane of the
    track.

    Attributes:
        y: Lateral position, positive to the right (mm).
        z: Vertical position, positive down (mm). A solve requires it or Fz. With Fz it is the start of the search.
        roll: Roll, from y to z (rad), -0.5 to 0.5.
        yaw: Yaw, from x to y, the first rotation (rad), -0.5 to 0.5.
        x: Position along the track on a rail that varies (mm). Forces and references are given relative to it.
        pitch: Rotation of the wheelset about its axle, for an out-of-round wheel (rad); any number of revolutions.
    """

    y: float = 0.0
    z: float | None = None
    roll: float = 0.0
    yaw: float = 0.0
    x: float = 0.0
    pitch: float = 0.0


@dataclass(frozen=True, kw_only=True)
class WheelsetVelocity:
    """Velocity of the wheelset's centre in track coordinates, and about its own axes.

    Attributes:
        x: Forward velocity (mm/s).
        y: Lateral velocity, positive to the right (mm/s).
        z: Vertical velocity, positive down (mm/s).
        roll: Roll rate, about x (rad/s).
        yaw: Yaw rate, about z (rad/s).
        pitch: Pitch rate, about y (rad/s). Rolling forwards is negative, near -x/nominal_radius.
    """

    x: float = 0.0
    y: float = 0.0
    z: float = 0.0
    roll: float = 0.0
    yaw: float = 0.0
    pitch: float = 0.0


@dataclass(frozen=True, kw_only=True)
class WheelDeviation:
    """Deviation of the wheel from its place on a rigid wheelset, for example due to axle bending: displacement of the
    origin of its profile along the wheelset's axes, and rotation about that point, yaw first. Rates are added to the
    motion of the wheelset.

    Attributes:
        x: Deviation of the wheel along the wheelset's x axis (mm).
        y: Deviation of the wheel along the wheelset's y axis, for a right wheel outwards (mm).
        z: Deviation of the wheel along the wheelset's z axis (mm): down.
        roll: Roll of the wheel in addition to that of the wheelset, from y to z (rad), -0.5 to 0.5.
        yaw: Yaw of the wheel in addition to that of the wheelset, from x to y (rad), -0.5 to 0.5.
        pitch: Rotation of an out-of-round wheel about its axle, in addition to that of the wheelset (rad).
        x_velocity: Velocity of the wheel's deviation along x (mm/s).
        y_velocity: Velocity of the wheel's deviation along y (mm/s).
        z_velocity: Velocity of the wheel's deviation along z (mm/s).
        roll_velocity: Roll velocity of the wheel in addition to that of the wheelset (rad/s).
        yaw_velocity: Yaw velocity of the wheel in addition to that of the wheelset (rad/s).
        pitch_velocity: Pitch velocity of the wheel in addition to that of the wheelset (rad/s).
    """

    x: float = 0.0
    y: float = 0.0
    z: float = 0.0
    roll: float = 0.0
    yaw: float = 0.0
    pitch: float = 0.0
    x_velocity: float = 0.0
    y_velocity: float = 0.0
    z_velocity: float = 0.0
    roll_velocity: float = 0.0
    yaw_velocity: float = 0.0
    pitch_velocity: float = 0.0


@dataclass(frozen=True, kw_only=True)
class RailDeviation:
    """Deviation of the rail from its position by track and gauge, in track coordinates, also for a left rail.

    Attributes:
        y: Lateral deviation, positive to the right (mm).
        z: Vertical deviation, positive down (mm).
        roll: Roll, from y to z (rad), -0.5 to 0.5.
        y_velocity: Velocity to the right (mm/s).
        z_velocity: Velocity downwards (mm/s).
        roll_velocity: Velocity of roll (rad/s).
        Fy: Force on a flexible rail to the right, in addition to those of the wheel and of the springs (N).
        Fz: Force on a flexible rail downwards, in addition to those of the wheel and of the springs (N).
    """

    y: float = 0.0
    z: float = 0.0
    roll: float = 0.0
    y_velocity: float = 0.0
    z_velocity: float = 0.0
    roll_velocity: float = 0.0
    Fy: float = 0.0
    Fz: float = 0.0


@dataclass(frozen=True, kw_only=True)
class WheelRailState(Saved):
    """Position and motion of the wheelset, and the kind of step.

    Attributes:
        position: Position of the wheelset's centre, relative to the central position with its tape circles on the plane
            of the track.
        velocity: Velocity of the wheelset's centre in track coordinates, and about its own axes.
        wheel: Deviation of the wheel from its place on a rigid wheelset, for example due to axle bending: displacement
            of the origin of its profile along the wheelset's axes, and rotation about that point, yaw first. Rates are
            added to the motion of the wheelset.
        rail: Deviation of the rail from its position by track and gauge, in track coordinates, also for a left rail.
        roller_pitch: Pitch rate of a roller, positive if the wheel on it turns as in forward rolling (rad/s).
        Fz: Vertical force of this wheel on the rail (N), >= 1e-06. It determines position.z. If None, position.z is
            prescribed.
        Fx: Longitudinal force on the rail along the wheelset's x axis (N). It determines velocity.pitch and requires
            friction. If None, velocity.pitch is prescribed.
        motion: Kind of step. Steady rolling does not depend on the previous steps. Transient rolling and a shift start
            from the tractions at the end of the previous step of a session, or from zero without one. Elements of
            transient rolling move with the wheelset; those of a shift are fixed to the rail.
        time_step: Duration of a step that is not steady (s), >= 1e-30. A shift requires it and has the velocities for
            this time. Transient rolling covers the distance of the rolling velocity. If None, transient rolling covers
            dq of the set-up.
        derivatives: True to compute derivatives of the forces by position and velocity, and those of the pressures of
            each patch by its approach.
        displacements: True to compute displacements and elastic energies of the patches, as in contact.solve.
    """

    position: WheelsetPosition = WheelsetPosition()
    velocity: WheelsetVelocity = WheelsetVelocity()
    wheel: WheelDeviation = WheelDeviation()
    rail: RailDeviation = RailDeviation()
    roller_pitch: float = 0.0
    Fz: float | None = None
    Fx: float | None = None
    motion: WheelRailMotion = "steady_rolling"
    time_step: float | None = None
    derivatives: bool = False
    displacements: bool = False


@dataclass(frozen=True, kw_only=True)
class WheelsetState(Saved):
    """Position and motion of a wheelset that is free to roll.

    Attributes:
        Fz_left: Vertical force of the left wheel on its rail (N), >= 1e-06.
        Fz_right: Vertical force of the right wheel on its rail (N), >= 1e-06.
        position: Position of the wheelset's centre. z and roll are starting values of the search.
        velocity: Velocity of the wheelset's centre in track coordinates, and about its own axes.
        left_wheel: Deviation of the left wheel, along the wheelset's axes: y to the right.
        right_wheel: Deviation of the right wheel, along the wheelset's axes.
        left_rail: Deviation of the left rail, in track coordinates: y to the right.
        right_rail: Deviation of the right rail, in track coordinates.
        roller_pitch: Pitch rate of a roller, positive if the wheel on it turns as in forward rolling (rad/s).
    """

    Fz_left: float
    Fz_right: float
    position: WheelsetPosition = WheelsetPosition()
    velocity: WheelsetVelocity = WheelsetVelocity()
    left_wheel: WheelDeviation = WheelDeviation()
    right_wheel: WheelDeviation = WheelDeviation()
    left_rail: RailDeviation = RailDeviation()
    right_rail: RailDeviation = RailDeviation()
    roller_pitch: float = 0.0
