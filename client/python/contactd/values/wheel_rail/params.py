"""A wheel on a rail as the wire has it. Ranges are the daemon's business."""

from __future__ import annotations

from typing import Any

import numpy as np

from ...refusals import check_type
from ..materials import Material, RigidBody
from ..params import plain
from ..profiles import profile_params
from .setup import Track, WheelRailFriction, WheelRailSetup
from .state import WheelRailState, WheelsetState

__all__ = ["friction_params", "setup_params", "state_params", "wheelset_state_params"]


def setup_params(setup: WheelRailSetup, field: str = "setup") -> dict[str, Any]:
    """`setup` of wheelrail.solve; `field` is where it stands."""
    check_type(field, setup, WheelRailSetup)
    given = plain(setup)
    said = ("side", "model", "dx", "dy", "dq", "wheel_surface", "rigid_slip", "conformal")
    params: dict[str, Any] = {name: given[name] for name in said if name in given}
    params |= {name: plain(given[name]) for name in ("wheelset", "patches", "force") if name in given}
    params |= {name: profile_params(given[name], f"{field}.{name}") for name in ("wheel", "rail") if name in given}
    for slices, place in (("rail_slices", "x"), ("wheel_slices", "angle")):
        if slices in given:
            params[slices] = [
                {place: at, "profile": profile_params(profile, f"{field}.{slices}[{i}].profile")}
                for i, (at, profile) in enumerate(given[slices])
            ]
    if setup.track is not None:
        params["track"] = _track_params(setup.track)
    params["friction"] = None if setup.friction is None else friction_params(setup.friction)
    if bodies := {name: _body_params(given[name]) for name in ("upper", "lower") if name in given}:
        params["bodies"] = {"upper": plain(Material(G=82000, nu=0.28)), **bodies}
    if settings := {name: plain(given[name]) for name in ("normal", "tangential", "outer") if name in given}:
        params["settings"] = settings
    return params


def state_params(state: WheelRailState, field: str) -> dict[str, Any]:
    """`state` of wheelrail.solve; `field` is where it stands."""
    check_type(field, state, WheelRailState)
    return {**plain(state), **{name: plain(getattr(state, name)) for name in ("position", "velocity", "rail")}}


def wheelset_state_params(state: WheelsetState) -> dict[str, Any]:
    """`state` of wheelrail.wheelset."""
    check_type("state", state, WheelsetState)
    parts = ("position", "velocity", "left_rail", "right_rail")
    return {**plain(state), **{name: plain(getattr(state, name)) for name in parts}}


def _track_params(track: Track) -> dict[str, Any]:
    given = plain(track)
    if track.rail_origin is not None:
        y, z = track.rail_origin
        given["rail_origin"] = {"y": y, "z": z}
    if track.springs is not None:
        given["springs"] = plain(track.springs)
    return given


def friction_params(friction: WheelRailFriction) -> dict[str, Any]:
    """`friction` of a set-up, or of a step."""
    given = plain(friction)
    if np.ndim(friction.mu) > 0:
        given["mu"] = [{"angle": angle, "mu": mu} for angle, mu in friction.mu]  # type: ignore[union-attr]
    if friction.kinetic is not None:
        given["kinetic"] = plain(friction.kinetic)
    return given


def _body_params(body: Material | RigidBody) -> dict[str, Any]:
    return {"rigid": True} if isinstance(body, RigidBody) else plain(body)
