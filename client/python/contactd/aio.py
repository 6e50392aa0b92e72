"""The asyncio client: the calls of Client as coroutines."""

from __future__ import annotations

import asyncio
from collections.abc import AsyncIterator, Iterable
from pathlib import Path
from types import TracebackType
from typing import TYPE_CHECKING, Any, overload

from .calls.any_session import AnySession
from .calls.call import Awaits, Pause
from .calls.caller import Caller, ProgressCallback
from .calls.comparison import ComparisonCalls
from .calls.contact import ContactCalls, solved, solved_many
from .calls.contact_files import ContactFileCalls
from .calls.contact_session import AnyContactSession
from .calls.creep_curves import CreepCurveCalls
from .calls.server import ServerCalls
from .calls.sessions import SessionCalls
from .calls.stated_problems import Body, Gap
from .calls.step_many import stepped_sessions
from .calls.tables import TableCalls
from .calls.wheel_rail import WheelRailCalls
from .calls.wheel_rail_session import AnyWheelRailSession
from .errors import ConnectionFailed, ContactdError, StatusError
from .refusals import public
from .transport.event_loop import Exchanges
from .transport.messages import Reply, Request
from .values.generated.problem import ContactProblem
from .values.generated.records import StoredIc
from .values.generated.step_input import StepInput
from .values.generated.wheel_rail.step_input import WheelRailStepInput
from .values.solution import ContactSolution, Fields
from .values.step_solution import StepSolution
from .values.wheel_rail.solution import WheelRailStepSolution

if TYPE_CHECKING:
    from typing_extensions import Self, Unpack

    from .values.generated.problem import ProblemFields

__all__ = ["AsyncClient", "AsyncSession", "AsyncWheelRailSession"]


class SessionThatAwaits(AnySession, Awaits):
    """A session with asynchronous calls. It ends with its ``async with`` block."""

    async def _carry_out(self, asked: Request | Pause) -> Any:
        return await self._client._carry_out(asked)  # type: ignore[attr-defined]

    async def __aenter__(self) -> Self:
        return self

    async def __aexit__(
        self, kind: type[BaseException] | None, value: BaseException | None, traceback: TracebackType | None
    ) -> None:
        try:
            await self.close()
        except ContactdError:
            pass  # In a forked process, the parent ends it. If the daemon does not answer, the lease ends it.


class AsyncSession(AnyContactSession, SessionThatAwaits):
    """A Session of an AsyncClient: the same steps as coroutines.

    ::

        async with await client.session(grid=grid, upper=steel, gap=gap, Fn=1e4) as session:
            solution = await session.step(Fn=2e4)

    Steps run one after the other: a call during another step raises ContactdError. Several tasks of one loop may use
    the session alternately.
    """


class AsyncWheelRailSession(AnyWheelRailSession, SessionThatAwaits):
    """A WheelRailSession of an AsyncClient: the same steps as coroutines."""


class AsyncClient(
    ServerCalls,
    TableCalls,
    ContactCalls,
    ComparisonCalls,
    ContactFileCalls,
    CreepCurveCalls,
    WheelRailCalls,
    SessionCalls[AsyncSession, AsyncWheelRailSession],
    Awaits,
):
    """A Client whose calls are coroutines. Names, arguments, answers and exceptions are the same.

    ::

        async with AsyncClient("tcp://127.0.0.1:5555") as client:
            solutions = await asyncio.gather(*(client.solve(problem, fields=[]) for problem in problems))

    All calls share one connection, which the first call opens. At most `outstanding` calls are sent at a time. Others
    wait in this process, except calls that are answered immediately (server.*, job.*). The timeout of a call includes
    this wait.

    Cancelling a task cancels its call in the daemon, and so does a timeout. `on_progress` is called in the awaiting
    task. A client belongs to one event loop at a time. It opens a new connection in a second ``asyncio.run``, in a
    forked process, and after unpickling. `close()` is a coroutine; calls still running then raise ConnectionFailed.
    """

    _session_kind = AsyncSession
    _wheel_rail_session_kind = AsyncWheelRailSession

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
        outstanding: int = 64,
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
        if not isinstance(outstanding, int) or isinstance(outstanding, bool):
            raise TypeError(f"outstanding is {outstanding!r}; it must be a whole number of calls, 1 or more")
        if outstanding < 1:
            raise ValueError(f"outstanding is {outstanding}; it must be a whole number of calls, 1 or more")
        self.outstanding = outstanding
        self._exchanges: Exchanges | None = None
        self._inherited: list[Exchanges] = []  # These belong to the parent process: do not use or free them.
        self._is_closed = False

    def __getstate__(self) -> dict[str, Any]:
        return {**super().__getstate__(), "outstanding": self.outstanding}

    def __setstate__(self, state: dict[str, Any]) -> None:
        AsyncClient.__init__(self, **state)

    def _title(self) -> str:
        return f"AsyncClient of {self.endpoint}"

    async def __aenter__(self) -> AsyncClient:
        return self

    async def __aexit__(
        self, kind: type[BaseException] | None, value: BaseException | None, traceback: TracebackType | None
    ) -> None:
        await self.close()

    async def close(self) -> None:
        """Closes the connection. Running calls raise ConnectionFailed. A second call has no effect."""
        self._is_closed = True
        if self._exchanges is not None:
            self._exchanges.close()

    @property
    def is_closed(self) -> bool:
        """Returns whether close() was called."""
        return self._is_closed

    async def stored_ics(self, *, evidence: bool = False, timeout: float | None = None) -> AsyncIterator[StoredIc]:
        """Iterates over the tables in the daemon's store by name (``async for``), in requests of a thousand.

        With `evidence`, each entry includes the evidence of its table. The daemon then reads the file of each table,
        and a request is for a hundred.
        """
        tables, after = await self._page_of_stored_ics(None, evidence, timeout)
        for table in tables:
            yield table
        while after is not None:
            tables, after = await self._page_of_stored_ics(after, evidence, timeout)
            for table in tables:
                yield table

    @public
    async def solve(
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
        """Solves as Client.solve does."""
        return await self._run(solved(self, problem, upper, lower, problem_fields, fields, timeout, on_progress, progress))

    @public
    async def solve_many(
        self,
        problems: Iterable[ContactProblem],
        *,
        fields: Fields | None = None,
        timeout: float | None = None,
        on_progress: ProgressCallback | None = None,
        progress: bool = False,
    ) -> list[ContactSolution | StatusError]:
        """Solves as Client.solve_many does."""
        return await self._run(solved_many(self, problems, fields, timeout, on_progress, progress))

    @overload
    async def step_many(
        self, steps: Iterable[tuple[AsyncSession, StepInput]], *, timeout: float | None = None
    ) -> list[StepSolution | StatusError]: ...
    @overload
    async def step_many(
        self, steps: Iterable[tuple[AsyncWheelRailSession, WheelRailStepInput]], *, timeout: float | None = None
    ) -> list[WheelRailStepSolution | StatusError]: ...
    @overload
    async def step_many(
        self,
        steps: Iterable[tuple[AsyncSession, StepInput] | tuple[AsyncWheelRailSession, WheelRailStepInput]],
        *,
        timeout: float | None = None,
    ) -> list[StepSolution | WheelRailStepSolution | StatusError]: ...
    @public
    async def step_many(self, steps: Iterable[Any], *, timeout: float | None = None) -> list[Any]:
        """Solves steps as Client.step_many does."""
        return await self._run(stepped_sessions(self, steps, timeout))

    async def _carry_out(self, asked: Request | Pause) -> Reply | None:
        if isinstance(asked, Pause):
            await asyncio.sleep(asked.seconds)
            return None
        return await self._exchange(asked)

    async def _exchange(self, request: Request) -> Reply:
        return await self._exchanges_here().exchange(request)

    def _exchanges_here(self) -> Exchanges:
        """Returns the exchanges of this process and event loop; creates them if there are none."""
        if self._is_closed:
            raise ConnectionFailed("The client is closed.")
        known = self._exchanges
        if known is not None and not known.is_of_this_process:
            self._inherited.append(known)
            known = None
        if known is not None and not known.is_closed and not known.is_of_this_loop:
            if not known.loop_has_ended:
                raise ContactdError("This client is used in another running event loop; create one client for each loop.")
            known.close()
        if known is None or known.is_closed:
            known = Exchanges(self.endpoint, self._curve, self.outstanding)
        self._exchanges = known
        return known
