"""Limits of Nadal and Prud'homme."""

from __future__ import annotations

import math

__all__ = ["nadal_limit", "prudhomme_limit"]

_BASE = 10e3  #: N


def nadal_limit(flange_angle: float, mu: float) -> float:
    """Returns the largest Y/Q without climbing of the flange, (tan d - mu) / (1 + mu tan d), for the flange angle d
    (rad) and the friction coefficient (Nadal, Locomotives à vapeur, 1908).
    """
    slope = math.tan(flange_angle)
    return (slope - mu) / (1 + mu * slope)


def prudhomme_limit(axle_load: float, factor: float = 1.0) -> float:
    """Returns the largest sum of the lateral forces of a wheelset (N), factor (10 kN + P/3), for its static vertical
    force P (N). The factor is 1, or 0.85 for freight wagons (Prud'homme, Revue générale des chemins de fer 86, 1967,
    as in UIC 518 and EN 14363).
    """
    return factor * (_BASE + axle_load / 3)
