"""The benchmark of EN 15302: combinations of profiles, conicities and their tolerances."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

from contactd.wheel_rail import Profile, ProfilePoints, Track, WheelRailSetup, Wheelset

from .reference_profiles import RAIL, WHEELS, points_of

__all__ = ["COMBINATIONS", "Benchmark", "Combination", "bounds", "own_benchmark"]

GAUGE, FLANGE_BACKS, CONTACT_DISTANCE = 1435.16, 1360.0, 1500.0  #: mm
_LARGEST_TOLERANCE = 0.05
_TOLERANCE_OF_ZERO = 0.01  #: The public values have it where the conicity is 0.


@dataclass(frozen=True)
class Combination:
    """Wheels on rail A.

    Attributes:
        right: Profile of the right wheel.
        left: Profile of the left wheel.
        left_radius: Nominal radius of the left wheel (mm); that of the right wheel is 460 mm.
    """

    right: str
    left: str
    left_radius: float = 460.0

    @property
    def title(self) -> str:
        """The wheels, as the standard writes them."""
        return f"{self.right}/{self.left}" + ("" if self.left_radius == 460 else f", radii 460 and {self.left_radius:g}")


COMBINATIONS = {
    "E1": Combination("A", "A"),
    "E2": Combination("B", "B"),
    "E3": Combination("H", "H"),
    "E4": Combination("I", "I"),
    "E5": Combination("A", "A", 459.0),
    "E6": Combination("B", "B", 459.0),
    "E7": Combination("H", "H", 459.0),
    "E8": Combination("I", "I", 459.0),
    "E9": Combination("A", "B"),
}


@dataclass(frozen=True)
class Benchmark:
    """Profiles, and the conicities to be met.

    Attributes:
        wheels: Profiles of the wheels by their letters.
        rail: Profile of the rail.
        values: Amplitudes (mm) and conicities of each combination.
    """

    wheels: Mapping[str, Profile]
    rail: Profile
    values: Mapping[str, Sequence[tuple[float, float]]]

    def setups(self, name: str) -> tuple[WheelRailSetup, WheelRailSetup]:
        """Returns the set-ups of the right and the left side of a combination."""
        combination = COMBINATIONS[name]
        sides = ((combination.right, 460.0), (combination.left, combination.left_radius))
        right, left = (
            WheelRailSetup(
                wheel=self.wheels[letter], rail=self.rail, track=Track(gauge=GAUGE),
                wheelset=Wheelset(nominal_radius=radius, flange_back_distance=FLANGE_BACKS),
            )
            for letter, radius in sides
        )  # fmt: skip
        return right, left


def bounds(reference: float) -> tuple[float, float]:
    """Returns the limits of a conicity: +- min(0.05, half the value), or +- 0.01 where the value is 0 (EN 15302:2008,
    annex F).
    """
    tolerance = min(_LARGEST_TOLERANCE, reference / 2) if reference > 0 else _TOLERANCE_OF_ZERO
    return max(0.0, reference - tolerance), reference + tolerance


_AMPLITUDES = (1.0, 2.0, 3.0, 4.0, 6.0, 7.0, 7.5)  #: mm
_CONICITIES = {
    "E1": (0.125, 0.155, 0.188, 0.216, 0.303, 0.505, 0.640),
    "E2": (0.025, 0.025, 0.058, 0.241, 0.302, 0.485, 0.627),
    "E3": (0.025, 0.025, 0.245, 0.319, 0.284, 0.437, 0.597),
    "E4": (0.0, 0.293, 0.489, 0.485, 0.447, 0.486, 0.643),
    "E5": (0.280, 0.272, 0.261, 0.269, 0.395, 0.492, 0.623),
    "E9": (0.137, 0.104, 0.132, 0.225, 0.307, 0.493, 0.634),
}


def own_benchmark() -> Benchmark:
    """Returns six combinations at seven amplitudes, on profiles that are built here."""
    wheels = {letter: ProfilePoints(points_of(outline)) for letter, outline in WHEELS.items()}
    values = {name: list(zip(_AMPLITUDES, conicities)) for name, conicities in _CONICITIES.items()}
    return Benchmark(wheels, ProfilePoints(points_of(RAIL)), values)
