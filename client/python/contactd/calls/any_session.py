"""Implements the common part of sessions of contacts and of wheels on rails (docs/sessions.md)."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from types import TracebackType
from typing import TYPE_CHECKING, Any, ClassVar, TypeVar

from ..errors import ContactdError, ProtocolError
from ..refusals import check_type
from ..transport.messages import Request
from ..values.generated.service import Progress
from ..values.representation import Rows, Shown
from ..values.step_solution import SavedState
from .call import Answering, Pause, Waits, asks, insist
from .steps import Steps

if TYPE_CHECKING:
    from typing_extensions import Self

    from .caller import Caller

__all__ = ["AnySession", "ProgressCallback", "SessionThatWaits", "reported_number"]

ProgressCallback = Callable[[Progress], None]
T = TypeVar("T")


def reported_number(reported: dict[str, Any], name: str, kind: Callable[[Any], T]) -> T:
    """Returns a number in the answer to session.open or session.info."""
    try:
        return kind(reported[name])
    except (KeyError, TypeError, ValueError):
        raise ProtocolError("The answer to session.open or session.info lacks its session.") from None


class AnySession(Shown):
    """Implements the common part of blocking and asyncio sessions."""

    _joins: ClassVar[str]  #: Method of Client that joins such a session.
    _builds = False  #: Whether a step may have to wait for finite-element tables.

    def __init__(self, client: Caller, steps: Steps, reported: dict[str, Any]) -> None:
        self.lease_seconds = reported_number(reported, "lease_seconds", float)
        self.bytes = reported_number(reported, "bytes", int)
        self.retries = 1
        self._client = client
        self._steps = steps

    @property
    def name(self) -> str:
        """The name of the session for Client.join_session. It is a key: any client that has it can solve steps and
        close the session.
        """
        return self._steps.session

    @property
    def step_number(self) -> int:
        """The number of the last step; 0 before the first."""
        return self._steps.number

    def __reduce__(self) -> Any:
        raise TypeError(
            f"a {type(self).__name__} cannot be pickled; pass session.name, and join it by client.{self._joins}"
        )

    def _title(self) -> str:
        return f"{type(self).__name__} {self.name[:6]}... of {self._client.endpoint}"  # Do not print the whole key.

    def _rows(self) -> Rows:
        return [("last step", self.step_number), *self._common(), ("lease", f"{self.lease_seconds:g} s")]

    def _common(self) -> Rows:
        """Returns the parameters that all steps have in common."""
        return []

    @asks
    def close(self, *, timeout: float | None = None) -> Answering[None]:
        """Closes the session in the daemon. Raises NotFound if it has already ended."""
        self._steps.check_process()
        yield from self._client.asked("session.close", {"session": self.name}, timeout=timeout)

    @asks
    def save(self, *, timeout: float | None = None) -> Answering[SavedState]:
        """Saves the state of the session for restore()."""
        with self._steps.alone():
            result = yield from self._client.asked("session.save", {"session": self.name}, timeout=timeout)
        return SavedState(str(result["state"]), int(result["step"]))

    @asks
    def restore(self, state: SavedState, *, timeout: float | None = None) -> Answering[None]:
        """Returns the session to a saved state. You may restore a state any number of times."""
        check_type("state", state, SavedState)
        with self._steps.alone():
            result = yield from self._insist("session.restore", {"session": self.name, "state": state.name}, timeout)
            self._steps.go_to(int(result["step"]))

    @asks
    def forget(self, state: SavedState, *, timeout: float | None = None) -> Answering[None]:
        """Frees a saved state."""
        check_type("state", state, SavedState)
        self._steps.check_process()
        yield from self._client.asked("session.forget", {"session": self.name, "state": state.name}, timeout=timeout)

    def _step(
        self,
        step: Mapping[str, Any],
        timeout: float | None,
        on_progress: ProgressCallback | None,
        progress: bool,
    ) -> Answering[Any]:
        with self._steps.alone():
            params = self._steps.params(self._steps.number_of(step), step)
            result = yield from self._insist("session.step", params, timeout, on_progress, progress, self._builds)
            return self._steps.read(params, result)

    def _insist(
        self,
        method: str,
        params: dict[str, Any],
        timeout: float | None,
        on_progress: ProgressCallback | None = None,
        progress: bool = False,
        builds: bool = False,
    ) -> Answering[dict[str, Any]]:
        """Repeats a request without an answer. The daemon recognises a request that it has already answered by its
        number.
        """

        def ask() -> Answering[dict[str, Any]]:
            return self._client.asked(
                method, params, timeout=timeout, on_progress=on_progress, progress=progress, builds=builds
            )

        return insist(ask, self.retries)


class SessionThatWaits(AnySession, Waits):
    """A session with blocking calls. It ends with its ``with`` block."""

    def _carry_out(self, asked: Request | Pause) -> Any:
        return self._client._carry_out(asked)  # type: ignore[attr-defined]

    def __enter__(self) -> Self:
        return self

    def __exit__(
        self, kind: type[BaseException] | None, value: BaseException | None, traceback: TracebackType | None
    ) -> None:
        try:
            self.close()
        except ContactdError:
            pass  # In a forked process, the parent ends it. If the daemon does not answer, the lease ends it.
