"""Provides a private daemon for the computations of a section."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path

from contactd import Client, LocalDaemon

from .section import Measure

_TIMEOUT = 3600.0  # s; includes the build of a table


@contextmanager
def measuring(programs: Path, make: Callable[[Client], Measure]) -> Iterator[Measure]:
    """Yields the result of `make` during the `with` block. The tables are deleted together with the daemon."""
    with LocalDaemon(programs / "contactd", config={"workers": 1}) as daemon:
        with daemon.client(timeout=_TIMEOUT) as client:
            yield make(client)
