"""Manages the order of the steps of a session: their numbers, and which thread may use the session."""

from __future__ import annotations

import os
import threading
from abc import ABC, abstractmethod
from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from typing import Any

from ..errors import ContactdError
from ..values.solution import names_of

__all__ = ["Steps"]


class Steps(ABC):
    """Manages the steps of one session. Numbers them, and admits one thread of one process at a time.

    Attributes:
        session: The name of the session.
        number: Number of the last step; 0 before the first.
    """

    words: frozenset[str]  #: keywords of a step

    def __init__(self, session: str, number: int) -> None:
        self.session = session
        self._process = os.getpid()
        self._in_use = threading.Lock()
        self.go_to(number)

    def go_to(self, number: int) -> None:
        """Sets the current step of the session, independent of earlier requests."""
        self.number = self._asked = number

    def check_process(self) -> None:
        """Raises ContactdError in a process that was forked."""
        if self._process != os.getpid():
            raise ContactdError(
                f"This session belongs to process {self._process}, from which process {os.getpid()} was forked; open a " "new one, or take it over by client.join_session(session.name)."
            )

    @contextmanager
    def alone(self) -> Iterator[None]:
        """Excludes concurrent calls, which would give two steps the same number."""
        self.check_process()
        if not self._in_use.acquire(blocking=False):
            raise ContactdError(
                "A call of this session is already running, in another thread or around this progress callback; a session takes " "one step at a time, in order. Open a session for each thread."
            )
        try:
            yield
        finally:
            self._in_use.release()

    def number_of(self, step: Mapping[str, Any]) -> int:
        """Returns the number to request: the next one, or with `again` the last one requested, whether it succeeded or
        not.
        """
        if not step.get("again") or self._asked == 0:
            self._asked = self.number + 1
        return self._asked

    def params(self, number: int, step: Mapping[str, Any]) -> dict[str, Any]:
        """Returns the parameters of session.step. Raises TypeError or InvalidArgument for invalid values."""
        params: dict[str, Any] = {"session": self.session, "step": number}
        if step.get("again"):
            params["again"] = True
        params |= self._given(step)
        if names := names_of(step.get("fields", ())):
            params["fields"] = names
        return params

    @abstractmethod
    def _given(self, step: Any) -> dict[str, Any]:
        """Returns the parameters of the step other than its number and the requested arrays."""

    @abstractmethod
    def read(self, asked: dict[str, Any], result: Any, path: str = "result") -> Any:
        """Reads the answer to the step with the parameters `asked`, and advances the session."""
