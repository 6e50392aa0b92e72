"""The client that awaits its answers: the calls of Client, as coroutines of asyncio."""

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
from .values.partial_solution import PartialSolution, StepSolution
from .values.problem import ContactProblem
from .values.records import StoredIc
from .values.solution import ContactSolution, Fields
from .values.step_input import StepInput
from .values.wheel_rail.solution import WheelRailStepSolution
from .values.wheel_rail.step_input import WheelRailStepInput

if TYPE_CHECKING:
    from typing_extensions import Self, Unpack

    from .values.problem import ProblemFields

__all__ = ["AsyncClient", "AsyncSession", "AsyncWheelRailSession"]


class SessionThatAwaits(AnySession, Awaits):
    """A session whose calls are awaited, and which ends with its ``async with`` block."""

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
            pass  # the parent's to end, gone already, or out of reach: then its lease ends it


class AsyncSession(AnyContactSession, SessionThatAwaits):
    """The Session of an AsyncClient: the same steps, which are awaited.

    ::

        async with await client.session(grid=grid, upper=steel, gap=gap, Fn=1e4) as session:
            solution = await session.step(Fn=2e4)

    Steps have an order: one that is asked for while another one runs raises ContactdError. Tasks of one loop may take
    turns.
    """


class AsyncWheelRailSession(AnyWheelRailSession, SessionThatAwaits):
    """The WheelRailSession of an AsyncClient: the same steps, which are awaited."""


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
    """A Client whose calls are coroutines: same names, same arguments, same answers and exceptions.

    ::

        async with AsyncClient("tcp://127.0.0.1:5555") as client:
            solutions = await asyncio.gather(*(client.solve(problem, fields=[]) for problem in problems))

    All calls share one connection, made with the first one. The daemon has `outstanding` of them at a time, and further
    ones wait here for their turn, except those that are answered at once (server.*, job.*). Time spent waiting counts.

    A task that is cancelled cancels its call in the daemon, as a timeout does. `on_progress` is called in the task that
    awaits. Belongs to one event loop at a time: a second ``asyncio.run`` connects anew, and so does a forked process, or one
    that a pickle of it arrives in. `close()` is a coroutine, and ends what still runs with ConnectionFailed.
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
        self._inherited: list[Exchanges] = []  # of the process this one was forked from: neither used nor freed
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
        """Ends the connection, and what still runs with ConnectionFailed. May be called twice."""
        self._is_closed = True
        if self._exchanges is not None:
            self._exchanges.close()

    @property
    def is_closed(self) -> bool:
        """Whether close() was called."""
        return self._is_closed

    async def stored_ics(self, *, evidence: bool = False, timeout: float | None = None) -> AsyncIterator[StoredIc]:
        """The tables in the daemon's store, by name; asked for a thousand at a time: ``async for``.

        With `evidence` each says how it was made, which takes its file to be read: asked for a hundred at a time.
        """
        tables, after = await self._page_of_stored_ics(None, evidence, timeout)
        for table in tables:
            yield table
        while after is not None:
            tables, after = await self._page_of_stored_ics(after, evidence, timeout)
            for table in tables:
                yield table

    @overload
    async def solve(
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
    async def solve(
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
    ) -> ContactSolution | PartialSolution:
        """Solves as Client.solve does."""
        return await self._run(solved(self, problem, upper, lower, problem_fields, fields, timeout, on_progress, progress))

    @overload
    async def solve_many(
        self,
        problems: Iterable[ContactProblem],
        *,
        fields: None = None,
        timeout: float | None = None,
        on_progress: ProgressCallback | None = None,
        progress: bool = False,
    ) -> list[ContactSolution | StatusError]: ...
    @overload
    async def solve_many(
        self,
        problems: Iterable[ContactProblem],
        *,
        fields: Fields,
        timeout: float | None = None,
        on_progress: ProgressCallback | None = None,
        progress: bool = False,
    ) -> list[PartialSolution | StatusError]: ...
    @public
    async def solve_many(
        self,
        problems: Iterable[ContactProblem],
        *,
        fields: Fields | None = None,
        timeout: float | None = None,
        on_progress: ProgressCallback | None = None,
        progress: bool = False,
    ) -> list[Any]:
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
        """Takes steps as Client.step_many does."""
        return await self._run(stepped_sessions(self, steps, timeout))

    async def _carry_out(self, asked: Request | Pause) -> Reply | None:
        if isinstance(asked, Pause):
            await asyncio.sleep(asked.seconds)
            return None
        return await self._exchange(asked)

    async def _exchange(self, request: Request) -> Reply:
        return await self._exchanges_here().exchange(request)

    def _exchanges_here(self) -> Exchanges:
        """Those of this process and this loop; made where there are none."""
        if self._is_closed:
            raise ConnectionFailed("The client is closed.")
        known = self._exchanges
        if known is not None and not known.is_of_this_process:
            self._inherited.append(known)
            known = None
        if known is not None and not known.is_closed and not known.is_of_this_loop:
            if not known.loop_has_ended:
                raise ContactdError("This client is used in another event loop that still runs; make one for each loop.")
            known.close()
        if known is None or known.is_closed:
            known = Exchanges(self.endpoint, self._curve, self.outstanding)
        self._exchanges = known
        return known
