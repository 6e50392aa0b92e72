"""Sessions of a contact: the steps of a simulation, each of which starts where the one before ended (docs/sessions.md)."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy.typing as npt

from ..errors import ProtocolError
from ..values.answers import read
from ..values.contact_params import opening_params
from ..values.evidence import IcUse
from ..values.friction import Force, Friction, RollingKind
from ..values.gaps import Paraboloid, SemiAxes
from ..values.grid import Grid
from ..values.partial_solution import Fields, StepInput, StepSolution
from ..values.problem import check_field_types
from ..values.representation import Rows
from ..values.service import SavedState
from .any_session import AnySession, ProgressCallback, SessionThatWaits, lease_params, told_number
from .call import Answering, asks
from .steps import ContactSteps

if TYPE_CHECKING:
    from .caller import Caller

__all__ = ["AnyContactSession", "SavedState", "Session", "StepSolution", "opening"]


def opening(fields: dict[str, Any], lease: float | None, accept_unconverged: bool) -> dict[str, Any]:
    """The parameters of session.open."""
    given = {name: value for name, value in fields.items() if value is not None}
    check_field_types(given)
    if given.keys() >= {"approach", "Fn"}:
        raise TypeError("session() takes either approach or Fn")
    return opening_params(given) | lease_params(lease, accept_unconverged)


class AnyContactSession(AnySession):
    """The session of a contact."""

    _joins = "join_session"

    _steps: ContactSteps

    def __init__(self, client: Caller, name: str, told: dict[str, Any], grid: Grid, rolls: bool) -> None:
        super().__init__(client, ContactSteps(name, grid, rolls, told_number(told, "step", int)), told)
        if not isinstance(ics := told.get("ics"), dict):
            raise ProtocolError("The answer to session.open or session.info lacks its session.")
        self.ics = {body: read(IcUse, use, f"result.ics.{body}") for body, use in ics.items()}

    @property
    def grid(self) -> Grid:
        """The potential contact area."""
        return self._steps.grid

    def _common(self) -> Rows:
        return [("grid", f"{self.grid.nx} x {self.grid.ny} elements of {self.grid.dx:g} x {self.grid.dy:g}")]

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
        solution: StepSolution = yield from self._step(step, timeout, on_progress, progress)
        return solution


class Session(AnyContactSession, SessionThatWaits):
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
