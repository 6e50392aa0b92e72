"""Opens and joins sessions, and solves steps of several sessions."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING, Any, Generic, TypeVar

from ..errors import ProtocolError, invalid
from ..refusals import check_type
from ..values.answers import read
from ..values.contact_params import opening_params
from ..values.generated.friction import Friction
from ..values.generated.grid import Grid
from ..values.generated.problem import ContactProblem, ProblemFields
from ..values.generated.service import SessionSummary
from ..values.generated.wheel_rail.setup import Side, WheelRailSetup
from ..values.problem_methods import check_field_types
from ..values.wheel_rail.params import setup_params
from .call import Answering, asks
from .caller import Caller, ProgressCallback
from .timeouts import wheel_may_build

if TYPE_CHECKING:
    from typing_extensions import Unpack

__all__ = ["SessionCalls"]

S = TypeVar("S")  #: A session of a contact, blocking or asyncio.
W = TypeVar("W")  #: A session of a wheel on its rail, blocking or asyncio.


class SessionCalls(Caller, Generic[S, W]):
    """Calls the methods session.* of the daemon. Sessions are blocking or asyncio like their client."""

    _session_kind: Callable[[Caller, str, dict[str, Any], Grid, bool], S]
    _wheel_rail_session_kind: Callable[[Caller, str, dict[str, Any], Side, bool], W]

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
        """Opens a Session for the steps of a simulation; see Session.

        Give the common part of its steps as a ContactProblem or by its fields, as for `solve`. You may leave `gap`,
        `approach` or `Fn`, and `friction` to the steps.
        """
        if problem is not None:
            check_type("problem", problem, ContactProblem)
            if fields:
                raise TypeError(f"session() accepts a ContactProblem or its fields, not both: {', '.join(fields)}")
        inputs: dict[str, Any] = vars(problem) if problem is not None else dict(fields)
        params = _opening(inputs, lease, accept_unconverged)
        reported = yield from self.asked(
            "session.open", params, timeout=timeout, on_progress=on_progress, progress=progress
        )
        name = _name_in(reported)
        friction: Friction | None = inputs.get("friction")
        rolls = friction is not None and friction.rolling is not None
        return self._session_kind(self, name, reported, inputs["grid"], rolls)

    @asks
    def join_session(self, name: str, *, timeout: float | None = None) -> Answering[S]:
        """Joins the session with this name (Session.name) at its current step. Any process may have opened it.

        Raises NotFound if it has ended. Programs that share a session must take turns and tell each other the step
        number. A step that the other program has already solved raises FailedPrecondition, or returns the same answer
        if the requests are equal.
        """
        reported = yield from self.asked("session.info", {"session": name}, timeout=timeout)
        if "side" in reported:
            raise invalid("name", "belongs to the session of a wheel on its rail; use join_wheel_rail_session")
        grid = read(Grid, reported.get("grid"), "result.grid")
        return self._session_kind(self, name, reported, grid, reported.get("motion") == "rolling")

    @asks
    def wheel_rail_session(
        self,
        setup: WheelRailSetup,
        *,
        lease: float | None = None,
        accept_unconverged: bool = False,
        timeout: float | None = None,
    ) -> Answering[W]:
        """Opens a WheelRailSession for the steps of a wheel on its rail. The set-up is sent once; see WheelRailSession.

        Raises InvalidArgument naming ``wheelrail.setup.track.gauge``, ...
        """
        params = _wheel_rail_opening(setup, lease, accept_unconverged)
        reported = yield from self.asked("session.open", params, timeout=timeout)
        builds = wheel_may_build(params["wheelrail"]["setup"])
        return self._wheel_rail_session_kind(self, _name_in(reported), reported, setup.side or "right", builds)

    @asks
    def join_wheel_rail_session(self, name: str, *, timeout: float | None = None) -> Answering[W]:
        """Joins the session of a wheel on its rail, as join_session does. Pass a `timeout` to steps that may wait for
        finite elements, because only the client that opened the session has this information.
        """
        reported = yield from self.asked("session.info", {"session": name}, timeout=timeout)
        if (side := reported.get("side")) not in ("left", "right"):
            raise invalid("name", "belongs to the session of a contact; use join_session")
        return self._wheel_rail_session_kind(self, name, reported, side, False)

    @asks
    def sessions(self, *, timeout: float | None = None) -> Answering[tuple[SessionSummary, ...]]:
        """Returns ages and counts of the open sessions, oldest first."""
        sessions = (yield from self.asked("session.list", timeout=timeout)).get("sessions")
        if not isinstance(sessions, list):
            raise ProtocolError("The answer to session.list lacks its sessions.")
        return tuple(read(SessionSummary, session, f"result.sessions[{i}]") for i, session in enumerate(sessions))


def _name_in(reported: dict[str, Any]) -> str:
    if not isinstance(name := reported.get("session"), str):
        raise ProtocolError("The answer to session.open lacks its session.")
    return name


def _lease_params(lease: float | None, accept_unconverged: bool) -> dict[str, Any]:
    """Returns the parameters that opening has for all kinds of sessions."""
    params: dict[str, Any] = {} if lease is None else {"lease_seconds": lease}
    return {**params, "accept_unconverged": True} if accept_unconverged else params


def _opening(fields: dict[str, Any], lease: float | None, accept_unconverged: bool) -> dict[str, Any]:
    """Returns the parameters of session.open."""
    given = {name: value for name, value in fields.items() if value is not None}
    check_field_types(ContactProblem, given)
    if given.keys() >= {"approach", "Fn"}:
        raise TypeError("session() has both approach and Fn; give only one of them")
    return opening_params(given) | _lease_params(lease, accept_unconverged)


def _wheel_rail_opening(setup: WheelRailSetup, lease: float | None, accept_unconverged: bool) -> dict[str, Any]:
    """Returns the parameters of session.open."""
    opened = {"wheelrail": {"setup": setup_params(setup, "wheelrail.setup")}}
    return opened | _lease_params(lease, accept_unconverged)
