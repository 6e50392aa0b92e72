"""Converts a solution of contactd to the results that the CONTACT program prints for a wheel on a rail."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, field

import numpy as np
import numpy.typing as npt

from ...values.generated.wheel_rail.result import WheelRailPatch, WheelRailSolution
from ..problems.bodies import pair_of
from ..problems.rails import RailContact
from .compared import Compared
from .elements import (
    Elements,
    ahead,
    displacement_of,
    division_of,
    friction_at,
    law_of,
    layer_of,
    plastic_elements,
    rigid_slip_on,
    temperature_of,
)  # fmt: skip
from .rail_places import moment_about_normal, on_rail, on_wheel
from .subsurface import Stresses, StressField, stress_field

__all__ = ["LETTERS", "RailResult"]

Floats = npt.NDArray[np.float64]

LETTERS = "abcdefghijklmnopqrstuvwxyz"  #: Letters of patches in file names.

_SPIN_OFFSET = 1 / 6
_PER_THOUSAND = 1e-3  #: Factor from N mm to J, and from N mm/s to W.


@dataclass(frozen=True, eq=False)
class RailResult:
    """A solved case. Forces act on the rail, in the axes of the patches and of the track.

    Attributes:
        contact: The case.
        solution: Its solution, with all arrays and gaps.
        stresses: Stresses of each patch at the subsurface points of the case, in the axes of the patch. Patches are
            ordered from right to left as in the solution.
        before: Patches of the previous step, if this step continues it; otherwise None.
    """

    contact: RailContact
    solution: WheelRailSolution
    stresses: list[list[StressField]] = field(default_factory=list)
    before: tuple[WheelRailPatch, ...] | None = None

    @classmethod
    def of(
        cls,
        contact: RailContact,
        solution: WheelRailSolution,
        stresses: Stresses,
        before: tuple[WheelRailPatch, ...] | None = None,
    ) -> RailResult:
        """Creates the result. The solution must have displacements. `stresses` computes subsurface stresses."""
        pair = pair_of(contact.case.values)
        below = []
        blocks = contact.case.subsurface if contact.case.digits["S"] >= 1 else ()
        for patch in solution.patches:
            tractions = _tractions(patch)
            below.append([stress_field(block, patch.place.grid, tractions, pair, stresses) for block in blocks])
        return cls(contact, solution, below, before)

    @property
    def patches(self) -> tuple[WheelRailPatch, ...]:
        """Returns the patches from the field side to the gauge side."""
        return self.solution.patches if self.contact.setup.side == "right" else self.solution.patches[::-1]

    @property
    def is_converged(self) -> bool:
        """Returns whether all solvers and searches met their tolerances."""
        return self.solution.converged

    @property
    def numbers(self) -> dict[str, float]:
        """Returns the compared numbers of the whole case by their printed labels."""
        track, wheelset = self.solution.forces.track, self.solution.forces.wheelset
        found = {"Z_WS": self.solution.z} if self.contact.state.Fz is not None else {}
        if self.contact.state.Fx is not None:
            found["VPITCH_WS"] = self.solution.pitch_rate
        return {
            **found, "FX(TR)": track.Fx, "FY(TR)": track.Fy, "FZ(TR)": track.Fz,
            "FX(WS)": wheelset.Fx, "FY(WS)": wheelset.Fy, "FZ(WS)": wheelset.Fz,
        }  # fmt: skip

    def numbers_of(self, patch: WheelRailPatch) -> dict[str, float]:
        """Returns the compared numbers of a patch."""
        reference, motion, solution = patch.place.reference, patch.place.creepages, patch.solution
        has_friction, counts = self._rolls(patch), solution.elements
        slip, plastic = plastic_elements(solution)
        flows = {} if solution.flow_x is None else {"NPLAST": plastic}
        return {
            "XCP(TR)": reference.x, "YCP(TR)": reference.y, "ZCP(TR)": reference.z, "DELTCP(TR)": reference.angle,
            "CKSI": motion.xi, "CETA": motion.eta, "CPHI": motion.phi, **self._forces(patch),
            "ELAST.EN.": (solution.elastic_energy or 0.0) * _PER_THOUSAND,
            "FRIC": -(solution.frictional_power or solution.frictional_work or 0.0) * _PER_THOUSAND,
            "APPROACH": solution.approach, "PMAX": solution.pmax, "NPOT": patch.place.grid.nx * patch.place.grid.ny,
            "NCON": counts.contact, "NADH": counts.adhesion if has_friction else counts.contact,
            "NSLIP": slip if has_friction else 0, **flows,
            **({} if solution.temperature is None else {"MAX(T1,T2)": solution.temperature.largest}),
        }  # fmt: skip

    @property
    def compared(self) -> Compared:
        """Returns the numbers for a comparison with printed ones."""
        patches = self.patches
        bounds = [self.mu_of(patch) * patch.solution.Fn for patch in patches]
        return Compared(self.numbers, sum(bounds), [self.numbers_of(patch) for patch in patches], bounds)

    def mu_of(self, patch: WheelRailPatch) -> float:
        """Returns the static coefficient, at the angle of the patch if friction depends on angles."""
        return self._mu_at(patch.place.reference.angle)

    def mu_of_rows(self, patch: WheelRailPatch) -> list[float]:
        """Returns the static coefficient of each row of a curved contact; None for a plane one."""
        return [self._mu_at(row.angle) for row in patch.place.rows]

    def _coefficients(self, patch: WheelRailPatch) -> Floats:
        """Those of friction that falls at the slip that was found, of others at rest."""
        if patch.solution.friction_coefficient is not None:
            return patch.solution.friction_coefficient
        rows = self.mu_of_rows(patch)
        return np.array(rows)[:, None] if rows else np.array(self.mu_of(patch))

    def _friction(self, patch: WheelRailPatch, at_rest: Floats) -> Floats:
        """The coefficients at the temperature where they follow it."""
        friction, solution = self.contact.setup.friction, patch.solution
        if solution.friction_coefficient is not None:
            return solution.friction_coefficient
        if friction is None or not friction.temperature_by_angle:
            law = None if friction is None else law_of(friction.temperature)
            return friction_at(at_rest, law, solution.upper_temperature)
        rows = [row.angle for row in patch.place.rows] or [patch.place.reference.angle]
        laws = [self._law_at(angle, friction.temperature_by_angle) for angle in rows]
        change, reference, span = (np.array(part)[:, None] for part in zip(*laws))
        return friction_at(at_rest, (change, reference, span), solution.upper_temperature)

    def _law_at(self, angle: float, laws: Sequence[tuple[float, float, float, float]]) -> list[float]:
        """Returns change, reference and range of friction by temperature at an angle, interpolated linearly."""
        turned = angle if self.contact.setup.side == "right" else -angle
        angles, *parts = zip(*laws)
        return [float(np.interp(turned, angles, part)) for part in parts]

    def _mu_at(self, angle: float) -> float:
        friction = self.contact.setup.friction
        if friction is None:
            return 0.0
        if not isinstance(friction.mu, Sequence):
            return float(friction.mu)
        turned = angle if self.contact.setup.side == "right" else -angle
        return float(np.interp(turned, [one for one, _ in friction.mu], [mu for _, mu in friction.mu]))

    def on_wheel(self, patch: WheelRailPatch) -> tuple[float, float, float]:
        """Returns the reference in the axes of the wheel's profile."""
        x, y, z = on_wheel(self.contact, self.solution, patch.place.reference)
        return float(x), float(y), float(z)

    def on_rail(self, patch: WheelRailPatch) -> tuple[float, float]:
        """Returns the reference in the axes of the rail's profile."""
        return on_rail(self.solution, patch.place.reference)

    def elements_of(self, patch: WheelRailPatch) -> Elements:
        """Returns the elements of a patch."""
        place, solution, motion = patch.place, patch.solution, patch.place.creepages
        none = np.zeros(place.grid.shape)
        offset = ahead(0.0 if self.contact.is_shift else self.contact.step_on(place.grid), motion.chi, _SPIN_OFFSET)
        arrays = [none if array is None else array for array in (solution.slip_x, solution.slip_y, patch.gap)]
        slip_x, slip_y, gap = arrays
        traction_x, traction_y, pressure = _tractions(patch)
        friction, step = self.contact.setup.friction, self.contact.step_on(place.grid)
        layer = None if friction is None else friction.layer
        return Elements(
            grid=place.grid, tangential=self.contact.case.digits["T"], is_frictionless=not self._rolls(patch), chi=motion.chi,
            division=division_of(solution, place.grid.shape, self._rolls(patch)), h=gap,
            approach=solution.approach, mu=self._friction(patch, none + self._coefficients(patch)), pressure=pressure, traction=(traction_x, traction_y),
            slip=(slip_x, slip_y), displacement=displacement_of(solution), temperature=temperature_of(solution),
            rigid_slip=rigid_slip_on(place.grid, (motion.xi, motion.eta), motion.phi, (-offset[0], -offset[1])),
            layer=layer_of(solution, layer, place.grid, self.contact.case.digits["T"], motion.chi, step),
        )  # fmt: skip

    def _forces(self, patch: WheelRailPatch) -> dict[str, float]:
        """Returns forces in the axes of the patch. For a curved patch, the vectors of all rows are summed. Moments of a
        transient contact are about the origin of its element numbering, which is that of the rows for a curved patch.
        """
        solution, track, reference = patch.solution, patch.forces.track, patch.place.reference
        x, y = self.spin_centre(patch)
        if not patch.place.rows:
            moment = solution.Mz + x * solution.Fy - y * solution.Fx
            return {"FN": solution.Fn, "FX": solution.Fx, "FS": solution.Fy, "MN": moment}
        cos, sin = math.cos(reference.angle), math.sin(reference.angle)
        lateral = track.Fy * cos + track.Fz * sin
        return {
            "BAR_FN": track.Fz * cos - track.Fy * sin, "BAR_FX": track.Fx, "BAR_FS": lateral,
            "MN": moment_about_normal(track, reference) + x * lateral,
        }  # fmt: skip

    def goes_on_from(self, patch: WheelRailPatch) -> list[int] | None:
        """Returns the numbers (from 1) of the patches of the previous step that share elements across the rail with a
        patch; None if the steps do not continue each other.
        """
        if self.before is None:
            return None
        from_y, to_y = _across(patch)
        ends = [_across(one) for one in self.before]
        return [number for number, (first, last) in enumerate(ends, 1) if first < to_y and last > from_y]

    def spin_centre(self, patch: WheelRailPatch) -> tuple[float, float]:
        """Returns the reference relative to the origin of the element numbering of a transient contact."""
        if self.contact.state.motion == "steady_rolling":
            return 0.0, 0.0
        along = patch.place.on_rail.along if self.contact.is_shift else patch.place.reference.x
        return along, patch.place.on_rail.across

    def stresses_of(self, patch: WheelRailPatch) -> list[StressField]:
        """Returns the subsurface stresses of a patch."""
        return self.stresses[self._index(patch)] if self.stresses else []

    def _rolls(self, patch: WheelRailPatch) -> bool:
        """Returns whether there is friction. None acts on a wheel at rest, which adheres."""
        return self.contact.case.digits["T"] != 0 and patch.place.creepages.velocity > 0

    def _index(self, patch: WheelRailPatch) -> int:
        return next(index for index, one in enumerate(self.solution.patches) if one is patch)


def _tractions(patch: WheelRailPatch) -> Floats:
    none = np.zeros(patch.place.grid.shape)
    arrays = (patch.solution.traction_x, patch.solution.traction_y, patch.solution.pressure)
    return np.stack([none if array is None else array for array in arrays])


def _across(patch: WheelRailPatch) -> tuple[float, float]:
    """Returns the ends of the elements of a patch by arc length across the rail (mm)."""
    across, half = patch.place.on_rail.across, 0.5 * patch.place.grid.dy
    rows = patch.place.grid.y
    return across + float(rows[0]) - half, across + float(rows[-1]) + half
