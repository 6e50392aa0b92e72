"""Steps of a session of a wheel on its rail: what one says, and what it answers."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, TypedDict

from .checks import check_type
from .errors import ProtocolError
from .partial import Fields
from .showing import with_inherited_attributes
from .steps import Steps
from .wheel_rail import WheelRailFriction, WheelRailSolution, WheelRailState
from .wheel_rail_params import friction_params, state_params
from .wheel_rail_solution import read_wheel_rail_as, read_wheel_rail_without_patches

__all__ = ["WheelRailStepInput", "WheelRailStepSolution", "WheelRailSteps"]


class WheelRailStepInput(TypedDict, total=False):
    """What a step says: the arguments of WheelRailSession.step, for Client.step_many, as in ``{"state": state}``."""

    state: WheelRailState
    friction: WheelRailFriction | None
    fields: Fields
    gap: bool
    patches: bool
    again: bool


@with_inherited_attributes
@dataclass(frozen=True, eq=False, repr=False, kw_only=True)
class WheelRailStepSolution(WheelRailSolution):
    """The solution of a step. Arrays of its patches are None unless `fields` named them; `converged` is False only in a
    session that accepts it.

    Attributes:
        step: Number of the step.
    """

    step: int

    def _title(self) -> str:
        return f"WheelRailStepSolution {self.step}"


class WheelRailSteps(Steps):
    """The steps of a wheel on its rail."""

    words = frozenset(WheelRailStepInput.__annotations__)

    def _said(self, step: WheelRailStepInput) -> dict[str, Any]:
        if "state" not in step:
            raise TypeError("a step of a wheel on its rail needs its state")
        said: dict[str, Any] = {"state": state_params(step["state"], "wheelrail.state")}
        if (friction := step.get("friction")) is not None:
            check_type("wheelrail.friction", friction, WheelRailFriction)
            said["friction"] = friction_params(friction)
        if step.get("gap"):
            said["gap"] = True
        if not step.get("patches", True):
            said["patches"] = False
        return {"wheelrail": said}

    def read(self, asked: dict[str, Any], result: Any, path: str = "result") -> WheelRailStepSolution:
        if not isinstance(result, dict) or not isinstance(told := result.get("wheelrail"), dict):
            raise ProtocolError("The answer to the step of a wheel on its rail lacks its wheelrail.")
        told = {**told, "step": result.get("step")}
        if asked["wheelrail"].get("patches", True):
            names, gap = asked.get("fields", ()), asked["wheelrail"].get("gap", False)
            solution = read_wheel_rail_as(WheelRailStepSolution, names, gap, told, path)
        else:
            solution = read_wheel_rail_without_patches(WheelRailStepSolution, told, path)
        self.number = solution.step
        return solution
