"""Where the program begins."""

from __future__ import annotations

import signal
import sys
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from typing import Any, NoReturn

__all__ = ["main"]


def main(arguments: Sequence[str] | None = None) -> NoReturn:
    """Runs the command that `arguments` name (those of the process), and ends the process with its exit code."""
    with _killed_by_interrupts():
        from .app import run
    sys.exit(run(arguments))


@contextmanager
def _killed_by_interrupts() -> Iterator[None]:
    """While modules are loaded there is nothing to cancel, and nothing to say."""
    before: Any = signal.getsignal(signal.SIGINT)
    if before is signal.SIG_IGN:  # in the background of a script
        yield
        return
    signal.signal(signal.SIGINT, signal.SIG_DFL)
    yield
    signal.signal(signal.SIGINT, before)
