"""Keeps the states of solutions of wheels on rails as long as the solutions."""

from __future__ import annotations

from typing import Any
from weakref import WeakKeyDictionary

__all__ = ["remember_state", "state_of"]

_STATES: WeakKeyDictionary[Any, Any] = WeakKeyDictionary()


def remember_state(solution: Any, state: Any) -> None:
    """Stores the state separately, so that saving, pickling and comparing a solution only concern the answer."""
    _STATES[solution] = state


def state_of(solution: Any) -> Any:
    """Returns the WheelRailState, or None."""
    return _STATES.get(solution)
