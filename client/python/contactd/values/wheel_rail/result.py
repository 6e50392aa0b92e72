"""Answers of a wheel on its rail, and of a wheelset. Lengths in mm, angles in rad, forces in N on the rail.

Written by ./dev generate from proto/schema: edit it there.
"""

from __future__ import annotations

from dataclasses import dataclass

from ..arrays import Array
from ..evidence import SolverEvidence
from ..solution import PartialSolution
from .forces import WheelRailDerivatives, WheelRailForces
from .places import ContactPlace, ProfileFrame
from .solution_methods import WheelRailSolutionMethods, WheelsetSolutionMethods

__all__ = ["RailDeflection", "WheelRailPatch", "WheelRailSolution", "WheelsetSolution"]


@dataclass(frozen=True, eq=False)
class WheelRailPatch:
    """A contact and its solution.

    Attributes:
        place: Where it is.
        solution: The solution, as of contact.solve, in contact coordinates; arrays that were asked for. Tractions and
            forces act on the rail.
        forces: Forces of this patch.
        gap: Where asked for: undeformed distance less its least value (mm), shape [ny, nx] of the place's grid.
    """

    place: ContactPlace
    solution: PartialSolution
    forces: WheelRailForces
    gap: Array | None = None


@dataclass(frozen=True)
class RailDeflection:
    """Deflection of a massless flexible rail, in addition to its deviation, in track coordinates.

    Attributes:
        y: To the right (mm).
        z: Down (mm).
    """

    y: float
    z: float


@dataclass(frozen=True, eq=False, repr=False)
class WheelRailSolution(WheelRailSolutionMethods):
    """The contact of a wheel with its rail. No contact is an answer: no patches. Forces act on the rail.

    Attributes:
        z: z of the wheelset, as prescribed or found (mm).
        pitch_rate: Pitch rate of the wheelset, as prescribed or found (rad/s).
        wheel_frame: Axes of the wheel's profile.
        rail_frame: Axes of the rail's profile, with the rail's deviation and deflection; of a roller at its top.
        forces: Forces of all patches.
        patches: Patches from the right to the left; none without contact. A step that said patches false lacks them.
        converged: Whether the solvers of all patches and the searches reached their tolerances.
        warnings: Sentences that a user should know.
        clearance: Least vertical distance of wheel and rail at this z, negative where they overlap (mm); None where
            they are not above each other.
        force: Search for z, where Fz was given: solves, and what was left, |F - Fz|/Fz.
        pitch_search: Search for the pitch rate, where Fx was given: searches for z, or solves, and the error of Fx that
            was left, over Fz.
        rail_deflection: Deflection of a massless flexible rail, in addition to its deviation, in track coordinates
            (mm).
        rail_search: Search for the deflection of a flexible rail: solves, and what is left of the balance of its forces
            over Fz, sideways or downwards.
        accuracy: Estimate of how far forces, over the normal force, and the largest pressures and tractions, over
            these, are from those of a fresh solve with tight tolerances at this height: of model full with contact.
        derivatives: Where asked for, of a converged solution with contact.
        contacts: Number of patches, in place of them, of a step with patches false.
        frictional_power: Power that friction dissipates in all patches, in rolling (N mm/s).
    """

    z: float
    pitch_rate: float
    wheel_frame: ProfileFrame
    rail_frame: ProfileFrame
    forces: WheelRailForces
    patches: tuple[WheelRailPatch, ...]
    converged: bool
    warnings: tuple[str, ...] = ()
    clearance: float | None = None
    force: SolverEvidence | None = None
    pitch_search: SolverEvidence | None = None
    rail_deflection: RailDeflection | None = None
    rail_search: SolverEvidence | None = None
    accuracy: float | None = None
    derivatives: WheelRailDerivatives | None = None
    contacts: int | None = None
    frictional_power: float | None = None


@dataclass(frozen=True, eq=False, repr=False)
class WheelsetSolution(WheelsetSolutionMethods):
    """A wheelset on its rails. Forces act on the rails.

    Attributes:
        z: z of the wheelset, as found (mm): against the mean of both nominal radii, as each wheel's own is against its.
        roll: Roll of the wheelset, as found (rad).
        left: The left wheel on its rail.
        right: The right wheel on its rail.
        roll_search: Search for the roll: solves of both wheels, and by how much their heights differ (mm).
        converged: Whether the solvers of both wheels and the search for the roll reached their tolerances.
        warnings: Sentences that a user should know of both wheels together; each wheel has its own, too.
    """

    z: float
    roll: float
    left: WheelRailSolution
    right: WheelRailSolution
    roll_search: SolverEvidence
    converged: bool
    warnings: tuple[str, ...] = ()
