"""From rows in track coordinates to points of a profile, of the right side: a left wheel is one in a mirror."""

from __future__ import annotations

import math

import numpy as np
import numpy.typing as npt

__all__ = ["rows_on_rail", "rows_on_wheel"]

Array = npt.NDArray[np.float64]


def rows_on_wheel(
    y: npt.ArrayLike, z: npt.ArrayLike, *, x: float, position: dict[str, float], origin: float, radius: float, left: bool = False
) -> Array:
    """Points (y, z) in the wheel's profile of rows at y and z (mm) of the track, x from the wheelset along the track.

    `position` has y, z, roll and yaw of the wheelset, z as it was found; `origin` is that of the profile from the middle of the
    axle, `radius` the nominal one.
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
    """Points (y, z) in the rail's profile, as cant turned it, of rows at y and z (mm) of the track. `origin` is where its
    origin stands, `deviation` what the rail is off by, in the track."""
    side = -1.0 if left else 1.0
    across = side * (np.asarray(y, dtype=np.float64) - deviation[0]) - origin[0]
    return np.stack([across, np.asarray(z, dtype=np.float64) - deviation[1] - origin[1]], axis=-1)
