"""Heat in a case: thermal properties of its bodies, and temperature-dependent friction."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, Any

from ...values.generated.motion import FrictionMemory, TemperatureFriction
from ...values.generated.thermal import ThermalBodies, ThermalBody
from .features import Missing

if TYPE_CHECKING:
    from ...values.generated.contact_files import ContactCase as Case

__all__ = ["temperature_by_angle", "temperature_friction", "thermal_bodies"]

_STEADY = 3
_LAYER = 4
_BY_TEMPERATURE = 6
_CONDUCTIVITY, _DENSITY = 1e3, 1e9  #: Factors from W/(mm K) to W/(m K), and from kg/mm^3 to kg/m^3.


def thermal_bodies(case: Case) -> ThermalBodies | None:
    """Returns the thermal properties of both bodies; None if no temperatures are requested."""
    if case.digits["H"] == 0 or case.digits["T"] != _STEADY:
        return None
    plastic_share = case.values.get("BETAPL") if case.digits["M"] == _LAYER else None
    return ThermalBodies(_body(case.values, 1), _body(case.values, 2), plastic_share)


def _body(values: Mapping[str, Any], number: int) -> ThermalBody:
    return ThermalBody(
        bulk_temperature=values[f"BKTEMP{number}"],
        conductivity=_CONDUCTIVITY * values[f"LAMBDA{number}"],
        heat_capacity=values[f"HEATCP{number}"],
        density=_DENSITY * values[f"DENS{number}"],
    )


def temperature_friction(
    values: Mapping[str, Any], sets: Sequence[Mapping[str, float]]
) -> TemperatureFriction | None:
    """How friction follows the temperature, which all sets have in common. Raises Missing where they do not."""
    if values["FRCLAW"] != _BY_TEMPERATURE:
        return None
    laws = [_law(one, _memory(values)) for one in sets]
    if any(one != laws[0] for one in laws):
        raise Missing("friction by temperature that is another one from row to row (V, L = 6)")
    return laws[0]


def temperature_by_angle(
    values: Mapping[str, Any], angles: Sequence[float], sets: Sequence[Mapping[str, float]]
) -> dict[str, Any]:
    """How friction follows the temperature where the rail has these angles, as keywords of WheelRailFriction."""
    if values["FRCLAW"] != _BY_TEMPERATURE:
        return {}
    memory = _memory(values)
    laws = [_law(one, memory) for one in sets]
    if all(one == laws[0] for one in laws):
        return {"temperature": laws[0]}
    by_angle = [(angle, one.change, one.reference, one.range) for angle, one in zip(angles, laws)]
    return {"temperature_by_angle": by_angle, "memory": memory}


def _memory(values: Mapping[str, Any]) -> FrictionMemory | None:
    return FrictionMemory(values["MEMDST"], values["MEM_S0"]) if values.get("MEMDST", 0) > 0 else None


def _law(one: Mapping[str, float], memory: FrictionMemory | None) -> TemperatureFriction:
    return TemperatureFriction(one["DFHEAT"], one["TREF"], one["DTHEAT"], memory)
