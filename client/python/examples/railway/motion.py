"""Where a wheelset is and how it moves, in contactd's words. Units: mm, s, N, and t for masses, so that forces are in N."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
import numpy.typing as npt

Array = npt.NDArray[np.float64]
GRAVITY = 9810.0  # mm/s^2
_NEXT, _LAST = [1, 2, 0], [2, 0, 1]


class Motion(NamedTuple):
    """Of the wheelset, in the words and signs of `contactd.wheel_rail`.

    Attributes:
        distance: That the centre has gone along the track (mm).
        y, z, roll, yaw: Its place (mm, rad).
        vx, vy, vz: Velocity of the centre over the track (mm/s).
        roll_rate, pitch_rate, yaw_rate: About its own axes, which do not turn with its pitch (rad/s).
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
    """The wheelset's axes as columns, in track coordinates, shape [3, 3]; of many [3, 3, n]."""
    cr, sr, cy, sy = np.cos(roll), np.sin(roll), np.cos(yaw), np.sin(yaw)
    return np.array([[cy, -sy * cr, sy * sr], [sy, cy * cr, -cy * sr], [0 * sr, sr, cr]])


def cross(first: Array, second: Array) -> Array:
    """As numpy.cross of vectors in the last dimension, which takes several times as long for a few of them."""
    return first[..., _NEXT] * second[..., _LAST] - first[..., _LAST] * second[..., _NEXT]
