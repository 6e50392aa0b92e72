"""Describes position and motion of a wheelset in contactd's terms. Units: mm, s, N, and t for masses, so that forces
are in N."""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np
import numpy.typing as npt

Array = npt.NDArray[np.float64]
GRAVITY = 9810.0  # mm/s^2
_NEXT = np.array([1, 2, 0])


class Motion(NamedTuple):
    """Holds the motion of the wheelset, with the names and signs of `contactd.wheel_rail`.

    Attributes:
        distance: Distance of the centre along the track (mm).
        y, z, roll, yaw: Its position (mm, rad).
        vx, vy, vz: Velocity of the centre relative to the track (mm/s).
        roll_rate, pitch_rate, yaw_rate: Rates about its own axes, which do not rotate with its pitch (rad/s).
    """

    distance: float
    y: float
    z: float
    roll: float
    yaw: float
    vx: float
    vy: float
    vz: float
    roll_rate: float
    pitch_rate: float
    yaw_rate: float


def axes(roll: float | Array, yaw: float | Array) -> Array:
    """Returns the wheelset's axes as columns, in track coordinates, shape [3, 3]; for many [3, 3, n]."""
    its = np if isinstance(roll, np.ndarray) else math  # numpy is several times slower for one angle
    cr, sr, cy, sy = its.cos(roll), its.sin(roll), its.cos(yaw), its.sin(yaw)
    return np.array([[cy, -sy * cr, sy * sr], [sy, cy * cr, -cy * sr], [0 * sr, sr, cr]])


def cross(first: Array, second: Array) -> Array:
    """Returns numpy.cross of vectors in the last dimension, but is several times faster for a few of them."""
    return (first * second[..., _NEXT] - first[..., _NEXT] * second)[..., _NEXT]
