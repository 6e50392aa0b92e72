"""Calls that are written once and run in two ways: a thread waits for answers, or a coroutine awaits them.

A call is a generator. It yields its Requests. The runner sends it each Reply, or throws the exception. It returns its
answer. It may also yield a Pause, or the warnings of an answer.
"""

from __future__ import annotations

import functools
import inspect
import types
from collections.abc import Callable, Coroutine, Generator
from dataclasses import dataclass
from typing import Any, Concatenate, Generic, ParamSpec, TypeVar, overload

from ..errors import ConnectionFailed, DeadlineExceeded, TimeoutExpired
from ..refusals import public
from ..transport.messages import Request
from .answer_warnings import give

__all__ = ["Answering", "Asked", "Awaits", "Noted", "Pause", "Waits", "asks", "insist"]

P = ParamSpec("P")
T = TypeVar("T")


@dataclass(frozen=True)
class Pause:
    """A pause between requests (s)."""

    seconds: float


@dataclass(frozen=True)
class Noted:
    """Warnings of an answer. Their sentences are given as a Python warning after the call."""

    sentences: tuple[str, ...]


Asked = Request | Pause | Noted
Answering = Generator[Asked, Any, T]


def insist(ask: Callable[[], Answering[T]], retries: int) -> Answering[T]:
    """Sends a request, and repeats it up to `retries` times without an answer. Only for requests that may be answered
    twice.
    """
    for _ in range(retries):
        try:
            return (yield from ask())
        except DeadlineExceeded:
            raise  # an answer
        except (TimeoutExpired, ConnectionFailed):
            yield Pause(0.05)
    return (yield from ask())


class Waits:
    """Runs calls in the calling thread."""

    def _carry_out(self, asked: Request | Pause) -> Any:
        """Returns the Reply to a Request; None after a Pause."""
        raise NotImplementedError

    def _run(self, steps: Answering[T]) -> T:
        noted: list[str] = []
        try:
            asked = next(steps)
            while True:
                if isinstance(asked, Noted):
                    noted.extend(asked.sentences)
                    asked = next(steps)
                    continue
                try:
                    reply = self._carry_out(asked)
                except BaseException as error:
                    asked = steps.throw(error)
                else:
                    asked = steps.send(reply)
        except StopIteration as end:
            answer: T = end.value
        give(noted)
        return answer


class Awaits:
    """Runs calls in an event loop."""

    async def _carry_out(self, asked: Request | Pause) -> Any:
        """Returns the Reply to a Request; None after a Pause."""
        raise NotImplementedError

    async def _run(self, steps: Answering[T]) -> T:
        noted: list[str] = []
        try:
            asked = next(steps)
            while True:
                if isinstance(asked, Noted):
                    noted.extend(asked.sentences)
                    asked = next(steps)
                    continue
                try:
                    reply = await self._carry_out(asked)
                except BaseException as error:
                    asked = steps.throw(error)
                else:
                    asked = steps.send(reply)
        except StopIteration as end:
            answer: T = end.value
        give(noted)
        return answer


class asks(Generic[P, T]):  # noqa: N801: a decorator
    """Turns such a generator into a method: a blocking call in subclasses of Waits, a coroutine in those of Awaits."""

    def __init__(self, steps: Callable[Concatenate[Any, P], Answering[T]]) -> None:
        self.steps = steps
        self.__doc__ = steps.__doc__

        def waiting(self: Any, *args: P.args, **keywords: P.kwargs) -> T:
            answer: T = self._run(steps(self, *args, **keywords))
            return answer

        async def awaiting(self: Any, *args: P.args, **keywords: P.kwargs) -> T:
            answer: T = await self._run(steps(self, *args, **keywords))
            return answer

        self._waiting, self._awaiting = _shown_as(steps, public(waiting)), _shown_as(steps, public(awaiting))

    @overload
    def __get__(self, of: None, kind: Any) -> Callable[Concatenate[Any, P], Any]: ...
    @overload
    def __get__(self, of: Waits, kind: Any) -> Callable[P, T]: ...
    @overload
    def __get__(self, of: Awaits, kind: Any) -> Callable[P, Coroutine[Any, Any, T]]: ...
    def __get__(self, of: Any, kind: Any) -> Any:
        function = self._awaiting if issubclass(kind, Awaits) else self._waiting
        return function if of is None else types.MethodType(function, of)


def _shown_as(steps: Callable[..., Any], function: Any) -> Any:
    """Gives `function` the name, docstring and signature of `steps`; the return type is that of the call."""
    functools.update_wrapper(function, steps)
    signature = inspect.signature(steps)
    answer = str(signature.return_annotation).removeprefix("Answering[").removesuffix("]")
    function.__signature__ = signature.replace(return_annotation=answer)
    function.__annotations__ = {**steps.__annotations__, "return": answer}
    return function
