"""Profiles of wheels and rails. They are those of the right side, also of a left wheel: y to the field side, z down,
the flange of a wheel and the gauge face of a rail at y < 0 (mm).

Written by ./dev generate from proto/schema: edit it there.
"""

from __future__ import annotations

from dataclasses import dataclass, field
from os import PathLike
from typing import Literal

import numpy.typing as npt

from ..profile_points import FileOfProfile, MeasuredProfile

__all__ = [
    "S1002",
    "ArcProfile",
    "ConeProfile",
    "KinkRule",
    "Profile",
    "ProfileFile",
    "ProfilePoints",
    "Rail60E1",
    "StandardName",
    "StandardProfile",
]

StandardName = Literal["S1002", "UIC60", "49E5", "54E1", "54E3", "60E1", "60E2"]


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
        radius: Radius, 1 to 1e5 in size (mm). Positive for a profile that falls off to both sides, such as a rail's
            head; negative for one that rises.
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
        slope: dz/dy, the negative of a wheel's conicity (-3 to 3).
        ends: y of its ends (mm), the second at least 1 mm above the first. Default (-40, 40).
    """

    _key = "cone"

    slope: float
    ends: tuple[float, float] | None = None


@dataclass(frozen=True)
class StandardProfile:
    """A wheel or the head of a rail by its name.

    ::

        StandardProfile("54E1", inclination=1 / 40)

    Attributes:
        name: S1002: the wheel of EN 13715, like the shape s1002. UIC60: the shape rail_60e1. Others: rails of EN
            13674-1:2017; 60E1 differs from UIC60 by at most 0.04 mm.
        inclination: Slope of a rail, towards y < 0 (-0.2 to 0.2): 0.025 is 1/40. Wheels have none. Default 0.
    """

    _key = "standard"

    name: StandardName
    inclination: float | None = None


@dataclass(frozen=True, eq=False)
class ProfilePoints(MeasuredProfile):
    """A measured profile.

    Attributes:
        points: (y, z) in the order of the curve, from either end, shape [n, 2].
        unit: Unit of the points in mm; 1000 for metres. Default 1.
        mirror_y: True if y points to the other side. Default False.
        mirror_z: True if z points upwards. Default False.
        smoothing_length: Wavelength whose amplitude smoothing halves (mm), about 5 for measured profiles; 0: no
            smoothing. Default 0.
    """

    points: npt.ArrayLike = field(metadata={"array": ""})
    unit: float | None = None
    mirror_y: bool | None = None
    mirror_z: bool | None = None
    smoothing_length: float | None = None


@dataclass(frozen=True)
class KinkRule:
    """Definition of a kink, at which the curve is broken.

    Attributes:
        angle: Points turn by more than this angle at a kink (rad), 0 to 3.14159. Default 0.5235987755982988.
        rest: Points near a kink turn by no more than this angle anywhere else (rad), 0 to 3.14159. Default
            0.10471975511965978.
        width: Distance along the points, on both sides of a kink, that counts as near it (mm), >= 0. Default 2.
    """

    angle: float | None = None
    rest: float | None = None
    width: float | None = None


@dataclass(frozen=True, repr=False)
class ProfileFile(FileOfProfile):
    """A profile in a file: Simpack (.prr, .prw), MiniProf (.ban, .whl), or two columns y and z.

    The file is read on construction, and its text is sent. Options here apply in addition to those in the file. Without
    either, the direction of z is detected from the shape of the points; an ambiguous profile is refused.

    ::

        ProfileFile("wheels/0815.whl", smoothing_length=5)
        ProfileFile("rail.csv", unit=25.4, mirror_z=True)  # in inches, z upwards

    Attributes:
        name: Path of the file; its extension determines the format.
        text: Content of the file; None: read from the path.
        unit: Length of the unit of the points in mm, instead of that in the file (>= 1e-06): 1000 for metres, 25.4 for
            inches. If None, the unit stated in the file, otherwise mm. Impossible widths of wheels and rails are
            refused.
        mirror_y: True to mirror y, after the settings of the file. Default False.
        mirror_z: True to mirror z, after the settings of the file. If None, Simpack files state the direction, and
            other files are mirrored if the shape of the points requires it; an ambiguous shape is refused.
        shift_y: Added to y last, after mirroring (mm). Default 0.
        shift_z: Added to z last, after mirroring (mm). Default 0.
        smoothing_length: Wavelength at which smoothing halves the amplitude, about 5 for measured profiles (mm), >= 0;
            0: no smoothing. Default 0.
        smoothing_order: Order of the derivative that smoothing minimizes (2 to 3): 2, the curvature, or 3, its change,
            by splines of a quarter of smoothing_length. Default 2.
        smoothing_lambda: Alternative to smoothing_length (mm^3), >= 0: weight of the integral of the squared curvature,
            with weight 1 for all points. The amplitude is halved for waves of length 2 pi (smoothing_lambda
            spacing)^(1/4). Default 0.
        kinks: Definition of a kink, at which the curve is broken.
    """

    _key = "file"

    name: str | PathLike[str]
    text: str | bytes | None = None
    unit: float | None = None
    mirror_y: bool | None = None
    mirror_z: bool | None = None
    shift_y: float | None = None
    shift_z: float | None = None
    smoothing_length: float | None = None
    smoothing_order: int | None = None
    smoothing_lambda: float | None = None
    kinks: KinkRule | None = None


Profile = S1002 | Rail60E1 | ArcProfile | ConeProfile | StandardProfile | ProfilePoints | ProfileFile
