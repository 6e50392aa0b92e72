"""Standard profiles by name: their standards, sources, and the profiles that are left out.

::

    from contactd.standard_profiles import STANDARDS
    from contactd.wheel_rail import StandardProfile, WheelRailSetup

    setup = WheelRailSetup(rail=StandardProfile("54E1", inclination=1 / 40))
    print(STANDARDS["54E1"].standard, STANDARDS["54E1"].difference)

docs/profiles.md explains how the sources were compared.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from types import MappingProxyType
from typing import Literal

from .values.generated.profile_shapes import StandardName

__all__ = ["OMITTED", "STANDARDS", "Standard"]

_EN_13674 = "dimensions of annex A, as in the public package EN13674 of A. Rohrbeck (2022)"
_ROLLAND = "points of the public package rolland (2026)"


@dataclass(frozen=True)
class Standard:
    """A standard profile with two independent sources.

    Attributes:
        of: The side that it belongs to.
        standard: The standard with its drawing.
        year: Edition of the standard. None if the sources do not state it.
        shape: Radii in mm from the top of a rail on, or the kind of formulas.
        first: Source of the dimensions or formulas.
        second: Source of the compared points.
        difference: Largest distance of these points from the profile (mm).
    """

    of: Literal["wheel", "rail"]
    standard: str
    year: int | None
    shape: str
    first: str
    second: str
    difference: float


def _rail(shape: str, difference: float) -> Standard:
    return Standard("rail", "EN 13674-1", 2017, shape, _EN_13674, _ROLLAND, difference)


#: Standard profiles by their names in contactd.wheel_rail.StandardProfile.
STANDARDS: Mapping[StandardName, Standard] = MappingProxyType(
    {
        "S1002": Standard(
            "wheel", "EN 13715", 2020, "polynomials, arcs and lines", "formulas of the standard",
            "its tables C.1 and C.2, as in the public package EN13715 of A. Rohrbeck", 0.0005,
        ),
        "UIC60": Standard(
            "rail", "UIC 861", None, "R300, R80, R13", "dimensions of the drawing",
            "points of the Manchester benchmarks, at 1/40", 5e-5,
        ),
        "49E5": _rail("R115, R16.5, R15.5, R7.64", 0.011),
        "54E1": _rail("R300, R80, R13", 0.0001),
        "54E3": _rail("R300, R80, R13", 0.0083),
        "60E1": _rail("R300, R80, R13", 0.0103),
        "60E2": _rail("R200, R70, R16, R8", 0.0139),
    }
)  # fmt: skip

#: Names of known profiles that are left out, with the reasons.
OMITTED: Mapping[str, str] = MappingProxyType(
    {
        "49E1": "its two sources disagree by 0.74 mm",
        **dict.fromkeys(("50E1", "54E4", "56E1", "GV 1/40", "EPS", "P8", "AAR-1B"), "no second source was found"),
        **dict.fromkeys(("LM", "LMA"), "points were found, but no drawing"),
        **dict.fromkeys(("115RE", "136RE", "R65"), "no public source has all dimensions of its head"),
        **dict.fromkeys(("ORE", "CN60"), "no public source was found"),
    }
)
