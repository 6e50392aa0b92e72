"""The friction of a case: sets of values by the law in force, as contactd has them."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, Any

import numpy as np

from ...values.friction_methods import Force
from ...values.generated.friction import InterfacialLayer
from ...values.generated.grid import Grid
from ...values.generated.motion import FrictionMemory, KineticFriction, SecondTerm, SlipLaw, SlipStart
from .features import Missing

if TYPE_CHECKING:
    from ...values.generated.contact_files import ContactCase as Case

__all__ = ["Coefficients", "coefficients", "coefficients_of_sets", "layer", "shares", "static"]

Set = Mapping[str, float]
Coefficients = tuple[Any, KineticFriction | None]
"""mu of Friction, one or an array, and its fall."""

_NO_TERM = 1e-8
_FULL_SLIP = 1 - 2e-6  #: of the bound; from a millionth below on no creepage is found
_BY_TEMPERATURE = 6
_LAYER, _NEVER_YIELDS = 4, 1e10
_LAWS: dict[int, tuple[SlipLaw, float]] = {
    2: ("linear", 0.5),
    3: ("rational", 1.0),
    4: ("exponential", math.log(2)),
}
"""The law of contactd, and SABSH over its slip velocity."""


def static(law: int, one: Set) -> float:
    """The coefficient at rest."""
    if law == 0:
        return one["FSTAT"]
    return one["FREF"] if law == _BY_TEMPERATURE else one["FKIN"] + one["F1"] + one["F2"]


def coefficients(values: Mapping[str, Any], sets: Sequence[Set], grid: Grid) -> Coefficients:
    """The coefficients of one set, or of one a row of the grid."""
    rows, fall = coefficients_of_sets(values, sets)
    if len(rows) == 1:
        return rows[0], fall
    return np.repeat(np.array(rows)[:, None], grid.nx, axis=1), fall


def coefficients_of_sets(
    values: Mapping[str, Any], sets: Sequence[Set]
) -> tuple[list[float], KineticFriction | None]:
    """Coefficients at rest, and the fall that all sets have. Raises Missing where they do not all fall alike.

    INISLP < 0 lets the slip start at VELOC, which finds another solution where there are several."""
    law = values["FRCLAW"]
    start: SlipStart | None = "full_slip" if values.get("INISLP", 0) < 0 else None
    memory = FrictionMemory(values["MEMDST"], values["MEM_S0"]) if law in _LAWS and values.get("MEMDST", 0) > 0 else None
    falls = [_fall(law, one, start, memory) for one in sets]
    if any(fall != falls[0] for fall in falls):
        raise Missing("falling friction that is another one from place to place (V)")
    return [static(law, one) for one in sets], falls[0]


def _fall(law: int, one: Set, start: SlipStart | None, memory: FrictionMemory | None) -> KineticFriction | None:
    if law not in _LAWS:
        return None
    name, share = _LAWS[law]
    first, second = ((one[f"F{term}"], one[f"SABSH{term}"] / share) for term in "12")
    if first[0] <= _NO_TERM and second[0] <= _NO_TERM:
        return None
    if first[0] <= _NO_TERM and name != "rational":  # whose terms differ
        first, second = second, first
    more = SecondTerm(*second) if second[0] > _NO_TERM else None
    return KineticFriction(one["FKIN"], first[1], name, start, more, memory)


def layer(case: Case) -> InterfacialLayer | None:
    """That of M = 4."""
    if case.digits["M"] != _LAYER:
        return None
    values = case.values
    stress = values["TAU_C0"] if 0 < values["TAU_C0"] < _NEVER_YIELDS else None
    return InterfacialLayer(values["LAYTHK"] / values["GG3"], stress, values["K_TAU"] if stress else None)


def shares(case_values: Mapping[str, Any], prescribed: int, unit: float) -> Force | None:
    """The forces that shares of `unit` (N) stand for; prescribed is the digit F. A force beyond friction becomes that of full
    slip in its direction."""
    if prescribed == 0:
        return None
    x, y = case_values["FX"], case_values["FY"] if prescribed == 2 else 0.0
    size = math.hypot(x, y)
    unit *= _FULL_SLIP / size if size > _FULL_SLIP else 1
    return (x * unit, y * unit if prescribed == 2 else None)
