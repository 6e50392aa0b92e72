"""What solutions of wheels on rails were solved for, as long as they live: pictures draw the profiles that touch each other."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any, NamedTuple
from weakref import WeakKeyDictionary

from .rigid_wheelset import PlacedProfiles
from .setup import WheelRailSetup
from .state import WheelRailState

__all__ = ["Origin", "origin_of", "remember"]


class Origin(NamedTuple):
    """Where a solution comes from."""

    setup: WheelRailSetup
    state: WheelRailState
    #: Asks for the profiles of the side; None where nobody can be asked any more.
    profiles: Callable[[], PlacedProfiles | None]


_ORIGINS: WeakKeyDictionary[Any, Origin] = WeakKeyDictionary()


def remember(solution: Any, origin: Origin) -> None:
    """Keeps the origin beside the solution, and not in it: what is saved, pickled or compared is the answer alone."""
    _ORIGINS[solution] = origin


def origin_of(solution: Any) -> Origin | None:
    return _ORIGINS.get(solution)
