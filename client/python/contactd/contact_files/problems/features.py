"""Unsupported features of cases: each by its name, and by the digit or value that requests it."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from ...values.generated.contact_files import ContactCase as Case

__all__ = ["MOST_ELEMENTS", "TOO_MANY_ELEMENTS", "Missing", "missing", "prescribes_pressures"]

_NEAR = 1e-6
MOST_ELEMENTS = 4_000_000  #: Largest limit that a service can have.
#: The limit of the computing service, if known.
TOO_MANY_ELEMENTS = "areas of more elements than the service takes (MX, MY; limits.max_grid_elements)"


class Missing(Exception):
    """A case that cannot be computed because of an unsupported feature."""


@dataclass(frozen=True)
class _Feature:
    name: str
    is_needed: Callable[[Case], bool]


def missing(case: Case, most_elements: int = MOST_ELEMENTS) -> list[str]:
    """Returns the names of unsupported features of a case; `most_elements` is the limit of the service."""
    features = _BOTH + (_ON_RAILS if case.module == 1 else _BASIC)
    names = [feature.name for feature in features if feature.is_needed(case)]
    if case.module == 3 and (count := case.values["MX"] * case.values["MY"]) > most_elements:
        names.append(f"{TOO_MANY_ELEMENTS}: {count}, and it takes {most_elements}")
    return names


def _digit(name: str, digit: str, *values: int) -> _Feature:
    asked = ", ".join(map(str, values))
    return _Feature(f"{name} ({digit} = {asked})", lambda case: case.digits.get(digit) in values)


def _has_heat(case: Case) -> bool:
    return case.digits.get("H", 0) > 0 and case.digits["T"] == 3


def _is_damped(case: Case) -> bool:
    return case.digits.get("M2", 1) != 0 and any(case.values.get(name, 0) != 0 for name in ("CDAMPN", "CDAMPT"))


def _is_simplified(case: Case) -> bool:
    return case.digits["M"] in (3, 5)


def _has_no_ellipse(case: Case) -> bool:
    return case.module == 3 and case.digits["B"] not in (5, 6) and case.values["IPOTCN"] not in (-1, -2, -3, -6)


def prescribes_pressures(case: Case) -> bool:
    """Returns whether the normal problem is skipped, for pressures over an ellipse or two half ellipses."""
    return case.digits["B"] in (2, 3, 4) and not (_is_simplified(case) and case.digits["B"] != 4)


def _rolls_along_x(case: Case) -> bool:
    return case.digits["T"] == 3 and abs(math.sin(case.values["CHI"])) < _NEAR


_BOTH = (
    _digit("tractions from the pressures of the case before", "P", 1),
    _Feature("viscoelastic bodies but in steady rolling along x (M = 1, T < 3, CHI)",
             lambda case: case.module == 3 and case.digits["M"] == 1 and not _rolls_along_x(case)),
    _Feature("FASTSIM or FaStrip without Hertz's contact (M = 3, 5, IPOTCN > 0)",
             lambda case: _is_simplified(case) and _has_no_ellipse(case)),
    _digit("FASTSIM of one flexibility", "M", 2),
    _digit("trials of the simplified theory", "M", 6, 7),
    _Feature("friction by temperature without heat (L = 6, H = 0)",
             lambda case: case.values.get("FRCLAW") == 6 and case.digits["T"] > 0 and not _has_heat(case)),
    _Feature("damping (M2)", _is_damped),
    _Feature("surface temperature under bilinear tractions (H, C = 3)",
             lambda case: _has_heat(case) and case.values.get("INFLCF") == 3),
)

_BASIC = (
    _Feature("shares of a normal force of viscoelastic bodies that is not known before the solve (M = 1, N = 0, F > 0)",
             lambda case: case.digits["M"] == 1 and case.digits["N"] == 0 and case.digits["F"] > 0),
    _Feature("parabolic traction bound with FaStrip (B = 3, M = 5)",
             lambda case: case.digits["B"] == 3 and case.digits["M"] == 5),
    _Feature("prescribed pressures of a line (B = 2, 3, IPOTCN = -4, -5)",
             lambda case: prescribes_pressures(case) and case.values["IPOTCN"] in (-4, -5)),
    _Feature("pressures of two half ellipses but prescribed ones (IPOTCN = -6, B = 0)",
             lambda case: case.values.get("IPOTCN") == -6 and case.digits["B"] != 4),
    _Feature("half-spaces that turn (C = 4)", lambda case: case.values.get("INFLCF") == 4),
    _Feature("patches that share their displacements but with pressures of the full theory (IPLAN = 4, B > 1)",
             lambda case: case.values.get("IPOTCN", 0) > 0 and case.values.get("IPLAN") == 4 and case.digits["B"] > 1),
)  # fmt: skip

_ON_RAILS = (
    _digit("viscoelastic bodies on rails", "M", 1),
    _digit("elliptic or parabolic traction bound", "B", 2, 3, 4),
    _Feature("FASTSIM or FaStrip on rails with pressures of the full theory (M = 3, 5, B = 0)",
             lambda case: _is_simplified(case) and case.digits["B"] not in (5, 6)),
    _Feature("bilinear tractions on rails (C = 3)", lambda case: case.values.get("INFLCF") == 3),
    _Feature("half-spaces that turn in a plane contact (C = 4)",
             lambda case: case.values.get("INFLCF") == 4 and case.values.get("DISCNS") != 4),
    _Feature("half-spaces that turn with their loads (C = 4, VARIANT = 1, 2)",
             lambda case: case.values.get("INFLCF") == 4 and case.values.get("VARIANT") in (1, 2)),
    _Feature("trials of the discretisation (D = 6 to 9)", lambda case: case.values.get("DISCNS", 2) > 5),
    _Feature("a roller placed by its gauge that deviates with its axle (DZRAIL)",
             lambda case: case.digits["C1"] >= 4 and case.values.get("DZRAIL", 0) != 0 and case.values["GAUGHT"] > 0),
)  # fmt: skip
