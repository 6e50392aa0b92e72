"""The client that waits for its answers: one method of Python for each method of the daemon."""

from __future__ import annotations

import time
from collections.abc import Iterable, Iterator
from pathlib import Path
from types import TracebackType
from typing import TYPE_CHECKING, Any, TypedDict, overload

from .calls.call import Pause, Waits
from .calls.caller import Caller, ProgressCallback
from .calls.comparison import ComparisonCalls
from .calls.contact import ContactCalls, solved, solved_many
from .calls.contact_files import ContactFileCalls
from .calls.contact_session import Session
from .calls.creep_curves import CreepCurveCalls
from .calls.server import ServerCalls
from .calls.sessions import SessionCalls
from .calls.stated_problems import Body, Gap
from .calls.step_many import stepped_sessions
from .calls.tables import TableCalls
from .calls.timeouts import spin_of
from .calls.wheel_rail import WheelRailCalls
from .calls.wheel_rail_session import WheelRailSession
from .errors import StatusError, TimeoutExpired, Unauthenticated
from .refusals import public
from .transport.connections import ConnectionPool, Connections
from .transport.messages import Reply, Request
from .values.partial_solution import PartialSolution, StepSolution
from .values.problem import ContactProblem
from .values.records import StoredIc
from .values.solution import ContactSolution, Fields
from .values.step_input import StepInput
from .values.wheel_rail.solution import WheelRailStepSolution
from .values.wheel_rail.step_input import WheelRailStepInput

if TYPE_CHECKING:
    from typing_extensions import Unpack

    from .values.problem import ProblemFields

__all__ = ["Client", "ClientOptions"]


class Client(
    ServerCalls,
    TableCalls,
    ContactCalls,
    ComparisonCalls,
    ContactFileCalls,
    CreepCurveCalls,
    WheelRailCalls,
    SessionCalls[Session, WheelRailSession],
    Waits,
):
    """Speaks with the daemon at `endpoint`, such as ``tcp://127.0.0.1:5555`` or ``ipc:///run/contactd.socket``.

    Connects with the first call. Safe to share between threads: every call has a socket of its own for as long as it
    lasts, so calls of several threads run side by side, and a progress callback may call the client. A process that is
    forked (multiprocessing, Dask) goes on with connections of its own, and a client that is pickled connects anew where
    it arrives; the key files are read there again, by their paths: no key is ever pickled.

    Times are in seconds, None for a day, the longest there is. `timeout` holds for each call that is not given its own,
    but `build_timeout` for those that may have to wait for tables by finite elements (FemIcs); `connect_timeout` bounds
    the wait for a daemon to listen. A timeout ends the waiting and not a build: the exception says how to follow it.

    `spin` is how long a call looks for its answer before its thread sleeps (s). It saves the 20 to 50 us that waking it
    takes, and keeps a processor busy meanwhile; 0, the default, sleeps at once.

    With the files `server_key` (the daemon's public key) and `own_key` (the secret key of this client, which the daemon
    has to know) the connection is encrypted; docs/security.md says how to make them.

    A call that is interrupted (Ctrl-C, an exception of the progress callback) or times out is cancelled and leaves the
    client usable; the daemon finishes a build for its cache, unless `cancel_job` ends it.

    Every method raises StatusError (a subclass per status), TimeoutExpired, ConnectionFailed or ProtocolError.
    """

    _session_kind = Session
    _wheel_rail_session_kind = WheelRailSession

    @public
    def __init__(
        self,
        endpoint: str,
        *,
        timeout: float | None = 60.0,
        build_timeout: float | None = 3600.0,
        connect_timeout: float | None = 5.0,
        server_key: str | Path | None = None,
        own_key: str | Path | None = None,
        spin: float = 0.0,
    ) -> None:
        Caller.__init__(
            self,
            endpoint,
            timeout=timeout,
            build_timeout=build_timeout,
            connect_timeout=connect_timeout,
            server_key=server_key,
            own_key=own_key,
        )
        self.spin = spin_of(spin)
        self._connections = self._pool()

    def _pool(self) -> ConnectionPool:
        return Connections(self.endpoint, self._curve, self.spin)

    def __getstate__(self) -> dict[str, Any]:
        return {**super().__getstate__(), "spin": self.spin}

    def __setstate__(self, state: dict[str, Any]) -> None:
        Client.__init__(self, **state)

    def __enter__(self) -> Client:
        return self

    def __exit__(
        self, kind: type[BaseException] | None, value: BaseException | None, traceback: TracebackType | None
    ) -> None:
        self.close()

    def close(self) -> None:
        """Ends the connections; calls still running in other threads keep theirs until they return."""
        self._connections.close()

    @property
    def is_closed(self) -> bool:
        """Whether close() was called."""
        return self._connections.is_closed

    def stored_ics(self, *, evidence: bool = False, timeout: float | None = None) -> Iterator[StoredIc]:
        """The tables in the daemon's store, by name; asked for a thousand at a time.

        With `evidence` each says how it was made, which takes its file to be read: asked for a hundred at a time.
        """
        tables, after = self._page_of_stored_ics(None, evidence, timeout)
        yield from tables
        while after is not None:
            tables, after = self._page_of_stored_ics(after, evidence, timeout)
            yield from tables

    @overload
    def solve(
        self,
        problem: ContactProblem | Gap | None = None,
        upper: Body | None = None,
        lower: Body | None = None,
        /,
        *,
        fields: None = None,
        timeout: float | None = None,
        on_progress: ProgressCallback | None = None,
        progress: bool = False,
        **problem_fields: Unpack[ProblemFields],
    ) -> ContactSolution: ...
    @overload
    def solve(
        self,
        problem: ContactProblem | Gap | None = None,
        upper: Body | None = None,
        lower: Body | None = None,
        /,
        *,
        fields: Fields,
        timeout: float | None = None,
        on_progress: ProgressCallback | None = None,
        progress: bool = False,
        **problem_fields: Unpack[ProblemFields],
    ) -> PartialSolution: ...
    @public
    def solve(
        self,
        problem: ContactProblem | Gap | None = None,
        upper: Body | None = None,
        lower: Body | None = None,
        /,
        *,
        fields: Fields | None = None,
        timeout: float | None = None,
        on_progress: ProgressCallback | None = None,
        progress: bool = False,
        **problem_fields: Unpack[ProblemFields],
    ) -> ContactSolution | PartialSolution:
        """Solves a ContactProblem, given whole, by its gap and bodies, or by its fields. Check `converged` of the solution::

            client.solve(problem)
            client.solve(Paraboloid(50, 50), steel, Fn=100)  # both bodies are of steel
            client.solve(gap=heights, grid=grid, upper=steel, lower=RigidBody(), approach=0.01)

        `grid` is optional for half-spaces in closed form whose `gap` is a Paraboloid or SemiAxes: the solve then takes
        40 x 40 elements over 1.25 times the ellipse of Hertz's contact. It repeats once on a larger grid where the contact
        reaches the border, and on a smaller one where the contact has few elements. `grid` of the solution is the one that
        was used.

        `fields` names the arrays wanted back, or the one, and the others are None; ``fields=[]`` brings forces, areas and
        the rest that is no array, for less. Left out, all arrays come.
        """
        return self._run(solved(self, problem, upper, lower, problem_fields, fields, timeout, on_progress, progress))

    @overload
    def solve_many(
        self,
        problems: Iterable[ContactProblem],
        *,
        fields: None = None,
        timeout: float | None = None,
        on_progress: ProgressCallback | None = None,
        progress: bool = False,
    ) -> list[ContactSolution | StatusError]: ...
    @overload
    def solve_many(
        self,
        problems: Iterable[ContactProblem],
        *,
        fields: Fields,
        timeout: float | None = None,
        on_progress: ProgressCallback | None = None,
        progress: bool = False,
    ) -> list[PartialSolution | StatusError]: ...
    @public
    def solve_many(
        self,
        problems: Iterable[ContactProblem],
        *,
        fields: Fields | None = None,
        timeout: float | None = None,
        on_progress: ProgressCallback | None = None,
        progress: bool = False,
    ) -> list[Any]:
        """Solves 1 to 1000 problems at once, on all workers of the daemon; the answers are in the order of the problems.

        Where a problem fails, its answer is the exception that `solve` would have raised, and the others are solved all
        the same::

            for answer in client.solve_many(problems):
                if isinstance(answer, StatusError):
                    print(answer.message, answer.violations)
                else:
                    print(answer.Fx, answer.converged)

        `fields` names the arrays wanted back of each, as for `solve`.

        Raises InvalidArgument for the whole when a problem lacks a field or has one out of its range, which it names
        like ``problems[3].grid.nx``, and LIMIT_EXCEEDED when their grids or arrays are too large together. An array that
        several problems share (a gap, TableIcs) is sent once.
        """
        return self._run(solved_many(self, problems, fields, timeout, on_progress, progress))

    @overload
    def step_many(
        self, steps: Iterable[tuple[Session, StepInput]], *, timeout: float | None = None
    ) -> list[StepSolution | StatusError]: ...
    @overload
    def step_many(
        self, steps: Iterable[tuple[WheelRailSession, WheelRailStepInput]], *, timeout: float | None = None
    ) -> list[WheelRailStepSolution | StatusError]: ...
    @overload
    def step_many(
        self,
        steps: Iterable[tuple[Session, StepInput] | tuple[WheelRailSession, WheelRailStepInput]],
        *,
        timeout: float | None = None,
    ) -> list[StepSolution | WheelRailStepSolution | StatusError]: ...
    @public
    def step_many(self, steps: Iterable[Any], *, timeout: float | None = None) -> list[Any]:
        """Takes the next step of 1 to 1000 sessions of this client in one message, on all workers of the daemon: of all
        contacts of a vehicle. Each is told as the session and the keywords of its step::

            answers = client.step_many([(left, {"Fn": 51e3, "xi": 1e-3}), (right, {"Fn": 49e3, "xi": -1e-3})])
            answers = client.step_many([(wheel, {"state": state}) for wheel, state in zip(wheels, states)])

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
        return self._run(stepped_sessions(self, steps, timeout))

    def _carry_out(self, asked: Request | Pause) -> Reply | None:
        if isinstance(asked, Pause):
            time.sleep(asked.seconds)
            return None
        return self._exchange(asked)

    def _exchange(self, request: Request) -> Reply:
        connection = self._connections.take()
        try:
            reply = connection.exchange(request)
        except (StatusError, TimeoutExpired) as error:
            # A socket whose handshake was refused never connects again.
            self._connections.give_back(connection, usable=not isinstance(error, Unauthenticated))
            raise
        except BaseException:
            # An interrupt may have come between two frames of a message: this socket cannot be trusted any more.
            self._connections.give_back(connection, usable=False)
            raise
        self._connections.give_back(connection)
        return reply


class ClientOptions(TypedDict, total=False):
    """Options of Client, beside the endpoint."""

    timeout: float | None
    build_timeout: float | None
    connect_timeout: float | None
    server_key: str | Path | None
    own_key: str | Path | None
    spin: float
