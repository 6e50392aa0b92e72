"""Sends steps of several sessions in one message."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from contextlib import ExitStack
from functools import partial
from typing import TYPE_CHECKING, Any

from ..errors import invalid
from ..transport.messages import results
from .any_session import AnySession
from .call import Answering, insist

if TYPE_CHECKING:
    from .caller import Caller

__all__ = ["stepped_sessions"]


def stepped_sessions(
    client: Caller, pairs: Iterable[tuple[AnySession, Mapping[str, Any]]], timeout: float | None
) -> Answering[list[Any]]:
    """Holds the steps of Client.step_many."""
    pairs = list(pairs)
    if not pairs:
        return []
    _check(client, pairs)
    steps = [(session._steps, step) for session, step in pairs]
    with ExitStack() as locks:
        for own, _ in steps:
            locks.enter_context(own.alone())
        numbers = [own.number_of(step) for own, step in steps]  # number all first: one may be invalid
        params = [own.params(number, step) for number, (own, step) in zip(numbers, steps)]

        def ask() -> Answering[dict[str, Any]]:
            return client.asked("session.step_many", {"steps": params}, timeout=timeout, builds=builds)

        builds = any(session._builds for session, _ in pairs)
        result = yield from insist(ask, min(session.retries for session, _ in pairs))
        readers = [partial(own.read, asked) for asked, (own, _) in zip(params, steps)]
        return results("session.step_many", result, "steps", readers)


def _check(client: Caller, pairs: list[tuple[AnySession, Mapping[str, Any]]]) -> None:
    first: dict[str, int] = {}
    for i, pair in enumerate(pairs):
        if not (isinstance(pair, tuple) and len(pair) == 2 and isinstance(pair[0], AnySession) and isinstance(pair[1], Mapping)):
            raise TypeError(f'steps[{i}] must be a session and the input of its step, such as (session, {{"Fn": 9e3}})')
        session, step = pair
        if unknown := step.keys() - session._steps.words:
            kind = type(session).__name__
            raise TypeError(f"steps[{i}] has {', '.join(sorted(unknown))}, which {kind}.step does not support for several sessions")
        if session._client is not client:
            raise invalid(f"steps[{i}].session", "belongs to another client; it must belong to the client of this call")
        if (other := first.setdefault(session.name, i)) != i:
            raise invalid(f"steps[{i}].session", f"is also that of steps[{other}]; a session takes one step at a time")
