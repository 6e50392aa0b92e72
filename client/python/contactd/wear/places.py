"""Converts rows in track coordinates to points of a profile of the right side; a left wheel is mirrored."""

from __future__ import annotations

import math

import numpy as np
import numpy.typing as npt

__all__ = ["rows_on_rail", "rows_on_wheel"]

Array = npt.NDArray[np.float64]


def rows_on_wheel(
    y: npt.ArrayLike, z: npt.ArrayLike, *, x: float, position: dict[str, float], origin: float, radius: float, left: bool = False
) -> Array:
    """Returns points (y, z) in the wheel's profile for rows at y and z (mm) in the track; x is along the track from the
    wheelset.

    `position` has y, z (as computed), roll and yaw of the wheelset. `origin` is that of the profile from the middle of
    the axle, `radius` the nominal radius.
    """
    side = -1.0 if left else 1.0
    roll, yaw = side * position.get("roll", 0.0), side * position.get("yaw", 0.0)
    away = side * np.asarray(y, dtype=np.float64) - side * position.get("y", 0.0)
    down = np.asarray(z, dtype=np.float64) + radius - position.get("z", 0.0)
    along = x * math.cos(yaw) + away * math.sin(yaw)
    across = away * math.cos(yaw) - x * math.sin(yaw)
    outwards = across * math.cos(roll) + down * math.sin(roll)
    below = down * math.cos(roll) - across * math.sin(roll)
    return np.stack([outwards - origin, np.hypot(along, below) - radius], axis=-1)


def rows_on_rail(
    y: npt.ArrayLike, z: npt.ArrayLike, *, origin: tuple[float, float], deviation: tuple[float, float] = (0.0, 0.0), left: bool = False
) -> Array:
    """Returns points (y, z) in the rail's profile, rotated by the cant, for rows at y and z (mm) in the track. `origin`
    is its position, `deviation` that of the rail in the track.
    """
    side = -1.0 if left else 1.0
    across = side * (np.asarray(y, dtype=np.float64) - deviation[0]) - origin[0]
    return np.stack([across, np.asarray(z, dtype=np.float64) - deviation[1] - origin[1]], axis=-1)
