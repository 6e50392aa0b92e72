"""Inputs of a step of a contact.

Written by ./dev generate from proto/schema: edit it there.
"""

from __future__ import annotations

from typing import TypedDict

import numpy.typing as npt

from ..friction_methods import Force
from ..solution import Fields
from .friction import Friction
from .grid import HalfEllipses, Paraboloid, SemiAxes
from .motion import RollingKind

__all__ = ["StepInput"]


class StepInput(TypedDict, total=False):
    """Inputs of a step: the keywords of Session.step, for Client.step_many, as in ``{"Fn": 9e3, "xi": 1e-3}``."""

    approach: float | None
    Fn: float | None
    gap: Paraboloid | SemiAxes | HalfEllipses | npt.ArrayLike | None
    friction: Friction | None
    mu: float | npt.ArrayLike | None
    force: Force | None
    rigid_shift: tuple[float, float] | None
    rotation: float | None
    duration: float | None
    rigid_slip: tuple[npt.ArrayLike, npt.ArrayLike] | None
    xi: float | None
    eta: float | None
    phi: float | None
    chi: float | None
    dq: float | None
    spin_offset: float | None
    kind: RollingKind | None
    steps: int | None
    velocity: float | None
    derivatives: bool | None
    displacements: bool | None
    fields: Fields
    again: bool
