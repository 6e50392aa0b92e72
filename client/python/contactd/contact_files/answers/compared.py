"""The numbers of a case for a comparison with printed ones."""

from __future__ import annotations

from dataclasses import dataclass, field

__all__ = ["Compared"]


@dataclass(frozen=True)
class Compared:
    """The compared numbers of a case, by their printed labels.

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
