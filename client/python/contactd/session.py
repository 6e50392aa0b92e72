"""Sessions: the steps of a simulation, each of which starts where the one before ended (docs/sessions.md)."""

from __future__ import annotations

import os
import threading
import time
from collections.abc import Callable, Iterable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from types import TracebackType
from typing import TYPE_CHECKING, Any

import numpy.typing as npt

from .errors import ConnectionFailed, ContactdError, DeadlineExceeded, ProtocolError, TimeoutExpired
from .friction import Force, Friction, RollingKind, coefficient_param, slip_param
from .partial import Fields, PartialSolution, check_arrays, names_of
from .problem import Grid, Paraboloid, SemiAxes, check_field_types, check_type, gap_params, opening_params
from .reading import read
from .showing import Rows, Shown, with_inherited_attributes
from .solution import IcUse, Progress

if TYPE_CHECKING:
    from .client import Client

__all__ = ["SavedState", "Session", "SessionSummary", "StepSolution"]

ProgressCallback = Callable[[Progress], None]


@with_inherited_attributes
@dataclass(frozen=True, eq=False, repr=False, kw_only=True)
class StepSolution(PartialSolution):
    """The solution of a step. Arrays are None unless `fields` named them; `converged` is False only in a session that
    accepts it.

    Attributes:
        step: Number of the step.
    """

    step: int

    def _title(self) -> str:
        return f"StepSolution {self.step}"


@dataclass(frozen=True)
class SavedState:
    """What save() returns and restore() takes.

    Attributes:
        name: What the daemon calls it.
        step: Number of the last step when it was saved.
    """

    name: str
    step: int


@dataclass(frozen=True)
class SessionSummary:
    """One session of the daemon, as Client.sessions lists it; its name is the key to it and is not told.

    Attributes:
        age_seconds: Since it was opened (s).
        idle_seconds: Since a request used it last (s), 0 while one does.
        lease_seconds: It ends when idle for that long (s).
        step: Number of its last step.
        states: Saved states.
        bytes: What it takes of the daemon's memory, saved states included.
        elements: Elements of its grid.
    """

    age_seconds: float
    idle_seconds: float
    lease_seconds: float
    step: int
    states: int
    bytes: int
    elements: int


def _session_params(fields: dict[str, Any], lease: float | None, accept_unconverged: bool) -> dict[str, Any]:
    """The parameters of session.open."""
    given = {name: value for name, value in fields.items() if value is not None}
    check_field_types(given)
    if given.keys() >= {"approach", "Fn"}:
        raise TypeError("session() takes either approach or Fn")
    params = opening_params(given)
    if lease is not None:
        params["lease_seconds"] = lease
    if accept_unconverged:
        params["accept_unconverged"] = True
    return params


def opened_session(
    client: Client,
    fields: dict[str, Any],
    lease: float | None,
    accept_unconverged: bool,
    timeout: float | None,
    on_progress: ProgressCallback | None,
) -> Session:
    """What Client.session returns."""
    params = _session_params(fields, lease, accept_unconverged)
    opened = client.call("session.open", params, timeout=timeout, on_progress=on_progress)
    if not isinstance(name := opened.get("session"), str):
        raise ProtocolError("The answer to session.open lacks its session.")
    friction: Friction | None = fields.get("friction")
    return Session(client, name, opened, fields["grid"], friction is not None and friction.rolling is not None)


def joined_session(client: Client, name: str, timeout: float | None) -> Session:
    """What Client.join_session returns."""
    told = client.call("session.info", {"session": name}, timeout=timeout)
    return Session(client, name, told, read(Grid, told.get("grid"), "result.grid"), told.get("motion") == "rolling")


def listed_sessions(answer: dict[str, Any]) -> tuple[SessionSummary, ...]:
    """What Client.sessions returns."""
    sessions = answer.get("sessions")
    if not isinstance(sessions, list):
        raise ProtocolError("The answer to session.list lacks its sessions.")
    return tuple(read(SessionSummary, session, f"result.sessions[{i}]") for i, session in enumerate(sessions))


class Session(Shown):
    """The steps of a simulation, of which each starts where the one before ended.

    ::

        with client.session(grid=grid, upper=steel, gap=gap, friction=Friction(mu=0.3, rolling=Rolling())) as session:
            for xi in creepages:
                solution = session.step(Fn=1e4, xi=xi)

    Client.session takes a ContactProblem without `initial`, or its fields; `gap`, `approach` or `Fn` and `friction` hold
    for the steps that name no others, and may be left out. It returns when the tables lie ready. The session ends with its
    ``with`` block, or when unused for `lease` seconds (None: the daemon's choice). A step that missed a tolerance fails,
    unless `accept_unconverged`.

    Steps are numbered here. A step whose answer does not come is asked for again under its number, which the daemon
    answers without solving twice; should that fail too, the session is either where it was or one step further, and the
    same step asked for again goes on from there. A step that fails leaves the session as it was.

    Belongs to the process that opened it, and there to one thread at a time, because steps have an order: a call while
    another one runs raises ContactdError. Others, a forked process too, take it over by its `name`, which is the key to
    it: ``client.join_session(name)``.

    Attributes:
        grid: The potential contact area.
        step_number: Number of the last step, 0 before the first.
        lease_seconds: The session ends when unused for that long (s).
        bytes: What it took of the daemon's memory when it was opened or joined.
        ics: Where the influence coefficients came from, as in ContactEvidence.
        retries: How often a step or a restore whose answer does not come is asked for again.
    """

    def __init__(self, client: Client, name: str, told: dict[str, Any], grid: Grid, rolls: bool) -> None:
        try:
            self.lease_seconds = float(told["lease_seconds"])
            self.bytes = int(told["bytes"])
            self.step_number = int(told["step"])
            ics = told["ics"].items()
        except (KeyError, TypeError, ValueError, AttributeError):
            raise ProtocolError("The answer to session.open or session.info lacks its session.") from None
        self.ics = {body: read(IcUse, use, f"result.ics.{body}") for body, use in ics}
        self.grid = grid
        self.retries = 1
        self._name = name
        self._client = client
        self._rolls = rolls
        self._process = os.getpid()
        self._in_use = threading.Lock()

    @property
    def name(self) -> str:
        """The key to the session, for Client.join_session: who has it can take steps, and end it."""
        return self._name

    def __reduce__(self) -> Any:
        raise TypeError("a Session cannot be pickled; hand on session.name, and join it by client.join_session(name)")

    def _title(self) -> str:
        return f"Session {self._name[:6]}... of {self._client.endpoint}"  # no more of the key

    def _rows(self) -> Rows:
        grid = f"{self.grid.nx} x {self.grid.ny} elements of {self.grid.dx:g} x {self.grid.dy:g}"
        return [("last step", self.step_number), ("grid", grid), ("lease", f"{self.lease_seconds:g} s")]

    def __enter__(self) -> Session:
        return self

    def __exit__(
        self, kind: type[BaseException] | None, value: BaseException | None, traceback: TracebackType | None
    ) -> None:
        if self._process != os.getpid():
            return  # the parent's to end
        try:
            self.close()
        except ContactdError:
            pass  # gone already, or out of reach: then its lease ends it

    def close(self, *, timeout: float | None = None) -> None:
        """Ends the session in the daemon. Raises NotFound when it has ended already."""
        self._check_process()
        self._client.call("session.close", {"session": self._name}, timeout=timeout)

    def step(
        self,
        *,
        approach: float | None = None,
        Fn: float | None = None,
        gap: Paraboloid | SemiAxes | npt.ArrayLike | None = None,
        friction: Friction | None = None,
        mu: float | npt.ArrayLike | None = None,
        force: Force | None = None,
        rigid_shift: tuple[float, float] | None = None,
        rotation: float | None = None,
        duration: float | None = None,
        rigid_slip: tuple[npt.ArrayLike, npt.ArrayLike] | None = None,
        xi: float | None = None,
        eta: float | None = None,
        phi: float | None = None,
        chi: float | None = None,
        dq: float | None = None,
        spin_offset: float | None = None,
        kind: RollingKind | None = None,
        steps: int | None = None,
        velocity: float | None = None,
        derivatives: bool | None = None,
        fields: Fields = (),
        timeout: float | None = None,
        on_progress: ProgressCallback | None = None,
    ) -> StepSolution:
        """Solves the next step. What is None is as the session was opened.

        Friction may be given whole, or by the fields of Friction and Rolling that change: `force` is that of rolling in
        a session that rolls, else that of a shift. `fields` names the arrays wanted back, or the one; `derivatives` says
        whether those are wanted, too.

        Raises FailedPrecondition when the daemon is at another step, Aborted (reason NOT_CONVERGED) when a solver
        missed its tolerance, NotFound when the session has ended, and what Client.solve raises.
        """
        params: dict[str, Any] = {"session": self._name}
        for name, load in (("approach", approach), ("Fn", Fn)):
            if load is not None:
                params[name] = load
        if gap is not None:
            params["gap"] = gap_params(gap)
        rolling = {
            "xi": xi, "eta": eta, "phi": phi, "chi": chi, "dq": dq, "spin_offset": spin_offset,
            "kind": kind, "steps": steps, "velocity": velocity,
        }  # fmt: skip
        shift = {"rigid_shift": _pair(rigid_shift), "rotation": rotation, "duration": duration}
        changes = self._friction(friction, mu, _pair(force), shift, rolling)
        if rigid_slip is not None:
            changes["rigid_slip"] = slip_param(rigid_slip)
        if changes:
            params["friction"] = changes
        if derivatives is not None:
            params["derivatives"] = derivatives
        if names := names_of(fields):
            params["fields"] = names
        with self._alone():
            params["step"] = self.step_number + 1
            result = self._insist("session.step", params, timeout, on_progress)
            solution = read(StepSolution, result)
            check_arrays(solution, names, self.grid)
            self.step_number = solution.step
        return solution

    def save(self, *, timeout: float | None = None) -> SavedState:
        """Keeps where the session is, for restore()."""
        with self._alone():
            result = self._client.call("session.save", {"session": self._name}, timeout=timeout)
        return SavedState(str(result["state"]), int(result["step"]))

    def restore(self, state: SavedState, *, timeout: float | None = None) -> None:
        """Takes the session to a saved state, which stays: as often as wanted."""
        check_type("state", state, SavedState)
        with self._alone():
            result = self._insist("session.restore", {"session": self._name, "state": state.name}, timeout, None)
            self.step_number = int(result["step"])

    def forget(self, state: SavedState, *, timeout: float | None = None) -> None:
        """Frees a saved state."""
        check_type("state", state, SavedState)
        self._check_process()
        self._client.call("session.forget", {"session": self._name, "state": state.name}, timeout=timeout)

    def _check_process(self) -> None:
        if self._process != os.getpid():
            raise ContactdError(
                f"This session belongs to process {self._process}, from which process {os.getpid()} was forked; open one "
                "of your own, or take it over by client.join_session(session.name)."
            )

    @contextmanager
    def _alone(self) -> Iterator[None]:
        """Two calls at once would give two steps the same number."""
        self._check_process()
        if not self._in_use.acquire(blocking=False):
            raise ContactdError(
                "A call of this session runs, in another thread or in the progress callback of this one; a session takes "
                "one step at a time, in order. Open a session for each thread."
            )
        try:
            yield
        finally:
            self._in_use.release()

    def _friction(
        self,
        friction: Friction | None,
        mu: float | npt.ArrayLike | None,
        force: Any,
        shift: dict[str, Any],
        rolling: dict[str, Any],
    ) -> dict[str, Any]:
        changes = friction.params() if friction is not None else {}
        if mu is not None:
            changes["mu"] = coefficient_param(mu)
        shift = {name: value for name, value in shift.items() if value is not None}
        rolling = {name: value for name, value in rolling.items() if value is not None}
        rolls = bool(rolling) or "rolling" in changes or (self._rolls and not shift and friction is None)
        if force is not None:
            (rolling if rolls else shift)["force"] = force
        if rolling:
            changes["rolling"] = {**changes.get("rolling", {}), **rolling}
        return {**changes, **shift}

    def _insist(
        self, method: str, params: dict[str, Any], timeout: float | None, on_progress: ProgressCallback | None
    ) -> dict[str, Any]:
        """Asks again when no answer came: the daemon tells a request that it has answered by its number."""
        for attempt in range(self.retries + 1):
            try:
                return self._client.call(method, params, timeout=timeout, on_progress=on_progress)
            except DeadlineExceeded:
                raise  # an answer: the session is as it was
            except (TimeoutExpired, ConnectionFailed):
                if attempt == self.retries:
                    raise
                time.sleep(0.05)
        raise AssertionError("unreachable")


def _pair(values: Any) -> Any:
    """As a list, whatever sequence it is. What is no sequence is the daemon's to refuse, by name."""
    return list(values) if isinstance(values, Iterable) else values
