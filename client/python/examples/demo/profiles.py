"""Provides curves of S1002 and 60E1 for drawings, in track coordinates: y to the right, z down (mm)."""

from __future__ import annotations

import math
from typing import Any

import numpy as np

Curve = np.ndarray[Any, Any]  # shape [n, 2]: y, z

GAUGE, GAUGE_HEIGHT, NOMINAL_RADIUS = 1435.0, 14.0, 460.0
WHEEL_ORIGIN = 750.0  # position of the profile, from the middle of the axle
TREAD = [-3.358537058e-2, 1.565681624e-3, -2.810427944e-5, 5.844240864e-8, -1.562379023e-8, 5.309217349e-15, -5.957839843e-12, 2.646656573e-13]  # fmt: skip
THROAT = [-4.320221063e3, -1.038384026e3, -1.065501873e2, -6.051367875, -2.054332446e-1, -4.169739389e-3, -4.687195829e-5, -2.252755540e-7]  # fmt: skip


def s1002() -> Curve:
    """Returns the profile from the back of the flange to the field side."""

    def arc(y: Curve, centre_y: float, centre_z: float, radius: float) -> Curve:
        return centre_z + math.copysign(1, radius) * np.sqrt(radius**2 - (y - centre_y) ** 2)

    powers = np.arange(8)
    pieces = [
        (-62.765, -49.66, lambda y: arc(y, -55, 16, 12)),
        (-49.66, -39.764, lambda y: arc(y, -58.558326413, 8.834924130, 20)),
        (-39.764, -38.426, lambda y: -93.576667419 - 2.747477419 * y),
        (-38.426, -35, lambda y: arc(y, -26.210665, 16.446, -13)),
        (-35, -26, lambda y: (y[:, None] ** powers) @ THROAT),
        (-26, 32.15796, lambda y: (y[:, None] ** (powers + 1)) @ TREAD),
        (32.15796, 60, lambda y: 1.364323640 - 0.066666667 * y),
    ]
    return np.vstack([np.column_stack([y := np.linspace(a, b, 60), f(y)]) for a, b, f in pieces])


def rail_60e1(slope: float) -> Curve:
    """Returns the head, inclined towards y < 0, with its top at z = 0."""
    y, z, angle = 0.0, 0.0, 0.0
    half = [(y, z)]
    for radius, end in ((300, math.asin(10.5 / 300)), (80, math.asin(0.035 + (25.988 - 10.5) / 80)), (13, math.atan(20))):
        angles = np.linspace(angle, end, 60)[1:]
        half += [(y + radius * (math.sin(a) - math.sin(angle)), z + radius * (math.cos(angle) - math.cos(a))) for a in angles]
        (y, z), angle = half[-1], end
    half.append((y + 1, z + 20))
    right = np.array(half)
    head = np.vstack([right[::-1] * (-1, 1), right[1:]])
    tilt = math.atan(slope)
    rotated = head @ np.array([[math.cos(tilt), -math.sin(tilt)], [math.sin(tilt), math.cos(tilt)]])
    return rotated - np.array([0, rotated[:, 1].min()])


def placed_rail(side: str) -> Curve:
    """Returns the rail with its gauge face at half of the gauge."""
    rail = rail_60e1(1 / 40)
    rail[:, 0] += GAUGE / 2 - rail[rail[:, 1] <= GAUGE_HEIGHT, 0].min()
    return rail if side == "right" else rail * (-1, 1)


def placed_wheel(side: str, y: float, z: float, roll: float) -> Curve:
    """Returns the wheel with the wheelset at `y`, `z` and `roll`."""
    wheel = s1002() + np.array([WHEEL_ORIGIN, NOMINAL_RADIUS])
    if side == "left":
        wheel = wheel * (-1, 1)
    cosine, sine = math.cos(roll), math.sin(roll)
    return wheel @ np.array([[cosine, sine], [-sine, cosine]]) + (y, z - NOMINAL_RADIUS)
