"""Signals that ask the command to end."""

from __future__ import annotations

import os
import signal
from collections.abc import Iterator
from contextlib import contextmanager
from typing import Any

from .codes import HungUp, Terminated

__all__ = ["heeded_signals", "ignore_more", "uninterrupted"]

_ENDING = (signal.SIGINT, signal.SIGTERM, signal.SIGHUP)


@contextmanager
def heeded_signals() -> Iterator[None]:
    """SIGTERM and SIGHUP interrupt the main thread as Ctrl-C does; afterwards they do what they did before.

    One that is ignored from the start, as nohup has it, goes on being ignored.
    """
    handlers = {signal.SIGTERM: _terminate, signal.SIGHUP: _hang_up}
    before: dict[signal.Signals, Any] = {number: signal.getsignal(number) for number in handlers}
    heeded = {number: handler for number, handler in handlers.items() if before[number] is not signal.SIG_IGN}
    for number, handler in heeded.items():
        signal.signal(number, handler)
    try:
        yield
    finally:
        for number, handler in heeded.items():
            if signal.getsignal(number) is handler:
                signal.signal(number, before[number])


def _terminate(*_: Any) -> None:
    raise Terminated


def _hang_up(*_: Any) -> None:
    _write_nowhere()
    raise HungUp


def _write_nowhere() -> None:
    """Leaves a terminal that has gone: what would be said there must not keep the command from ending in order."""
    for descriptor in (1, 2):
        try:
            os.write(descriptor, b"")
        except OSError:
            nowhere = os.open(os.devnull, os.O_WRONLY)
            os.dup2(nowhere, descriptor)
            os.close(nowhere)


def ignore_more() -> None:
    """The command is on its way out."""
    for number in _ENDING:
        signal.signal(number, signal.SIG_IGN)


@contextmanager
def uninterrupted() -> Iterator[None]:
    """For what must be finished once it has begun, and takes a moment; of the main thread."""
    before: list[Any] = [signal.signal(number, signal.SIG_IGN) for number in _ENDING]
    try:
        yield
    finally:
        for number, handler in zip(_ENDING, before):
            signal.signal(number, handler)
