"""Where a wheel touches its rail, and what comes of it: the answer of `Client.wheel_rail`, as plain, immutable values.
Lengths in mm, angles in rad, forces in N on the rail."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, TypedDict, TypeVar

from ...errors import ProtocolError
from ...refusals import public
from ..answers import read
from ..dictionaries import Saved
from ..evidence import SolverEvidence
from ..grid import Array
from ..partial_solution import ALL_FIELDS, PartialSolution, check_arrays, on_grid
from ..registry import extra
from ..representation import Rows, Shown, with_inherited_attributes
from ..solution import Fields
from .forces import WheelRailDerivatives, WheelRailForces
from .places import ContactPlace
from .setup import WheelRailFriction
from .state import WheelRailState

if TYPE_CHECKING:
    from matplotlib.figure import Figure

__all__ = [
    "RailShift",
    "WheelRailPatch",
    "WheelRailSolution",
    "WheelRailStepInput",
    "WheelRailStepSolution",
    "WheelsetSolution",
    "read_wheel_rail",
    "read_wheel_rail_as",
    "read_wheel_rail_without_patches",
    "read_wheelset",
]

S = TypeVar("S", bound="WheelRailSolution")


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
class RailShift:
    """By how much a rail on springs has given way beside its deviation, in track coordinates.

    Attributes:
        y: To the right (mm).
        z: Down (mm).
    """

    y: float
    z: float


@dataclass(frozen=True, eq=False, repr=False)
class WheelRailSolution(Saved, Shown):
    """The contact of a wheel with its rail. No contact is an answer: no patches. Read `warnings`, ask `converged`.

    Attributes:
        z: Of the wheelset, as prescribed or found (mm).
        pitch: Its pitch rate, as prescribed or found (rad/s).
        forces: Of all patches.
        patches: From the right to the left. Of a step that said ``patches=False`` they are left out, and reading them raises
            AttributeError.
        converged: Whether the solvers of all patches and the searches reached their tolerances.
        warnings: Sentences.
        clearance: Least vertical distance of wheel and rail at this z (mm), negative where they overlap; None where they
            are not above each other.
        force: Of the search for z, where Fz was given: solves, |F - Fz|/Fz.
        pitch_search: Of the search for the pitch rate, where Fx was given.
        rail_shift: Of a rail on springs.
        rail_search: Of a rail on springs: solves, and what its forces leave of each other, over Fz.
        derivatives: Where asked for, of a converged solution with contact.
        contacts: Where patches are left out: how many there are.
        frictional_power: Of rolling with friction: what it dissipates in all patches (N mm/s).
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
    rail_shift: RailShift | None = None
    rail_search: SolverEvidence | None = None
    derivatives: WheelRailDerivatives | None = None
    contacts: int | None = None
    frictional_power: float | None = None

    if not TYPE_CHECKING:  # which has none to report otherwise

        def __getattr__(self, name: str) -> Any:
            if name == "patches":
                raise AttributeError("patches were left out of this answer, as its step said by patches=False")
            raise AttributeError(f"{type(self).__name__!r} object has no attribute {name!r}")

    @public
    def plot(self) -> Figure:
        """Draws the contacts and forces across the track, and beside them the pressures of each patch that has them.

        Returns the figure. Needs matplotlib ("contactd[pictures]").
        """
        drawn: Figure = extra("WheelRailSolution.plot")(self)
        return drawn

    def _rows(self) -> Rows:
        track = self.forces.track
        rows: Rows = [("z", self.z), ("Fx", track.Fx), ("Fy", track.Fy), ("Fz", track.Fz)]
        if self.contacts is not None:
            rows.append(("contacts", self.contacts))
        for patch in self.patches if self.contacts is None else ():
            at = patch.place.reference
            rows.append(("patch at y", f"{at.y:.2f}, {at.angle:.3f} rad, pmax {patch.solution.pmax:.5g}"))
        return [*rows, ("converged", "yes" if self.converged else "NO")]

    def _remarks(self) -> tuple[str, ...]:
        return self.warnings


@dataclass(frozen=True, eq=False, repr=False)
class WheelsetSolution(Saved, Shown):
    """Both wheels of a wheelset on their rails. Read `warnings`, and those of each wheel; ask `converged`.

    Attributes:
        z: Of the wheelset, as found (mm): against the mean of both nominal radii, as each wheel's own is against its.
        roll: Of the wheelset, as found (rad).
        left: The left wheel on its rail.
        right: The right wheel on its rail.
        roll_search: Solves of both wheels, and by how much their heights differ (mm).
        converged: Whether the solvers of both wheels and the search for the roll reached their tolerances.
        warnings: Sentences, of both wheels together.
    """

    z: float
    roll: float
    left: WheelRailSolution
    right: WheelRailSolution
    roll_search: SolverEvidence
    converged: bool
    warnings: tuple[str, ...] = ()

    def _rows(self) -> Rows:
        rows: Rows = [("z", self.z), ("roll", self.roll)]
        for name, wheel in (("left", self.left), ("right", self.right)):
            track = wheel.forces.track
            rows.append((name, f"{len(wheel.patches)} patches, Fx {track.Fx:.5g}, Fy {track.Fy:.5g}, Fz {track.Fz:.5g}"))
        return [*rows, ("converged", "yes" if self.converged else "NO")]

    def _remarks(self) -> tuple[str, ...]:
        return self.warnings + self.left.warnings + self.right.warnings


def read_wheel_rail(names: Iterable[str] | None, gap: bool, result: dict[str, Any]) -> WheelRailSolution:
    """The answer to a request for the arrays `names`, None: all, and, where `gap` says so, the undeformed distances."""
    return read_wheel_rail_as(WheelRailSolution, names, gap, result)


def read_wheel_rail_as(
    kind: type[S], names: Iterable[str] | None, gap: bool, result: dict[str, Any], path: str = "result"
) -> S:
    """The same as a class that holds more."""
    return _checked(read(kind, result, path), names, gap)


def read_wheel_rail_without_patches(kind: type[S], result: dict[str, Any], path: str) -> S:
    """The same of an answer that leaves them out."""
    if type(result.get("contacts")) is not int:
        raise ProtocolError(f"The answer's {path} lacks contacts.")
    solution = read(kind, {**result, "patches": []}, path)
    del vars(solution)["patches"]
    return solution


def read_wheelset(names: Iterable[str] | None, gap: bool, result: dict[str, Any]) -> WheelsetSolution:
    """As `read_wheel_rail`, of both wheels."""
    solution = read(WheelsetSolution, result)
    for wheel in (solution.left, solution.right):
        _checked(wheel, names, gap)
    return solution


def _checked(solution: S, names: Iterable[str] | None, gap: bool) -> S:
    wanted = list(ALL_FIELDS if names is None else names)
    for index, patch in enumerate(solution.patches):
        check_arrays(patch.solution, wanted, patch.place.grid)
        on_grid(patch.solution, patch.place.grid)
        if gap and patch.gap is not None and patch.gap.shape != patch.place.grid.shape:
            raise ProtocolError(f"The answer's gap of patch {index} does not fit its grid.")
    return solution


class WheelRailStepInput(TypedDict, total=False):
    """What a step says: the arguments of WheelRailSession.step, for Client.step_many, as in ``{"state": state}``."""

    state: WheelRailState
    friction: WheelRailFriction | None
    fields: Fields
    gap: bool
    patches: bool
    again: bool


@with_inherited_attributes
@dataclass(frozen=True, eq=False, repr=False, kw_only=True)
class WheelRailStepSolution(WheelRailSolution):
    """The solution of a step. Arrays of its patches are None unless `fields` named them; `converged` is False only in a
    session that accepts it.

    Attributes:
        step: Number of the step.
    """

    step: int

    def _title(self) -> str:
        return f"WheelRailStepSolution {self.step}"
