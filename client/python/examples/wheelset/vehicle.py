"""Describes a wheelset on its primary suspension, below a frame with constant speed.

Track coordinates relative to the frame: x forwards, y to the right, z down (docs/wheel-rail.md). The wheelset is
rotated by its yaw about z, then by its roll about its own x; its pitch is about its axle. Units: mm, s, N, and t for
masses, so that forces are in N.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from railway.motion import GRAVITY, Array, Motion, axes, cross


@dataclass(frozen=True)
class Vehicle:
    """Mass and inertia are those of vehicle 1 of the Manchester benchmarks (Iwnicki 1998: a passenger coach; axle load
    of the whole coach by four). The longitudinal and lateral springs are softer, so that it hunts at speeds of trains:
    a single wheelset does not have the inertia of a bogie.

    Attributes:
        mass: Mass of the wheelset (t).
        inertia: Moment of inertia about x and z (t mm^2).
        inertia_axle: Moment of inertia about the axle (t mm^2).
        radius: Nominal radius (mm).
        axle_load: Force of both wheels on the rails (N).
        half_base: Distance from the centre to an axle box (mm).
        stiffness: Stiffness of one axle box's springs along x, y, z (N/mm).
        damping: Damping of one axle box's dampers along x, y, z (N s/mm).
    """

    mass: float = 1.813
    inertia: float = 1120e3
    inertia_axle: float = 112e3
    radius: float = 460.0
    axle_load: float = 109e3
    half_base: float = 1000.0
    stiffness: tuple[float, float, float] = (1500.0, 500.0, 1220.0)
    damping: tuple[float, float, float] = (5.0, 0.0, 20.0)


def frame_load(vehicle: Vehicle) -> float:
    """Returns the load of the frame on one axle box (N), without the wheelset's own weight."""
    return (vehicle.axle_load - vehicle.mass * GRAVITY) / 2


def suspension(vehicle: Vehicle, x: float, rest: float, motion: Motion, speed: float) -> tuple[Array, Array]:
    """Returns the force of springs and dampers on the wheelset in track coordinates (N), and their moment about its
    centre along its own axes (N mm).

    x is the position of the centre relative to the frame (mm), rest the z at which the springs carry the frame's load
    (mm).
    """
    rotated = axes(motion.roll, motion.yaw)
    rates = rotated @ (motion.roll_rate, motion.pitch_rate, motion.yaw_rate)
    force, moment = np.zeros(3), np.zeros(3)
    for side in (-1, 1):
        box = np.array([0.0, side * vehicle.half_base, 0.0])
        arm = rotated @ box
        moved = np.array([x, motion.y, motion.z - rest]) + arm - box
        velocity = np.array([motion.vx - speed, motion.vy, motion.vz]) + cross(rates, arm)
        at_box = -np.multiply(vehicle.stiffness, moved) - np.multiply(vehicle.damping, velocity)
        at_box[2] += frame_load(vehicle)
        force += at_box
        moment += rotated.T @ cross(arm, at_box)
    return force, moment
