"""Contains the entry point of the program."""

from __future__ import annotations

import io
import os
import signal
import sys
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from typing import Any, NoReturn

__all__ = ["main"]

_OF_THE_EXTRA = ("click", "rich", "typer")  #: Packages of the extra contactd[cli].


def main(arguments: Sequence[str] | None = None) -> NoReturn:
    """Runs the command in `arguments` (default: those of the process), and ends the process with its exit code."""
    _open_streams()
    with _killed_by_interrupts():
        try:
            from .app import run
            from .ending import end_soon_after_signals
        except ModuleNotFoundError as error:
            _end_without(error)
    end_soon_after_signals()
    sys.exit(run(arguments))


def _end_without(error: ModuleNotFoundError) -> NoReturn:
    """Names the extra of a missing module. A missing module of other packages is a defect."""
    from contactd import MissingExtra

    from .codes import Code

    if error.name not in _OF_THE_EXTRA:
        raise error
    print(f"contactctl: {MissingExtra('The command line', error.name, 'cli', 'contactctl')}", file=sys.stderr)
    sys.exit(Code.USAGE)


def _open_streams() -> None:
    """Opens closed standard streams; otherwise the next opened file, such as a socket, would take their place."""
    for name, mode in (("stdin", "r"), ("stdout", "w"), ("stderr", "w")):
        if getattr(sys, name) is None:
            setattr(sys, name, open(os.devnull, mode))
    if isinstance(getattr(sys.stdout, "buffer", None), io.RawIOBase):  # for PYTHONUNBUFFERED: partial writes would be lost
        sys.stdout = open(sys.stdout.fileno(), "w", encoding=sys.stdout.encoding, errors=sys.stdout.errors, closefd=False)


@contextmanager
def _killed_by_interrupts() -> Iterator[None]:
    """Restores default signals while modules are loaded, when there is nothing to cancel or print."""
    before: Any = signal.getsignal(signal.SIGINT)
    if before is signal.SIG_IGN:  # ignored in the background of a script
        yield
        return
    signal.signal(signal.SIGINT, signal.SIG_DFL)
    yield
    signal.signal(signal.SIGINT, before)
