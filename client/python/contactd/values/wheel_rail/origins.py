"""What solutions of wheels on rails were solved for, as long as they live: pictures draw the profiles that touch each other."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any, NamedTuple
from weakref import WeakKeyDictionary

from .rigid_wheelset import PlacedProfiles
from .setup import Side, WheelRailSetup
from .state import RailDeviation, WheelRailState, WheelsetPosition

__all__ = ["RADIUS", "Origin", "origin_of", "remember"]

RADIUS = 460.0  #: of the wheel, where the set-up names none (mm)


class Origin(NamedTuple):
    """Where a solution comes from."""

    side: Side | None  #: None is that of the set-up by default
    nominal_radius: float
    position: WheelsetPosition
    rail: RailDeviation
    #: Asks for the profiles of the side; None where nobody can be asked any more.
    profiles: Callable[[], PlacedProfiles | None]

    @staticmethod
    def of(setup: WheelRailSetup, state: WheelRailState, profiles: Callable[[], PlacedProfiles | None]) -> Origin:
        """Returns that of a set-up and a state."""
        radius = None if setup.wheelset is None else setup.wheelset.nominal_radius
        return Origin(setup.side, RADIUS if radius is None else radius, state.position, state.rail, profiles)


_ORIGINS: WeakKeyDictionary[Any, Origin] = WeakKeyDictionary()


def remember(solution: Any, origin: Origin) -> None:
    """Keeps the origin beside the solution, and not in it: what is saved, pickled or compared is the answer alone."""
    _ORIGINS[solution] = origin


def origin_of(solution: Any) -> Origin | None:
    return _ORIGINS.get(solution)
