"""Contact without a service: the same client, for scripts and simulations that run alone."""

from __future__ import annotations

import weakref
from collections.abc import Mapping
from pathlib import Path
from typing import Any

from .client import Client
from .daemon import LocalDaemon
from .errors import DaemonFailed
from .refusals import public
from .transport.connections import Lender
from .transport.in_process import Engine, can_solve_here
from .transport.programs import checked

__all__ = ["InProcessClient", "local"]

#: Of a configuration, what only a daemon has.
_OF_DAEMONS = ("endpoint", "security", "methods", "log", "http", "shutdown")


class _ClientOfItsOwn(Client):
    """A client that has its daemon to itself, and ends it. Copies in other processes are clients as any others."""

    def __init__(self, daemon: LocalDaemon) -> None:
        super().__init__(daemon.endpoint)
        self._end = weakref.finalize(self, daemon.close)

    def close(self) -> None:
        """Ends the connections and the daemon."""
        super().close()
        self._end()

    def __reduce__(self) -> Any:
        return _client_like, (self.__getstate__(),)


def _client_like(state: dict[str, Any]) -> Client:
    return Client(**state)


@public
def local(
    program: str | Path | None = None,
    *,
    folder: str | Path | None = None,
    config: Mapping[str, Any] | None = None,
    in_process: bool | None = None,
) -> Client:
    """A client that needs no service::

        with contactd.local() as client:
            solution = client.solve(...)

    Its sessions and tables end with the ``with`` block, or with ``client.close()``, which may be called twice.
    Where the extension contactd_local is installed it solves in this process, and otherwise starts a private daemon: the
    answers are the same, and so are the errors. `in_process` insists on one of the two. Who names the `program` or says
    what only a daemon has in `config` (endpoint, security, methods, log, http, shutdown) gets a daemon.

    `program`, `folder` and `config` are those of LocalDaemon. Tables by finite elements are kept in `folder`; without
    one they go with the client. In process they are built by ``contactd-ic``, as CONTACTD_IC names it, the package
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
        return InProcessClient(folder, config)
    return _ClientOfItsOwn(LocalDaemon(program, folder=folder, config=config))


def _needs_daemon(program: str | Path | None, config: Mapping[str, Any]) -> str:
    """Why it takes a daemon; empty when it takes none."""
    if program is not None:
        return f"program is {str(program)!r}, a daemon"
    own = [name for name in _OF_DAEMONS if name in config]
    return f"config has {own[0]}, which only a daemon has" if own else ""


class InProcessClient(Client):
    """A client that asks the engine in its own process. `folder` and `config` are those of contactd.local()."""

    def __init__(self, folder: str | Path | None = None, config: Mapping[str, Any] | None = None) -> None:
        self._folder, self._config = None if folder is None else Path(folder), config or {}
        super().__init__("local")

    def _lender(self) -> Lender:
        return Engine(self._folder, self._config)

    def __getstate__(self) -> dict[str, Any]:
        raise TypeError("a client that solves in process cannot be pickled; one of a LocalDaemon can: daemon.client()")
