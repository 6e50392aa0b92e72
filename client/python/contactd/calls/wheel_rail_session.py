"""Implements sessions of a wheel on its rail (docs/sessions.md)."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from ..errors import ProtocolError
from ..refusals import check_type
from ..values.generated.wheel_rail.setup import Side, WheelRailFriction
from ..values.generated.wheel_rail.state import WheelRailState
from ..values.generated.wheel_rail.step_input import WheelRailStepInput
from ..values.params import params_of
from ..values.representation import Rows
from ..values.solution import Fields
from ..values.wheel_rail.params import state_params
from ..values.wheel_rail.solution import WheelRailStepSolution, read_wheel_rail_as, read_wheel_rail_without_patches
from .any_session import AnySession, ProgressCallback, SessionThatWaits, reported_number
from .call import Answering, asks
from .steps import Steps

if TYPE_CHECKING:
    from .caller import Caller

__all__ = ["AnyWheelRailSession", "WheelRailSession", "WheelRailSteps"]


class WheelRailSteps(Steps):
    """Manages the steps of a wheel on its rail."""

    words = frozenset(WheelRailStepInput.__annotations__)

    def _given(self, step: WheelRailStepInput) -> dict[str, Any]:
        if "state" not in step:
            raise TypeError("a step of a wheel on its rail requires its state")
        given: dict[str, Any] = {"state": state_params(step["state"], "wheelrail.state")}
        if (friction := step.get("friction")) is not None:
            check_type("wheelrail.friction", friction, WheelRailFriction)
            given["friction"] = params_of(friction, "friction")
        if step.get("gap"):
            given["gap"] = True
        if not step.get("patches", True):
            given["patches"] = False
        return {"wheelrail": given}

    def read(self, asked: dict[str, Any], result: Any, path: str = "result") -> WheelRailStepSolution:
        if not isinstance(result, dict) or not isinstance(reported := result.get("wheelrail"), dict):
            raise ProtocolError("The answer to the step of a wheel on its rail lacks its wheelrail.")
        reported = {**reported, "step": result.get("step")}
        if asked["wheelrail"].get("patches", True):
            names, gap = asked.get("fields", ()), asked["wheelrail"].get("gap", False)
            solution = read_wheel_rail_as(WheelRailStepSolution, names, gap, reported, path)
        else:
            solution = read_wheel_rail_without_patches(WheelRailStepSolution, reported, path)
        self.number = solution.step
        return solution


class AnyWheelRailSession(AnySession):
    """Implements the common part of blocking and asyncio sessions of a wheel on its rail."""

    _joins = "join_wheel_rail_session"

    def __init__(self, client: Caller, name: str, reported: dict[str, Any], side: Side, builds: bool = False) -> None:
        super().__init__(client, WheelRailSteps(name, reported_number(reported, "step", int)), reported)
        self.side: Side = side
        self._builds = builds

    def _common(self) -> Rows:
        return [("wheel", self.side)]

    @asks
    def step(
        self,
        state: WheelRailState,
        *,
        friction: WheelRailFriction | None = None,
        fields: Fields = (),
        gap: bool = False,
        patches: bool = True,
        again: bool = False,
        timeout: float | None = None,
        on_progress: ProgressCallback | None = None,
        progress: bool = False,
    ) -> Answering[WheelRailStepSolution]:
        """Solves the next step. `state` is the complete position and motion of the wheelset.

        `friction` is that of this step; if None, that of the opening. `fields` names the arrays to return for each
        patch, or a single one; `gap` requests the undeformed distances. Without `patches`, the answer contains only
        their number. This makes the message much smaller for simulations that only use forces.

        `again` repeats the last requested step, as in Session.step.

        Raises InvalidArgument naming the field, such as ``wheelrail.state.position.z``, and the exceptions of
        Session.step.
        """
        step = WheelRailStepInput(state=state, friction=friction, fields=fields, gap=gap, patches=patches, again=again)
        solution: WheelRailStepSolution = yield from self._step(step, timeout, on_progress, progress)
        return solution


class WheelRailSession(AnyWheelRailSession, SessionThatWaits):
    """Solves the steps of a simulation of a wheel on its rail.

    ::

        with client.wheel_rail_session(WheelRailSetup(side="left")) as wheel:
            for state in states:
                solution = wheel.step(state)

    The set-up is sent and its profiles are read once. A step of steady rolling, which has no history, returns the
    answer of `Client.wheel_rail`. Its searches and solvers start from the previous step, which changes the answer only
    within their tolerances. For step numbers, retries, saved states, the lease and shared sessions see Session.

    Attributes:
        side: The side of the wheel.
        lease_seconds: Time without use after which the session ends (s).
        bytes: Its use of the daemon's memory when it was opened or joined.
        retries: Number of times that a step or a restore without an answer is repeated.
    """
