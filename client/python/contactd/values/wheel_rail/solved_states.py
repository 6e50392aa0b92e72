"""The states that solutions of wheels on rails were solved for, beside the solutions, as long as these live."""

from __future__ import annotations

from typing import Any
from weakref import WeakKeyDictionary

__all__ = ["remember_state", "state_of"]

_STATES: WeakKeyDictionary[Any, Any] = WeakKeyDictionary()


def remember_state(solution: Any, state: Any) -> None:
    """Keeps the state beside the solution, and not in it: what is saved, pickled or compared is the answer alone."""
    _STATES[solution] = state


def state_of(solution: Any) -> Any:
    """Returns the WheelRailState, or None."""
    return _STATES.get(solution)
