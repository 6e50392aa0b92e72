"""Checks the units of a measured curve by its magnitudes."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np

from ..errors import invalid
from .creep_curves import Response
from .measured_curve import MeasuredCurve

__all__ = ["check_coefficients", "unlikely_forces"]

_LARGEST_COEFFICIENT = 2.0  #: The daemon's limit of friction.mu.
_LEAST_COEFFICIENT = 1e-3  #: Lower limit for a curve: less than any lubricated contact.


def check_coefficients(points: MeasuredCurve, response: Response) -> None:
    """Raises InvalidArgument for forces, or percentages, given as coefficients."""
    largest = float(np.max(np.abs(points.value)))
    if response.is_coefficient and largest > _LARGEST_COEFFICIENT:
        raise invalid(
            "measured",
            f"reaches {largest:g}, but traction coefficients are below {_LARGEST_COEFFICIENT:g}. For forces in N set quantity to "
            '"force"; divide coefficients in percent by 100',
        )


def unlikely_forces(points: MeasuredCurve, response: Response, params: Mapping[str, Any]) -> list[str]:
    """Returns sentences about forces that are implausible for the prescribed normal force."""
    Fn = params.get("Fn")
    if response.is_coefficient or not isinstance(Fn, (int, float)) or not Fn > 0:
        return []
    largest = float(np.max(np.abs(points.value)))
    if _LEAST_COEFFICIENT * Fn <= largest <= _LARGEST_COEFFICIENT * Fn:
        return []
    return [
        f"measured reaches {largest:g} N, {largest / Fn:.2g} of the normal force, {Fn:g} N. Give forces in N, not in kN. For " 'coefficients set quantity to "coefficient".'
    ]
