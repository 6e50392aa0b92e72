"""What is asked: materials, grids, influence coefficients and contact problems as plain, immutable values.

Any consistent system of units works; the docstrings name N and mm. Ranges are the daemon's business: a value it cannot
use comes back as InvalidArgument naming the field.
"""

from __future__ import annotations

from dataclasses import dataclass, fields, replace
from typing import TYPE_CHECKING, Any, Literal

import numpy as np
import numpy.typing as npt

if TYPE_CHECKING:
    from .solution import ContactSolution

__all__ = [
    "AnalyticIcs",
    "ContactProblem",
    "Estimate",
    "FemIcs",
    "Friction",
    "Grid",
    "Ics",
    "Material",
    "Paraboloid",
    "SolverSettings",
]

Array = npt.NDArray[np.float64]


@dataclass(frozen=True)
class Material:
    """A homogeneous, isotropic, linearly elastic material."""

    G: float  #: shear modulus (N/mm^2), > 0
    nu: float  #: Poisson's ratio, 0 to 0.5; 0.5 itself only with closed-form influence coefficients


@dataclass(frozen=True)
class Grid:
    """The potential contact area: `nx` x `ny` elements of size `dx` x `dy` (mm), unknowns at their centres.

    `x0`, `y0` are the lower left corner (mm); left out, the area is centred on the origin.
    Arrays over the grid have shape `[ny, nx]`: the first index counts along y.
    """

    nx: int
    ny: int
    dx: float
    dy: float
    x0: float | None = None
    y0: float | None = None

    @classmethod
    def centred(cls, nx: int, ny: int, width: float, height: float) -> Grid:
        """Elements that divide a `width` x `height` rectangle (mm) around the origin."""
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


@dataclass(frozen=True)
class AnalyticIcs:
    """Influence coefficients of the elastic half-space in closed form."""

    body: str | None = None
    load_shape: str | None = None


@dataclass(frozen=True)
class FemIcs:
    """Influence coefficients computed with finite elements; what is None takes the preset's or the daemon's default.

    Lengths are ratios to the element size h of the grid (paper, Table 2): a table serves every element size.
    """

    preset: str | None = None  #: "paper-test1", "paper-test2" or "paper-test3"; named fields win over it
    L_over_h: float | None = None  #: size of the block
    l_over_h: float | None = None  #: size of the uniform cube below the load
    h_over_hs: float | None = None  #: elements of the cube per element of the grid, even; l/h times it is whole
    f: float | None = None  #: growth of the layers outside the cube, >= 1
    order: int | None = None  #: polynomial order of the displacement, 1 or 2
    mesh: str | None = None  #: "hex": the paper's Mesh1
    far_boundary: str | None = None  #: "clamped": u = 0
    sampling: str | None = None  #: "fem", "linear" or "linear_nodes": how displacements are read at the element centres
    tolerance: float | None = None  #: true relative residual of each solve
    max_iterations: int | None = None  #: of conjugate gradients, per load case
    strength_threshold: float | None = None  #: of BoomerAMG
    body: str | None = None
    load_shape: str | None = None


Ics = AnalyticIcs | FemIcs


@dataclass(frozen=True)
class Paraboloid:
    """Undeformed distance h = x^2/(2 Rx) + y^2/(2 Ry), without the approach. Radii in mm; None is a flat direction
    (not both), negative a concave one."""

    Rx: float | None = None
    Ry: float | None = None


@dataclass(frozen=True)
class Friction:
    """Coulomb friction in a shift problem: the slip is the elastic displacement plus the rigid shift."""

    mu: float  #: coefficient of friction, >= 0
    rigid_shift: tuple[float, float]  #: (w_x, w_y) of the upper body (mm); the traction on it opposes the slip


@dataclass(frozen=True)
class SolverSettings:
    """Stop test and bound of one iterative solver (paper, sections 4.1 and 4.2)."""

    tolerance: float | None = None  #: the daemon's default is 1e-6
    max_iterations: int | None = None  #: the daemon's default is 1000


@dataclass(frozen=True, eq=False)
class Estimate:
    """Tractions (N/mm^2), each of shape [ny, nx], for the solvers to start from. A ContactSolution serves as well."""

    pressure: Array | None = None
    traction_x: Array | None = None
    traction_y: Array | None = None


@dataclass(frozen=True, eq=False)
class ContactProblem:
    """Normal contact with the approach prescribed; with `friction`, tangential contact too."""

    grid: Grid
    upper: Material
    gap: Paraboloid | npt.ArrayLike  #: undeformed distance without the approach (mm); an array has shape [ny, nx]
    approach: float  #: delta (mm), > 0 in compression; the gap before deformation is h - delta
    lower: Material | None = None  #: None: as the upper body
    ics: Ics = AnalyticIcs()
    friction: Friction | None = None  #: None: frictionless
    normal: SolverSettings | None = None
    tangential: SolverSettings | None = None
    initial: Estimate | ContactSolution | None = None  #: where the solvers start: tractions of a similar problem

    def replace(self, **changes: Any) -> ContactProblem:
        """The same problem with some fields changed."""
        return replace(self, **changes)


def plain(value: Any) -> dict[str, Any]:
    """The fields of a dataclass that are not None, as the wire names them."""
    return {f.name: item for f in fields(value) if (item := getattr(value, f.name)) is not None}


def ics_params(ics: Ics) -> dict[str, Any]:
    """`ics` of ic.get and contact.solve."""
    source: Literal["analytic", "fem"] = "fem" if isinstance(ics, FemIcs) else "analytic"
    return {"source": source, **plain(ics)}


def table_params(material: Material, grid: Grid, ics: Ics) -> dict[str, Any]:
    """The parameters of ic.get; where the grid lies does not matter to a table."""
    extent = {"nx": grid.nx, "ny": grid.ny, "dx": grid.dx, "dy": grid.dy}
    return {"material": plain(material), "grid": extent, "ics": ics_params(ics)}


def problem_params(problem: ContactProblem) -> dict[str, Any]:
    """The parameters of contact.solve."""
    bodies = {"upper": plain(problem.upper)}
    if problem.lower is not None:
        bodies["lower"] = plain(problem.lower)
    params: dict[str, Any] = {
        "grid": plain(problem.grid),
        "bodies": bodies,
        "ics": ics_params(problem.ics),
        "approach": problem.approach,
    }
    if isinstance(problem.gap, Paraboloid):
        params["gap"] = {"paraboloid": plain(problem.gap)}
    else:
        params["gap"] = {"array": np.asarray(problem.gap)}
    if problem.friction is not None:
        params["friction"] = {"mu": problem.friction.mu, "rigid_shift": list(problem.friction.rigid_shift)}
    settings = {name: plain(s) for name in ("normal", "tangential") if (s := getattr(problem, name)) is not None}
    if settings:
        params["settings"] = settings
    if problem.initial is not None:
        names = ("pressure", "traction_x", "traction_y")
        estimates = {name: getattr(problem.initial, name) for name in names}
        params["initial"] = {name: np.asarray(e) for name, e in estimates.items() if e is not None}
    return params
