"""Steps of a session: what one says, which number it has, and what it answers."""

from __future__ import annotations

import os
import threading
from abc import ABC, abstractmethod
from collections.abc import Iterable, Iterator, Mapping
from contextlib import contextmanager
from typing import Any

from ..errors import ContactdError
from ..values.answers import read
from ..values.friction import coefficient_param, slip_param
from ..values.gaps import gap_params
from ..values.grid import Grid
from ..values.partial_solution import StepInput, StepSolution, check_arrays, names_of, on_grid

__all__ = ["ContactSteps", "Steps"]

_ROLLING = ("xi", "eta", "phi", "chi", "dq", "spin_offset", "kind", "steps", "velocity")
_SHIFT = ("rigid_shift", "rotation", "duration")


class Steps(ABC):
    """The steps of one session, which have an order: numbers them, and lets one thread of one process take them.

    Attributes:
        session: Its name.
        number: That of the last step, 0 before the first.
    """

    words: frozenset[str]  #: what a step may say

    def __init__(self, session: str, number: int) -> None:
        self.session = session
        self._process = os.getpid()
        self._in_use = threading.Lock()
        self.go_to(number)

    def go_to(self, number: int) -> None:
        """Where the session is, whatever was asked for before."""
        self.number = self._asked = number

    def check_process(self) -> None:
        """Raises ContactdError in a process that was forked."""
        if self._process != os.getpid():
            raise ContactdError(
                f"This session belongs to process {self._process}, from which process {os.getpid()} was forked; open one "
                "of your own, or take it over by client.join_session(session.name)."
            )

    @contextmanager
    def alone(self) -> Iterator[None]:
        """Two calls at once would give two steps the same number."""
        self.check_process()
        if not self._in_use.acquire(blocking=False):
            raise ContactdError(
                "A call of this session runs, in another thread or in the progress callback of this one; a session takes "
                "one step at a time, in order. Open a session for each thread."
            )
        try:
            yield
        finally:
            self._in_use.release()

    def number_of(self, step: Mapping[str, Any]) -> int:
        """The number to ask for: the next one, or with `again` the one asked for last, whatever came of it."""
        if not step.get("again") or self._asked == 0:
            self._asked = self.number + 1
        return self._asked

    def params(self, number: int, step: Mapping[str, Any]) -> dict[str, Any]:
        """The parameters of session.step. Raises TypeError or InvalidArgument for what has no form on the wire."""
        params: dict[str, Any] = {"session": self.session, "step": number}
        if step.get("again"):
            params["again"] = True
        params |= self._said(step)
        if names := names_of(step.get("fields", ())):
            params["fields"] = names
        return params

    @abstractmethod
    def _said(self, step: Any) -> dict[str, Any]:
        """What the step says beside its number and the arrays that it wants."""

    @abstractmethod
    def read(self, asked: dict[str, Any], result: Any, path: str = "result") -> Any:
        """The answer to the step with the parameters `asked`, with which the session has moved on."""


class ContactSteps(Steps):
    """The steps of a contact.

    Attributes:
        grid: The potential contact area.
    """

    words = frozenset(StepInput.__annotations__)

    def __init__(self, session: str, grid: Grid, rolls: bool, number: int) -> None:
        super().__init__(session, number)
        self.grid = grid
        self._rolls = rolls

    def _said(self, step: StepInput) -> dict[str, Any]:
        params: dict[str, Any] = {name: load for name in ("approach", "Fn") if (load := step.get(name)) is not None}
        if (gap := step.get("gap")) is not None:
            params["gap"] = gap_params(gap)
        if friction := self._friction(step):
            params["friction"] = friction
        if (derivatives := step.get("derivatives")) is not None:
            params["derivatives"] = derivatives
        return params

    def read(self, asked: dict[str, Any], result: Any, path: str = "result") -> StepSolution:
        solution = read(StepSolution, result, path)
        check_arrays(solution, asked.get("fields", ()), self.grid)
        self.number = solution.step
        return on_grid(solution, self.grid)

    def _friction(self, step: StepInput) -> dict[str, Any]:
        friction = step.get("friction")
        changes = friction.params() if friction is not None else {}
        if (mu := step.get("mu")) is not None:
            changes["mu"] = coefficient_param(mu)
        given = {name: value for name, value in step.items() if value is not None}
        shift = {name: _listed(given[name]) for name in _SHIFT if name in given}
        rolling = {name: given[name] for name in _ROLLING if name in given}
        rolls = bool(rolling) or "rolling" in changes or (self._rolls and not shift and friction is None)
        if "force" in given:
            (rolling if rolls else shift)["force"] = _listed(given["force"])
        if rolling:
            changes["rolling"] = {**changes.get("rolling", {}), **rolling}
        if (slip := step.get("rigid_slip")) is not None:
            changes["rigid_slip"] = slip_param(slip)
        return {**changes, **shift}


def _listed(value: Any) -> Any:
    """A pair as a list, whatever sequence it is. What is no sequence is the daemon's to refuse, by name."""
    return list(value) if isinstance(value, Iterable) else value
