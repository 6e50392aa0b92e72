"""Compares numbers of a case with those printed by the CONTACT program."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field

from .out_reader import PrintedCase

__all__ = ["Compared", "Difference", "case_differences", "common", "differences", "matched"]

_FORCES = ("FN", "FX", "FY", "FS", "MZ", "MN", "FX(TR)", "FY(TR)", "FZ(TR)", "FX(WS)", "FY(WS)", "FZ(WS)", "BAR_FN", "BAR_FX", "BAR_FS")
_MOTIONS = ("CREEP X", "CREEP Y", "SHIFT X", "SHIFT Y", "CKSI", "CETA")
_PLACES = ("XCP(TR)", "YCP(TR)", "ZCP(TR)", "Z_WS", "DY_DEFL", "DZ_DEFL")
_COUNTS = ("NCON", "NADH", "NSLIP")
_SHARE = 5e-4
_SHARE_OF_PMAX = 4e-3
_ELEMENTS = 3.0
_NO_MOTION = 1e-9  #: Creepages and spin (1/mm) that result from rounded velocities.
_LENGTH = 0.01  # mm
_ANGLE = 2e-4  # rad


@dataclass(frozen=True)
class Compared:
    """Lists the compared numbers of a case, by their printed labels.

    Attributes:
        numbers: Numbers of the whole case.
        bound: mu Fn (N).
        patches: Numbers of each patch, for cases on rails.
        bounds: The bound mu Fn of each patch (N).
    """

    numbers: dict[str, float]
    bound: float
    patches: list[dict[str, float]] = field(default_factory=list)
    bounds: list[float] = field(default_factory=list)


@dataclass(frozen=True)
class Difference:
    """Holds a number, the printed one, and the allowed difference."""

    name: str
    printed: float
    found: float
    allowed: float

    @property
    def share(self) -> float:
        """Returns the difference divided by the tolerance; infinity for NaN."""
        apart = abs(self.found - self.printed)
        if apart == 0:
            return 0.0
        return apart / self.allowed if self.allowed > 0 and math.isfinite(apart) else math.inf

    @property
    def is_in_tolerance(self) -> bool:
        """Returns whether the difference is within the tolerance."""
        return abs(self.found - self.printed) <= self.allowed

    def __str__(self) -> str:
        apart = abs(self.found - self.printed)
        return f"{self.name} {self.found:.6g}, printed {self.printed:.6g}: {apart:.2g} apart, {self.allowed:.2g} is in tolerance"


def matched(cases: Iterable[tuple[int, int | None, int | None]], printed: Sequence[PrintedCase]) -> list[PrintedCase | None]:
    """Returns the printed case for each number, result element and contact problem: the first match that is not used
    yet, or None.
    """
    waiting: dict[tuple[int, int | None], list[PrintedCase]] = {}
    for case in printed:
        waiting.setdefault((case.number, case.reid), []).append(case)
    found = []
    for number, reid, cpid in cases:
        there = waiting.get((number, reid)) or waiting.get((number, None), [])
        theirs = next((case for case in there if case.cpid in (None, cpid or 1)), None)
        if theirs is not None:
            there.remove(theirs)
        found.append(theirs)
    return found


def case_differences(found: Compared, printed: PrintedCase) -> list[str]:
    """Returns a sentence for each number of a case that exceeds its tolerance."""
    sentences = [str(apart) for apart in differences(found.numbers, printed.numbers, found.bound)]
    if len(found.patches) != len(printed.patches):
        return [*sentences, f"{len(found.patches)} patches, printed {len(printed.patches)}"]
    for number, (patch, theirs, bound) in enumerate(zip(found.patches, printed.patches, found.bounds), 1):
        sentences += [f"patch {number}: {apart}" for apart in differences(patch, theirs, bound)]
    return sentences


def differences(found: Mapping[str, float], printed: Mapping[str, float], friction_bound: float) -> Iterator[Difference]:
    """Returns the numbers that both sides have and that exceed their tolerances."""
    return (one for one in common(found, printed, friction_bound) if not one.is_in_tolerance)


def common(found: Mapping[str, float], printed: Mapping[str, float], friction_bound: float) -> Iterator[Difference]:
    """Returns the numbers that both sides have. Relative tolerances are 5e-4 for forces and moments, the approach and
    motions, and 4e-3 for the largest pressure. Forces and moments refer to themselves or to `friction_bound`, mu Fn
    (moments: per mm); motions refer to the largest one (spin: per mm). Absolute tolerances are 3 elements, 0.01 mm for
    positions and 2e-4 rad for angles.
    """
    largest = max((abs(value) for name, value in printed.items() if name in _MOTIONS), default=0.0)
    rules: tuple[tuple[tuple[str, ...], Callable[[float], float]], ...] = (
        (_FORCES, lambda theirs: _SHARE * max(abs(theirs), friction_bound)),
        (_MOTIONS, lambda theirs: max(_SHARE * largest, _NO_MOTION)),
        (("CPHI",), lambda theirs: max(_SHARE * max(abs(theirs), largest), _NO_MOTION)),
        (("APPROACH", "VPITCH_WS"), lambda theirs: _SHARE * abs(theirs)),
        (("PMAX",), lambda theirs: _SHARE_OF_PMAX * abs(theirs)),
        (_COUNTS, lambda theirs: _ELEMENTS),
        (_PLACES, lambda theirs: _LENGTH),
        (("DELTCP(TR)",), lambda theirs: _ANGLE),
    )
    for names, rule in rules:
        for name in names:
            if name in found and name in printed:
                yield Difference(name, printed[name], found[name], rule(printed[name]))
