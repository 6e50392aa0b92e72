"""Parameters of contact.temperature from a solution."""

from __future__ import annotations

from typing import Any

from ..errors import invalid
from ..refusals import check_type
from .arrays import array_of
from .generated.motion import Rolling
from .generated.thermal import ThermalBodies
from .params import params_of
from .solution import ContactSolution

__all__ = ["temperature_params"]

_ARRAYS = ("pressure", "traction_x", "traction_y", "slip_x", "slip_y")
_OF_LAYERS = ("flow_x", "flow_y")
"""Plastic flow, of solutions with a layer that yields."""


def temperature_params(
    solution: ContactSolution, bodies: ThermalBodies | None, velocity: float | None
) -> dict[str, Any]:
    """Returns the parameters of contact.temperature."""
    check_type("solution", solution, ContactSolution)
    if bodies is not None:
        check_type("bodies", bodies, ThermalBodies)
    needed = _ARRAYS if solution.plastic_power is None else _ARRAYS + _OF_LAYERS
    if missing := [name for name in needed if getattr(solution, name, None) is None]:
        raise TypeError(
            f"solution has no {', '.join(missing)}: include them in `fields` when you request it; only problems with friction have " "slip"
        )
    if not isinstance(solution.motion, Rolling) or solution.motion.kind == "transient":
        raise invalid("solution", "does not roll steadily, which temperatures require")
    if solution.grid is None:
        raise TypeError("solution has no grid; use a solution of a client")
    rolling = solution.motion
    params: dict[str, Any] = {
        "grid": params_of(solution.grid),
        "velocity": rolling.velocity if velocity is None else velocity,
        "chi": rolling.chi or 0.0,
        **{name: array_of(getattr(solution, name)) for name in needed},
    }
    if solution.upper_speed is not None:  # at another velocity in proportion
        params["upper_speed"] = solution.upper_speed * (1.0 if velocity is None else velocity / (rolling.velocity or 1.0))
    return params if bodies is None else {**params, "temperature": params_of(bodies)}
