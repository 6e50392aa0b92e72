"""Forces of wheels on rails, and their derivatives. Forces act on the rail, in N and N mm.

Written by ./dev generate from proto/schema: edit it there.
"""

from __future__ import annotations

from dataclasses import dataclass

__all__ = ["WheelRailDerivatives", "WheelRailForces", "Wrench", "WrenchesByPosition", "WrenchesByVelocity"]


@dataclass(frozen=True)
class Wrench:
    """A force and its moment about the origin of its axes, on the rail.

    Attributes:
        Fx: Force along x (N).
        Fy: Force along y (N).
        Fz: Force along z (N).
        Mx: Moment about x (N mm).
        My: Moment about y (N mm).
        Mz: Moment about z (N mm).
    """

    Fx: float
    Fy: float
    Fz: float
    Mx: float
    My: float
    Mz: float


@dataclass(frozen=True)
class WheelRailForces:
    """Forces on the rail in three coordinate systems.

    Attributes:
        track: Forces in track coordinates.
        rail: Forces along the axes of the rail's profile, and moments about its origin.
        wheelset: Forces along the axes of the wheelset, which do not rotate with its pitch, and moments about its
            centre.
    """

    track: Wrench
    rail: Wrench
    wheelset: Wrench


@dataclass(frozen=True)
class WrenchesByPosition:
    """Derivatives by the position of the wheelset.

    Attributes:
        y: Derivative by y (per mm).
        z: Derivative by z (per mm).
        roll: Derivative by roll (per rad).
        yaw: Derivative by yaw (per rad).
    """

    y: Wrench
    z: Wrench
    roll: Wrench
    yaw: Wrench


@dataclass(frozen=True)
class WrenchesByVelocity:
    """Derivatives by the velocity of the wheelset.

    Attributes:
        x: Derivative by x (per mm/s).
        y: Derivative by y (per mm/s).
        z: Derivative by z (per mm/s).
        roll: Derivative by roll (per rad/s).
        yaw: Derivative by yaw (per rad/s).
        pitch: Derivative by pitch (per rad/s).
    """

    x: Wrench
    y: Wrench
    z: Wrench
    roll: Wrench
    yaw: Wrench
    pitch: Wrench


@dataclass(frozen=True)
class WheelRailDerivatives:
    """First derivatives of the forces on the rail by the state, in track coordinates: derivatives.position.z.Fz is
    dFz/dz (N/mm). Units are those of a wrench over those of the input. All other inputs are fixed, also height and
    pitch rate found from forces.

    Attributes:
        position: Derivatives by the position of the wheelset.
        velocity: Derivatives by the velocity of the wheelset.
    """

    position: WrenchesByPosition
    velocity: WrenchesByVelocity
