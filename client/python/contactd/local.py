"""Contact without a service: the same client, for scripts and simulations that run alone."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from pathlib import Path
from typing import Any

from .client import Client
from .daemon import LocalDaemon, checked
from .errors import DaemonFailed
from .in_process import InProcessClient, can_solve_here

__all__ = ["local"]

#: Of a configuration, what only a daemon has.
_OF_DAEMONS = ("endpoint", "security", "methods", "log", "http", "shutdown")


@contextmanager
def local(
    program: str | Path | None = None,
    *,
    folder: str | Path | None = None,
    config: Mapping[str, Any] | None = None,
    in_process: bool | None = None,
) -> Iterator[Client]:
    """A client that needs no service, whose sessions and tables end with the ``with`` block::

        with contactd.local() as client:
            solution = client.solve(...)

    Where the extension contactd_local is installed it solves in this process, and otherwise starts a private daemon: the
    answers are the same, and so are the errors. `in_process` insists on one of the two. Who names the `program` or says
    what only a daemon has in `config` (endpoint, security, methods, log, http, shutdown) gets a daemon.

    `program`, `folder` and `config` are those of LocalDaemon. Tables by finite elements are kept in `folder`; without
    one they go with the block. In process they are built by ``contactd-ic``, as CONTACTD_IC names it, the package
    contactd-daemon has it, or PATH finds it, and the log goes to the logger ``contactd.local``.

    A client that solves in process belongs to it: it cannot be pickled, and a process that is forked opens its own.

    Raises DaemonFailed when the daemon or the engine cannot be started.
    """
    why = _needs_daemon(program, checked(config))
    if in_process and why:
        raise TypeError(f"local() was asked to solve in process, and {why}")
    if in_process is None:
        in_process = not why and can_solve_here()
    if in_process:
        if not can_solve_here():
            raise DaemonFailed("contactd_local is not installed, which solving in process takes; local() needs it not.")
        with InProcessClient(folder, config) as client:
            yield client
        return
    with LocalDaemon(program, folder=folder, config=config) as daemon, daemon.client() as client:
        yield client


def _needs_daemon(program: str | Path | None, config: Mapping[str, Any]) -> str:
    """Why it takes a daemon; empty when it takes none."""
    if program is not None:
        return f"program is {str(program)!r}, a daemon"
    own = [name for name in _OF_DAEMONS if name in config]
    return f"config has {own[0]}, which only a daemon has" if own else ""
