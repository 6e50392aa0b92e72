"""Solves contact problems without a service, by the same client, for single scripts and simulations."""

from __future__ import annotations

import json
import os
import select
import subprocess
import tempfile
import time
import weakref
from collections.abc import Mapping
from pathlib import Path
from types import TracebackType
from typing import TYPE_CHECKING, Any

from .client import Client, ClientOptions
from .errors import DaemonFailed, MissingExtra
from .refusals import public
from .transport.connections import ConnectionPool
from .transport.in_process import Engine, can_solve_here
from .transport.lifeline import Lifeline
from .transport.programs import checked, laid_over, program_of
from .transport.shared_client import open_by, shared_client
from .transport.temporary import TemporaryFolder

if TYPE_CHECKING:
    from typing_extensions import Unpack

__all__ = ["InProcessClient", "LocalDaemon", "default_client", "local"]

_ADVICE = (
    ' Put it on PATH, or give its path: LocalDaemon(program). Install it with pip install "contactd[daemon]",' ' or solve without it by contactd.local() from "contactd[local]".'
)
#: Sections of a configuration that require a daemon.
_OF_DAEMONS = ("endpoint", "security", "methods", "log", "http", "shutdown")


class _ClientOfItsOwn(Client):
    """A client that owns its daemon and stops it. Copies in other processes are ordinary clients."""

    def __init__(self, daemon: LocalDaemon) -> None:
        super().__init__(daemon.endpoint)
        self._end = weakref.finalize(self, daemon.close)

    def close(self) -> None:
        """Closes the connections and stops the daemon."""
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
    """Returns a client that needs no service::

        with contactd.local() as client:
            solution = client.solve(...)

    Its sessions and tables end with the ``with`` block, or with ``client.close()``. If the extension contactd_local is
    installed, the client solves in this process; otherwise it starts a private daemon. Answers and errors are the same.
    `in_process` requires one of the two. The arguments `program`, and settings in `config` that require a daemon
    (endpoint, security, methods, log, http, shutdown), also select a daemon.

    `program`, `folder` and `config` are those of LocalDaemon. Finite-element tables are stored in `folder`; without
    one, they are deleted with the client. In process they are built by ``contactd-ic``: the program named by
    CONTACTD_IC, that of the package contactd-daemon, or the one on PATH. The log goes to the logger ``contactd.local``.

    A client that solves in process cannot be pickled, and a forked process must open its own.

    Raises DaemonFailed if the daemon or the engine cannot be started, and MissingExtra if `in_process` is True and the
    extension is not installed.
    """
    why = _needs_daemon(program, checked(config))
    if in_process and why:
        raise TypeError(f"local() cannot solve in process as requested, because {why}")
    if in_process is None:
        in_process = not why and can_solve_here()
    if in_process:
        if not can_solve_here():
            raise MissingExtra("Solving in process", "contactd_local", "local", "python3-contactd-local")
        return InProcessClient(folder, config)
    return _ClientOfItsOwn(LocalDaemon(program, folder=folder, config=config))


@public
def default_client() -> Client:
    """Returns the client that `contactd.solve`, `contactd.creep_curve` and the other functions of the package use.

    The first call opens it by the rule of `contactctl`. If the environment contains CONTACTD_ENDPOINT, it is a client
    of that daemon, with the key files named by CONTACTD_SERVER_KEY and CONTACTD_OWN_KEY. Otherwise it is
    `contactd.local()`, which solves in this process, or starts a private daemon if contactd_local is not installed. All
    threads share the client. A forked process opens its own. The client is closed when the process ends. After
    ``default_client().close()``, the next call reads the environment again and opens another.

    Raises DaemonFailed if neither contactd_local nor a daemon is installed.
    """
    client: Client = shared_client()
    return client


def _client_of_environment() -> Client:
    endpoint = os.environ.get("CONTACTD_ENDPOINT")
    if not endpoint:
        return local()
    server_key, own_key = (os.environ.get(f"CONTACTD_{name}_KEY") or None for name in ("SERVER", "OWN"))
    return Client(endpoint, server_key=server_key, own_key=own_key)


open_by(_client_of_environment)


def _needs_daemon(program: str | Path | None, config: Mapping[str, Any]) -> str:
    """Returns the reason why a daemon is needed; empty if none is."""
    if program is not None:
        return f"program is {str(program)!r}, a daemon"
    own = [name for name in _OF_DAEMONS if name in config]
    return f"config contains {own[0]}, which applies to daemons only" if own else ""


def _short_temporary_folder() -> TemporaryFolder:
    # The path of a Unix socket is limited to 107 characters, and $TMPDIR may be long.
    return TemporaryFolder("/tmp" if len(tempfile.gettempdir()) > 70 else None)


class LocalDaemon:
    """Runs ``contactd`` on a private ipc endpoint until the end of the ``with`` block.

    A `program` without a folder is searched on PATH; it starts the `contactd-ic` in the same folder. The default is the
    `contactd` of the package contactd-daemon if installed, otherwise that on PATH. `folder` contains configuration, log
    and store; the default is a temporary folder, which is removed afterwards. `config` replaces values of the default
    configuration, section by section. Signals of the terminal (Ctrl-C) reach only the calling process, which stops the
    daemon by leaving the block. If the calling process is killed, or ends by SIGTERM without a handler, the daemon
    receives SIGTERM and a temporary folder is removed. Forked processes can use the daemon, but do not stop it.
    """

    @public
    def __init__(
        self,
        program: str | Path | None = None,
        *,
        folder: str | Path | None = None,
        config: Mapping[str, Any] | None = None,
        start_timeout: float = 30.0,
    ) -> None:
        config = checked(config)
        self._temporary = _short_temporary_folder() if folder is None else None
        self.folder = Path(self._temporary or folder or "").absolute()
        own = {"endpoint": f"ipc://{self.folder}/socket", "store": {"folder": str(self.folder / "store")}}
        self.config = laid_over(own, config)
        self.log_path = self.folder / "contactd.log"
        self.endpoint = ""
        self._owner = os.getpid()
        self._lifeline: Lifeline | None = None
        self.process = self._start(program_of("contactd") if program is None else str(program))
        try:
            self._lifeline = Lifeline(self.pid, self._configuration, self.folder if self._temporary is not None else None)
            self._wait_until_ready(start_timeout)
        except BaseException:
            self.close()
            raise

    def __repr__(self) -> str:
        return f"<LocalDaemon at {self.endpoint or self.folder}, process {self.pid}>"

    def __reduce__(self) -> Any:
        raise TypeError("a LocalDaemon cannot be pickled; pass its endpoint, or a client of it: daemon.client()")

    def __enter__(self) -> LocalDaemon:
        return self

    def __exit__(
        self, kind: type[BaseException] | None, value: BaseException | None, traceback: TracebackType | None
    ) -> None:
        self.close()

    @property
    def pid(self) -> int:
        """The process ID."""
        return self.process.pid

    @property
    def _configuration(self) -> Path:
        return self.folder / "contactd.json"

    @property
    def log(self) -> str:
        """Returns the log of the daemon up to now."""
        return self.log_path.read_text(errors="replace") if self.log_path.exists() else ""

    def client(self, **options: Unpack[ClientOptions]) -> Client:
        """Returns a new client of this daemon; `options` are those of Client."""
        return Client(self.endpoint, **options)

    @public
    def stop(self, timeout: float = 30.0) -> int:
        """Stops the daemon (SIGTERM) and returns its exit status.

        If the daemon does not stop within `timeout` seconds, kills it and raises DaemonFailed. Also raises DaemonFailed
        in a process forked from the one that started it.
        """
        if self._owner != os.getpid():
            raise DaemonFailed(f"contactd was started by process {self._owner}, and only that process can end it.")
        if self._lifeline is not None:
            self._lifeline.let_go()
        if self.process.poll() is None:
            self.process.terminate()
        try:
            return self.process.wait(timeout)
        except subprocess.TimeoutExpired:
            self.process.kill()
            self.process.wait()
            raise DaemonFailed(f"contactd did not end within {timeout:g} s of SIGTERM and was killed.") from None
        finally:
            if self.process.stdout is not None:
                self.process.stdout.close()

    def close(self) -> None:
        """Stops the daemon and removes the temporary folder. A second call, or a call in a forked process, has no
        effect.
        """
        if self._owner != os.getpid():
            return
        try:
            self.stop()
        finally:
            if self._temporary is not None:
                self._temporary.remove()

    def _start(self, program: str) -> subprocess.Popen[bytes]:
        self.folder.mkdir(parents=True, exist_ok=True)
        self._configuration.write_text(json.dumps(self.config, indent=2) + "\n")
        try:
            with self.log_path.open("ab") as log:
                return subprocess.Popen(
                    [program, "--config", str(self._configuration)],
                    stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=log, start_new_session=True,
                )  # fmt: skip
        except OSError as error:
            if self._temporary is not None:
                self._temporary.remove()
            advice = "" if os.sep in program else _ADVICE
            raise DaemonFailed(f"{program} cannot be started: {error.strerror}.{advice}") from None

    def _wait_until_ready(self, timeout: float) -> None:
        line, deadline = b"", time.monotonic() + timeout
        assert self.process.stdout is not None
        while not line.endswith(b"\n"):
            longest_wait = max(0.0, deadline - time.monotonic())
            if not select.select([self.process.stdout], [], [], longest_wait)[0]:
                raise DaemonFailed(f"contactd was not ready within {timeout:g} s. Its log:\n{self.log}")
            chunk = os.read(self.process.stdout.fileno(), 4096)
            if not chunk:
                status = self.process.wait()
                raise DaemonFailed(f"contactd ended with status {status} before it was ready. Its log:\n{self.log}")
            line += chunk
        try:
            self.endpoint = str(json.loads(line)["endpoint"])
        except (ValueError, KeyError, TypeError):
            raise DaemonFailed(f"contactd printed {line!r} instead of becoming ready.") from None


class InProcessClient(Client):
    """A client of the engine in its own process. `folder` and `config` are those of contactd.local()."""

    def __init__(self, folder: str | Path | None = None, config: Mapping[str, Any] | None = None) -> None:
        self._folder, self._config = None if folder is None else Path(folder), config or {}
        super().__init__("local")

    def _pool(self) -> ConnectionPool:
        return Engine(self._folder, self._config)

    def __getstate__(self) -> dict[str, Any]:
        raise TypeError("a client that solves in process cannot be pickled; use one of a LocalDaemon: daemon.client()")
