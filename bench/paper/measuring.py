"""A daemon of one's own for the computations of a section."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path

from contactd import Client, LocalDaemon

from .section import Measure

_TIMEOUT = 3600.0  # s; a table is built on the way


@contextmanager
def measuring(programs: Path, make: Callable[[Client], Measure]) -> Iterator[Measure]:
    """What `make` gives for as long as the `with` block; the tables go with the daemon."""
    with LocalDaemon(programs / "contactd", config={"workers": 1}) as daemon:
        with daemon.client(timeout=_TIMEOUT) as client:
            yield make(client)
