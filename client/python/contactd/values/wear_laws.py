"""Laws of wear, with all of their coefficients: none is a default.

Written by ./dev generate from proto/schema: edit it there.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field
from typing import Literal

from .params import HasParams
from .wear_law_methods import StatedWear

__all__ = [
    "ArchardWear",
    "BrWear",
    "EnergyWear",
    "SeizureWear",
    "SevereWear",
    "UsfdWear",
    "WearEnergy",
    "WearLaw",
    "WearRequest",
    "WornBody",
    "ZoboryWear",
]

WearEnergy = Literal["scaled", "plain"]
WornBody = Literal["upper", "lower"]


@dataclass(frozen=True)
class SevereWear:
    """Wear where the sliding velocity is between two.

    Attributes:
        k: k there (>= 0).
        velocity: The least and the most sliding velocity (mm/s).
    """

    k: float
    velocity: tuple[float, float]


@dataclass(frozen=True)
class SeizureWear:
    """Wear where the pressure is above a share of the hardness, whatever the velocity.

    Attributes:
        k: k there (>= 0).
        pressure: The pressure over the hardness above which it holds (>= 0).
    """

    k: float
    pressure: float


@dataclass(frozen=True)
class ArchardWear(StatedWear):
    """Archard: depth per length of path k p |s|/H, with k by a map of sliding velocity and pressure.

    Attributes:
        hardness: Hardness H of the body that wears (N/mm^2), >= 1e-12.
        mild: k where neither of the others holds (>= 0).
        severe: Wear where the sliding velocity is between two; None: none.
        seizure: Wear where the pressure is above a share of the hardness, whatever the velocity; None: none.
        source: Where the coefficients come from, for `wear` of contactd.wheel_rail, which asks for it.
        body: The body that wears, likewise; None: the wheel.
        range: Range that the law was tested in, as of WearLaw, likewise; None: not stated, so that nothing warns.
        name: What the law is called, likewise; None: by its kind.
    """

    hardness: float
    mild: float
    severe: SevereWear | None = None
    seizure: SeizureWear | None = None
    source: str | None = None
    body: Literal["wheel", "rail"] | None = None
    range: tuple[float, float] | None = None
    name: str | None = None


@dataclass(frozen=True)
class EnergyWear(StatedWear):
    """Depth per length of path in proportion to the dissipation, c |t s|.

    Attributes:
        coefficient: c, the volume that a unit of energy takes off (mm^3/J), >= 0.
        source: Where the coefficients come from, for `wear` of contactd.wheel_rail, which asks for it.
        body: The body that wears, likewise; None: the wheel.
        range: Range that the law was tested in, as of WearLaw, likewise; None: not stated, so that nothing warns.
        name: What the law is called, likewise; None: by its kind.
    """

    coefficient: float
    source: str | None = None
    body: Literal["wheel", "rail"] | None = None
    range: tuple[float, float] | None = None
    name: str | None = None


@dataclass(frozen=True)
class UsfdWear(StatedWear):
    """Sheffield's function: mass per area and length of path by |t s| (N/mm^2).

    Attributes:
        pieces: K (ug/(m mm^2)), by |t s| (N/mm^2): pieces from an argument on, the first from 0, of value + slope
            (argument - from).
        density: Density of the body (kg/m^3), >= 1e-12.
        source: Where the coefficients come from, for `wear` of contactd.wheel_rail, which asks for it.
        body: The body that wears, likewise; None: the wheel.
        range: Range that the law was tested in, as of WearLaw, likewise; None: not stated, so that nothing warns.
        name: What the law is called, likewise; None: by its kind.
    """

    pieces: Sequence[tuple[float, float, float]] = field(metadata={"keys": ("from", "value", "slope")})
    density: float
    source: str | None = None
    body: Literal["wheel", "rail"] | None = None
    range: tuple[float, float] | None = None
    name: str | None = None


@dataclass(frozen=True)
class BrWear(StatedWear):
    """British Rail's function of a whole patch, by T gamma without spin (N); spread over its rows by |t s|.

    Attributes:
        pieces: D times the area that a wheel of diameter D loses of its section per distance (mm mm^2/km), by T gamma
            (N): pieces from an argument on, the first from 0, of value + slope (argument - from).
        source: Where the coefficients come from, for `wear` of contactd.wheel_rail, which asks for it.
        body: The body that wears, likewise; None: the wheel.
        range: Range that the law was tested in, as of WearLaw, likewise; None: not stated, so that nothing warns.
        name: What the law is called, likewise; None: by its kind.
    """

    pieces: Sequence[tuple[float, float, float]] = field(metadata={"keys": ("from", "value", "slope")})
    source: str | None = None
    body: Literal["wheel", "rail"] | None = None
    range: tuple[float, float] | None = None
    name: str | None = None


@dataclass(frozen=True)
class ZoboryWear(StatedWear):
    """Zobory's function: mass by energy, by the power V |t s| (W/mm^2).

    Attributes:
        pieces: k (kg/J), by the power (W/mm^2): pieces from an argument on, the first from 0, of value + slope
            (argument - from).
        density: Density of the body (kg/m^3), >= 1e-12.
        source: Where the coefficients come from, for `wear` of contactd.wheel_rail, which asks for it.
        body: The body that wears, likewise; None: the wheel.
        range: Range that the law was tested in, as of WearLaw, likewise; None: not stated, so that nothing warns.
        name: What the law is called, likewise; None: by its kind.
    """

    pieces: Sequence[tuple[float, float, float]] = field(metadata={"keys": ("from", "value", "slope")})
    density: float
    source: str | None = None
    body: Literal["wheel", "rail"] | None = None
    range: tuple[float, float] | None = None
    name: str | None = None


@dataclass(frozen=True)
class WearLaw(HasParams):
    """A law of wear: what it is called, who says it, the range that it was tested in, and one of its five kinds with
    all of its coefficients. None is a default.

    ::

        WearLaw("mild", "our twin disc, 2024", "lower", (0, 10), energy=EnergyWear(6.75e-4))

    Attributes:
        name: What the law is called; no other one of the request is.
        source: Where its coefficients come from: a paper, a test.
        body: The body that wears by it; of wheels on rails upper is the rail, lower the wheel.
        range: Range that the law was tested in, of its argument: of archard the sliding velocity (mm/s), of energy and
            usfd |t s| (N/mm^2), of br T gamma without spin (N), of zobory the power V |t s| (W/mm^2). A contact beyond
            it has a warning.
        archard: Archard: depth per length of path k p |s|/H, with k by a map of sliding velocity and pressure.
        energy: Depth per length of path in proportion to the dissipation, c |t s|.
        usfd: Sheffield's function: mass per area and length of path by |t s| (N/mm^2).
        br: British Rail's function of a whole patch, by T gamma without spin (N); spread over its rows by |t s|.
        zobory: Zobory's function: mass by energy, by the power V |t s| (W/mm^2).
        zones: Factors of the depth by the angle of a row from the horizontal (rad), ascending, with straight lines
            between; angles are negative on the gauge side. None: 1 everywhere.
    """

    name: str
    source: str
    body: WornBody
    range: tuple[float, float]
    archard: ArchardWear | None = None
    energy: EnergyWear | None = None
    usfd: UsfdWear | None = None
    br: BrWear | None = None
    zobory: ZoboryWear | None = None
    zones: Sequence[tuple[float, float]] | None = field(default=None, metadata={"keys": ("angle", "factor")})


@dataclass(frozen=True)
class WearRequest(HasParams):
    """What a passage takes off the surfaces: with it, solutions of steady rolling along x have `wear`.

    ::

        WearRequest()  # T gamma, and what laws are made of, row by row

    Attributes:
        laws: Laws of wear; none: rows have what laws are made of.
        energy: Whether slips are scaled, by one factor for a patch, so that the dissipation of the elements sums to T
            gamma by forces and creepages, to which it converges from below; or plain. Default "scaled".
    """

    laws: tuple[WearLaw, ...] | None = None
    energy: WearEnergy | None = None
