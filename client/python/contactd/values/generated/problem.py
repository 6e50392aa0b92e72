"""Contact problems as immutable values. Any consistent system of units works; the docstrings assume N and mm. The
daemon checks bounds: an invalid value raises InvalidArgument naming the field.

Written by ./dev generate from proto/schema: edit it there.
"""

from __future__ import annotations

from dataclasses import dataclass, field, replace
from typing import TYPE_CHECKING, TypedDict

import numpy.typing as npt

from ...refusals import public
from ..arrays import Array
from ..dictionaries import Saved
from ..params import HasParams, instead
from ..problem_methods import CLOSED_FORMS, REQUIRED, ProblemMethods
from ..solution import ContactSolution
from ..tables import TableIcs
from .evidence import Model, NormalModel, SimplifiedSettings, SolverSettings
from .fatigue import FatigueRequest
from .friction import Friction
from .grid import Grid, HalfEllipses, Paraboloid, SemiAxes
from .ics import Ics
from .materials import LayeredBody, Material, RigidBody, ViscoelasticBody
from .regions import ContactRegions
from .thermal import ThermalBodies
from .wear_laws import WearRequest

if TYPE_CHECKING:
    from typing_extensions import Unpack

__all__ = ["ContactColumns", "ContactProblem", "Estimate", "ProblemFields"]


@dataclass(frozen=True, eq=False)
class Estimate:
    """Tractions (N/mm^2) on the upper body, each of shape [ny, nx]: an estimate for the solvers (`initial`), or those
    of the previous step (`previous`). A ContactSolution is also accepted.

    Attributes:
        pressure: Pressure, >= 0, shape [ny, nx] (N/mm^2); None: zero.
        traction_x: Traction along x, shape [ny, nx] (N/mm^2); None: zero.
        traction_y: Traction along y, shape [ny, nx] (N/mm^2); None: zero.
        yield_stress: Yield stress of a layer that hardens or softens, shape [ny, nx] (N/mm^2); None: no flow yet.
        friction_coefficient: Coefficient of friction with memory, shape [ny, nx]; None: the static one.
    """

    pressure: Array | None = None
    traction_x: Array | None = None
    traction_y: Array | None = None
    yield_stress: Array | None = None
    friction_coefficient: Array | None = None


@dataclass(frozen=True, eq=False)
class ContactColumns(HasParams):
    """Shape of a surface that is curved along y. Rows of the grid are columns of elements of the lower body.

    dy of the grid is their arc length. The axes of an element are those of its column: gap and pressure are along its
    outward normal, tractions along x and along its tangent (cos angle, -sin angle). Columns are numbered in the
    direction of the tangent. Axes of the section: y to the right, z up, x towards the reader.

    Attributes:
        frames: Position and normal of each column, in the order of rows: y and z of its middle (mm), and the angle of
            its outward normal from +z (rad), positive towards +y and continuous; shape [ny, 3]. Columns are numbered
            along the tangent (cos angle, -sin angle).
        direction: Direction from which the upper body approaches (rad): an angle as in frames. An approach closes the
            gap of a column by its cosine with the column's normal. The normal force and the axis of spin and rotation
            are along this direction.
        origin: y and z of the reference point of moments, creepages and rigid shifts (mm); its x is 0.
    """

    frames: npt.ArrayLike = field(metadata={"array": ""})
    direction: float = 0.0
    origin: tuple[float, float] = (0.0, 0.0)


@public
@dataclass(frozen=True, eq=False)
class ContactProblem(ProblemMethods, Saved):
    """Normal contact with a prescribed approach or normal force and, with `friction`, tangential contact.

    Attributes:
        grid: The potential contact area, which must contain the whole contact.
        upper: The upper body; optional with TableIcs, which describe the bodies completely.
        gap: Undeformed distance without the approach (mm): a paraboloid given by radii or semi-axes, an array [ny, nx],
            or two half ellipses of prescribed pressures.
        approach: The approach delta (mm), > 0 in compression; the gap before deformation is h - delta.
        lower: The lower body; None: equal to the upper one.
        ics: Origin of the influence coefficients of both bodies: closed forms (default), finite elements, or your own
            table of the pair.
        friction: Tangential contact with Coulomb friction: a shift or rolling. If None, frictionless.
        normal: Stopping criterion of NORM for the pressures, which all other results depend on. The default tolerance
            is 1e-8.
        tangential: Stopping criterion for the tractions under friction, and the solver that computes them.
        initial: Initial estimate for the solvers: tractions of a similar problem.
        Fn: Normal force, instead of approach, which is then computed (N), >= 0.
        model: full: boundary elements. hertz: closed forms of elliptic contact, and with ics.line_contact of line
            contact. The models of vehicle codes, for steady rolling: fastsim, Kalker's simplified theory; fastrip,
            strip theory with FASTSIM in the slip area; polach, Polach's forces, without tractions and spin moment. All
            but full require a paraboloid or semi-axes, unless normal_model computes the pressures, and accept only
            line_contact of ics. Default "full".
        previous: Tractions at the end of the previous step, where a shift or transient rolling starts, and the state of
            friction: yield stresses of a layer, and coefficients with memory. None fields are zero. If previous is
            None, the surfaces have just come into contact.
        outer: Stopping criterion of the outer (Panagiotopoulos) iterations around these, which dissimilar bodies,
            kinetic friction and prescribed tangential forces require. The default limit is 100 iterations.
        upper_ics: Influence coefficients of the upper body, if they differ from `ics`; a table is that of this body.
        lower_ics: Influence coefficients of the lower body. If both this and `lower` are None, those of the upper body.
        derivatives: True to compute the derivatives of the forces by motion, load and friction, and that of the
            pressures by the approach. Refused for transient rolling of several steps, and with kinetic friction.
        columns: Shape of a surface that is curved along y. Rows of the grid are columns of elements of the lower body,
            dy is their arc length, and the axes of an element are those of its column. Requires model full and an array
            of distances along the columns' normals as the gap. The section's axes are y to the right, z up, x towards
            the reader. If None, a plane.
        displacements: True to compute the displacements of the surfaces and the elastic energy. Refused for simplified
            models.
        sheet_flexibility: Flexibility of a thin sheet between the bodies (mm^3/N), >= 0: its product with the pressure
            is added to the normal displacement of the same element only. Requires model full. Default 0.
        normal_model: Model of the pressures. of_model: according to model, by boundary elements or Hertz. The models of
            vehicle codes use the overlap of the undeformed surfaces: kp (Piotrowski and Kik), kpec (Piotrowski, Liu and
            Bruni), analyn (Sichani, Enblom and Berg). Tractions are then those of model: full, fastsim, fastrip or
            polach. Default "of_model".
        simplified: Options of the simplified models of rolling. A model refuses an option that it does not use unless
            the option has its default.
        temperature: Thermal properties of both bodies; requests surface temperatures. Requires steady rolling along x
            (chi 0 or pi) with its velocity. None: no temperatures.
        wear: Laws of wear; requests wear. Requires steady rolling along x (chi 0 or pi). None: no wear.
        fatigue: Requests rolling contact fatigue of one of the bodies. Requires steady rolling along x (chi 0 or pi).
            None: no fatigue.
        regions: Regions in which bodies may touch, and the influence of the pressures of each region on the others.
            Requires model full. None: the whole grid is one region.
        accuracy: Requests extrapolated tangential forces in steady rolling, with this error: of Fx and Fy over mu Fn,
            and of Mz over mu Fn sqrt(a b). The solution states the error in `evidence.accuracy`. Arrays, areas and
            derivatives are those of `grid`. None: forces are those of the grid.
    """

    grid: Grid
    upper: Material | RigidBody | LayeredBody | ViscoelasticBody | None = field(
        default=None, metadata={"within": "bodies"}
    )
    gap: Paraboloid | SemiAxes | HalfEllipses | npt.ArrayLike = field(default=REQUIRED, metadata={"array": "array"})
    approach: float | None = None
    lower: Material | RigidBody | LayeredBody | ViscoelasticBody | None = field(
        default=None, metadata={"within": "bodies"}
    )
    ics: Ics | TableIcs = CLOSED_FORMS
    friction: Friction | None = None
    normal: SolverSettings | None = field(default=None, metadata={"within": "settings"})
    tangential: SolverSettings | None = field(default=None, metadata={"within": "settings"})
    initial: Estimate | ContactSolution | None = None
    Fn: float | None = None
    model: Model | None = None
    previous: Estimate | ContactSolution | None = None
    outer: SolverSettings | None = field(default=None, metadata={"within": "settings"})
    upper_ics: Ics | TableIcs | None = None
    lower_ics: Ics | TableIcs | None = None
    derivatives: bool = False
    columns: ContactColumns | None = None
    displacements: bool = False
    sheet_flexibility: float | None = None
    normal_model: NormalModel | None = None
    simplified: SimplifiedSettings | None = None
    temperature: ThermalBodies | None = None
    wear: WearRequest | None = None
    fatigue: FatigueRequest | None = None
    regions: ContactRegions | None = None
    accuracy: float | None = None

    @public
    def replace(self, **changes: Unpack[ProblemFields]) -> ContactProblem:
        """A copy with some fields changed; approach and Fn take the place of each other."""
        return replace(self, **instead(changes, "approach", "Fn"))


class ProblemFields(TypedDict, total=False):
    """Keywords of ContactProblem."""

    grid: Grid
    upper: Material | RigidBody | LayeredBody | ViscoelasticBody | None
    gap: Paraboloid | SemiAxes | HalfEllipses | npt.ArrayLike
    approach: float | None
    lower: Material | RigidBody | LayeredBody | ViscoelasticBody | None
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
    displacements: bool
    sheet_flexibility: float | None
    normal_model: NormalModel | None
    simplified: SimplifiedSettings | None
    temperature: ThermalBodies | None
    wear: WearRequest | None
    fatigue: FatigueRequest | None
    regions: ContactRegions | None
    accuracy: float | None
