"""Writes a wheel on a rail in its form on the wire. The daemon checks bounds."""

from __future__ import annotations

from typing import Any

from ...refusals import check_type
from ..generated.materials import Material
from ..generated.wheel_rail.setup import WheelRailSetup
from ..generated.wheel_rail.state import WheelRailState, WheelsetState
from ..params import params_of

__all__ = ["setup_params", "state_params", "wheelset_state_params"]

STEEL = Material(G=82000, nu=0.28)


def setup_params(setup: WheelRailSetup, field: str = "setup") -> dict[str, Any]:
    """Returns `setup` of wheelrail.solve; `field` is its path."""
    check_type(field, setup, WheelRailSetup)
    params: dict[str, Any] = params_of(setup, field)
    if "bodies" in params:
        params["bodies"].setdefault("upper", params_of(STEEL))
    return params


def state_params(state: WheelRailState, field: str) -> dict[str, Any]:
    """Returns `state` of wheelrail.solve; `field` is its path."""
    check_type(field, state, WheelRailState)
    params: dict[str, Any] = params_of(state, field)
    return params


def wheelset_state_params(state: WheelsetState) -> dict[str, Any]:
    """Returns `state` of wheelrail.wheelset."""
    check_type("state", state, WheelsetState)
    params: dict[str, Any] = params_of(state, "state")
    return params
