"""Sessions: the steps of a simulation, each of which starts where the one before ended (docs/sessions.md)."""

from __future__ import annotations

import time
from collections.abc import Callable, Iterable
from dataclasses import dataclass
from types import TracebackType
from typing import TYPE_CHECKING, Any, Literal

import numpy as np
import numpy.typing as npt

from .errors import ConnectionFailed, ContactdError, DeadlineExceeded, ProtocolError, TimeoutExpired
from .friction import Force, Friction, Motion, RollingKind
from .problem import Array, ContactProblem, Grid, Paraboloid, SemiAxes, check_type, gap_params, problem_params
from .reading import read
from .solution import Areas, Counts, Forces, IcUse, Progress, SolverEvidence, WithForces

if TYPE_CHECKING:
    from .client import Client

__all__ = ["Field", "SavedState", "Session", "SessionSummary", "StepEvidence", "StepSolution"]

Field = Literal["element_division", "pressure", "traction_x", "traction_y", "slip_x", "slip_y"]
ProgressCallback = Callable[[Progress], None]


@dataclass(frozen=True)
class StepEvidence:
    """How the solvers of a step ended, as in ContactEvidence."""

    normal: SolverEvidence
    tangential: SolverEvidence | None = None
    outer: SolverEvidence | None = None
    force: SolverEvidence | None = None


@dataclass(frozen=True, eq=False)
class StepSolution(WithForces):
    """The solution of a step. Its fields are those of ContactSolution; arrays are None unless `fields` named them."""

    step: int
    approach: float  #: delta (mm), prescribed or found
    forces: Forces
    pmax: float  #: largest pressure (N/mm^2)
    area: Areas
    elements: Counts
    converged: bool  #: False only in a session that accepts it
    evidence: StepEvidence
    warnings: tuple[str, ...] = ()
    frictional_work: float | None = None  #: of a shift (N mm)
    frictional_power: float | None = None  #: of rolling (N mm/s)
    motion: Motion | None = None  #: as asked for, with what a prescribed force made of it
    element_division: npt.NDArray[np.uint8] | None = None
    pressure: Array | None = None
    traction_x: Array | None = None
    traction_y: Array | None = None
    slip_x: Array | None = None
    slip_y: Array | None = None


@dataclass(frozen=True)
class SavedState:
    """What save() returns and restore() takes."""

    name: str
    step: int  #: number of the last step when it was saved


@dataclass(frozen=True)
class SessionSummary:
    """One session of the daemon, as Client.sessions lists it; its name is the key to it and is not told."""

    age_seconds: float
    idle_seconds: float  #: since a request used it last
    lease_seconds: float
    step: int
    states: int
    bytes: int
    elements: int


def _session_params(fields: dict[str, Any], lease: float | None, accept_unconverged: bool) -> dict[str, Any]:
    """The parameters of session.open."""
    given = {name: value for name, value in fields.items() if value is not None}
    left_out: dict[str, Any] = {} if "gap" in given else {"gap": Paraboloid(1, 1)}
    if not given.keys() & {"approach", "Fn"}:
        left_out["approach"] = 1
    params = problem_params(ContactProblem(**given, **left_out))
    for name in left_out:
        del params[name]
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
    friction: Friction | None = fields.get("friction")
    return Session(client, opened, fields["grid"], friction is not None and friction.rolling is not None)


def listed_sessions(answer: dict[str, Any]) -> tuple[SessionSummary, ...]:
    """What Client.sessions returns."""
    sessions = answer.get("sessions")
    if not isinstance(sessions, list):
        raise ProtocolError("The answer to session.list lacks its sessions.")
    return tuple(read(SessionSummary, session, f"result.sessions[{i}]") for i, session in enumerate(sessions))


class Session:
    """The steps of a simulation, of which each starts where the one before ended. Belongs to one thread at a time.

    ::

        with client.session(grid=grid, upper=steel, gap=gap, friction=Friction(mu=0.3, rolling=Rolling())) as session:
            for xi in creepages:
                solution = session.step(Fn=1e4, xi=xi)

    Client.session takes the fields of ContactProblem but `initial`; `gap`, `approach` or `Fn` and `friction` hold for the
    steps that name no others, and may be left out. It returns when the tables lie ready. The session ends with its
    ``with`` block, or when unused for `lease` seconds (None: the daemon's choice). A step that missed a tolerance fails,
    unless `accept_unconverged`.

    Steps are numbered here. A step whose answer does not come is asked for again under its number, which the daemon
    answers without solving twice; should that fail too, the session is either where it was or one step further, and the
    same step asked for again goes on from there. A step that fails leaves the session as it was.
    """

    def __init__(self, client: Client, opened: dict[str, Any], grid: Grid, rolls: bool) -> None:
        try:
            self._name = str(opened["session"])
            self.lease_seconds = float(opened["lease_seconds"])  #: the session ends when unused for that long
            self.bytes = int(opened["bytes"])  #: what it takes of the daemon's memory, without saved states
            ics = opened["ics"].items()
        except (KeyError, TypeError, ValueError, AttributeError):
            raise ProtocolError("The answer to session.open lacks its session.") from None
        self.ics = {name: read(IcUse, use, f"result.ics.{name}") for name, use in ics}  #: as in ContactEvidence
        self.grid = grid
        self.step_number = 0  #: of the last step
        self.retries = 1  #: how often a step or a restore whose answer does not come is asked for again
        self._client = client
        self._rolls = rolls

    def __enter__(self) -> Session:
        return self

    def __exit__(
        self, kind: type[BaseException] | None, value: BaseException | None, traceback: TracebackType | None
    ) -> None:
        try:
            self.close()
        except ContactdError:
            pass  # gone already, or out of reach: then its lease ends it

    def close(self, *, timeout: float | None = None) -> None:
        """Ends the session in the daemon. Raises NotFound when it has ended already."""
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
        xi: float | None = None,
        eta: float | None = None,
        phi: float | None = None,
        chi: float | None = None,
        dq: float | None = None,
        kind: RollingKind | None = None,
        steps: int | None = None,
        velocity: float | None = None,
        fields: Iterable[Field] = (),
        timeout: float | None = None,
        on_progress: ProgressCallback | None = None,
    ) -> StepSolution:
        """Solves the next step. What is None is as the session was opened.

        Friction may be given whole, or by the fields of Friction and Rolling that change: `force` is that of rolling in
        a session that rolls, else that of a shift. `fields` names the arrays wanted back.

        Raises FailedPrecondition when the daemon is at another step, Aborted (reason NOT_CONVERGED) when a solver
        missed its tolerance, NotFound when the session has ended, and what Client.solve raises.
        """
        params: dict[str, Any] = {"session": self._name, "step": self.step_number + 1}
        for name, load in (("approach", approach), ("Fn", Fn)):
            if load is not None:
                params[name] = load
        if gap is not None:
            params["gap"] = gap_params(gap)
        rolling = {
            "xi": xi, "eta": eta, "phi": phi, "chi": chi, "dq": dq, "kind": kind, "steps": steps,
            "velocity": velocity,
        }  # fmt: skip
        shift = {"rigid_shift": _pair(rigid_shift), "rotation": rotation, "duration": duration}
        if changes := self._friction(friction, mu, _pair(force), shift, rolling):
            params["friction"] = changes
        if names := list(fields):
            params["fields"] = names
        result = self._insist("session.step", params, timeout, on_progress)
        solution = read(StepSolution, result)
        for name in names:
            array = getattr(solution, name)
            if array is not None and array.shape != self.grid.shape:
                raise ProtocolError(f"The answer's {name} has shape {array.shape} instead of {self.grid.shape}.")
        self.step_number = solution.step
        return solution

    def save(self, *, timeout: float | None = None) -> SavedState:
        """Keeps where the session is, for restore()."""
        result = self._client.call("session.save", {"session": self._name}, timeout=timeout)
        return SavedState(str(result["state"]), int(result["step"]))

    def restore(self, state: SavedState, *, timeout: float | None = None) -> None:
        """Takes the session to a saved state, which stays: as often as wanted."""
        check_type("state", state, SavedState)
        result = self._insist("session.restore", {"session": self._name, "state": state.name}, timeout, None)
        self.step_number = int(result["step"])

    def forget(self, state: SavedState, *, timeout: float | None = None) -> None:
        """Frees a saved state."""
        check_type("state", state, SavedState)
        self._client.call("session.forget", {"session": self._name, "state": state.name}, timeout=timeout)

    def _friction(
        self,
        friction: Friction | None,
        mu: float | npt.ArrayLike | None,
        force: list[float | None] | None,
        shift: dict[str, Any],
        rolling: dict[str, Any],
    ) -> dict[str, Any]:
        changes = friction.params() if friction is not None else {}
        if mu is not None:
            coefficient = np.asarray(mu)
            changes["mu"] = coefficient if coefficient.ndim else coefficient.item()
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


def _pair(values: Iterable[float | None] | None) -> list[float | None] | None:
    return None if values is None else list(values)
