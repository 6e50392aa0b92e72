"""A step of a section that wears."""

from __future__ import annotations

from dataclasses import dataclass, field, replace

import numpy as np
import numpy.typing as npt

from .section import WornPart

__all__ = ["StepFatigue", "WornStep"]

Array = npt.NDArray[np.float64]


@dataclass(frozen=True, eq=False)
class StepFatigue:
    """What a step made a section bear, by the cells of its depths.

    Attributes:
        damages: Damage of all passages of the step, by the names of the functions.
        dang_van: The largest stress of Dang Van of any state (N/mm^2); NaN where none is known.
        limits: The least yield strength in shear over the largest shear of any state; below 1 no steel shakes down. Without a
            strength it is 1 over that shear (mm^2/N).
        contacts: Traction coefficient, load, limit and share of each patch, shape [n, 4]: the shakedown diagram.
    """

    damages: dict[str, Array]
    dang_van: Array
    limits: Array
    contacts: Array


@dataclass(frozen=True, eq=False)
class WornStep:
    """The section after a step, and what the step took off; that of number 0 is new.

    Attributes:
        number: How many steps there were.
        distance: What the wheel has run so far (km), or how many wheels have passed the rail.
        points: (y, z) of the section (mm), in the coordinates of its profile, of a rail as cant has turned it.
        edges: Ends of the cells of `depths` along the section before the step (mm).
        depths: What the step took off the cells (mm).
        area: What all steps together took off (mm^2), as rows told it.
        removed: The area between the new section and this one (mm^2).
        T_gamma: The mean over the states, without spin (N), before the step.
        T_gamma_with_spin: And with it (N).
        pmax: The largest pressure of the states (N/mm^2), before the step.
        mean_pressure: The mean pressure that stability goes by (N/mm^2).
        smoothing: Wavelength that was smoothed (mm); 0: none, or by exponential steps.
        groups: What the step took off by groups of states (mm^2).
        warnings: Sentences; one of a state begins with its name, such as ``states[3]:``.
        ended_by: Why the step went no farther: "depth", it is as deep as a step may be; "stability", a deeper one would let
            grooves grow; "distance", the farthest that a step goes; or "until", the end of the study. Where wheel and rail wear
            together, the first two name the part, as in "depth of the rail". Empty of the new section.
        fatigue: What the step made the section bear; None where that was not asked for.
        stage: How often dynamics have told new states before.
        rail: The same of the rail, where wheel and rail wear together; the step itself is that of the wheel then.
    """

    number: int
    distance: float
    points: Array
    edges: Array
    depths: Array
    area: float = 0.0
    removed: float = 0.0
    T_gamma: float = 0.0
    T_gamma_with_spin: float = 0.0
    pmax: float = 0.0
    mean_pressure: float = 0.0
    smoothing: float = 0.0
    groups: dict[str, float] = field(default_factory=dict)
    warnings: tuple[str, ...] = ()
    ended_by: str = ""
    fatigue: StepFatigue | None = None
    stage: int = 0
    rail: WornStep | None = None

    def of(self, part: WornPart) -> WornStep:
        """The step of a part that wears."""
        return self if part == "wheel" or self.rail is None else self.rail

    def beside(self, rail: WornStep) -> WornStep:
        """The same step with that of the rail."""
        return replace(self, rail=rail)

    @property
    def all_warnings(self) -> tuple[str, ...]:
        """Those of the step, and those that the rail alone has where wheel and rail wear together."""
        return tuple(dict.fromkeys([*self.warnings, *(() if self.rail is None else self.rail.warnings)]))

    def warned(self, sentence: str) -> WornStep:
        """The same step with a sentence more."""
        return replace(self, warnings=(*self.warnings, sentence))
