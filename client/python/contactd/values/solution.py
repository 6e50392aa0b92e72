"""What is answered of a contact, as plain, immutable values.

Arrays are read-only; copy one to change it.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from typing import TYPE_CHECKING, Generic, Literal, TypeVar

import numpy as np
import numpy.typing as npt

from ..refusals import public
from .dictionaries import Saved
from .evidence import ContactEvidence
from .friction import Motion
from .grid import Array, Grid
from .registry import extra
from .representation import Rows, Shown, with_inherited_attributes

if TYPE_CHECKING:
    import xarray
    from matplotlib.axes import Axes

__all__ = [
    "Areas",
    "ContactSolution",
    "Counts",
    "Derivatives",
    "DerivativesOfAnswer",
    "Field",
    "Fields",
    "Forces",
    "Resultant",
    "Solution",
    "names_of",
]


@dataclass(frozen=True)
class DerivativesOfAnswer:
    """Of one answer, by each input: units are those of the answer over those of the input. None is what the problem does
    not have, or its model does not know.

    Attributes:
        xi: Of rolling: by the longitudinal creepage.
        eta: Of rolling: by the lateral creepage.
        phi: Of rolling: by the spin creepage.
        rigid_shift: Of a shift: by that along x, and along y.
        rotation: Of a shift: by its rotation.
        approach: By the approach, where that is prescribed.
        Fn: By the normal force, where that is prescribed.
        mu: By the coefficient of friction: the same change in every element.
    """

    xi: float | None = None
    eta: float | None = None
    phi: float | None = None
    rigid_shift: tuple[float, float] | None = None
    rotation: float | None = None
    approach: float | None = None
    Fn: float | None = None
    mu: float | None = None


@dataclass(frozen=True)
class Derivatives:
    """How the answers follow the inputs, to first order: ``solution.derivatives.Fx.xi`` is dFx/d(xi).

    Held are the undeformed distance (also where semi-axes and the load made it), the tractions before the step,
    rigid_slip, and the division of the elements, at whose next change the derivatives are one-sided. Motion is an input
    also where forces found it: as if it had been given.

    Attributes:
        Fx: Of Fx (N), with friction.
        Fy: Of Fy (N), with friction.
        Mz: Of Mz (N mm), with friction.
        Fn: Of the normal force (N), where the approach is prescribed.
        approach: Of the approach (mm), where the normal force is prescribed.
    """

    Fx: DerivativesOfAnswer | None = None
    Fy: DerivativesOfAnswer | None = None
    Mz: DerivativesOfAnswer | None = None
    Fn: DerivativesOfAnswer | None = None
    approach: DerivativesOfAnswer | None = None


@dataclass(frozen=True)
class Areas:
    """Areas (mm^2): contact = adhesion + slip; without friction all contact counts as slip.

    Attributes:
        contact: Of all elements in contact (mm^2).
        adhesion: Of those in adhesion (mm^2).
        slip: Of those in slip (mm^2).
    """

    contact: float
    adhesion: float
    slip: float


@dataclass(frozen=True)
class Counts:
    """Numbers of elements: contact = adhesion + slip; without friction all contact counts as slip.

    Attributes:
        contact: Of elements in contact.
        adhesion: Of elements in adhesion.
        slip: Of elements in slip.
        border: Of elements in contact at the border of the potential contact area, which should not be; see `warnings`.
    """

    contact: int
    adhesion: int
    slip: int
    border: int


@dataclass(frozen=True)
class Forces:
    """Total force on the upper body (N), and its moment about z.

    Attributes:
        Fn: Normal force (N), > 0 in compression.
        Fx: Tangential force along x (N).
        Fy: Tangential force along y (N).
        Mz: At the origin: sum of x p_y - y p_x over the elements (N mm).
    """

    Fn: float
    Fx: float
    Fy: float
    Mz: float


@dataclass(frozen=True)
class Resultant:
    """Of all pressures and tractions on curved columns, on the upper body, in the axes of the section.

    Attributes:
        Fx: Force along x (N).
        Fy: Force along y (N).
        Fz: Force along z (N).
        Mx: Moment about x through the origin of the columns (N mm).
        My: The same about y.
        Mz: The same about z.
    """

    Fx: float
    Fy: float
    Fz: float
    Mx: float
    My: float
    Mz: float


# What the arrays of a solution are: of a step each may be left out.
Floats = TypeVar("Floats", bound="Array | None")
Bytes = TypeVar("Bytes", bound="npt.NDArray[np.uint8] | None")


@dataclass(frozen=True, eq=False, repr=False, kw_only=True)
class Solution(Saved, Shown, Generic[Floats, Bytes]):
    """What is answered of one contact. Arrays have shape [ny, nx]; tractions and forces act on the upper body.

    Attributes:
        approach: delta (mm), prescribed or found.
        forces: Total force on the upper body; also as Fn, Fx, Fy (N) and Mz (N mm) of the solution.
        pmax: Largest pressure (N/mm^2).
        area: Areas (mm^2) of contact, adhesion and slip.
        elements: Numbers of elements in contact, adhesion and slip.
        element_division: Shape [ny, nx]: 0 exterior, 1 adhesion, 2 slip.
        pressure: Shape [ny, nx] (N/mm^2), >= 0.
        traction_x: Along x on the upper body, shape [ny, nx] (N/mm^2).
        traction_y: Along y on the upper body, shape [ny, nx] (N/mm^2).
        converged: Whether every solver reached its tolerance.
        evidence: How the solvers ended, and where the coefficients came from.
        warnings: Sentences, e.g. that the contact touches the border of the potential contact area, or that elements or
            dq are too large for it.
        slip_x: Along x, slip of the upper body over the lower, zero outside contact: of a shift the distance over the
            step (mm), of rolling the relative slip, per distance rolled. None without friction, like all that follow.
        slip_y: The same along y.
        frictional_work: Of a shift: what friction dissipates in the step (N mm).
        frictional_power: Of rolling: what friction dissipates (N mm/s).
        motion: As asked for, with what a prescribed force made of it.
        derivatives: How forces follow the inputs, where the problem asked for that, and the solution has converged and has
            contact.
        resultant: On curved columns: of all tractions together. None on a plane.
        grid: That of the problem, which the client adds.
    """

    approach: float
    forces: Forces
    pmax: float
    area: Areas
    elements: Counts
    element_division: Bytes
    pressure: Floats
    traction_x: Floats
    traction_y: Floats
    converged: bool
    evidence: ContactEvidence
    warnings: tuple[str, ...] = ()
    slip_x: Array | None = None
    slip_y: Array | None = None
    frictional_work: float | None = None
    frictional_power: float | None = None
    motion: Motion | None = None
    derivatives: Derivatives | None = None
    resultant: Resultant | None = None
    grid: Grid | None = None

    @public
    def plot(self, axes: Axes | None = None) -> Axes:
        """Draws pressures over the grid, the edges of contact and adhesion, and arrows of the tractions on the upper body.

        Into `axes`, or a figure of its own; returns the axes. Needs matplotlib ("contactd[pictures]").
        """
        drawn: Axes = extra("Solution.plot")(self, axes)
        return drawn

    @public
    def plot_section(self, y: float = 0.0, axes: Axes | None = None) -> Axes:
        """Draws pressure and tractions along x, in the row of elements nearest to `y` (mm); else as `plot`."""
        drawn: Axes = extra("Solution.plot_section")(self, y, axes)
        return drawn

    @public
    def to_xarray(self) -> xarray.Dataset:
        """Arrays over x and y, forces, pmax and the approach, with their units. Needs xarray ("contactd[xarray]")."""
        labelled: xarray.Dataset = extra("Solution.to_xarray")(self)
        return labelled

    def _rows(self) -> Rows:
        division = f"{self.elements.contact} elements: {self.elements.adhesion} in adhesion, {self.elements.slip} in slip"
        forces: Rows = [(name, getattr(self, name)) for name in ("Fn", "Fx", "Fy", "Mz")]
        rows: Rows = [*forces, ("pmax", self.pmax), ("approach", self.approach), ("contact", division)]
        if self.motion is not None:
            rows.append(("motion", self.motion))
        return [*rows, ("converged", "yes" if self.converged else "NO")]

    def _remarks(self) -> tuple[str, ...]:
        return self.warnings

    @property
    def Fn(self) -> float:
        """Normal force (N), > 0 in compression."""
        return self.forces.Fn

    @property
    def Fx(self) -> float:
        """Tangential force along x on the upper body (N)."""
        return self.forces.Fx

    @property
    def Fy(self) -> float:
        """Tangential force along y on the upper body (N)."""
        return self.forces.Fy

    @property
    def Mz(self) -> float:
        """Moment of the tractions on the upper body about z at the origin (N mm)."""
        return self.forces.Mz


@with_inherited_attributes
@dataclass(frozen=True, eq=False, repr=False, kw_only=True)
class ContactSolution(Solution[Array, npt.NDArray[np.uint8]]):
    """The solution of a ContactProblem. Arrays have shape [ny, nx]; tractions and forces act on the upper body.

    A solve that did not converge is a solution too: ask `converged`. Read `warnings`. A solution may be `previous` or
    `initial` of the next problem.
    """

    def _title(self) -> str:
        ny, nx = self.pressure.shape
        return f"ContactSolution on {nx} x {ny} elements"


Field = Literal["element_division", "pressure", "traction_x", "traction_y", "slip_x", "slip_y"]


Fields = Iterable[Field] | Field  #: what `fields` of a call may be: names, or the one


def names_of(fields: Fields) -> list[str]:
    """What is no name of an array is the daemon's to refuse."""
    return [fields] if isinstance(fields, str) else list(fields)
