"""Defines tables of influence coefficients: those of a body, returned by the daemon, and those that the caller
provides. Arrays are read-only.
"""

from __future__ import annotations

import math
import os
from collections.abc import Iterable
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np
import numpy.typing as npt

from ..refusals import public
from .arrays import Array, array_of
from .dictionaries import HasDict
from .generated.evidence import IcEvidence
from .generated.fem_ics import FemIcs
from .generated.grid import Grid
from .generated.ics import Ics
from .generated.materials import LayeredBody, Material
from .params import whole
from .products import displacements_by
from .registry import extra
from .representation import Rows, Shown, number

if TYPE_CHECKING:
    import xarray
    from matplotlib.axes import Axes
    from scipy.sparse.linalg import LinearOperator

__all__ = ["IcSpec", "IcTable", "TableIcs", "check_finite", "combined_modulus"]

_AXES = "xyz"
#: Advice for the table of a longitudinally uniform body.
_IMPORT = (
    "export it where it was built (export_ic), import the file into the daemon that solves (import_ic), and request it there by FemIcs with its " "section"
)
#: Largest relative difference of element sizes that counts as rounding.
_SIZE_TOLERANCE = 1e-6


@dataclass(frozen=True)
class IcSpec:
    """A request for a table with its defaults filled in.

    Attributes:
        material: The body.
        grid: Offsets and element size; its position has no effect.
        ics: Closed form or finite elements, with every option.
    """

    material: Material | LayeredBody
    grid: Grid
    ics: Ics

    @staticmethod
    def of_wire(spec: dict[str, Any]) -> dict[str, Any]:
        """Reads the spec; layers, which are part of `ics` on the wire, become the material."""
        ics = spec.get("ics")
        if not isinstance(ics, dict) or "layers" not in ics:
            return spec
        return {**spec, "material": {name: ics[name] for name in ("body", "layers", "base") if name in ics}}


@dataclass(frozen=True, eq=False, repr=False)
class IcTable(HasDict, Shown):
    """Influence coefficients of one body.

    `array[i, j, l, k]` (mm^3/N) is the displacement along axis i at an element whose offset from the loaded element is
    (k dx, l dy), for a unit traction along axis j; axes are x, y, z, and z is the outward normal. Negative offsets
    follow from symmetry: xx, yy, zz are even in both, xy, yx odd in both, xz, zx odd in x, yz, zy odd in y.

    Attributes:
        key: Equal for every shear modulus, element size and extent of the same dimensionless problem; "" of a file .h5.
        origin: "closed_form", "memory", "disk" or "built"; "file" when load_table read it.
        spec: The request, with its defaults filled in.
        array: Shape [3, 3, ny, nx] (mm^3/N); of a longitudinally uniform body [3, 3, ny, ny, nx]: `array[i, j, I, J, k]`
            is the displacement of column I, k elements ahead of a loaded one of column J, axes x, along the outline, and
            outward of each.
        evidence: Its origin and its accuracy.
        frames: Of a longitudinally uniform body, shape [ny, 3]: y and z of the middle of each column (mm), z up, and the
            angle of its outward normal from +z towards +y (rad).
    """

    key: str
    origin: str
    spec: IcSpec
    array: Array
    evidence: IcEvidence
    frames: Array | None = None

    def _title(self) -> str:
        return f"IcTable of {self.spec.grid.nx} x {self.spec.grid.ny} offsets"

    def _rows(self) -> Rows:
        material, grid, ics = self.spec.material, self.spec.grid, self.spec.ics
        if isinstance(material, LayeredBody):
            rows: Rows = [("layers", len(material.layers))]
        else:
            rows = [("G", material.G), ("nu", material.nu)]
        rows += [("dx", grid.dx), ("dy", grid.dy)]
        rows.append(("source", _recipe(ics)))
        rows += [("origin", self.origin), ("zz at the origin", float(self["zz"].flat[0]))]
        if (section := self.evidence.section) is not None:
            rows.append(("largest error, of zz at the origin", f"{section.error:.2g}"))
        if (errors := self.evidence.errors) is not None:
            name = "largest error of zz, estimated" if self.evidence.errors_estimated else "largest error of zz"
            rows.append((name, f"{errors.zz.largest:.2g}"))
        if self.evidence.modelling_error is not None:
            rows.append(("modelling error, off the middle", f"{self.evidence.modelling_error:.2g}"))
        return rows

    def _remarks(self) -> tuple[str, ...]:
        return self.evidence.warnings

    @public
    def apply(self, tractions: npt.ArrayLike) -> Array:
        """Returns the displacements of the surface of this body under tractions on elements of the table's size (mm)::

            table = client.get_ic(steel, grid, AnalyticIcs())
            inward = table.apply(pressure)

        Pressures (N/mm^2), shape [ny, nx], give displacements into the body, > 0 under pressures: the component zz.
        Tractions [3, ny, nx] along x, y and the outward normal give displacements along the same axes. Any shape up to
        the extent of the table is allowed. For a longitudinally uniform body, rows are its columns. The FFT is exact to
        rounding. Raises InvalidArgument for other shapes, and for values that are not finite.
        """
        return displacements_by(self.array, tractions)

    @public
    def operator(self, ny: int | None = None, nx: int | None = None, *, tractions: bool = False) -> LinearOperator:
        """Returns `apply` as a scipy linear operator on ny x nx elements (None: the extent of the table). It is
        symmetric and positive definite, and maps pressures to displacements into the body, both flattened row by row.
        With `tractions` it maps [3, ny, nx] to [3, ny, nx]. Operators of two bodies can be added. Needs scipy
        ("contactd[fit]").
        """
        made: LinearOperator = extra("IcTable.operator")(self, ny, nx, tractions)
        return made

    @public
    def plot(self, components: Iterable[str] = ("xx", "yy", "zz", "xz"), axes: Axes | None = None) -> Axes:
        """Plots the sizes of the components against the distance from the load, along x and along y, on a logarithmic
        scale.

        Draws into `axes` or a new figure, and returns the axes. Needs matplotlib ("contactd[pictures]").
        """
        drawn: Axes = extra("IcTable.plot")(self, components, axes)
        return drawn

    @public
    def to_xarray(self) -> xarray.DataArray:
        """Returns the table against displacement, load and offsets (mm): ``table.to_xarray().sel(displacement="x",
        load="z")``.

        Needs xarray ("contactd[xarray]").
        """
        dataset: xarray.DataArray = extra("IcTable.to_xarray")(self)
        return dataset

    def __getitem__(self, component: str) -> Array:
        """Returns one component, shape [ny, nx]: ``table["xz"]`` is the displacement along x for a load along z."""
        if len(component) != 2 or not set(component) <= set(_AXES):
            raise KeyError(f"{component!r} is not a component; give two of the letters x, y and z.")
        part: Array = self.array[_AXES.index(component[0]), _AXES.index(component[1])]
        return part


def _recipe(ics: Ics) -> str:
    """Describes finite elements by their main options."""
    if not isinstance(ics, FemIcs):
        return "closed form"
    names = ("preset", "accuracy", "body", "mesh", "order", "L_over_h")
    given = [f"{name} {number(value)}" for name in names if (value := getattr(ics, name)) is not None]
    return " ".join(["finite elements,", *given]) if given else "finite elements"


def combined_modulus(upper: Material | LayeredBody, lower: Material | LayeredBody | None = None) -> float:
    """Returns the modulus by which CONTACT multiplies the coefficients of a pair: 1/G = (1/G_upper + 1/G_lower)/2
    (N/mm^2).
    """
    if lower is None or lower.G == upper.G:
        return upper.G
    return 2 / (1 / upper.G + 1 / lower.G)


def check_finite(array: Array) -> None:
    """Raises ValueError naming the first coefficient that is not finite."""
    for at in np.argwhere(~np.isfinite(array))[:1]:
        i, j, *rows, k = at
        place = f"the offset ({k}, {rows[0]})" if len(rows) == 1 else f"the columns {rows[0]} and {rows[1]}, offset {k}"
        raise ValueError(f"array contains {array[tuple(at)]} for {_AXES[i] + _AXES[j]} at {place}; every coefficient must be finite")


def _require_offsets(table: IcTable) -> None:
    if table.frames is not None:
        raise ValueError(f"the table is that of a longitudinally uniform body, with columns instead of offsets; {_IMPORT}")


@public
@dataclass(frozen=True, eq=False, repr=False)
class TableIcs(Shown):
    """A table of influence coefficients of a pair of bodies, for `ContactProblem.ics`, which makes materials
    unnecessary. A table for `upper_ics` or `lower_ics` is that of one body, and its `array` is that of an IcTable (see
    `of_body`).

    `array[i, j, l, k]` (mm^3/N) is the difference (upper minus lower body) of the displacements along axis i at an
    element whose offset from the loaded element is (k dx, l dy), for unit tractions along axis j, positive on the upper
    body; axes x, y, z with z from the lower to the upper body. For bodies with the tables (IcTable) U and L, this is L
    + U, but L - U for xz, zx, yz and zy. Offsets start at 0. Each axis needs at least as many as the grid has elements.

    Components xz, zx, yz and zy below 1e-6 of zz at the origin are treated as rounding errors. Larger ones couple
    normal and tangential contact.

    Attributes:
        array: Shape [3, 3, ny, nx].
        dx: Element size of the table along x (mm), equal to that of the grid to 1e-6.
        dy: Element size along y (mm).
        G: Combined modulus of the bodies (N/mm^2), only for writing CONTACT's text.
    """

    array: Array
    dx: float
    dy: float
    G: float | None = None

    def __post_init__(self) -> None:
        array = np.asarray(whole(array_of(self.array), "array"), dtype=np.float64)
        if array.ndim == 5:
            raise ValueError(f"array has shape {list(array.shape)}, that of the columns of a longitudinally uniform body; {_IMPORT}")
        if array.ndim != 4 or array.shape[:2] != (3, 3) or 0 in array.shape:
            raise ValueError(f"array has shape {list(array.shape)}; it must be [3, 3, ny, nx]")
        for name, size in (("dx", self.dx), ("dy", self.dy), ("G", 1.0 if self.G is None else self.G)):
            if not (math.isfinite(size) and size > 0):
                raise ValueError(f"{name} is {size}; it must be positive and finite")
        check_finite(array)
        object.__setattr__(self, "array", array)

    def _title(self) -> str:
        return f"TableIcs of {self.shape[1]} x {self.shape[0]} offsets"

    def _rows(self) -> Rows:
        rows: Rows = [("dx", self.dx), ("dy", self.dy), ("zz at the origin", float(self["zz"][0, 0]))]
        return rows if self.G is None else [("G", self.G), *rows]

    @public
    def apply(self, tractions: npt.ArrayLike) -> Array:
        """Differences of displacements, upper less lower body, under tractions on the upper one; of a table of one body as
        IcTable.apply (mm).

        Pressures (N/mm^2), shape [ny, nx], give by how much both surfaces yield, > 0 under pressure: the component zz.
        Tractions [3, ny, nx] along x, y and z give differences along these axes. Any shape up to that of the table is
        allowed.
        """
        return displacements_by(self.array, tractions)

    @property
    def shape(self) -> tuple[int, int]:
        """Extent (ny, nx) of the offsets."""
        return (self.array.shape[2], self.array.shape[3])

    def __getitem__(self, component: str) -> Array:
        """Returns one component, shape [ny, nx]: ``ics["zx"]`` is the displacement along z for a load along x."""
        if len(component) != 2 or not set(component) <= set(_AXES):
            raise KeyError(f"{component!r} is not a component; give two of the letters x, y and z.")
        part: Array = self.array[_AXES.index(component[0]), _AXES.index(component[1])]
        return part

    @classmethod
    @public
    def from_table(cls, upper: IcTable, lower: IcTable | None = None) -> TableIcs:
        """Returns the table of the pair of two bodies; without `lower`, of two equal bodies.

        If the extents differ, uses the smaller one.
        """
        lower = upper if lower is None else lower
        for table in (upper, lower):
            _require_offsets(table)
        grid, other = upper.spec.grid, lower.spec.grid
        for name in ("dx", "dy"):
            size, of_other = getattr(grid, name), getattr(other, name)
            if abs(size - of_other) > _SIZE_TOLERANCE * size:
                raise ValueError(f"the tables have different {name}, {size} and {of_other}; both tables of a pair must have the same")
        ny = min(upper.array.shape[2], lower.array.shape[2])
        nx = min(upper.array.shape[3], lower.array.shape[3])
        array = lower.array[:, :, :ny, :nx] + upper.array[:, :, :ny, :nx]
        for i, j in ((0, 2), (2, 0), (1, 2), (2, 1)):
            array[i, j] = lower.array[i, j, :ny, :nx] - upper.array[i, j, :ny, :nx]
        return cls(array, grid.dx, grid.dy, combined_modulus(upper.spec.material, lower.spec.material))

    @classmethod
    @public
    def of_body(cls, table: IcTable) -> TableIcs:
        """Returns the table of one body, for `ContactProblem.upper_ics` or `lower_ics`."""
        _require_offsets(table)
        return cls(table.array, table.spec.grid.dx, table.spec.grid.dy)

    @classmethod
    @public
    def from_contact_text(
        cls, path: str | os.PathLike[str], G: float | None = None, *, tolerance: float = 1e-6
    ) -> TableIcs:
        """Reads numerical influence coefficients from the text format of the CONTACT program.

        `G` is the combined modulus of CONTACT's two materials (N/mm^2), by which the values are multiplied; texts
        written by contactd contain it. Values that violate the symmetry in y by more than `tolerance` (relative to the
        largest coefficient) are refused. Raises TableFileError naming the line.
        """
        return cls(*extra("TableIcs.from_contact_text")(path, G, tolerance))

    @public
    def to_contact_text(self, G: float | None = None) -> str:
        """Returns that text with 17 digits: values read back differ only by rounding of the product with G. For `G` see
        from_contact_text.
        """
        modulus = self.G if G is None else G
        if modulus is None:
            raise ValueError("G is None; CONTACT's text contains coefficients times the combined modulus of the bodies")
        text: str = extra("TableIcs.to_contact_text")(self.array, self.dx, self.dy, modulus)
        return text
