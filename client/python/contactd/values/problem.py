"""What is asked: contact problems as plain, immutable values.

Any consistent system of units works; the docstrings name N and mm. Ranges are the daemon's business: a value it cannot
use comes back as InvalidArgument naming the field.
"""

from __future__ import annotations

import reprlib
from collections.abc import Mapping
from dataclasses import dataclass, replace
from dataclasses import fields as dataclass_fields
from typing import TYPE_CHECKING, Any, TypedDict

import numpy.typing as npt

from ..refusals import check_type, public
from .dictionaries import Saved
from .evidence import Model, SolverSettings
from .friction import Friction
from .grid import Array, Grid, Paraboloid, SemiAxes
from .ics import AnalyticIcs, FemIcs, Ics
from .materials import LayeredBody, Material, RigidBody
from .params import array_of
from .tables import TableIcs

if TYPE_CHECKING:
    from typing_extensions import Unpack

    from .solution import ContactSolution

__all__ = ["ContactColumns", "ContactProblem", "Estimate", "ProblemFields"]


@dataclass(frozen=True, eq=False)
class Estimate:
    """Tractions (N/mm^2) on the upper body, each of shape [ny, nx]: for the solvers to start from (`initial`), or of the
    step before (`previous`). A ContactSolution serves as well.

    Attributes:
        pressure: Shape [ny, nx] (N/mm^2), >= 0; None: zero.
        traction_x: Shape [ny, nx] (N/mm^2); None: zero.
        traction_y: Shape [ny, nx] (N/mm^2); None: zero.
    """

    pressure: Array | None = None
    traction_x: Array | None = None
    traction_y: Array | None = None


_CLOSED_FORMS = AnalyticIcs()
_REQUIRED: Any = object()  # stands behind `upper`, which may be left out, without being left out itself


@dataclass(frozen=True, eq=False)
class ContactColumns:
    """Where the surface is curved along y: rows of the grid are columns of elements of the lower body.

    dy of the grid is their arc length. The axes of an element are those of its column: gap and pressure are along its
    outward normal, tractions along x and along its tangent (cos angle, -sin angle), in the direction of which columns
    are numbered. Axes of the section: y to the right, z up, x towards the reader.

    Attributes:
        frames: Of each column y and z of its middle (mm), and the angle of its normal from +z (rad), positive towards +y,
            running on continuously; shape [ny, 3].
        direction: Where the upper body comes from, an angle (rad) as of frames. An approach closes the gap of a column by
            its cosine with the normal; the normal force, and the axis of spin and rotation, are along it.
        origin: y and z of the point that moments are about, and that creepages and rigid shifts are those of (mm).
    """

    frames: npt.ArrayLike
    direction: float = 0.0
    origin: tuple[float, float] = (0.0, 0.0)

    def params(self) -> dict[str, Any]:
        """`columns` of contact.solve."""
        return {"frames": array_of(self.frames), "direction": self.direction, "origin": list(self.origin)}


@public
@dataclass(frozen=True, eq=False)
class ContactProblem(Saved):
    """Normal contact with either the approach or the normal force prescribed; with `friction`, tangential contact too.

    Attributes:
        grid: The potential contact area, which must hold the whole contact.
        upper: The upper body; may be left out with TableIcs, which say all about the bodies.
        gap: Undeformed distance without the approach (mm): a paraboloid, by radii or semi-axes, or an array [ny, nx].
        approach: delta (mm), > 0 in compression; the gap before deformation is h - delta.
        lower: The lower body; None: as the upper one.
        ics: Where the influence coefficients of both bodies come from: closed forms (default), finite elements, or a
            table of your own, which is of the pair.
        upper_ics: The same of the upper body alone, where it is not `ics`; a table is of this body then.
        lower_ics: The same of the lower body; None, and `lower` None too: as the upper one.
        friction: Friction and the motion; None: frictionless.
        normal: Stop test of NORM, for the pressures.
        tangential: Stopping criterion of the solver for the tractions; TangentialSettings chooses which that is.
        initial: Where the solvers start: tractions of a similar problem.
        Fn: Normal force (N), >= 0, instead of the approach, which is found then.
        model: "full": boundary elements; "hertz": closed forms of elliptic contact, and of line contact where `ics` says
            so; "fastsim": Hertzian contact and Kalker's simplified theory of rolling. The quick ones need a paraboloid or
            semi-axes, and materials.
        previous: The step before, where a shift or transient rolling starts.
        outer: Stop test of the loop that bodies that differ, kinetic friction and forces need.
        derivatives: Whether the solution has those of its forces by motion, load and friction.
        columns: Where the surface is curved along y; None: a plane. The gap is an array of distances along the normals
            then, and the model "full".
    """

    grid: Grid
    upper: Material | RigidBody | LayeredBody | None = None
    gap: Paraboloid | SemiAxes | npt.ArrayLike = _REQUIRED
    approach: float | None = None
    lower: Material | RigidBody | LayeredBody | None = None
    ics: Ics | TableIcs = _CLOSED_FORMS
    friction: Friction | None = None
    normal: SolverSettings | None = None
    tangential: SolverSettings | None = None
    initial: Estimate | ContactSolution | None = None
    Fn: float | None = None
    model: Model | None = None
    previous: Estimate | ContactSolution | None = None
    outer: SolverSettings | None = None
    upper_ics: Ics | TableIcs | None = None
    lower_ics: Ics | TableIcs | None = None
    derivatives: bool = False
    columns: ContactColumns | None = None

    def __post_init__(self) -> None:
        if self.gap is _REQUIRED:
            raise TypeError("ContactProblem() lacks gap")
        if (self.approach is None) == (self.Fn is None):
            raise TypeError("ContactProblem() takes either approach or Fn")
        check_field_types(vars(self))

    @public
    def replace(self, **changes: Unpack[ProblemFields]) -> ContactProblem:
        """The same problem with some fields changed; Fn takes the place of the approach, and the other way round."""
        if changes.get("Fn") is not None:
            changes.setdefault("approach", None)
        if changes.get("approach") is not None:
            changes.setdefault("Fn", None)
        return replace(self, **changes)


def check_field_types(fields: Mapping[str, Any]) -> None:
    """Raises TypeError when a field of a ContactProblem is of a wrong type, or there is none of its name."""
    if unknown := fields.keys() - {field.name for field in dataclass_fields(ContactProblem)}:
        raise TypeError(f"ContactProblem has no field {', '.join(sorted(unknown))}")
    check_type("grid", fields.get("grid"), Grid)
    check_type("ics", fields.get("ics", AnalyticIcs()), AnalyticIcs, FemIcs, TableIcs)
    for name in ("upper", "lower"):
        check_type(name, fields.get(name), Material, RigidBody, LayeredBody, optional=True)
        check_type(f"{name}_ics", fields.get(f"{name}_ics"), AnalyticIcs, FemIcs, TableIcs, optional=True)
    check_type("friction", fields.get("friction"), Friction, optional=True)
    check_type("derivatives", fields.get("derivatives"), bool, optional=True)
    check_type("columns", fields.get("columns"), ContactColumns, optional=True)
    for name in ("normal", "tangential", "outer"):
        check_type(name, fields.get(name), SolverSettings, optional=True)
    for name in ("initial", "previous"):
        if (tractions := fields.get(name)) is not None and not hasattr(tractions, "pressure"):
            raise TypeError(f"{name} is {reprlib.repr(tractions)}; it must be a solution or an Estimate")


class ProblemFields(TypedDict, total=False):
    """Of ContactProblem. Which of them must be there is told when it is made."""

    grid: Grid
    upper: Material | RigidBody | LayeredBody | None
    gap: Paraboloid | SemiAxes | npt.ArrayLike
    approach: float | None
    lower: Material | RigidBody | LayeredBody | None
    ics: Ics | TableIcs
    friction: Friction | None
    normal: SolverSettings | None
    tangential: SolverSettings | None
    initial: Estimate | ContactSolution | None
    Fn: float | None
    model: Model | None
    previous: Estimate | ContactSolution | None
    outer: SolverSettings | None
    upper_ics: Ics | TableIcs | None
    lower_ics: Ics | TableIcs | None
    derivatives: bool
    columns: ContactColumns | None
