"""Where a wheel touches its rail, and what comes of it: the answers of `Client.wheel_rail` and
`Client.wheel_rail_geometry`, as plain, immutable values. Lengths in mm, angles in rad, forces in N on the rail."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from typing import Any

from .errors import ProtocolError
from .partial import ALL_FIELDS, PartialSolution, check_arrays
from .problem import Array, Grid
from .reading import read
from .showing import Rows, Shown
from .solution import SolverEvidence

__all__ = [
    "ContactPlace",
    "ContactRadii",
    "ContactReference",
    "ContactRow",
    "Creepages",
    "EquivalentConicity",
    "OverlapRegion",
    "WheelRailDerivatives",
    "WheelRailForces",
    "WheelRailGeometry",
    "WheelRailPatch",
    "WheelRailSolution",
    "Wrench",
    "WrenchesByPosition",
    "WrenchesByVelocity",
    "read_wheel_rail",
]


@dataclass(frozen=True)
class ContactReference:
    """The reference of a contact, on the rail in track coordinates. Contact coordinates have their origin there: x
    forwards, y along the rail's surface to the right, z into the rail.

    Attributes:
        x: Forwards (mm).
        y: To the right (mm).
        z: Down (mm).
        angle: By which the track's axes are turned about x (rad): positive where the rail falls to the right.
    """

    x: float
    y: float
    z: float
    angle: float


@dataclass(frozen=True)
class OverlapRegion:
    """Where the undeformed profiles overlap, seen from above.

    Attributes:
        reference: Its weighted centre.
        x: Its ends forwards, in track coordinates (mm).
        y: Its ends to the right (mm).
        z: The rail's z there (mm).
        penetration: Largest vertical one (mm).
        size: Integral of the vertical penetration squared (mm^4).
    """

    reference: ContactReference
    x: tuple[float, float]
    y: tuple[float, float]
    z: tuple[float, float]
    penetration: float
    size: float


@dataclass(frozen=True)
class Creepages:
    """Velocities of the rail over those of the wheel, by the rolling velocity, in contact coordinates.

    Attributes:
        xi: Longitudinal creepage.
        eta: Lateral creepage.
        phi: Spin (rad/mm).
        chi: Rolling direction (rad): 0 forwards, pi backwards.
        velocity: Rolling velocity (mm/s); 0: the wheel does not roll.
    """

    xi: float
    eta: float
    phi: float
    chi: float
    velocity: float


@dataclass(frozen=True)
class ContactRadii:
    """Radii of curvature at the reference (mm), positive where convex; None where straight.

    Attributes:
        wheel_along: Of the wheel along x.
        wheel_across: Of the wheel along y.
        rail_along: Of the rail along x.
        rail_across: Of the rail along y.
    """

    wheel_along: float | None = None
    wheel_across: float | None = None
    rail_along: float | None = None
    rail_across: float | None = None


@dataclass(frozen=True)
class ContactRow:
    """A row of elements of a contact that is curved across the track, half-way between rail and wheel.

    Attributes:
        y: Its middle in track coordinates (mm).
        z: The same down (mm).
        angle: Its inclination (rad): tractions are along axes turned about x by it.
    """

    y: float
    z: float
    angle: float


@dataclass(frozen=True)
class ContactPlace:
    """One place where wheel and rail are in contact.

    Attributes:
        reference: Its origin and plane.
        regions: From the right to the left; more than one feel a share of each other.
        shares: What each region feels of the displacements of each, row by row; 1 on the diagonal.
        grid: The potential contact area, in contact coordinates.
        approach: Penetration along z, the largest at the elements (mm).
        penetration: Vertical, the largest (mm).
        creepages: By the motion of the wheelset.
        radii: Of wheel and rail.
        rows: Of the grid, where the contact is curved; empty where it is plane.
    """

    reference: ContactReference
    regions: tuple[OverlapRegion, ...]
    shares: tuple[float, ...]
    grid: Grid
    approach: float
    penetration: float
    creepages: Creepages
    radii: ContactRadii
    rows: tuple[ContactRow, ...] = ()


@dataclass(frozen=True)
class Wrench:
    """A force (N) and its moment (N mm) about the origin of its axes, on the rail.

    Attributes:
        Fx: Along x (N).
        Fy: Along y (N).
        Fz: Along z (N).
        Mx: About x (N mm).
        My: About y (N mm).
        Mz: About z (N mm).
    """

    Fx: float
    Fy: float
    Fz: float
    Mx: float
    My: float
    Mz: float


@dataclass(frozen=True)
class WheelRailForces:
    """Forces on the rail, in the axes of three.

    Attributes:
        track: In track coordinates.
        rail: About the origin of the rail's profile, along its axes.
        wheelset: About the wheelset's centre, along its axes, which do not turn with its pitch.
    """

    track: Wrench
    rail: Wrench
    wheelset: Wrench


@dataclass(frozen=True, eq=False)
class WheelRailPatch:
    """A contact and its solution.

    Attributes:
        place: Where it is.
        solution: In contact coordinates; arrays that `fields` did not name are None.
        forces: Of this patch.
        gap: Where asked for: undeformed distance less its least value (mm), shape [ny, nx] of the place's grid.
    """

    place: ContactPlace
    solution: PartialSolution
    forces: WheelRailForces
    gap: Array | None = None


@dataclass(frozen=True)
class WrenchesByPosition:
    """Derivatives of a wrench by the position of the wheelset.

    Attributes:
        y: By y (per mm).
        z: By z (per mm).
        roll: By the roll (per rad).
        yaw: By the yaw (per rad).
    """

    y: Wrench
    z: Wrench
    roll: Wrench
    yaw: Wrench


@dataclass(frozen=True)
class WrenchesByVelocity:
    """Derivatives of a wrench by the velocity of the wheelset.

    Attributes:
        x: By x (per mm/s).
        y: By y (per mm/s).
        z: By z (per mm/s).
        roll: By the roll rate (per rad/s).
        yaw: By the yaw rate (per rad/s).
        pitch: By the pitch rate (per rad/s).
    """

    x: Wrench
    y: Wrench
    z: Wrench
    roll: Wrench
    yaw: Wrench
    pitch: Wrench


@dataclass(frozen=True)
class WheelRailDerivatives:
    """How the forces on the rail, in track coordinates, follow the state, to first order. All inputs but the one are held,
    height and pitch rate also where forces found them: ``solution.derivatives.position.z.Fz`` is dFz/dz (N/mm).

    Attributes:
        position: By the position.
        velocity: By the velocity.
    """

    position: WrenchesByPosition
    velocity: WrenchesByVelocity


@dataclass(frozen=True, eq=False, repr=False)
class WheelRailSolution(Shown):
    """The contact of a wheel with its rail. No contact is an answer: no patches. Read `warnings`, ask `converged`.

    Attributes:
        z: Of the wheelset, as prescribed or found (mm).
        pitch: Its pitch rate, as prescribed or found (rad/s).
        forces: Of all patches.
        patches: From the right to the left.
        converged: Whether the solvers of all patches and the searches reached their tolerances.
        warnings: Sentences.
        clearance: Least vertical distance of wheel and rail at this z (mm), negative where they overlap; None where they
            are not above each other.
        force: Of the search for z, where Fz was given: solves, |F - Fz|/Fz.
        pitch_search: Of the search for the pitch rate, where Fx was given.
        derivatives: Where asked for, of a converged solution with contact.
    """

    z: float
    pitch: float
    forces: WheelRailForces
    patches: tuple[WheelRailPatch, ...]
    converged: bool
    warnings: tuple[str, ...] = ()
    clearance: float | None = None
    force: SolverEvidence | None = None
    pitch_search: SolverEvidence | None = None
    derivatives: WheelRailDerivatives | None = None

    def _rows(self) -> Rows:
        track = self.forces.track
        rows: Rows = [("z", self.z), ("Fx", track.Fx), ("Fy", track.Fy), ("Fz", track.Fz)]
        for patch in self.patches:
            at = patch.place.reference
            rows.append(("patch at y", f"{at.y:.2f}, {at.angle:.3f} rad, pmax {patch.solution.pmax:.5g}"))
        return [*rows, ("converged", "yes" if self.converged else "NO")]

    def _remarks(self) -> tuple[str, ...]:
        return self.warnings


@dataclass(frozen=True, eq=False)
class WheelRailGeometry:
    """What the profiles and a position tell without a solve.

    Attributes:
        z: Of the wheelset (mm).
        places: From the right to the left; none where wheel and rail do not overlap.
        clearance: Least vertical distance of wheel and rail (mm), negative where they overlap; None where they are not
            above each other.
        warnings: Sentences.
    """

    z: float
    places: tuple[ContactPlace, ...]
    clearance: float | None = None
    warnings: tuple[str, ...] = ()


@dataclass(frozen=True)
class EquivalentConicity:
    """Of a wheelset with the same profiles on both sides: the conicity of cones that roll with the same wavelength.

    Attributes:
        amplitude: Half of the way from side to side (mm).
        harmonic: The first harmonic of the radius difference.
        integrated: From the wavelength of the kinematic motion; None where the wheelset does not swing.
        wavelength: Of the kinematic motion (mm); None where the wheelset does not swing.
    """

    amplitude: float
    harmonic: float
    integrated: float | None = None
    wavelength: float | None = None


def read_wheel_rail(names: Iterable[str] | None, gap: bool, result: dict[str, Any]) -> WheelRailSolution:
    """The answer to a request for the arrays `names`, None: all, and, where `gap` says so, the undeformed distances."""
    solution = read(WheelRailSolution, result)
    wanted = list(ALL_FIELDS if names is None else names)
    for index, patch in enumerate(solution.patches):
        check_arrays(patch.solution, wanted, patch.place.grid)
        if gap and patch.gap is not None and patch.gap.shape != patch.place.grid.shape:
            raise ProtocolError(f"The answer's gap of patch {index} does not fit its grid.")
    return solution
