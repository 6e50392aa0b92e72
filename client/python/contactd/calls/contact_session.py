"""Implements sessions of a contact: the steps of a simulation, each starting from the end of the previous one
(docs/sessions.md).
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy.typing as npt

from ..errors import ProtocolError
from ..values.answers import read
from ..values.friction_methods import Force
from ..values.generated.evidence import IcUse
from ..values.generated.friction import Friction
from ..values.generated.grid import Grid, HalfEllipses, Paraboloid, SemiAxes
from ..values.generated.motion import Rolling, RollingKind
from ..values.generated.problem import ContactProblem
from ..values.generated.step_input import StepInput
from ..values.params import fields_of, names_of_fields
from ..values.representation import Rows
from ..values.solution import Fields
from ..values.step_solution import StepSolution, checked
from .any_session import AnySession, ProgressCallback, SessionThatWaits, reported_number
from .call import Answering, asks
from .steps import Steps

if TYPE_CHECKING:
    from .caller import Caller

__all__ = ["AnyContactSession", "ContactSteps", "Session"]

_ROLLING = names_of_fields(Rolling) - {"force"}
_FRICTION = names_of_fields(Friction)
_SHIFT = {"rigid_shift", "rotation", "duration"}
_OWN = ("approach", "Fn", "gap")


class ContactSteps(Steps):
    """The steps of a contact.

    Attributes:
        grid: The potential contact area.
    """

    words = frozenset(StepInput.__annotations__)

    def __init__(self, session: str, grid: Grid, rolls: bool, number: int) -> None:
        super().__init__(session, number)
        self.grid = grid
        self._rolls = rolls

    def _given(self, step: StepInput) -> dict[str, Any]:
        params = fields_of(ContactProblem, {name: step.get(name) for name in _OWN})
        if friction := self._friction(step):
            params["friction"] = friction
        for flag in ("derivatives", "displacements"):
            if (value := step.get(flag)) is not None:
                params[flag] = value
        return params

    def read(self, asked: dict[str, Any], result: Any, path: str = "result") -> StepSolution:
        solution = read(StepSolution, result, path)
        checked(solution, asked.get("fields", ()), self.grid)
        self.number = solution.step
        return solution

    def _friction(self, step: StepInput) -> dict[str, Any]:
        whole = {} if (friction := step.get("friction")) is None else friction.params()
        given = {name: value for name, value in step.items() if value is not None}
        rolling = {name: value for name, value in given.items() if name in _ROLLING}
        others = {name: value for name, value in given.items() if name in _FRICTION}
        rolls = bool(rolling) or "rolling" in whole or (self._rolls and friction is None and _SHIFT.isdisjoint(others))
        if rolls and "force" in others:
            rolling["force"] = others.pop("force")
        changes = fields_of(Friction, others)
        if rolling:
            changes["rolling"] = {**whole.get("rolling", {}), **fields_of(Rolling, rolling)}
        return {**whole, **changes}


class AnyContactSession(AnySession):
    """The session of a contact."""

    _joins = "join_session"

    _steps: ContactSteps

    def __init__(self, client: Caller, name: str, reported: dict[str, Any], grid: Grid, rolls: bool) -> None:
        super().__init__(client, ContactSteps(name, grid, rolls, reported_number(reported, "step", int)), reported)
        if not isinstance(ics := reported.get("ics"), dict):
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
        gap: Paraboloid | SemiAxes | HalfEllipses | npt.ArrayLike | None = None,
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
        displacements: bool | None = None,
        fields: Fields = (),
        again: bool = False,
        timeout: float | None = None,
        on_progress: ProgressCallback | None = None,
        progress: bool = False,
    ) -> Answering[StepSolution]:
        """Solves the next step. Arguments that are None keep their values from the opening of the session.

        Give friction as a whole, or only the fields of Friction and Rolling that change. `force` is that of rolling if
        the session rolls, otherwise that of a shift. `fields` names the arrays to return, or a single one. Set
        `derivatives` and `displacements` to return these, too.

        `again` repeats the last requested step with new inputs, from the same initial state. If that step was solved,
        its result is discarded. You may repeat it any number of times, also after it failed or its answer was lost.

        Raises FailedPrecondition if the daemon is at another step, Aborted (reason NOT_CONVERGED) if a solver missed
        its tolerance, NotFound if the session has ended, and the exceptions of Client.solve.
        """
        step = StepInput(
            approach=approach, Fn=Fn, gap=gap, friction=friction, mu=mu, force=force, rigid_shift=rigid_shift,
            rotation=rotation, duration=duration, rigid_slip=rigid_slip, xi=xi, eta=eta, phi=phi, chi=chi, dq=dq,
            spin_offset=spin_offset, kind=kind, steps=steps, velocity=velocity, derivatives=derivatives,
            displacements=displacements, fields=fields, again=again,
        )  # fmt: skip
        solution: StepSolution = yield from self._step(step, timeout, on_progress, progress)
        return solution


class Session(AnyContactSession, SessionThatWaits):
    """Solves the steps of a simulation, each starting from the end of the previous one.

    ::

        with client.session(grid=grid, upper=steel, gap=gap, friction=Friction(mu=0.3, rolling=Rolling())) as session:
            for xi in creepages:
                solution = session.step(Fn=1e4, xi=xi)

    Client.session accepts a ContactProblem without `initial`, or its fields. Its `gap`, `approach` or `Fn` and
    `friction` are optional defaults for the steps. It returns when the tables are available. The session ends with its
    ``with`` block, or after `lease` seconds without use (None: the daemon's default). A step that misses a tolerance
    fails, unless `accept_unconverged` is set.

    The client numbers the steps. It repeats a step without an answer under the same number, and the daemon does not
    solve it twice. If the repetition fails too, the session may or may not have advanced by that step; requesting the
    same step again continues correctly. A failed step leaves the session unchanged.

    Only the process that opened a session may use it, from one thread at a time: a call during another call raises
    ContactdError. Another process, also a forked one, takes it over by its `name`: ``client.join_session(name)``.

    Attributes:
        lease_seconds: Time without use after which the session ends (s).
        bytes: Its use of the daemon's memory when it was opened or joined.
        ics: Origin of the influence coefficients, as in ContactEvidence.
        retries: Number of times that a step or a restore without an answer is repeated.
    """
