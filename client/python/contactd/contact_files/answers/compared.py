"""The numbers of a case for a comparison with those that were printed."""

from __future__ import annotations

from dataclasses import dataclass, field

__all__ = ["Compared"]


@dataclass(frozen=True)
class Compared:
    """The numbers of a case that are compared, by the labels that they are printed under.

    Attributes:
        numbers: Those of the whole case.
        bound: mu Fn (N).
        patches: Those of each patch, of cases on rails.
        bounds: mu Fn of each patch (N).
    """

    numbers: dict[str, float]
    bound: float
    patches: list[dict[str, float]] = field(default_factory=list)
    bounds: list[float] = field(default_factory=list)
