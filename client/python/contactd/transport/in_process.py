"""Uses the engine in this process, from the extension contactd_local: a client without a daemon."""

from __future__ import annotations

import atexit
import json
import logging
import os
import shutil
import weakref
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

from ..errors import ConnectionFailed, DaemonFailed
from .messages import Reply, Request, parsed, reply_of
from .programs import laid_over, program_of
from .temporary import TemporaryFolder

__all__ = ["Engine", "can_solve_here", "remove_temporary_folders"]

_LOG = logging.getLogger("contactd.local")
_LOG.addHandler(logging.NullHandler())  # silent unless the program configures the logger


def can_solve_here() -> bool:
    """Returns whether the extension is installed. Raises DaemonFailed if it is installed but cannot be loaded."""
    try:
        import contactd_local  # noqa: F401
    except ModuleNotFoundError as error:
        if error.name == "contactd_local":
            return False
        raise DaemonFailed(f"contactd_local is installed but cannot be loaded: {error}.") from error
    except ImportError as error:
        raise DaemonFailed(f"contactd_local is installed but cannot be loaded: {error}.") from error
    return True


def _builder() -> str:
    program = program_of("contactd-ic")
    return shutil.which(program) or program


class Engine:
    """Replaces Connections in process: lends each call the same engine. Thread-safe.

    Belongs to the process that created it. In a forked process, which has none of its threads and sessions, calls raise
    an exception.
    """

    def __init__(self, folder: Path | None, config: Mapping[str, Any]) -> None:
        from contactd_local import Error, Service

        self._owner = os.getpid()
        self.is_closed = False
        self._temporary = TemporaryFolder() if folder is None else None
        store = str(Path(self._temporary or folder or "").absolute() / "store")
        builder = {"program": os.environ.get("CONTACTD_IC") or _builder()}
        # Ctrl-C at a terminal must not reach its builders.
        launcher = {"launcher": ["setsid"]} if shutil.which("setsid") else {}
        own = {"store": {"folder": store}, "builds": {**builder, **launcher}}
        try:
            self._service = Service(json.dumps(laid_over(own, config)))
        except Error as error:
            self._remove_temporary()
            raise DaemonFailed(str(error)) from None
        except BaseException:
            self._remove_temporary()
            raise
        self._log()
        _ALL.add(self)

    @property
    def is_of_this_process(self) -> bool:
        return self._owner == os.getpid()

    def _check_process(self) -> None:
        if not self.is_of_this_process:
            raise ConnectionFailed(
                f"This client solves in process {self._owner}, from which this one was forked; "
                "open another here: contactd.local()."
            )

    def take(self) -> Engine:
        """Lends the engine. Raises ConnectionFailed."""
        self._check_process()
        if self.is_closed:
            raise ConnectionFailed("The client is closed.")
        return self

    def give_back(self, connection: Any, usable: bool = True) -> None:
        """Has no effect."""

    def exchange(self, asked: Request) -> Reply:
        """Exchanges like Connection.exchange. The envelope's `timeout_ms` is the timeout."""
        request = None  # An interrupt may occur at once; an unreferenced engine is closed, too.
        try:
            envelope, *frames = asked.message()
            request = self._ask(envelope, frames)
            while True:
                message = request.next()
                answer = parsed(message[0])
                if "status" in answer:
                    return reply_of(answer, message[1:])
                if asked.on_progress is not None:
                    asked.on_progress(answer["progress"])
                    self._check_process()  # A callback may have forked; this is the child process.
        except BaseException:
            if request is not None and self.is_of_this_process:
                request.cancel()
            raise
        finally:
            if self.is_of_this_process:
                self._log()

    def _ask(self, envelope: bytes, frames: Sequence[bytes]) -> Any:
        try:
            return self._service.ask(envelope, list(frames))
        except RuntimeError as error:  # Another thread has just closed it.
            raise ConnectionFailed(str(error)) from None

    def close(self) -> None:
        """Closes the engine. A second call, or a call in a forked process, has no effect."""
        if self.is_closed or not self.is_of_this_process:
            return
        self.is_closed = True
        try:
            self._service.close()
            self._log()
        finally:
            self._remove_temporary()

    def _log(self) -> None:
        for level, sentence in self._service.take_log():
            _LOG.log(level, sentence)

    def _remove_temporary(self) -> None:
        if self._temporary is not None:
            self._temporary.remove()


_ALL: weakref.WeakSet[Engine] = weakref.WeakSet()


def remove_temporary_folders() -> None:
    """Removes the folders of this process, which is about to end without closing its engines."""
    for engine in list(_ALL):
        if engine.is_of_this_process:
            engine._remove_temporary()


@atexit.register
def _close_all() -> None:
    """Ends all threads before the interpreter: their answers need it."""
    for engine in list(_ALL):
        engine.close()
