"""Signals that ask the command to end."""

from __future__ import annotations

import signal
from collections.abc import Iterator
from contextlib import contextmanager
from typing import Any

from .codes import Terminated

__all__ = ["heeded_sigterm", "ignore_more", "uninterrupted"]

_ENDING = (signal.SIGINT, signal.SIGTERM)


@contextmanager
def heeded_sigterm() -> Iterator[None]:
    """SIGTERM interrupts the main thread as Ctrl-C does; afterwards it does what it did before, unless it is ignored."""
    before: Any = signal.signal(signal.SIGTERM, _terminate)
    try:
        yield
    finally:
        if signal.getsignal(signal.SIGTERM) is _terminate:
            signal.signal(signal.SIGTERM, before)


def _terminate(*_: Any) -> None:
    raise Terminated


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
