"""Profiles of wheels and rails. They are those of the right side, also of a left wheel: y to the field side, z down,
the flange of a wheel and the gauge face of a rail at y < 0 (mm).

Written by ./dev generate from proto/schema: edit it there.
"""

from __future__ import annotations

from dataclasses import dataclass, field

import numpy.typing as npt

from .profile_points import MeasuredProfile

__all__ = ["S1002", "ArcProfile", "ConeProfile", "Profile", "ProfilePoints", "Rail60E1"]


@dataclass(frozen=True)
class S1002:
    """The wheel S1002 of EN 13715, with z = 0 at its tape circle, y = 0."""

    _fixed = ("s1002", True)


@dataclass(frozen=True)
class Rail60E1:
    """The head of the rail 60E1 (UIC60), its top at z = 0.

    Attributes:
        inclination: A slope, towards y < 0 (-0.2 to 0.2): 0.025 is 1/40. Default 0.
    """

    _key = "rail_60e1"

    inclination: float | None = None


@dataclass(frozen=True)
class ArcProfile:
    """A circular arc through the origin.

    Attributes:
        radius: Radius, 1 to 1e5 in size (mm). Positive: falls off to both sides, as a rail's head; negative: rises.
        slope: dz/dy at y = 0 (-3 to 3). Default 0.
        ends: y of its ends (mm), the second at least 1 mm above the first. Default (-40, 40).
    """

    _key = "arc"

    radius: float
    slope: float | None = None
    ends: tuple[float, float] | None = None


@dataclass(frozen=True)
class ConeProfile:
    """A straight line through the origin.

    Attributes:
        slope: dz/dy (-3 to 3): a wheel has the negative of its conicity.
        ends: y of its ends (mm), the second at least 1 mm above the first. Default (-40, 40).
    """

    _key = "cone"

    slope: float
    ends: tuple[float, float] | None = None


@dataclass(frozen=True, eq=False)
class ProfilePoints(MeasuredProfile):
    """A profile as it was measured.

    Attributes:
        points: (y, z) in the order of the curve, from either end, shape [n, 2].
        unit: Mm that a unit of the points has, 1000 for metres. Default 1.
        mirror_y: Whether y points to the other side. Default False.
        mirror_z: Whether z points upwards. Default False.
        smoothing_length: Wavelength of which half the amplitude is smoothed away (mm), about 5 of measured profiles; 0:
            none. Default 0.
    """

    points: npt.ArrayLike = field(metadata={"array": ""})
    unit: float | None = None
    mirror_y: bool | None = None
    mirror_z: bool | None = None
    smoothing_length: float | None = None


Profile = S1002 | Rail60E1 | ArcProfile | ConeProfile | ProfilePoints
