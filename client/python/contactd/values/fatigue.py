"""What rolling contact fatigue is asked by: strengths and functions with their sources, none of which is a default.

Written by ./dev generate from proto/schema: edit it there.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field

from .params import HasParams
from .wear_laws import WornBody

__all__ = ["DamageFunction", "FatigueRequest", "FatigueStrength", "Passage"]


@dataclass(frozen=True)
class FatigueStrength(HasParams):
    """What its steel bears.

    ::

        FatigueStrength("rail", "a torsion test of ours, 2024", shear_yield=300)

    Attributes:
        name: What the steel is called.
        source: Where its numbers come from: a paper, a test.
        shear_yield: k, the yield strength in cyclic shear (N/mm^2), > 0.
        a_DV: Dang Van's coefficient of the hydrostatic stress (>= 0); None: no stress of Dang Van.
        tau_e: Endurance limit in alternating shear, with which Dang Van's stress is compared (N/mm^2), > 0; None: it is
            not.
    """

    name: str
    source: str
    shear_yield: float
    a_DV: float | None = None
    tau_e: float | None = None


@dataclass(frozen=True)
class DamageFunction(HasParams):
    """Damage of rolling contact fatigue by T gamma without spin (N): what it is called, who says it, the range that it
    was fitted in. None is a default.

    ::

        DamageFunction("ours", "field data of ours, 2024", (0, 200), [(0, 0, 0), (20, 0, 2e-7), (65, 9e-6, -9e-8)])

    Attributes:
        name: What the function is called; no other one of the request is.
        source: Where its numbers come from: a paper, a fit.
        range: Range of T gamma (N) that it was fitted in. A contact beyond it has a warning.
        pieces: Damage of a passage by T gamma (N): pieces from an argument on, the first from 0, of value + slope
            (argument - from); below 0 wear takes cracks away.
    """

    name: str
    source: str
    range: tuple[float, float]
    pieces: Sequence[tuple[float, float, float]] = field(metadata={"keys": ("from", "value", "slope")})


@dataclass(frozen=True)
class Passage(HasParams):
    """Where stresses below the surface are wanted, from which the shakedown limit and Dang Van's stress follow.

    Attributes:
        depths: Depths (mm), ascending; None: 0 and 20 more, up to twice the smaller half-length of the contact. Nearer
            to the surface than an element the steps of the tractions show, but not at 0.
        residual: Residual stresses by depth, ascending, with straight lines between and constant beyond; stresses along
            z balance to none. They add to the hydrostatic stress of Dang Van. None: none.
    """

    depths: Sequence[float] | None = None
    residual: Sequence[tuple[float, float, float]] | None = field(
        default=None, metadata={"keys": ("depth", "xx", "yy")}
    )


@dataclass(frozen=True)
class FatigueRequest(HasParams):
    """Rolling contact fatigue of one of the bodies: with it, solutions of steady rolling along x have `fatigue`.

    ::

        FatigueRequest("upper", passage=Passage())  # the shakedown limit by the stresses below a rail's patches

    Attributes:
        body: The body; of wheels on rails upper is the rail, lower the wheel.
        strength: What its steel bears; None: nothing is compared with that.
        damages: Functions of damage by T gamma.
        passage: Where stresses below the surface are wanted, from which the shakedown limit and Dang Van's stress
            follow; None: they are not.
    """

    body: WornBody
    strength: FatigueStrength | None = None
    damages: tuple[DamageFunction, ...] | None = None
    passage: Passage | None = None
