"""The blocking client: one Python method for each method of the daemon."""

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
from .values.generated.problem import ContactProblem
from .values.generated.records import StoredIc
from .values.generated.step_input import StepInput
from .values.generated.wheel_rail.step_input import WheelRailStepInput
from .values.solution import ContactSolution, Fields
from .values.step_solution import StepSolution
from .values.wheel_rail.solution import WheelRailStepSolution

if TYPE_CHECKING:
    from typing_extensions import Unpack

    from .values.generated.problem import ProblemFields

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
    """Connects to the daemon at `endpoint`, such as ``tcp://127.0.0.1:5555`` or ``ipc:///run/contactd.socket``.

    The first call opens the connection. Threads may share a client: each call has its own socket, so calls of several
    threads run in parallel, and a progress callback may call the client. A forked process (multiprocessing, Dask) opens
    its own connections, and so does an unpickled client. It reads the key files again by their paths; keys are never
    pickled.

    Times are in seconds; None means one day, the maximum. `timeout` applies to each call without its own timeout.
    `build_timeout` applies instead to calls that may wait for finite-element tables (FemIcs). `connect_timeout` limits
    the wait for a connection. A timeout ends the wait, not the build: the exception describes how to follow the build.

    `spin` is the time that a call polls for its answer before its thread sleeps (s). Polling saves the 20 to 50 us that
    a wake-up takes, but keeps a processor busy. The default is 0.

    The files `server_key` (the daemon's public key) and `own_key` (the secret key of this client, whose public key the
    daemon must have) encrypt the connection. docs/security.md describes how to create them.

    A call that is interrupted (Ctrl-C, an exception of the progress callback) or times out is cancelled. The client
    stays usable. The daemon finishes a build for its cache, unless `cancel_job` ends it.

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
        """Closes the connections. Calls still running in other threads keep theirs until they return."""
        self._connections.close()

    @property
    def is_closed(self) -> bool:
        """Returns whether close() was called."""
        return self._connections.is_closed

    def stored_ics(self, *, evidence: bool = False, timeout: float | None = None) -> Iterator[StoredIc]:
        """Iterates over the tables in the daemon's store by name, in requests of a thousand.

        With `evidence`, each entry includes the evidence of its table. The daemon then reads the file of each table,
        and a request is for a hundred.
        """
        tables, after = self._page_of_stored_ics(None, evidence, timeout)
        yield from tables
        while after is not None:
            tables, after = self._page_of_stored_ics(after, evidence, timeout)
            yield from tables

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
    ) -> ContactSolution:
        """Solves a ContactProblem. Give the problem, its gap and bodies, or its fields. Check `converged` of the
        solution::

            client.solve(problem)
            client.solve(Paraboloid(50, 50), steel, Fn=100)  # both bodies are of steel
            client.solve(gap=heights, grid=grid, upper=steel, lower=RigidBody(), approach=0.01)

        `grid` is optional for half-spaces in closed form whose `gap` is a Paraboloid or SemiAxes. The solve then uses
        40 x 40 elements over 1.25 times the ellipse of Hertz's contact. It is repeated once on a larger grid if the
        contact reaches the border, or on a smaller one if the contact has few elements. `grid` of the solution is the
        grid that was used.

        `fields` names the arrays to return, or a single one; access to another raises AttributeError. ``fields=[]``
        returns only forces, areas and other results that are not arrays, which is faster. Without `fields`, all arrays
        are returned.
        """
        return self._run(solved(self, problem, upper, lower, problem_fields, fields, timeout, on_progress, progress))

    @public
    def solve_many(
        self,
        problems: Iterable[ContactProblem],
        *,
        fields: Fields | None = None,
        timeout: float | None = None,
        on_progress: ProgressCallback | None = None,
        progress: bool = False,
    ) -> list[ContactSolution | StatusError]:
        """Solves 1 to 1000 problems in one message, on all workers of the daemon. Returns the answers in the order of
        the problems.

        If a problem fails, its answer is the exception that `solve` would raise. The others are not affected::

            for answer in client.solve_many(problems):
                if isinstance(answer, StatusError):
                    print(answer.message, answer.violations)
                else:
                    print(answer.Fx, answer.converged)

        `fields` names the arrays to return for each problem, as for `solve`.

        Raises InvalidArgument for the whole call if a field of a problem is missing or out of bounds; the error names
        it, such as ``problems[3].grid.nx``. The error is LIMIT_EXCEEDED if all grids or arrays together are too large.
        An array that several problems share (a gap, TableIcs) is sent once.
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
        """Solves the next step of 1 to 1000 sessions of this client in one message, on all workers of the daemon, for
        example of all contacts of a vehicle. Give each session with the keywords of its step::

            answers = client.step_many([(left, {"Fn": 51e3, "xi": 1e-3}), (right, {"Fn": 49e3, "xi": -1e-3})])
            answers = client.step_many([(wheel, {"state": state}) for wheel, state in zip(wheels, states)])

        The answers are in the order of the steps. If a step fails, its answer is the exception that Session.step would
        raise. Its session is unchanged, and the others are not affected. ``"again": True`` in every step repeats all of
        them, including those that failed. An array that several steps share (a gap) is sent once.

        Raises InvalidArgument for the whole call, before any session changes, if a field of a step is invalid (the
        error names it, such as ``steps[3].friction.mu``), or a session is repeated or belongs to another client. Raises
        ContactdError while another call of one of the sessions runs.

        Steps without an answer are repeated under the same numbers, up to the smallest `retries` of the sessions. If
        the whole call fails (a timeout, Ctrl-C), some sessions may have advanced and others not. To continue, request
        the same steps again, or other steps with ``"again": True``.
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
            # A socket never connects again after its handshake was refused.
            self._connections.give_back(connection, usable=not isinstance(error, Unauthenticated))
            raise
        except BaseException:
            # An interrupt may have come between two frames of a message: this socket cannot be trusted any more.
            self._connections.give_back(connection, usable=False)
            raise
        self._connections.give_back(connection)
        return reply


class ClientOptions(TypedDict, total=False):
    """Options of Client other than the endpoint."""

    timeout: float | None
    build_timeout: float | None
    connect_timeout: float | None
    server_key: str | Path | None
    own_key: str | Path | None
    spin: float
