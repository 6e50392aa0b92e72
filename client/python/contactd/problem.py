"""What is asked: materials, grids, influence coefficients and contact problems as plain, immutable values.

Any consistent system of units works; the docstrings name N and mm. Ranges are the daemon's business: a value it cannot
use comes back as InvalidArgument naming the field.
"""

from __future__ import annotations

import math
import reprlib
from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field, replace
from dataclasses import fields as dataclass_fields
from numbers import Real
from typing import TYPE_CHECKING, Any, Literal

import numpy as np
import numpy.typing as npt

from .arrays import array_of, invalid, plain
from .friction import Friction
from .saving import Saved
from .table_ics import TableIcs

if TYPE_CHECKING:
    from typing_extensions import Unpack

    from .keywords import ProblemFields
    from .solution import ContactSolution

__all__ = [
    "AnalyticIcs",
    "Body",
    "ContactColumns",
    "ContactProblem",
    "Diagonal",
    "Estimate",
    "FarBoundary",
    "FemIcs",
    "FemSolver",
    "Grid",
    "Ics",
    "Layer",
    "LayeredBody",
    "LineContact",
    "LoadShape",
    "Material",
    "MeshKind",
    "Model",
    "Paraboloid",
    "Preset",
    "RigidBody",
    "Sampling",
    "SemiAxes",
    "SolverSettings",
    "StopTest",
]

Array = npt.NDArray[np.float64]


@dataclass(frozen=True, init=False)
class Material:
    """A homogeneous, isotropic, linearly elastic material, given by its shear modulus or by Young's.

    ::

        Material(G=82000, nu=0.28)
        Material(E=210000, nu=0.28)  # G = E / (2 (1 + nu))

    Attributes:
        G: Shear modulus (N/mm^2), > 0.
        nu: Poisson's ratio, 0 to 0.5; 0.5 itself only with closed-form influence coefficients.
    """

    G: float
    nu: float

    def __init__(self, G: float | None = None, nu: float | None = None, *, E: float | None = None) -> None:
        if nu is None:
            raise TypeError("Material() lacks nu")
        if (G is None) == (E is None):
            raise TypeError("Material() takes either G, the shear modulus, or E, Young's modulus")
        object.__setattr__(self, "G", _shear_modulus(E, nu) if E is not None else G)
        object.__setattr__(self, "nu", nu)

    @property
    def E(self) -> float:
        """Young's modulus 2 G (1 + nu) (N/mm^2)."""
        return 2 * self.G * (1 + self.nu)


def _shear_modulus(E: float, nu: float) -> float:
    """Says of Young's modulus what the daemon, which gets G only, would say of that."""
    for name, value in (("E", E), ("nu", nu)):
        if not isinstance(value, Real) or isinstance(value, bool):
            raise TypeError(f"{name} is {value!r}; it must be a number")
    if not 0 < E < math.inf:
        raise invalid("E", f"is {E}; it must be a positive, finite number")
    if not 0 <= nu <= 0.5:
        raise invalid("nu", f"is {nu}; it must lie in [0, 0.5]")
    return float(E / (2 * (1 + nu)))


@dataclass(frozen=True)
class RigidBody:
    """A body that does not deform; the other one must be elastic. Influence coefficients mean nothing to it."""


@dataclass(frozen=True)
class Layer:
    """A layer of a LayeredBody.

    Attributes:
        thickness: mm, > 0.
        G: Shear modulus (N/mm^2), > 0.
        nu: Poisson's ratio, 0 to 0.5; 0.5 is meant exactly.
    """

    thickness: float
    G: float
    nu: float


@dataclass(frozen=True)
class LayeredBody:
    """Layers that are bonded to each other and to what they lie on, uniform along x and y: rubber, coatings, films.

    ::

        LayeredBody([Layer(thickness=2, G=1, nu=0.5)], base=RigidBody())
        LayeredBody([Layer(0.01, G=120000, nu=0.25), Layer(0.5, G=30000, nu=0.3)], base=Material(G=82000, nu=0.28))

    Their coefficients are computed in milliseconds, exactly but for rounding; evidence states the error
    (docs/layers.md). Of `ics` only load_shape means something to such a body.

    Attributes:
        layers: From the surface down; at most 20, whose shear moduli differ by a factor of at most 1e9.
        base: The half-space below them, or a RigidBody, which does not move.
    """

    layers: tuple[Layer, ...]
    base: Material | RigidBody

    def __init__(self, layers: Iterable[Layer], base: Material | RigidBody) -> None:
        found = tuple(layers)
        for i, layer in enumerate(found):
            check_type(f"layers[{i}]", layer, Layer)
        check_type("base", base, Material, RigidBody)
        object.__setattr__(self, "layers", found)
        object.__setattr__(self, "base", base)

    @property
    def G(self) -> float:
        """Shear modulus at the surface (N/mm^2)."""
        return self.layers[0].G

    @property
    def nu(self) -> float:
        """Poisson's ratio at the surface."""
        return self.layers[0].nu

    def params(self) -> dict[str, Any]:
        """What `ics` of the body say of it."""
        base = {"rigid": True} if isinstance(self.base, RigidBody) else plain(self.base)
        return {"body": "layered", "layers": [plain(layer) for layer in self.layers], "base": base}


@dataclass(frozen=True)
class Grid:
    """The potential contact area: `nx` x `ny` elements of size `dx` x `dy` (mm), unknowns at their centres.

    `dx` and `dy` are those of one element; `Grid.centred` takes the size of the whole area.
    Arrays over the grid have shape `[ny, nx]`: the first index counts along y.

    Attributes:
        nx: Number of elements along x.
        ny: Number of elements along y.
        dx: Size of an element along x (mm), > 0.
        dy: Size of an element along y (mm), > 0.
        x0: x of the lower left corner (mm); None: centred on the origin.
        y0: y of the lower left corner (mm); None: centred on the origin.
    """

    nx: int
    ny: int
    dx: float
    dy: float
    x0: float | None = None
    y0: float | None = None

    @classmethod
    def centred(cls, nx: int, ny: int, width: float, height: float) -> Grid:
        """`nx` x `ny` elements that together fill a `width` x `height` rectangle (mm) around the origin.

        ``Grid.centred(40, 40, 2.4, 2.4)`` is ``Grid(40, 40, 0.06, 0.06)``.
        """
        if nx < 1 or ny < 1:
            raise ValueError(f"nx and ny are {nx} and {ny}; a rectangle is divided into at least one element each way.")
        return cls(nx, ny, width / nx, height / ny)

    @property
    def shape(self) -> tuple[int, int]:
        """Shape of arrays over the grid: (ny, nx)."""
        return (self.ny, self.nx)

    @property
    def x(self) -> Array:
        """Element centres along x (mm), shape [nx]."""
        return _centres(self.nx, self.dx, self.x0)

    @property
    def y(self) -> Array:
        """Element centres along y (mm), shape [ny]."""
        return _centres(self.ny, self.dy, self.y0)


def _centres(n: int, size: float, corner: float | None) -> Array:
    start = -0.5 * n * size if corner is None else corner
    return np.asarray(start + (np.arange(n) + 0.5) * size, dtype=np.float64)


Body = Literal["half_space", "block", "prism"]
LoadShape = Literal["constant", "bilinear"]
Preset = Literal[
    "paper-test1", "paper-test2", "paper-test3", "paper-mesh2-test1", "paper-mesh2-test2", "paper-mesh2-test3"
]
MeshKind = Literal["hex", "prism", "adaptive"]
Diagonal = Literal["outward", "across"]
FarBoundary = Literal["clamped", "half_space"]
Sampling = Literal["fem", "linear", "linear_nodes"]
FemSolver = Literal["auto", "amg_pcg", "direct"]
StopTest = Literal["residual", "update"]


@dataclass(frozen=True)
class LineContact:
    """A contact that does not change along y nor end there: plane strain (anti-plane strain for what points along y).

    The grid has ny = 1, and its dy is the length that forces are counted over: Fn/dy is the force per length.
    Displacements of the plane are known up to a constant only, which `datum` fixes. The approach and the rigid shift
    depend on it; under prescribed forces, and in steady rolling, nothing else does.

    Attributes:
        datum: Distance from a load, along the surface, at which its displacements xx, yy and zz vanish (mm), at least the
            length of the grid.
    """

    datum: float


@dataclass(frozen=True)
class AnalyticIcs:
    """Influence coefficients of the elastic half-space in closed form.

    Attributes:
        body: "half_space" (default), or "prism": half-spaces that are turned from column to column of `section`
            (docs/sections.md); "layered" is what answers say of a LayeredBody.
        load_shape: Traction of the loaded element: "constant" (default), or "bilinear", the tent
            (1 - |x|/dx) (1 - |y|/dy).
        line_contact: A contact that does not change along y; None: elements end along y.
        section: Of a prism, as FemIcs.section.
    """

    body: Literal["half_space", "layered", "prism"] | None = None
    load_shape: LoadShape | None = None
    line_contact: LineContact | None = None
    section: Mapping[str, Any] | None = None

    def __post_init__(self) -> None:
        if self.line_contact is not None:
            check_type("line_contact", self.line_contact, LineContact)


@dataclass(frozen=True, kw_only=True)
class FemIcs:
    """Influence coefficients computed with finite elements; what is None takes the daemon's default.

    There are two ways to ask (docs/ic-tables.md). Either for an accuracy, and the daemon chooses mesh and solver::

        FemIcs(accuracy=1e-3)
        FemIcs(accuracy=1e-3, body="block", L_over_h=20, load_shape="bilinear", any_nu=True)

    or for a mesh, by one of the paper's presets, by fields, or both (fields win)::

        FemIcs("paper-test3", L_over_h=1280)

    ``FemIcs()`` asks for an accuracy of 1e-3. Lengths are ratios to the element size h of the grid (paper, Table 2), so
    that a table serves every element size.

    Attributes:
        preset: A test of the paper's Table 2 on its Mesh1 or Mesh2: sets mesh, order, l_over_h, h_over_hs, f, and
            far_boundary "clamped"; does not go with accuracy.
        L_over_h: Size L of the mesh over h, default 640; of a block that of the body, which goes with accuracy too.
        accuracy: Largest error, 1e-4 to 0.1: of xx, yy, zz relative, of the others times 2 pi G rho / (dx dy). Of the
            other fields any_nu, body, load_shape and (of a block) L_over_h go with it.
        any_nu: True: one build for every Poisson's ratio from 0 to 0.49; material.nu is the value to interpolate to.
        body: "half_space" (default), "block": [-L, L]^2 x [-L, 0], u = 0 on all faces but the top, or "prism": a body
            that is uniform along x, for which an accuracy is asked for.
        load_shape: Traction of the loaded element: "constant" (default), or "bilinear", the tent
            (1 - |x|/dx) (1 - |y|/dy).
        l_over_h: Of meshes "hex" and "prism": size of the uniform cube around the load over h, 0.5 to 64; default 1.
        h_over_hs: Of meshes "hex" and "prism": elements of the cube per element of the grid, even; l_over_h times it is
            whole; default 4.
        f: Of meshes "hex" and "prism": growth of the layers outside the cube, 1 to 10; default 1.2.
        t1_over_hs: Of meshes "hex" and "prism": first layer's thickness over the cube's element size; default 0, which
            means f.
        order: Polynomial order of the displacement, 1 to 6; default 2.
        mesh: "hex" (default, the paper's Mesh1), "prism" (its Mesh2) or "adaptive".
        diagonal: Of mesh "prism": the diagonal that halves a quadrilateral starts "outward" (default) from its corner
            nearest to the load, or runs "across".
        max_dofs: Of mesh "adaptive": no refinement beyond, 1000 to 5000000; default 60000.
        far_boundary: On the mesh's far faces: "clamped" (u = 0; with a preset, and for a block), or "half_space" (the
            displacements of the half-space under the load; the default otherwise).
        sampling: How displacements are read at the element centres: "fem" (default, the finite-element function), or
            linear between the vertices ("linear") or all nodes ("linear_nodes") of the surface mesh.
        solver: "auto" (default, the faster one), "amg_pcg" (with a preset) or "direct" (sparse Cholesky).
        stop_test: Compared with tolerance: the true relative "residual" (default), or the relative "update" (the
            paper's).
        tolerance: Of the stop test, 1e-13 to 1; default 1e-8.
        max_iterations: Of conjugate gradients, per load case; default 1000.
        strength_threshold: Of BoomerAMG, 0 to 1; chosen for the mesh when left out.
        section: Of a prism: its cross-section as the wire has it (docs/protocol.md, docs/sections.md), for example
            {"rail_60e1": {"from": 2}} or {"edge_block": {"width": 100, "height": 50, "edge_distance": 1}}. Its columns
            are the rows of the grid, dy wide along the outline.
    """

    preset: Preset | None = field(default=None, kw_only=False)
    L_over_h: float | None = field(default=None, kw_only=False)

    accuracy: float | None = None
    any_nu: bool | None = None
    body: Body | None = None
    load_shape: LoadShape | None = None

    l_over_h: float | None = None
    h_over_hs: float | None = None
    f: float | None = None
    t1_over_hs: float | None = None
    order: int | None = None
    mesh: MeshKind | None = None
    diagonal: Diagonal | None = None
    max_dofs: int | None = None
    far_boundary: FarBoundary | None = None
    sampling: Sampling | None = None
    solver: FemSolver | None = None
    stop_test: StopTest | None = None
    tolerance: float | None = None
    max_iterations: int | None = None
    strength_threshold: float | None = None
    section: Mapping[str, Any] | None = None


Ics = AnalyticIcs | FemIcs


@dataclass(frozen=True)
class Paraboloid:
    """Undeformed distance h = x^2/(2 Rx) + y^2/(2 Ry), without the approach. One direction may be flat, not both.

    Attributes:
        Rx: Radius of curvature along x (mm), negative where concave; None: flat.
        Ry: Radius of curvature along y (mm), negative where concave; None: flat.
    """

    Rx: float | None = None
    Ry: float | None = None


@dataclass(frozen=True)
class SemiAxes:
    """The paraboloid whose Hertzian contact, under the approach or force of the problem, has these semi-axes.

    Attributes:
        a: Semi-axis along x (mm), > 0.
        b: Semi-axis along y (mm), > 0.
    """

    a: float
    b: float


@dataclass(frozen=True)
class SolverSettings:
    """Stop test and bound of one iterative solver (paper, sections 4.1 and 4.2).

    Attributes:
        tolerance: Bound of the figure that the stop test compares; None: 1e-6, of `normal` 1e-8.
        max_iterations: Bound of the iterations; None: 1000, of `outer` 100.
    """

    tolerance: float | None = None
    max_iterations: int | None = None


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


_REQUIRED: Any = object()  # stands behind `upper`, which may be left out, without being left out itself

Model = Literal["full", "hertz", "fastsim"]


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
        tangential: Stop test of Newton's method on the friction law, for the tractions.
        initial: Where the solvers start: tractions of a similar problem.
        Fn: Normal force (N), >= 0, instead of the approach, which is found then.
        model: "full": boundary elements; "hertz": closed forms of elliptic contact; "fastsim": Hertzian contact and
            Kalker's simplified theory of rolling. The quick ones need a paraboloid or semi-axes, and materials.
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
    ics: Ics | TableIcs = AnalyticIcs()
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


def check_type(name: str, value: object, *types: type, optional: bool = False) -> None:
    """Raises TypeError when `value` is of none of the types; what is in it is the daemon's business."""
    if isinstance(value, types) or (optional and value is None):
        return
    words = " or ".join(kind.__name__ for kind in types)
    raise TypeError(f"{name} is {reprlib.repr(value)}; it must be of type {words}")


def ics_params(ics: Ics) -> dict[str, Any]:
    """`ics` of ic.get, ic.export and contact.solve."""
    source: Literal["analytic", "fem"] = "fem" if isinstance(ics, FemIcs) else "analytic"
    given = plain(ics)
    if given.get("body") == "layered":
        raise TypeError("the ics of layers say no more than load_shape; give the layers as a LayeredBody")
    if isinstance(ics, AnalyticIcs) and ics.line_contact is not None:
        given["line_contact"] = plain(ics.line_contact)
    return {"source": source, **given}


def table_shape(grid: Grid, ics: Ics) -> tuple[int, ...]:
    """Of one component: [ny, nx], of a prism [ny, ny, nx]: the observed column, the loaded one, and the x offset."""
    return grid.shape if ics.section is None else (grid.ny, *grid.shape)


def table_params(material: Material | LayeredBody, grid: Grid, ics: Ics) -> dict[str, Any]:
    """The parameters of ic.get; where the grid lies does not matter to a table."""
    check_type("material", material, Material, LayeredBody)
    check_type("grid", grid, Grid)
    check_type("ics", ics, AnalyticIcs, FemIcs)
    extent = {"nx": grid.nx, "ny": grid.ny, "dx": grid.dx, "dy": grid.dy}
    if isinstance(material, LayeredBody):
        return {"grid": extent, "ics": layered_params(material, ics)}
    return {"material": plain(material), "grid": extent, "ics": ics_params(ics)}


def layered_params(body: LayeredBody, ics: Ics | TableIcs) -> dict[str, Any]:
    """`ics` of a body of layers; they take the load shape of the other body's, and what they refuse of closed forms."""
    if isinstance(ics, TableIcs):
        raise TypeError("a table says all of a body; give it with a Material instead of a LayeredBody")
    said = plain(ics) if isinstance(ics, FemIcs) else ics_params(replace(ics, body=None))
    kept: dict[str, Any] = {name: said[name] for name in ("load_shape", "line_contact") if name in said}
    return {"source": "analytic", **kept, **body.params()}


def body_params(
    body: Material | RigidBody | LayeredBody, ics: Ics | TableIcs | None, grid: Grid, both: Ics | TableIcs
) -> dict[str, Any]:
    """`bodies.upper` or `bodies.lower`; `ics` is the body's own, where it is not that of both."""
    if isinstance(body, LayeredBody):
        return {"ics": layered_params(body, both if ics is None else ics)}
    params = {"rigid": True} if isinstance(body, RigidBody) else plain(body)
    return params if ics is None else {**params, "ics": coefficient_params(ics, grid)}


def problem_params(problem: ContactProblem, fields: list[str] | None = None) -> dict[str, Any]:
    """The parameters of contact.solve; `fields` are the arrays wanted back, None: all."""
    params = opening_params(vars(problem))
    return params if fields is None else {**params, "fields": fields}


def opening_params(fields: Mapping[str, Any]) -> dict[str, Any]:
    """The same of fields of a problem, of which gap and load may be missing: steps of a session bring them."""
    given = {name: value for name, value in fields.items() if value is not None}
    params = {"grid": plain(given["grid"]), **_influence_params(given)}
    if "gap" in given:
        params["gap"] = gap_params(given["gap"])
    params.update({name: given[name] for name in ("approach", "Fn", "model") if name in given})
    if "friction" in given:
        params["friction"] = given["friction"].params()
    if settings := {name: plain(given[name]) for name in ("normal", "tangential", "outer") if name in given}:
        params["settings"] = settings
    params.update({name: traction_params(given[name], name) for name in ("initial", "previous") if name in given})
    if given.get("derivatives"):
        params["derivatives"] = True
    if "columns" in given:
        params["columns"] = given["columns"].params()
    return params


def gap_params(gap: Paraboloid | SemiAxes | npt.ArrayLike) -> dict[str, Any]:
    """`gap` of contact.solve."""
    if isinstance(gap, Paraboloid):
        return {"paraboloid": plain(gap)}
    if isinstance(gap, SemiAxes):
        return {"semi_axes": plain(gap)}
    return {"array": array_of(gap)}


def coefficient_params(ics: Ics | TableIcs, grid: Grid) -> dict[str, Any]:
    """`ics` of contact.solve, of both bodies or of one."""
    if not isinstance(ics, TableIcs):
        return ics_params(ics)
    ny, nx = grid.shape
    return {"source": "table", "table": ics.array[:, :, :ny, :nx], "dx": ics.dx, "dy": ics.dy}


def _influence_params(given: Mapping[str, Any]) -> dict[str, Any]:
    grid, ics = given["grid"], given.get("ics", AnalyticIcs())
    own = {body: given.get(f"{body}_ics") for body in ("upper", "lower")}
    is_full = given.get("model", "full") == "full"
    if isinstance(ics, TableIcs) and is_full and not any(own.values()):
        return {"ics": coefficient_params(ics, grid)}
    bodies = {name: given[name] for name in ("upper", "lower") if name in given}
    if own["lower"] is not None and "lower" not in bodies and "upper" in bodies:
        bodies["lower"] = bodies["upper"]
    params: dict[str, Any] = {}
    if bodies:
        params["bodies"] = {name: body_params(body, own[name], grid, ics) for name, body in bodies.items()}
    if not isinstance(ics, TableIcs) or (is_full and any(own.values())):
        params["ics"] = coefficient_params(ics, grid)
    return params


def traction_params(tractions: Estimate | ContactSolution, field: str) -> dict[str, Any]:
    """The arrays of `previous`, `initial` and contact.subsurface that are there; of a solution all must be."""
    arrays = {name: getattr(tractions, name) for name in ("pressure", "traction_x", "traction_y")}
    missing = [name for name, array in arrays.items() if array is None]
    if missing and not isinstance(tractions, Estimate):
        raise TypeError(
            f"{field} has no {', '.join(missing)}: name them in `fields` when you ask for it, or make an Estimate, in "
            "which they are zero"
        )
    return {name: array_of(array) for name, array in arrays.items() if array is not None}
