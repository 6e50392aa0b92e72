"""Where a wheelset is, and how it moves. Lengths in mm, angles in rad, forces in N.

Written by ./dev generate from proto/schema: edit it there.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

from ..dictionaries import Saved

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
    """Position of the wheelset's centre, from where it stands in the middle with its tape circles on the plane of the
    track.

    Attributes:
        y: To the right (mm).
        z: Down (mm); a solve needs it, or Fz. Where Fz is given, only where to start.
        roll: Roll, from y to z (rad), -0.5 to 0.5.
        yaw: Yaw, from x to y, turned first (rad), -0.5 to 0.5.
        x: Along the track, where the rail varies (mm); forces and references are told from there on.
        pitch: Angle by which the wheelset has turned about its axle, for an out-of-round wheel (rad); any number of
            revolutions.
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
        x: Forwards (mm/s).
        y: To the right (mm/s).
        z: Down (mm/s).
        roll: About x (rad/s).
        yaw: About z (rad/s).
        pitch: About y (rad/s): rolling forwards is negative, near -x/nominal_radius.
    """

    x: float = 0.0
    y: float = 0.0
    z: float = 0.0
    roll: float = 0.0
    yaw: float = 0.0
    pitch: float = 0.0


@dataclass(frozen=True, kw_only=True)
class WheelDeviation:
    """Deviation of the wheel from where a rigid wheelset has it, as of an axle that bends: of the origin of its profile
    along the wheelset's axes, and turns about that point, the yaw first. Rates are added to the motion of the wheelset.

    Attributes:
        x: Deviation of the wheel along the wheelset's x axis (mm).
        y: Deviation of the wheel along the wheelset's y axis (mm): of a right wheel outwards.
        z: Deviation of the wheel along the wheelset's z axis (mm): down.
        roll: Roll of the wheel beside that of the wheelset, from y to z (rad), -0.5 to 0.5.
        yaw: Yaw of the wheel beside that of the wheelset, from x to y (rad), -0.5 to 0.5.
        pitch: Rotation of an out-of-round wheel about its axle, beside that of the wheelset (rad).
        x_velocity: Velocity of the wheel's deviation along x (mm/s).
        y_velocity: Velocity of the wheel's deviation along y (mm/s).
        z_velocity: Velocity of the wheel's deviation along z (mm/s).
        roll_velocity: Velocity of the wheel's roll beside that of the wheelset (rad/s).
        yaw_velocity: Velocity of the wheel's yaw beside that of the wheelset (rad/s).
        pitch_velocity: Velocity of the wheel's pitch beside that of the wheelset (rad/s).
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
    """Deviation of the rail from where track and gauge have it, in track coordinates also for a left one.

    Attributes:
        y: To the right (mm).
        z: Down (mm).
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
    """Where the wheelset is, and how it moves.

    Attributes:
        position: Position of the wheelset's centre, from where it stands in the middle with its tape circles on the
            plane of the track.
        velocity: Velocity of the wheelset's centre in track coordinates, and about its own axes.
        wheel: Deviation of the wheel from where a rigid wheelset has it, as of an axle that bends: of the origin of its
            profile along the wheelset's axes, and turns about that point, the yaw first. Rates are added to the motion
            of the wheelset.
        rail: Deviation of the rail from where track and gauge have it, in track coordinates also for a left one.
        roller_pitch: Pitch rate of a roller (rad/s): positive where the wheel on it turns as when rolling forwards.
        Fz: Vertical force of this wheel on the rail, which position.z is found for (N), >= 1e-06. None: position.z is
            prescribed.
        Fx: Longitudinal force on the rail along the wheelset's x axis, which velocity.pitch is found for (N); needs
            friction. None: velocity.pitch is prescribed.
        motion: What a step is: steady rolling knows nothing of the steps before; transient rolling and a shift go on
            from the tractions that the step before of a session ended with, and from none where there was none.
            Elements of transient rolling move with the wheelset, and those of a shift are fixed to the rail.
        time_step: Duration of a step that is not steady (s), >= 1e-30: a shift, which needs it, is that of the
            velocities in this time, and transient rolling goes as far as the rolling velocity takes it. None, that
            rolls by dq of the set-up.
        derivatives: Whether the solution has derivatives of the forces by position and velocity.
        displacements: Whether the solutions of patches have displacements, and elastic energies, as in contact.solve.
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
    """Where a wheelset is that is free to roll, and how it moves.

    Attributes:
        Fz_left: Vertical force of the left wheel on its rail (N), >= 1e-06.
        Fz_right: Vertical force of the right wheel on its rail (N), >= 1e-06.
        position: Position of the wheelset's centre; z and roll, which are found, only tell where to start.
        velocity: Velocity of the wheelset's centre in track coordinates, and about its own axes.
        left_wheel: Deviation of the left wheel, along the wheelset's axes: y to the right.
        right_wheel: Deviation of the right wheel, along the wheelset's axes.
        left_rail: Deviation of the left rail, in track coordinates: y to the right.
        right_rail: Deviation of the right rail, in track coordinates.
        roller_pitch: Pitch rate of a roller (rad/s): positive where the wheel on it turns as when rolling forwards.
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
