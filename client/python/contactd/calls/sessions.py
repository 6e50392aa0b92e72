"""Sessions: those that are opened or joined, and the steps of many."""

from __future__ import annotations

from collections.abc import Iterable
from typing import TYPE_CHECKING, Any, Generic, TypeVar

from ..checks import check_type
from ..errors import ProtocolError, StatusError
from ..friction import Friction
from ..grid import Grid
from ..many_steps import stepped_sessions
from ..problem import ContactProblem
from ..reading import read
from ..session import AnySession, SessionSummary, opening
from ..steps import StepInput, StepSolution
from .asking import Answering, asks
from .caller import Caller, ProgressCallback

if TYPE_CHECKING:
    from typing_extensions import Unpack

    from ..keywords import ProblemFields

__all__ = ["SessionCalls"]

S = TypeVar("S", bound=AnySession)


class SessionCalls(Caller, Generic[S]):
    """The methods session.* of the daemon, which give sessions that wait, or await, as their client."""

    _session_kind: type[S]

    @asks
    def session(
        self,
        problem: ContactProblem | None = None,
        /,
        *,
        lease: float | None = None,
        accept_unconverged: bool = False,
        timeout: float | None = None,
        on_progress: ProgressCallback | None = None,
        progress: bool = False,
        **fields: Unpack[ProblemFields],
    ) -> Answering[S]:
        """Opens a Session, which says more: the steps of a simulation.

        What its steps have in common is given as a ContactProblem, as to `solve`, or by its fields, of which `gap`,
        `approach` or `Fn`, and `friction` may be left to the steps.
        """
        if problem is not None:
            check_type("problem", problem, ContactProblem)
            if fields:
                raise TypeError(f"session() takes a ContactProblem or its fields, not both: {', '.join(fields)}")
        said: dict[str, Any] = vars(problem) if problem is not None else dict(fields)
        params = opening(said, lease, accept_unconverged)
        told = yield from self.asked(
            "session.open", params, timeout=timeout, on_progress=on_progress, progress=progress
        )
        if not isinstance(name := told.get("session"), str):
            raise ProtocolError("The answer to session.open lacks its session.")
        friction: Friction | None = said.get("friction")
        rolls = friction is not None and friction.rolling is not None
        return self._session_kind(self, name, told, said["grid"], rolls)

    @asks
    def join_session(self, name: str, *, timeout: float | None = None) -> Answering[S]:
        """The session with this name (Session.name), where its last step left it, whoever opened it and wherever.

        Raises NotFound when it has ended. Two who share a session take turns, and must tell each other: the number of a
        step that the other one has taken is refused (FailedPrecondition) or, asked for in the same words, answered as the
        other one was.
        """
        told = yield from self.asked("session.info", {"session": name}, timeout=timeout)
        grid = read(Grid, told.get("grid"), "result.grid")
        return self._session_kind(self, name, told, grid, told.get("motion") == "rolling")

    @asks
    def step_many(
        self, steps: Iterable[tuple[S, StepInput]], *, timeout: float | None = None
    ) -> Answering[list[StepSolution | StatusError]]:
        """Takes the next step of 1 to 1000 sessions of this client in one message, on all workers of the daemon: of all
        contacts of a vehicle. Each is told as the session and the keywords of its step::

            answers = client.step_many([(left, {"Fn": 51e3, "xi": 1e-3}), (right, {"Fn": 49e3, "xi": -1e-3})])

        The answers are in the order of the steps. Where a step fails, its answer is the exception that Session.step would
        have raised; its session stays where it was, and the others take their steps all the same. With ``"again": True``
        in each, all are tried anew, those that failed, too. An array that several steps share (a gap) is sent once.

        Raises InvalidArgument for the whole, before any session has moved, when a step has a field that the schema does
        not allow, which it names like ``steps[3].friction.mu``, and when a session stands twice or is of another client;
        ContactdError while another call of one of the sessions runs.

        Steps whose answer does not come are asked for again under their numbers, as often as all of the sessions'
        `retries` allow. When the whole fails (a timeout, Ctrl-C), some have taken their steps and others have not: the
        same steps asked for again go on from there, and so do others with ``"again": True``.
        """
        return (yield from stepped_sessions(self, steps, timeout))

    @asks
    def sessions(self, *, timeout: float | None = None) -> Answering[tuple[SessionSummary, ...]]:
        """Ages and counts of the open sessions, oldest first."""
        sessions = (yield from self.asked("session.list", timeout=timeout)).get("sessions")
        if not isinstance(sessions, list):
            raise ProtocolError("The answer to session.list lacks its sessions.")
        return tuple(read(SessionSummary, session, f"result.sessions[{i}]") for i, session in enumerate(sessions))
