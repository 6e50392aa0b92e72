"""Steps of a session of a wheel on its rail: what one says, and what it answers."""

from __future__ import annotations

from typing import Any

from ..errors import ProtocolError
from ..refusals import check_type
from ..values.wheel_rail.params import friction_params, state_params
from ..values.wheel_rail.setup import WheelRailFriction
from ..values.wheel_rail.solution import (
    WheelRailStepInput,
    WheelRailStepSolution,
    read_wheel_rail_as,
    read_wheel_rail_without_patches,
)
from .steps import Steps

__all__ = ["WheelRailSteps"]


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
