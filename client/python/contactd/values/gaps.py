"""Undeformed distances, which the paraboloid of a Hertzian contact is one of."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy.typing as npt

from ..transport.frames import array_of, plain

__all__ = ["Paraboloid", "SemiAxes"]

@dataclass(frozen=True)
class Paraboloid:
    """Undeformed distance h = x^2/(2 Rx) + y^2/(2 Ry), without the approach. One direction may be flat, not both.

    Attributes:
        Rx: Radius of curvature along x (mm), negative where concave; None: flat.
        Ry: Radius of curvature along y (mm), negative where concave; None: flat.
    """

    Rx: float | None = None
    Ry: float | None = None


@dataclass(frozen=True)
class SemiAxes:
    """The paraboloid whose Hertzian contact, under the approach or force of the problem, has these semi-axes.

    Attributes:
        a: Semi-axis along x (mm), > 0.
        b: Semi-axis along y (mm), > 0.
    """

    a: float
    b: float


def gap_params(gap: Paraboloid | SemiAxes | npt.ArrayLike) -> dict[str, Any]:
    """`gap` of contact.solve."""
    if isinstance(gap, Paraboloid):
        return {"paraboloid": plain(gap)}
    if isinstance(gap, SemiAxes):
        return {"semi_axes": plain(gap)}
    return {"array": array_of(gap)}
