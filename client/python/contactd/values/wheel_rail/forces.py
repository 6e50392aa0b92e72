"""Forces of wheels on rails, and their derivatives. On the rail, in N and N mm."""

from __future__ import annotations

from dataclasses import dataclass

__all__ = [
    "WheelRailDerivatives",
    "WheelRailForces",
    "Wrench",
    "WrenchesByPosition",
    "WrenchesByVelocity",
]


@dataclass(frozen=True)
class Wrench:
    """A force (N) and its moment (N mm) about the origin of its axes, on the rail.

    Attributes:
        Fx: Along x (N).
        Fy: Along y (N).
        Fz: Along z (N).
        Mx: About x (N mm).
        My: About y (N mm).
        Mz: About z (N mm).
    """

    Fx: float
    Fy: float
    Fz: float
    Mx: float
    My: float
    Mz: float


@dataclass(frozen=True)
class WheelRailForces:
    """Forces on the rail, in the axes of three.

    Attributes:
        track: In track coordinates.
        rail: About the origin of the rail's profile, along its axes.
        wheelset: About the wheelset's centre, along its axes, which do not turn with its pitch.
    """

    track: Wrench
    rail: Wrench
    wheelset: Wrench


@dataclass(frozen=True)
class WrenchesByPosition:
    """Derivatives of a wrench by the position of the wheelset.

    Attributes:
        y: By y (per mm).
        z: By z (per mm).
        roll: By the roll (per rad).
        yaw: By the yaw (per rad).
    """

    y: Wrench
    z: Wrench
    roll: Wrench
    yaw: Wrench


@dataclass(frozen=True)
class WrenchesByVelocity:
    """Derivatives of a wrench by the velocity of the wheelset.

    Attributes:
        x: By x (per mm/s).
        y: By y (per mm/s).
        z: By z (per mm/s).
        roll: By the roll rate (per rad/s).
        yaw: By the yaw rate (per rad/s).
        pitch: By the pitch rate (per rad/s).
    """

    x: Wrench
    y: Wrench
    z: Wrench
    roll: Wrench
    yaw: Wrench
    pitch: Wrench


@dataclass(frozen=True)
class WheelRailDerivatives:
    """How the forces on the rail, in track coordinates, follow the state, to first order. All inputs but the one are held,
    height and pitch rate also where forces found them: ``solution.derivatives.position.z.Fz`` is dFz/dz (N/mm).

    Attributes:
        position: By the position.
        velocity: By the velocity.
    """

    position: WrenchesByPosition
    velocity: WrenchesByVelocity
