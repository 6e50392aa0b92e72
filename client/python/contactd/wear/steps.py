"""A step of a worn section."""

from __future__ import annotations

from dataclasses import dataclass, field, replace

import numpy as np
import numpy.typing as npt

from .section import WornPart

__all__ = ["StepFatigue", "WornStep"]

Array = npt.NDArray[np.float64]


@dataclass(frozen=True, eq=False)
class StepFatigue:
    """Holds fatigue of a section in a step, by the cells of its depths.

    Attributes:
        damages: Damage of all passages of the step, by the names of the functions.
        dang_van: The largest Dang Van stress of all states (N/mm^2); NaN if unknown.
        limits: The yield strength in shear over the largest shear stress of all states, the smallest of the step; below
            1 there is no shakedown. Without a strength, 1 over that stress (mm^2/N).
        contacts: Traction coefficient, load, limit and share of each patch, shape [n, 4]: the shakedown diagram.
    """

    damages: dict[str, Array]
    dang_van: Array
    limits: Array
    contacts: Array


@dataclass(frozen=True, eq=False)
class WornStep:
    """The section after a step, and the wear in the step. Step 0 is the new section.

    Attributes:
        number: Number of the step.
        distance: Total distance of the wheel (km), or number of wheels that have passed the rail.
        points: (y, z) of the section (mm) in the coordinates of its profile; those of a rail are rotated by the cant.
        edges: Ends of the cells of `depths` along the section before the step (mm).
        depths: Depths removed from the cells in the step (mm).
        area: Total area removed in all steps (mm^2), by the rows.
        removed: The area between the new section and this one (mm^2).
        T_gamma: Mean of T gamma over the states before the step, without spin (N).
        T_gamma_with_spin: The same with spin (N).
        pmax: The largest pressure of the states (N/mm^2), before the step.
        mean_pressure: The mean pressure for the stability criterion (N/mm^2).
        smoothing: Smoothed wavelength (mm); 0 without smoothing, and for exponential steps.
        groups: Area removed in the step by groups of states (mm^2).
        warnings: Sentences; those of a state begin with its name, such as ``states[3]:``.
        ended_by: Limit of the step: "depth" of a step; "stability", beyond which grooves would grow; "distance" of a
            step; or "until", the end of the study. If wheel and rail wear together, the first two name the body, as in
            "depth of the rail". Empty for the new section.
        fatigue: Fatigue in the step; None if not requested.
        stage: Number of times that dynamics have provided new states.
        rail: The same for the rail if both wear; the step itself is then that of the wheel.
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
        """Returns the step of a body that wears."""
        return self if part == "wheel" or self.rail is None else self.rail

    def beside(self, rail: WornStep) -> WornStep:
        """Returns the step combined with that of the rail."""
        return replace(self, rail=rail)

    @property
    def all_warnings(self) -> tuple[str, ...]:
        """Warnings of the step, and those of the rail alone if both wear."""
        return tuple(dict.fromkeys([*self.warnings, *(() if self.rail is None else self.rail.warnings)]))

    def warned(self, sentence: str) -> WornStep:
        """Returns the step with another warning."""
        return replace(self, warnings=(*self.warnings, sentence))
