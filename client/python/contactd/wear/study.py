"""Describes the input of an evolution of profiles."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import Any, Literal

from ..errors import invalid
from ..values.generated.fatigue import FatigueRequest
from ..values.generated.wear_laws import WearEnergy, WearLaw
from ..values.generated.wheel_rail.setup import WheelRailSetup
from ..values.params import params_of, with_objects
from ..values.wheel_rail.params import setup_params, state_params
from .section import WornPart
from .states import WeightedState, mirrored

__all__ = ["WearStudy"]

Law = WearLaw | Mapping[str, Any]

_MOST_STEPS = 1_000_000
_SPACINGS = (0.01, 10.0)  #: Bounds of cells (mm): longer cells hide contacts, shorter ones need too much memory.


@dataclass(frozen=True)
class WearStudy:
    """The bodies that wear, the laws, the states, the distance, and the steps.

    Attributes:
        setup: The wheel on its rail, or its parameters as on the wire; its friction applies to states without a `mu`.
        states: The weighted states; weights are shares of the distance (of a wheel) or of the passages (over a rail).
        wears: "wheel" or "rail" (the other one is unchanged), or "both".
        law: The law, also as a value or parameters. Its `body` must be the worn one: lower for a wheel, upper for a
            rail. If both wear, the law of the wheel. Parameters may have lists in place of the tuples of a WearLaw.
        until: End of the study: km of the wheel, or passages of a wheel if only the rail wears.
        depth: Largest depth of a step (mm).
        distance: Largest distance of a step (km or passages); None: limited only by the depth.
        smoothing: Stabilisation of steps. "auto" smooths depths according to the depth of the step and the pressure.
            With "exponential_step", grooves decay as in many small steps, which allows deeper steps. A wavelength (mm)
            is smoothed to half its amplitude in each step; 0 is no smoothing.
        energy: See WearRequest.
        spacing: Length of cells along the section, and largest distance between its points (mm).
        rail_law: The law of the rail if both wear.
        passages_per_km: Number of wheels of the fleet that pass the rail while a wheel runs a km, if both wear.
        symmetric: Whether each state also represents its mirror image, both with half the weight. This describes
            wheelsets that run in both directions, so that the profile is the mean of a left and a right one.
        fatigue: Requests the fatigue in each step; its `body` must be one that wears.
    """

    setup: WheelRailSetup | Mapping[str, Any]
    states: Sequence[WeightedState]
    wears: WornPart | Literal["both"]
    law: Law
    until: float
    depth: float = 0.02
    distance: float | None = None
    smoothing: float | Literal["auto", "exponential_step"] = "auto"
    energy: WearEnergy = "scaled"
    spacing: float = 0.25
    rail_law: Law | None = None
    passages_per_km: float | None = None
    symmetric: bool = False
    fatigue: FatigueRequest | Mapping[str, Any] | None = None

    def __post_init__(self) -> None:
        """Raises InvalidArgument naming an invalid field."""
        if self.wears not in ("wheel", "rail", "both"):
            raise invalid("wears", f"is {self.wears!r}; it must be wheel, rail or both")
        self._check_laws()
        for name in ("until", "depth", "spacing", "distance", "passages_per_km"):
            value = getattr(self, name)
            if value is not None and not (math.isfinite(value) and value > 0):
                raise invalid(name, f"is {value}; it must be positive")
        if self.distance is not None and self.until / self.distance > _MOST_STEPS:
            raise invalid("distance", f"is {self.distance:g} {self.unit}, which results in more than {_MOST_STEPS} steps of {self.until:g}")
        if not _SPACINGS[0] <= self.spacing <= _SPACINGS[1]:
            raise invalid("spacing", f"is {self.spacing:g} mm; it must lie in [{_SPACINGS[0]:g}, {_SPACINGS[1]:g}]")
        if self.smoothing not in ("auto", "exponential_step") and not _is_length(self.smoothing):
            raise invalid("smoothing", f"is {self.smoothing!r}; it must be auto, exponential_step, or a wavelength (mm)")
        if not self.states:
            raise invalid("states", "are empty; give at least one state")
        for i, one in enumerate(self.states):
            if not (math.isfinite(one.weight) and one.weight >= 0):
                raise invalid(f"states[{i}].weight", f"is {one.weight:g}; it must be at least 0, and finite")
            if one.state.motion != "steady_rolling":
                raise invalid(f"states[{i}].motion", f"is {one.state.motion}, but wear requires steady rolling")
            wheel = one.state.wheel
            if wheel.x or wheel.y or wheel.z or wheel.roll or wheel.yaw or one.state.rail.roll:
                raise invalid(f"states[{i}]", "moves the wheel on its axle, or rotates the rail, which wear does not support")
        if sum(one.weight for one in self.states) == 0:
            raise invalid("states", "all have a weight of 0; give at least one of them a positive weight")
        if {"rail_slices", "wheel_slices"} & self.setup_params().keys():
            raise invalid("setup", "has slices; wear requires profiles that are constant along the track and round the wheel")

    def _check_laws(self) -> None:
        for name, part in zip(("law", "rail_law"), self.parts) if self.wears == "both" else (("law", self.parts[0]),):
            if getattr(self, name) is None:
                raise invalid(name, f"is missing; wheel and rail wear, and the {part} requires its own law")
            body = "lower" if part == "wheel" else "upper"
            if (of_law := self._law(name).get("body")) != body:
                raise invalid(f"{name}.body", f"is {of_law}, but the {part} wears; its law must have body {body}")
        if self.wears == "both" and self._law("law").get("name") == self._law("rail_law").get("name"):
            raise invalid("rail_law.name", f"is {self._law('law').get('name')}, which the wheel's law already has; answers identify laws by their names")
        if self.wears == "both" and self.passages_per_km is None:
            raise invalid("passages_per_km", "is missing; give the number of wheels that pass the rail while a wheel runs a km")
        for name in ("rail_law", "passages_per_km"):
            if self.wears != "both" and getattr(self, name) is not None:
                raise invalid(name, f"is given, but only the {self.wears} wears; it requires wears = both")
        if self.fatigue is not None and self.tired_part not in self.parts:
            raise invalid("fatigue.body", f"is that of the {self.tired_part}, but the {self.wears} wears; fatigue requires the part that wears")

    @property
    def parts(self) -> tuple[WornPart, ...]:
        """The bodies that wear."""
        return ("wheel", "rail") if self.wears == "both" else (self.wears,)

    @property
    def unit(self) -> str:
        """The unit of distances."""
        return "passages" if self.wears == "rail" else "km"

    @property
    def passages_per_unit(self) -> float:
        """The number of passages over the rail per unit of distance."""
        return 1.0 if self.passages_per_km is None else self.passages_per_km

    @property
    def tired_part(self) -> WornPart | None:
        """The body for which fatigue is requested."""
        return None if self.fatigue is None else ("rail" if self._fatigue_params()["body"] == "upper" else "wheel")

    @property
    def shear_yield(self) -> float | None:
        """The yield strength in shear, if given."""
        strength = self._fatigue_params().get("strength") if self.fatigue is not None else None
        return float(strength["shear_yield"]) if strength else None

    @cached_property
    def collective(self) -> list[WeightedState]:
        """The solved states; in a symmetric study, followed by their mirror images."""
        return [*self.states, *(mirrored(one) for one in self.states)] if self.symmetric else list(self.states)

    @cached_property
    def shares(self) -> list[float]:
        """The shares of the distance of all solved states."""
        total = sum(one.weight for one in self.collective)
        return [one.weight / total for one in self.collective]

    def given_index(self, index: int) -> int:
        """Returns the index among the given states."""
        return index % len(self.states)

    def law_index(self, part: WornPart) -> int:
        """Returns the index of a body's law in requests."""
        return self.parts.index(part)

    def setup_params(self) -> dict[str, Any]:
        """Returns the set-up as on the wire."""
        return setup_params(self.setup) if isinstance(self.setup, WheelRailSetup) else dict(self.setup)

    def law_params(self) -> list[dict[str, Any]]:
        """Returns the laws of the bodies as on the wire."""
        return [self._law(name) for name in ("law", "rail_law")[: len(self.parts)]]

    def _law(self, name: str) -> dict[str, Any]:
        law = getattr(self, name)
        params: dict[str, Any] = params_of(law, name) if isinstance(law, WearLaw) else with_objects(WearLaw, law, name)
        return params

    def _fatigue_params(self) -> dict[str, Any]:
        request = self.fatigue
        params: dict[str, Any] = (
            params_of(request, "fatigue") if isinstance(request, FatigueRequest) else with_objects(FatigueRequest, request or {}, "fatigue")
        )
        return params

    def params(self, profiles: Mapping[str, Any]) -> list[dict[str, Any]]:
        """Returns the parameters of wheelrail.solve for each state; `profiles` replace fields of the set-up."""
        setup = {**self.setup_params(), **profiles, "wear": {"energy": self.energy, "laws": self.law_params()}}
        if self.fatigue is not None:
            setup["fatigue"] = self._fatigue_params()
        found = []
        for i, one in enumerate(self.collective):
            own = setup if one.mu is None else {**setup, "friction": {**(setup.get("friction") or {}), "mu": one.mu}}
            found.append({"setup": own, "state": state_params(one.state, f"states[{i}]"), "fields": []})
        return found

    def sourced(self) -> list[dict[str, Any]]:
        """Lists everything with a name and a source: laws, strength, functions of damage."""
        fatigue = self._fatigue_params()
        return [*self.law_params(), *([fatigue["strength"]] if fatigue.get("strength") else []), *fatigue.get("damages", [])]

    def described(self) -> dict[str, Any]:
        """Returns the study as on the wire, without its end."""
        states = [{"state": state_params(one.state, "state"), "weight": one.weight, "group": one.group, "mu": one.mu} for one in self.states]
        described: dict[str, Any] = {
            "setup": self.setup_params(), "states": states, "wears": self.wears, "laws": self.law_params(), "depth": self.depth,
            "distance": self.distance, "smoothing": self.smoothing, "energy": self.energy, "spacing": self.spacing,
        }  # fmt: skip
        more = {"passages_per_km": self.passages_per_km, "symmetric": self.symmetric or None, "fatigue": self._fatigue_params() or None}
        return {**described, **{name: value for name, value in more.items() if value is not None}}


def _is_length(value: Any) -> bool:
    return isinstance(value, (int, float)) and not isinstance(value, bool) and math.isfinite(value) and value >= 0
