"""Answers of a wheel on its rail, and of a wheelset. Lengths are in mm, angles in rad, forces in N on the rail.

Written by ./dev generate from proto/schema: edit it there.
"""

from __future__ import annotations

from dataclasses import dataclass

from ...arrays import Array
from ...solution import ContactSolution
from ...wheel_rail.solution_methods import WheelRailSolutionMethods, WheelsetSolutionMethods
from ..evidence import SolverEvidence
from .forces import WheelRailDerivatives, WheelRailForces
from .places import ContactPlace, ProfileFrame

__all__ = ["RailDeflection", "WheelRailPatch", "WheelRailSolution", "WheelsetSolution"]


@dataclass(frozen=True, eq=False)
class WheelRailPatch:
    """A contact and its solution.

    Attributes:
        place: Place of the contact.
        solution: The solution, as in contact.solve, in contact coordinates, with the requested arrays. Tractions and
            forces act on the rail.
        forces: Forces of this patch.
        gap: Undeformed distance minus its smallest value (mm), shape [ny, nx] of the place's grid. Only if requested.
    """

    place: ContactPlace
    solution: ContactSolution
    forces: WheelRailForces
    gap: Array | None = None


@dataclass(frozen=True)
class RailDeflection:
    """Deflection of a massless flexible rail, in addition to its deviation, in track coordinates.

    Attributes:
        y: Lateral deflection, positive to the right (mm).
        z: Vertical deflection, positive down (mm).
    """

    y: float
    z: float


@dataclass(frozen=True, eq=False, repr=False)
class WheelRailSolution(WheelRailSolutionMethods):
    """The contact of a wheel with its rail. Without contact there are no patches, which is not an error. Forces act on
    the rail.

    Attributes:
        z: z of the wheelset, prescribed or computed (mm).
        pitch_rate: Pitch rate of the wheelset, prescribed or computed (rad/s).
        wheel_frame: Axes of the wheel's profile.
        rail_frame: Axes of the rail's profile, with the rail's deviation and deflection; for a roller at its top.
        forces: Forces of all patches.
        patches: Patches from right to left. Empty without contact. None in a step with patches false.
        converged: True if the solvers of all patches and the searches reached their tolerances.
        warnings: Warnings.
        clearance: Smallest vertical distance of wheel and rail at this z, negative where they overlap (mm). None if
            they are not above each other.
        force: Search for z, with a prescribed Fz: number of solves, and the remaining error |F - Fz|/Fz.
        pitch_search: Search for the pitch rate, with a prescribed Fx: number of searches for z, or of solves, and the
            remaining error of Fx over Fz.
        rail_deflection: Deflection of a massless flexible rail, in addition to its deviation, in track coordinates
            (mm).
        rail_search: Search for the deflection of a flexible rail: number of solves, and the remaining imbalance of its
            forces over Fz, lateral or vertical.
        accuracy: Estimate of the deviation of forces (relative to the normal force) and of the largest pressures and
            tractions (relative to these) from those of a fresh solve with tight tolerances at this height. Only for
            model full with contact.
        derivatives: Derivatives of a converged solution with contact. Only if requested.
        contacts: Number of patches, for a step with patches false.
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
        z: Computed z of the wheelset, relative to the mean of both nominal radii (mm); z of each wheel is relative to
            its own nominal radius.
        roll: Computed roll of the wheelset (rad).
        left: The left wheel on its rail.
        right: The right wheel on its rail.
        roll_search: Search for the roll: number of solves of both wheels, and the remaining difference of their heights
            (mm).
        converged: True if the solvers of both wheels and the search for the roll reached their tolerances.
        warnings: Warnings about both wheels together. Each wheel also has its own.
    """

    z: float
    roll: float
    left: WheelRailSolution
    right: WheelRailSolution
    roll_search: SolverEvidence
    converged: bool
    warnings: tuple[str, ...] = ()
