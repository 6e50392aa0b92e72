"""What an evolution of a profile is asked for."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any, Literal

from ..errors import invalid
from ..values.params import params_of
from ..values.wear_laws import WearEnergy, WearLaw
from ..values.wheel_rail.params import setup_params, state_params
from ..values.wheel_rail.setup import WheelRailSetup
from .section import WornPart
from .states import WeightedState

__all__ = ["WearStudy"]


@dataclass(frozen=True)
class WearStudy:
    """What wears, by which law, in which states, how far and in which steps.

    Attributes:
        setup: The wheel on its rail, or its parameters in the words of the wire; its friction holds for states without a `mu`.
        states: The collective; weights are shares of the distance (of a wheel) or of the passages (over a rail).
        wears: The wheel or the rail; the other one stays as it is.
        law: The law, likewise; its `body` must be that which wears: lower of a wheel, upper of a rail.
        until: Where it ends: km that the wheel runs, or passages of a wheel over the rail.
        depth: Largest depth of a step (mm).
        distance: Most that a step goes (km or passages); None: as far as the depth lets it.
        smoothing: What keeps steps stable: "auto", depths are smoothed by the length that the depth of the step and the pressure
            ask for; "exponential_step", by which grooves wear down as in many small steps, and depths reach farther; or the
            wavelength (mm) of which half the amplitude is smoothed away in each step; 0: nothing.
        energy: As of WearRequest.
        spacing: Length of cells along the section, and most between its points (mm).
    """

    setup: WheelRailSetup | Mapping[str, Any]
    states: Sequence[WeightedState]
    wears: WornPart
    law: WearLaw | Mapping[str, Any]
    until: float
    depth: float = 0.02
    distance: float | None = None
    smoothing: float | Literal["auto", "exponential_step"] = "auto"
    energy: WearEnergy = "scaled"
    spacing: float = 0.25

    def __post_init__(self) -> None:
        """Raises InvalidArgument naming what makes no sense."""
        body = "lower" if self.wears == "wheel" else "upper"
        if self.wears not in ("wheel", "rail"):
            raise invalid("wears", f"is {self.wears!r}; it must be wheel or rail: the other one stays as it is")
        if (of_law := self.law_params().get("body")) != body:
            raise invalid("law.body", f"is {of_law}, and the {self.wears} wears; its law is one of {body}")
        for name in ("until", "depth", "spacing", "distance"):
            value = getattr(self, name)
            if value is not None and not (math.isfinite(value) and value > 0):
                raise invalid(name, f"is {value}; it must be positive")
        if self.smoothing not in ("auto", "exponential_step") and not (isinstance(self.smoothing, (int, float)) and self.smoothing >= 0):
            raise invalid("smoothing", f"is {self.smoothing!r}; it must be auto, exponential_step, or a wavelength (mm)")
        if not self.states or not sum(one.weight for one in self.states) > 0:
            raise invalid("states", "are none, or have no weight together")
        for i, one in enumerate(self.states):
            if one.state.motion != "steady_rolling":
                raise invalid(f"states[{i}].motion", f"is {one.state.motion}; wear is that of steady rolling")
            wheel = one.state.wheel
            if wheel.x or wheel.y or wheel.z or wheel.roll or wheel.yaw or one.state.rail.roll:
                raise invalid(f"states[{i}]", "moves the wheel on its axle, or turns the rail; rows are placed without that")
        if {"rail_slices", "wheel_slices"} & self.setup_params().keys():
            raise invalid("setup", "has slices; profiles that are the same along the track, or round the wheel, can wear")

    def setup_params(self) -> dict[str, Any]:
        """The set-up in the words of the wire."""
        return setup_params(self.setup) if isinstance(self.setup, WheelRailSetup) else dict(self.setup)

    def law_params(self) -> dict[str, Any]:
        """The law in the words of the wire."""
        return params_of(self.law, "law") if isinstance(self.law, WearLaw) else dict(self.law)

    def params(self, profiles: Mapping[str, Any]) -> list[dict[str, Any]]:
        """The parameters of wheelrail.solve for each state; `profiles` are fields of the set-up in place of its own."""
        setup = {**self.setup_params(), **profiles, "wear": {"energy": self.energy, "laws": [self.law_params()]}}
        found = []
        for i, one in enumerate(self.states):
            own = setup if one.mu is None else {**setup, "friction": {**(setup.get("friction") or {}), "mu": one.mu}}
            found.append({"setup": own, "state": state_params(one.state, f"states[{i}]"), "fields": []})
        return found
