"""Converts a solution of contactd to the results that the CONTACT program prints for basic contact."""

from __future__ import annotations

from dataclasses import dataclass, field
from functools import cached_property

import numpy as np
import numpy.typing as npt

from ...values.generated.motion import Rolling, Shift
from ...values.solution import ContactSolution
from ..problems.basic import BasicContact
from ..problems.models import is_parabolic
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
from .subsurface import Stresses, StressField, stress_field, surface_displacement

__all__ = ["BasicResult"]

Floats = npt.NDArray[np.float64]

_PER_THOUSAND = 1e-3  #: Factor from N mm to J, and from N mm/s to W.


@dataclass(frozen=True, eq=False)
class BasicResult:
    """A solved case. Forces act on body 1, as in contactd.

    Attributes:
        contact: The case.
        solution: Its solution.
        fx: Force along x (N); 0 where the program rounds it to zero.
        fy: Force along y (N), rounded in the same way.
        mz: Torsional moment (N mm), rounded in the same way.
        creepage: The prescribed or computed motion at the centre of spin: creepages of rolling, or the rigid shift of a
            shift (mm).
        pressure: Pressures, shape [ny, nx] (N/mm^2). For FASTSIM, the parabola that bounds the tractions.
        displacement: Displacements of body 1 minus those of body 2, shape [3, ny, nx] (mm).
        elastic_energy: Elastic energy of both bodies (J).
        stresses: Stresses at the subsurface points of the case.
        friction: Work (J) of a shift, or power (W) of rolling, dissipated by friction; negative.
    """

    contact: BasicContact
    solution: ContactSolution
    fx: float
    fy: float
    mz: float
    creepage: tuple[float, float]
    pressure: Floats
    displacement: Floats
    elastic_energy: float
    friction: float
    stresses: list[StressField] = field(default_factory=list)

    @classmethod
    def of(cls, contact: BasicContact, solution: ContactSolution, stresses: Stresses) -> BasicResult:
        """Creates the result. The solution must have displacements, unless its model is simplified. `stresses` computes
        subsurface stresses.
        """
        grid, case = contact.area.grid, contact.case
        pressure = _parabola(contact, solution) if is_parabolic(case) and contact.problem.normal_model is None else solution.pressure
        tractions = np.stack([solution.traction_x, solution.traction_y, pressure])
        energy = (solution.elastic_energy or 0.0) * _PER_THOUSAND
        lost = solution.frictional_power if case.digits["T"] > 1 else solution.frictional_work
        least = case.values["EPS"] * solution.Fn * contact.friction_unit / 2
        fx, fy, mz = (0.0 if abs(force) < least else force for force in (solution.Fx, solution.Fy, solution.Mz))
        creepage = _creepage(contact, solution)
        blocks = case.subsurface if case.digits["S"] >= 1 else ()
        below = [stress_field(block, grid, tractions, contact.pair, stresses) for block in blocks]
        return cls(
            contact,
            solution,
            fx,
            fy,
            mz,
            creepage,
            pressure,
            displacement_of(solution) if contact.problem.model is None else surface_displacement(grid, tractions, contact.pair, stresses),
            energy,
            -(lost or 0.0) * _PER_THOUSAND,
            below,
        )

    @property
    def plastic(self) -> tuple[Floats, Floats] | None:
        """The plastic slip of a layer where the case ends (mm), as of Elements."""
        return None if self._layer is None else self._layer[1:]

    @property
    def elements(self) -> Elements:
        """Returns the elements."""
        contact, solution = self.contact, self.solution
        grid = contact.area.grid
        none = np.zeros(grid.shape)
        return Elements(
            grid=grid, tangential=contact.case.digits["T"], is_frictionless=contact.case.digits["T"] == 0, chi=contact.chi,
            division=division_of(solution, grid.shape, contact.case.digits["T"] > 0), layer=self._layer, h=contact.area.h, approach=solution.approach,
            mu=self._friction_coefficient(), pressure=self.pressure,
            traction=(solution.traction_x, solution.traction_y), slip=(_or(solution.slip_x, none), _or(solution.slip_y, none)),
            rigid_slip=self._rigid_slip(), found=self._found, displacement=self.displacement, temperature=temperature_of(solution),
        )  # fmt: skip

    @property
    def _normal_force(self) -> float:
        """Returns the sum over the elements; for prescribed pressures, the force given with them (N)."""
        problem = self.contact.problem
        if problem.Fn is not None and problem.normal_model in ("elliptic", "parabolic"):
            return problem.Fn
        return float(self.solution.Fn)

    def _friction_coefficient(self) -> Floats:
        friction, none = self.contact.problem.friction, np.zeros(self.contact.area.grid.shape)
        if self.solution.friction_coefficient is not None:
            return self.solution.friction_coefficient
        if friction is None:
            return none
        at_rest = none + np.asarray(friction.mu, dtype=float)
        return friction_at(at_rest, law_of(friction.temperature), self.solution.upper_temperature)

    @cached_property
    def _layer(self) -> tuple[Floats, Floats, Floats] | None:
        contact, friction = self.contact, self.contact.problem.friction
        layer = None if friction is None else friction.layer
        return layer_of(self.solution, layer, contact.area.grid, contact.case.digits["T"], contact.chi, contact.dq, contact.plastic)

    @property
    def _found(self) -> tuple[float, float]:
        """The creepages or the shift that prescribed forces require."""
        values = self.contact.case.values
        return self.creepage[0] if "FX" in values else 0.0, self.creepage[1] if "FY" in values else 0.0

    def _rigid_slip(self) -> tuple[Floats, Floats]:
        contact, values = self.contact, self.contact.case.values
        friction = contact.problem.friction
        rolling = None if friction is None else friction.rolling
        # ConvexGS prints the step as it is given; steady rolling is that by one element.
        offset = (0.0, 0.0) if rolling is None else ahead(rolling.dq or 0.0, contact.chi, values["FACPHI"])
        centre = values["SPINXO"] - offset[0], values["SPINYO"] - offset[1]
        given = self.creepage[0] - self._found[0], self.creepage[1] - self._found[1]
        x, y = rigid_slip_on(contact.area.grid, given, contact.phi, centre)
        extra = None if contact.problem.friction is None else contact.problem.friction.rigid_slip
        return (
            (x, y) if extra is None else (x + np.asarray(extra[0], dtype=float), y + np.asarray(extra[1], dtype=float))
        )

    @property
    def compared(self) -> Compared:
        """Returns the numbers for a comparison with printed ones."""
        friction = self.contact.problem.friction
        mu = 0.0 if friction is None else float(np.max(np.asarray(friction.mu, dtype=float)))
        return Compared(self.numbers, mu * self.solution.Fn)

    @property
    def is_converged(self) -> bool:
        """Returns whether all solvers met their tolerances. If the case allows one outer iteration, outer iterations
        are ignored.
        """
        outer, evidence = self.contact.problem.outer, self.solution.evidence
        if outer is None or outer.max_iterations != 1:
            return self.solution.converged
        others = (evidence.normal, evidence.tangential, evidence.force)
        return all(solver is None or solver.converged for solver in others)

    @property
    def force_unit(self) -> float:
        """Returns the unit of printed tangential forces (N)."""
        return self.contact.friction_unit * self.solution.Fn

    @property
    def numbers(self) -> dict[str, float]:
        """Returns the compared numbers by their printed labels. Motions are included only for prescribed forces."""
        values, solution, counts = self.contact.case.values, self.solution, self.solution.elements
        moves = "CREEP" if self.contact.case.digits["T"] >= 2 else "SHIFT"
        found = {f"{moves} {axis}": motion for axis, motion in zip("XY", self.creepage) if f"F{axis}" in values}
        has_friction = self.contact.case.digits["T"] > 0
        adhesion, (slip, plastic) = (counts.adhesion, plastic_elements(solution)) if has_friction else (counts.contact, (0, 0))
        flows = {} if solution.flow_x is None else {"NPLAST": plastic}
        return {
            "FN": self._normal_force, "FX": self.fx, "FY": self.fy, "MZ": self.mz, "ELAST.EN.": self.elastic_energy,
            "FRIC": self.friction, **found, "APPROACH": solution.approach, "PMAX": float(np.max(self.pressure)),
            "NPOT": solution.pressure.size, "NCON": counts.contact, "NADH": adhesion, "NSLIP": slip,
            **flows,
            **({} if solution.temperature is None else {"MAX(T1,T2)": solution.temperature.largest}),
        }  # fmt: skip

    @property
    def velocity(self) -> float:
        """Returns VELOC as printed (mm/s)."""
        return float(self.contact.case.values["VELOC"])


def _creepage(contact: BasicContact, solution: ContactSolution) -> tuple[float, float]:
    values, found = contact.case.values, solution.motion
    if isinstance(found, Rolling):
        xi, eta = found.xi, found.eta
    elif isinstance(found, Shift):
        xi, eta = found.rigid_shift
    else:
        return values.get("CKSI", 0.0), values.get("CETA", 0.0)
    phi = values["CPHI"]
    x = values.get("CKSI", xi - phi * values["SPINYO"])
    y = values.get("CETA", eta + phi * values["SPINXO"])
    least = values["EPS"] * max(abs(x), abs(y))
    return (0.0 if "FX" in values and abs(x) < least else x), (0.0 if "FY" in values and abs(y) < least else y)


def _parabola(contact: BasicContact, solution: ContactSolution) -> Floats:
    """Returns 2 Fn/(pi a b) (1 - x^2/a^2 - y^2/b^2) at the element centres."""
    ellipse, grid = contact.area.ellipse, contact.area.grid
    assert ellipse is not None
    depth = 1 - (grid.x[None, :] / ellipse.aa) ** 2 - (grid.y[:, None] / ellipse.bb) ** 2
    return np.asarray(2 * solution.Fn / (np.pi * ellipse.aa * ellipse.bb) * np.maximum(depth, 0.0))


def _or(array: Floats | None, none: Floats) -> Floats:
    return none if array is None else array
