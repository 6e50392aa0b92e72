"""Signals that end the command."""

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
    """Lets SIGTERM and SIGHUP interrupt the main thread like Ctrl-C inside the block.

    A signal that is ignored at the start, as with nohup, remains ignored.
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
    """Discards output to a closed terminal, which must not keep the command from ending."""
    for descriptor in (1, 2):
        try:
            os.write(descriptor, b"")
        except OSError:
            nowhere = os.open(os.devnull, os.O_WRONLY)
            os.dup2(nowhere, descriptor)
            os.close(nowhere)


def ignore_more() -> None:
    """Ignores further signals while the command ends."""
    for number in _ENDING:
        signal.signal(number, signal.SIG_IGN)


@contextmanager
def uninterrupted() -> Iterator[None]:
    """Protects a short operation that must be completed; for the main thread."""
    before: list[Any] = [signal.signal(number, signal.SIG_IGN) for number in _ENDING]
    try:
        yield
    finally:
        for number, handler in zip(_ENDING, before):
            signal.signal(number, handler)
