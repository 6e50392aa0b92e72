"""Laws of wear. All coefficients are required.

Written by ./dev generate from proto/schema: edit it there.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field
from typing import Literal

from ..params import HasParams
from ..wear_law_methods import StatedWear

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
    """Wear for sliding velocities between two bounds. If None, none.

    Attributes:
        k: k in this region (>= 0).
        velocity: Smallest and largest sliding velocity (mm/s).
    """

    k: float
    velocity: tuple[float, float]


@dataclass(frozen=True)
class SeizureWear:
    """Wear for pressures above a fraction of the hardness, at any velocity. If None, none.

    Attributes:
        k: k in this region (>= 0).
        pressure: Pressure over hardness above which the region applies (>= 0).
    """

    k: float
    pressure: float


@dataclass(frozen=True)
class ArchardWear(StatedWear):
    """Archard: depth per length of path k p |s|/H, with k by a map of sliding velocity and pressure.

    Attributes:
        hardness: Hardness H of the body that wears (N/mm^2), >= 1e-12.
        mild: k outside the two other regions (>= 0).
        severe: Wear for sliding velocities between two bounds. If None, none.
        seizure: Wear for pressures above a fraction of the hardness, at any velocity. If None, none.
        source: Source of the coefficients, which `wear` of contactd.wheel_rail requires.
        body: The worn body, for the same argument; None: the wheel.
        range: Tested range of the law, for the same argument (see WearLaw); None: unknown, so there are no warnings.
        name: Name of the law, for the same argument; None: that of its kind.
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
        coefficient: c, the volume removed per unit of energy (mm^3/J), >= 0.
        source: Source of the coefficients, which `wear` of contactd.wheel_rail requires.
        body: The worn body, for the same argument; None: the wheel.
        range: Tested range of the law, for the same argument (see WearLaw); None: unknown, so there are no warnings.
        name: Name of the law, for the same argument; None: that of its kind.
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
        pieces: K (ug/(m mm^2)) by |t s| (N/mm^2), as pieces value + slope (argument - from), the first one from 0.
        density: Density of the body (kg/m^3), >= 1e-12.
        source: Source of the coefficients, which `wear` of contactd.wheel_rail requires.
        body: The worn body, for the same argument; None: the wheel.
        range: Tested range of the law, for the same argument (see WearLaw); None: unknown, so there are no warnings.
        name: Name of the law, for the same argument; None: that of its kind.
    """

    pieces: Sequence[tuple[float, float, float]] = field(metadata={"keys": ("from", "value", "slope")})
    density: float
    source: str | None = None
    body: Literal["wheel", "rail"] | None = None
    range: tuple[float, float] | None = None
    name: str | None = None


@dataclass(frozen=True)
class BrWear(StatedWear):
    """British Rail's function of a whole patch, by T gamma without spin (N), distributed over its rows by |t s|.

    Attributes:
        pieces: D times the area that the section of a wheel of diameter D loses per distance (mm mm^2/km), by T gamma
            (N), as pieces value + slope (argument - from), the first one from 0.
        source: Source of the coefficients, which `wear` of contactd.wheel_rail requires.
        body: The worn body, for the same argument; None: the wheel.
        range: Tested range of the law, for the same argument (see WearLaw); None: unknown, so there are no warnings.
        name: Name of the law, for the same argument; None: that of its kind.
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
        pieces: k (kg/J) by the power (W/mm^2), as pieces value + slope (argument - from), the first one from 0.
        density: Density of the body (kg/m^3), >= 1e-12.
        source: Source of the coefficients, which `wear` of contactd.wheel_rail requires.
        body: The worn body, for the same argument; None: the wheel.
        range: Tested range of the law, for the same argument (see WearLaw); None: unknown, so there are no warnings.
        name: Name of the law, for the same argument; None: that of its kind.
    """

    pieces: Sequence[tuple[float, float, float]] = field(metadata={"keys": ("from", "value", "slope")})
    density: float
    source: str | None = None
    body: Literal["wheel", "rail"] | None = None
    range: tuple[float, float] | None = None
    name: str | None = None


@dataclass(frozen=True)
class WearLaw(HasParams):
    """A law of wear: its name, its source, the range in which it was tested, and one of its five kinds with all
    coefficients. There are no defaults.

    ::

        WearLaw("mild", "our twin disc, 2024", "lower", (0, 10), energy=EnergyWear(6.75e-4))

    Attributes:
        name: Name of the law, unique in the request.
        source: Source of the coefficients: a paper, a test.
        body: The body that wears. For wheels on rails, upper is the rail and lower the wheel.
        range: Range of the argument in which the law was tested: the sliding velocity (mm/s) for archard, |t s|
            (N/mm^2) for energy and usfd, T gamma without spin (N) for br, the power V |t s| (W/mm^2) for zobory. A
            contact outside the range has a warning.
        archard: Archard: depth per length of path k p |s|/H, with k by a map of sliding velocity and pressure.
        energy: Depth per length of path in proportion to the dissipation, c |t s|.
        usfd: Sheffield's function: mass per area and length of path by |t s| (N/mm^2).
        br: British Rail's function of a whole patch, by T gamma without spin (N), distributed over its rows by |t s|.
        zobory: Zobory's function: mass by energy, by the power V |t s| (W/mm^2).
        zones: Factors of the depth by the angle of a row from the horizontal (rad), ascending, with linear
            interpolation. Angles are negative on the gauge side. If None, 1 everywhere.
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
    """Laws of wear of the surfaces. With them, solutions of steady rolling along x contain `wear`.

    ::

        WearRequest()  # T gamma, and the variables of laws, row by row

    Attributes:
        laws: Laws of wear. An empty list returns only the inputs of the laws for each row.
        energy: scaled: slips are multiplied by one factor per patch, so that the dissipation of the elements sums to T
            gamma from forces and creepages, to which it converges from below. plain: not scaled. Default "scaled".
    """

    laws: tuple[WearLaw, ...] | None = None
    energy: WearEnergy | None = None
