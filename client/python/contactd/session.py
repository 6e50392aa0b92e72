"""Sessions: the steps of a simulation, each of which starts where the one before ended (docs/sessions.md)."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from types import TracebackType
from typing import TYPE_CHECKING, Any

import numpy.typing as npt

from .calls.asking import Answering, Asked, Waits, asks, insist
from .checks import check_type
from .errors import ContactdError, ProtocolError
from .friction import Force, Friction, RollingKind
from .gaps import Paraboloid, SemiAxes
from .grid import Grid
from .partial import Fields
from .problem import check_field_types
from .problem_params import opening_params
from .reading import read
from .showing import Rows, Shown
from .solution import IcUse, Progress
from .steps import StepInput, Steps, StepSolution

if TYPE_CHECKING:
    from .calls.caller import Caller

__all__ = ["AnySession", "SavedState", "Session", "SessionSummary", "StepSolution", "opening"]

ProgressCallback = Callable[[Progress], None]


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


def opening(fields: dict[str, Any], lease: float | None, accept_unconverged: bool) -> dict[str, Any]:
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


class AnySession(Shown):
    """The steps of a session, whether they are waited for (Session) or awaited (AsyncSession)."""

    def __init__(self, client: Caller, name: str, told: dict[str, Any], grid: Grid, rolls: bool) -> None:
        try:
            self.lease_seconds = float(told["lease_seconds"])
            self.bytes = int(told["bytes"])
            step = int(told["step"])
            ics = told["ics"].items()
        except (KeyError, TypeError, ValueError, AttributeError):
            raise ProtocolError("The answer to session.open or session.info lacks its session.") from None
        self.ics = {body: read(IcUse, use, f"result.ics.{body}") for body, use in ics}
        self.retries = 1
        self._client = client
        self._steps = Steps(name, grid, rolls, step)

    @property
    def name(self) -> str:
        """The key to the session, for Client.join_session: who has it can take steps, and end it."""
        return self._steps.session

    @property
    def grid(self) -> Grid:
        """The potential contact area."""
        return self._steps.grid

    @property
    def step_number(self) -> int:
        """Number of the last step, 0 before the first."""
        return self._steps.number

    def __reduce__(self) -> Any:
        raise TypeError("a Session cannot be pickled; hand on session.name, and join it by client.join_session(name)")

    def _title(self) -> str:
        return f"Session {self.name[:6]}... of {self._client.endpoint}"  # no more of the key

    def _rows(self) -> Rows:
        grid = f"{self.grid.nx} x {self.grid.ny} elements of {self.grid.dx:g} x {self.grid.dy:g}"
        return [("last step", self.step_number), ("grid", grid), ("lease", f"{self.lease_seconds:g} s")]

    @asks
    def close(self, *, timeout: float | None = None) -> Answering[None]:
        """Ends the session in the daemon. Raises NotFound when it has ended already."""
        self._steps.check_process()
        yield from self._client.asked("session.close", {"session": self.name}, timeout=timeout)

    @asks
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
        again: bool = False,
        timeout: float | None = None,
        on_progress: ProgressCallback | None = None,
        progress: bool = False,
    ) -> Answering[StepSolution]:
        """Solves the next step. What is None is as the session was opened.

        Friction may be given whole, or by the fields of Friction and Rolling that change: `force` is that of rolling in
        a session that rolls, else that of a shift. `fields` names the arrays wanted back, or the one; `derivatives` says
        whether those are wanted, too.

        With `again` the step that was asked for last is tried anew: had it been solved, it is taken back, and this one
        starts where it started. As often as wanted, also after one that failed or whose answer was lost.

        Raises FailedPrecondition when the daemon is at another step, Aborted (reason NOT_CONVERGED) when a solver
        missed its tolerance, NotFound when the session has ended, and what Client.solve raises.
        """
        step: StepInput = {
            "approach": approach, "Fn": Fn, "gap": gap, "friction": friction, "mu": mu, "force": force,
            "rigid_shift": rigid_shift, "rotation": rotation, "duration": duration, "rigid_slip": rigid_slip,
            "xi": xi, "eta": eta, "phi": phi, "chi": chi, "dq": dq, "spin_offset": spin_offset, "kind": kind,
            "steps": steps, "velocity": velocity, "derivatives": derivatives, "fields": fields, "again": again,
        }  # fmt: skip
        with self._steps.alone():
            params = self._steps.params(self._steps.number_of(step), step)
            result = yield from self._insist("session.step", params, timeout, on_progress, progress)
            return self._steps.read(params.get("fields", ()), result)

    @asks
    def save(self, *, timeout: float | None = None) -> Answering[SavedState]:
        """Keeps where the session is, for restore()."""
        with self._steps.alone():
            result = yield from self._client.asked("session.save", {"session": self.name}, timeout=timeout)
        return SavedState(str(result["state"]), int(result["step"]))

    @asks
    def restore(self, state: SavedState, *, timeout: float | None = None) -> Answering[None]:
        """Takes the session to a saved state, which stays: as often as wanted."""
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

    def _insist(
        self,
        method: str,
        params: dict[str, Any],
        timeout: float | None,
        on_progress: ProgressCallback | None = None,
        progress: bool = False,
    ) -> Answering[dict[str, Any]]:
        """Asks again when no answer came: the daemon tells a request that it has answered by its number."""

        def ask() -> Answering[dict[str, Any]]:
            return self._client.asked(method, params, timeout=timeout, on_progress=on_progress, progress=progress)

        return insist(ask, self.retries)


class Session(AnySession, Waits):
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
        lease_seconds: The session ends when unused for that long (s).
        bytes: What it took of the daemon's memory when it was opened or joined.
        ics: Where the influence coefficients came from, as in ContactEvidence.
        retries: How often a step or a restore whose answer does not come is asked for again.
    """

    def _carry_out(self, asked: Asked) -> Any:
        return self._client._carry_out(asked)  # type: ignore[attr-defined]

    def __enter__(self) -> Session:
        return self

    def __exit__(
        self, kind: type[BaseException] | None, value: BaseException | None, traceback: TracebackType | None
    ) -> None:
        try:
            self.close()
        except ContactdError:
            pass  # the parent's to end, gone already, or out of reach: then its lease ends it
