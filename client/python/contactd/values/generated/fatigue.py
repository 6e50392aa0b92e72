"""Requests for rolling contact fatigue: strengths and functions with their sources, all of them required.

Written by ./dev generate from proto/schema: edit it there.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field

from ..params import HasParams
from .wear_laws import WornBody

__all__ = ["DamageFunction", "FatigueRequest", "FatigueStrength", "Passage"]


@dataclass(frozen=True)
class FatigueStrength(HasParams):
    """Strength of the steel. If None, results are not compared with it.

    ::

        FatigueStrength("rail", "a torsion test of ours, 2024", shear_yield=300)

    Attributes:
        name: Name of the steel.
        source: Source of the values: a paper, a test.
        shear_yield: k, the yield strength in cyclic shear (N/mm^2), > 0.
        a_DV: Dang Van's coefficient of the hydrostatic stress (>= 0). If None, Dang Van's stress is not computed.
        tau_e: Endurance limit in alternating shear for comparison with Dang Van's stress (N/mm^2), > 0. If None, no
            comparison.
    """

    name: str
    source: str
    shear_yield: float
    a_DV: float | None = None
    tau_e: float | None = None


@dataclass(frozen=True)
class DamageFunction(HasParams):
    """Damage of rolling contact fatigue as a function of T gamma without spin (N): its name, its source, and the range
    in which it was fitted. There are no defaults.

    ::

        DamageFunction("ours", "field data of ours, 2024", (0, 200), [(0, 0, 0), (20, 0, 2e-7), (65, 9e-6, -9e-8)])

    Attributes:
        name: Name of the function, unique in the request.
        source: Source of the values: a paper, a fit.
        range: Range of T gamma (N) in which the function was fitted. A contact outside the range has a warning.
        pieces: Damage of a passage by T gamma (N), as pieces value + slope (argument - from), the first one from 0.
            Where damage is negative, wear removes cracks.
    """

    name: str
    source: str
    range: tuple[float, float]
    pieces: Sequence[tuple[float, float, float]] = field(metadata={"keys": ("from", "value", "slope")})


@dataclass(frozen=True)
class Passage(HasParams):
    """Settings of the stresses below the surface, which the shakedown limit and Dang Van's stress require. If None,
    these are not computed.

    Attributes:
        depths: Depths (mm), ascending. If None, 0 and 20 more, up to twice the smaller half-length of the contact. At
            depths below the size of an element, except at 0, the steps of the tractions are visible.
        residual: Residual stresses by depth, ascending, with linear interpolation and constant beyond the last depth.
            The stress along z is zero by equilibrium. They are added to the hydrostatic stress of Dang Van. If None,
            zero.
    """

    depths: Sequence[float] | None = None
    residual: Sequence[tuple[float, float, float]] | None = field(
        default=None, metadata={"keys": ("depth", "xx", "yy")}
    )


@dataclass(frozen=True)
class FatigueRequest(HasParams):
    """Rolling contact fatigue of one of the bodies. With it, solutions of steady rolling along x contain `fatigue`.

    ::

        FatigueRequest("upper", passage=Passage())  # the shakedown limit by the stresses below a rail's patches

    Attributes:
        body: The body; of wheels on rails upper is the rail, lower the wheel.
        strength: Strength of the steel. If None, results are not compared with it.
        damages: Functions of damage by T gamma.
        passage: Settings of the stresses below the surface, which the shakedown limit and Dang Van's stress require. If
            None, these are not computed.
    """

    body: WornBody
    strength: FatigueStrength | None = None
    damages: tuple[DamageFunction, ...] | None = None
    passage: Passage | None = None
