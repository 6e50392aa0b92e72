"""Creates the state of a wheelset that rolls without slip on its nominal radius."""

from __future__ import annotations

import math
from numbers import Real
from typing import Any

from ..generated.wheel_rail.setup import WheelRailSetup
from ..generated.wheel_rail.state import WheelRailState, WheelsetPosition, WheelsetVelocity
from .origins import RADIUS

__all__ = ["pure_rolling"]


def pure_rolling(
    setup: WheelRailSetup,
    *,
    speed: float,
    y: float,
    yaw: float,
    roll: float,
    z: float | None,
    Fz: float | None,
    Fx: float | None,
    pitch_rate: float | None,
) -> WheelRailState:
    """Returns the state at a speed (mm/s); on a roller, the wheelset stands and the roller turns."""
    given = None if setup.wheelset is None else setup.wheelset.nominal_radius
    rate = _ratio(-1, speed, RADIUS if given is None else given) if pitch_rate is None else pitch_rate
    roller = None if setup.track is None else setup.track.roller_radius
    return WheelRailState(
        position=WheelsetPosition(y=y, z=z, roll=roll, yaw=yaw),
        velocity=WheelsetVelocity(x=speed if roller is None else 0.0, pitch=rate),
        roller_pitch=0.0 if roller is None else _ratio(1, speed, roller),
        Fz=Fz,
        Fx=Fx,
    )


def _ratio(sign: float, speed: Any, radius: Any) -> float:
    """Returns the rate for a radius; 0 for values that the daemon refuses by name."""
    numbers = all(isinstance(value, Real) and not isinstance(value, bool) for value in (speed, radius))
    if not numbers or not math.isfinite(speed) or not radius > 0:
        return 0.0
    return float(sign * speed / radius)
