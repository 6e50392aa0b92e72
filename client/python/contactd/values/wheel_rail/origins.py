"""Set-ups and states of solutions of wheels on rails, kept as long as the solutions, so that plots can draw the
profiles.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any, NamedTuple
from weakref import WeakKeyDictionary

from ..generated.wheel_rail.rigid_wheelset import PlacedProfiles
from ..generated.wheel_rail.setup import Side, WheelRailSetup
from ..generated.wheel_rail.state import RailDeviation, WheelRailState, WheelsetPosition

__all__ = ["RADIUS", "Origin", "origin_of", "remember"]

RADIUS = 460.0  #: Default of the wheel (mm).


class Origin(NamedTuple):
    """Set-up, state and client of a solution."""

    side: Side | None  #: None is the default set-up.
    nominal_radius: float
    position: WheelsetPosition
    rail: RailDeviation
    #: Requests the profiles of the side; None if no client is available.
    profiles: Callable[[], PlacedProfiles | None]

    @staticmethod
    def of(setup: WheelRailSetup, state: WheelRailState, profiles: Callable[[], PlacedProfiles | None]) -> Origin:
        """Returns the origin for a set-up and a state."""
        radius = None if setup.wheelset is None else setup.wheelset.nominal_radius
        return Origin(setup.side, RADIUS if radius is None else radius, state.position, state.rail, profiles)


_ORIGINS: WeakKeyDictionary[Any, Origin] = WeakKeyDictionary()


def remember(solution: Any, origin: Origin) -> None:
    """Stores the origin separately, so that saving, pickling and comparing a solution only concern the answer."""
    _ORIGINS[solution] = origin


def origin_of(solution: Any) -> Origin | None:
    return _ORIGINS.get(solution)
