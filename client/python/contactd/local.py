"""Contact without a service: the same client, for scripts and simulations that run alone."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from pathlib import Path
from typing import Any

from .client import Client
from .daemon import LocalDaemon

__all__ = ["local"]


@contextmanager
def local(
    program: str | Path = "contactd", *, folder: str | Path | None = None, config: Mapping[str, Any] | None = None
) -> Iterator[Client]:
    """A client of a private daemon, which ends with the ``with`` block::

        with contactd.local() as client:
            solution = client.solve(...)

    `program`, `folder` and `config` are those of LocalDaemon. Tables by finite elements are kept in `folder`; without
    one they go with the block. Raises DaemonFailed when the daemon cannot be started.
    """
    with LocalDaemon(program, folder=folder, config=config) as daemon, daemon.client() as client:
        yield client
