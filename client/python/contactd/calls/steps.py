"""The order of the steps of a session: their numbers, and who may take one."""

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
    """The steps of one session, which have an order: numbers them, and lets one thread of one process take them.

    Attributes:
        session: Its name.
        number: That of the last step, 0 before the first.
    """

    words: frozenset[str]  #: keywords of a step

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
        params |= self._given(step)
        if names := names_of(step.get("fields", ())):
            params["fields"] = names
        return params

    @abstractmethod
    def _given(self, step: Any) -> dict[str, Any]:
        """Returns what the step says beside its number and the arrays that it requests."""

    @abstractmethod
    def read(self, asked: dict[str, Any], result: Any, path: str = "result") -> Any:
        """The answer to the step with the parameters `asked`, with which the session has moved on."""
