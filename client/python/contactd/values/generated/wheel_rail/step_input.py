"""Inputs of a step of a wheel on its rail.

Written by ./dev generate from proto/schema: edit it there.
"""

from __future__ import annotations

from typing import TypedDict

from ...solution import Fields
from .setup import WheelRailFriction
from .state import WheelRailState

__all__ = ["WheelRailStepInput"]


class WheelRailStepInput(TypedDict, total=False):
    """Inputs of a step: the arguments of WheelRailSession.step, for Client.step_many, as in ``{"state": state}``."""

    state: WheelRailState
    friction: WheelRailFriction | None
    fields: Fields
    gap: bool
    patches: bool
    again: bool
