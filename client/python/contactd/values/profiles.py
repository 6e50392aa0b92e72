"""Profiles of wheels and rails. They are those of the right side, also of a left wheel: y to the field side, z down, the
flange of a wheel and the gauge face of a rail at y < 0 (mm)."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy.typing as npt

from ..errors import invalid
from ..refusals import check_type
from .params import array_of, plain

__all__ = ["S1002", "ArcProfile", "ConeProfile", "Profile", "ProfilePoints", "Rail60E1", "profile_params"]


@dataclass(frozen=True)
class S1002:
    """The wheel S1002 of EN 13715: z = 0 at its tape circle, y = 0."""

    @staticmethod
    def _on_wire(_field: str) -> dict[str, Any]:
        return {"s1002": True}


@dataclass(frozen=True)
class Rail60E1:
    """The head of the rail 60E1 (UIC60), its top at z = 0.

    Attributes:
        inclination: A slope, towards y < 0; default 0: upright.
    """

    inclination: float | None = None

    def _on_wire(self, _field: str) -> dict[str, Any]:
        return {"rail_60e1": plain(self)}


@dataclass(frozen=True)
class ArcProfile:
    """A circular arc through the origin.

    Attributes:
        radius: (mm) Positive: falls off to both sides, as a rail's head; negative: rises.
        slope: dz/dy at y = 0; default 0.
        ends: y of its ends (mm); default (-40, 40).
    """

    radius: float
    slope: float | None = None
    ends: tuple[float, float] | None = None

    def _on_wire(self, _field: str) -> dict[str, Any]:
        return {"arc": _curve(self)}


@dataclass(frozen=True)
class ConeProfile:
    """A straight line through the origin.

    Attributes:
        slope: dz/dy: a wheel has the negative of its conicity.
        ends: y of its ends (mm); default (-40, 40).
    """

    slope: float
    ends: tuple[float, float] | None = None

    def _on_wire(self, _field: str) -> dict[str, Any]:
        return {"cone": _curve(self)}


@dataclass(frozen=True, eq=False)
class ProfilePoints:
    """A profile as it was measured.

    Attributes:
        points: (y, z) in the order of the curve, from either end, shape [n, 2].
        unit: Mm that a unit of the points has, 1000 for metres; default 1.
        mirror_y: Whether y points to the other side.
        mirror_z: Whether z points upwards.
        smoothing_length: Wavelength of which half the amplitude is smoothed away (mm), about 5 of measured profiles;
            default 0: none.
    """

    points: npt.ArrayLike
    unit: float | None = None
    mirror_y: bool | None = None
    mirror_z: bool | None = None
    smoothing_length: float | None = None

    def _on_wire(self, field: str) -> dict[str, Any]:
        points = array_of(self.points)
        if points.ndim != 2 or points.shape[1] != 2:
            raise invalid(f"{field}.points", f"has shape {list(points.shape)}; it must be [n, 2]", "ARRAY_INVALID")
        return {**plain(self), "points": points}


Profile = S1002 | Rail60E1 | ArcProfile | ConeProfile | ProfilePoints


def _curve(profile: ArcProfile | ConeProfile) -> dict[str, Any]:
    """With its ends as a list, whatever sequence they were given as."""
    given = plain(profile)
    return given if profile.ends is None else {**given, "ends": list(profile.ends)}


def profile_params(profile: Profile, field: str) -> dict[str, Any]:
    """A profile as the wire has it; `field` is where it stands."""
    check_type(field, profile, S1002, Rail60E1, ArcProfile, ConeProfile, ProfilePoints)
    return profile._on_wire(field)
