"""Tables of influence coefficients as they are answered, and the evidence for them. Arrays are read-only."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any

from .dictionaries import HasDict
from .grid import Array, Grid
from .ics import FemIcs, Ics
from .materials import LayeredBody, Material
from .representation import Rows, Shown, number

if TYPE_CHECKING:
    import xarray
    from matplotlib.axes import Axes

__all__ = [
    "ComponentError",
    "IcErrors",
    "IcEvidence",
    "IcSpec",
    "IcTable",
    "LoadCase",
    "SectionEvidence",
]


@dataclass(frozen=True)
class LoadCase:
    """One solve of the finite-element problem.

    Attributes:
        load: Direction of the load: "x", "y" or "z".
        iterations: Of the linear solver.
        residual: True relative residual ||b - A u|| / ||b||.
        converged: Whether the stop test was met.
        seconds: Time spent (s).
        update: Relative update of the last iteration, where that is the stop test.
    """

    load: str
    iterations: int
    residual: float
    converged: bool
    seconds: float
    update: float | None = None


@dataclass(frozen=True)
class ComponentError:
    """Relative error: signed at the origin (paper, (3.1)), and the largest size over the table.

    Attributes:
        origin: Signed, at the origin.
        largest: Largest size over the table.
    """

    origin: float
    largest: float


@dataclass(frozen=True)
class IcErrors:
    """Errors against the closed form, or estimated ones (IcEvidence.errors_estimated).

    xy and xz vanish on the axes, so theirs are scaled by 2 pi G rho / (dx dy).

    Attributes:
        xx: Relative errors of xx.
        yy: Relative errors of yy.
        zz: Relative errors of zz.
        scaled_xy: Largest scaled error of xy over the table.
        scaled_xz: Largest scaled error of xz over the table.
    """

    xx: ComponentError
    yy: ComponentError
    zz: ComponentError
    scaled_xy: float
    scaled_xz: float


@dataclass(frozen=True)
class SectionEvidence:
    """How the transform of a prism's coefficients was computed.

    Errors are over zz of the half-space under an element as long as a column is wide.

    Attributes:
        order: Of the elements.
        wavenumbers: How many it was computed at.
        error: Of any coefficient: the sum of the three below.
        mesh_error: Of the mesh, from elements of the next order.
        wavenumber_error: Of interpolation between wavenumbers.
        end_error: Of what lies beyond the last wavenumber.
        reciprocity_defect: Of coefficients before they were made symmetric.
    """

    order: int
    wavenumbers: int
    error: float
    mesh_error: float
    wavenumber_error: float
    end_error: float
    reciprocity_defect: float


@dataclass(frozen=True)
class IcEvidence:
    """How a table was made. A closed-form one has no elements, no solves and no errors.

    Read `warnings` first. `errors` is None where nothing is known of them: of a block on a mesh that was named.

    Attributes:
        source: "analytic" or "fem".
        version: Of the contactd that made it.
        elements: Of the mesh.
        dofs: Unknowns of the finite-element problem.
        processes: MPI processes that built it.
        seconds: Time spent (s) on "assembly", "setup", "solve" and "total".
        load_cases: The solves, by direction of the load.
        errors: Of its components, where known.
        errors_estimated: Of a block, by half of the difference to a coarser mesh.
        warnings: Sentences, e.g. that the mesh is outside of the ranges the paper recommends.
        solver: "amg_pcg", "direct" or, of a block of an accuracy, "tensor_pcg".
        mesh: What was chosen for an accuracy; not of a block.
        family_nu: Of a family: Poisson's ratios of its tables.
        interpolation_error: Of a family: what interpolation between them adds at most, estimated.
        section: Of a prism by finite elements.
        modelling_error: Of a block: how far a load in the corner of the elements is from the table, which is that of one
            in the middle; in the measures of `FemIcs.accuracy`.
        imported: Somebody has imported the table: all of this is the importer's word.
    """

    source: str
    version: str = ""
    elements: int = 0
    dofs: int = 0
    processes: int = 0
    seconds: Mapping[str, float] = field(default_factory=dict)
    load_cases: tuple[LoadCase, ...] = ()
    errors: IcErrors | None = None
    errors_estimated: bool = False
    warnings: tuple[str, ...] = ()
    solver: str | None = None
    mesh: FemIcs | None = None
    family_nu: tuple[float, ...] = ()
    interpolation_error: float | None = None
    section: SectionEvidence | None = None
    modelling_error: float | None = None
    imported: bool = False


@dataclass(frozen=True)
class IcSpec:
    """A request for a table with its defaults filled in.

    Attributes:
        material: The body.
        grid: Offsets and element size; where it lies does not matter.
        ics: Closed form or finite elements, with every option.
    """

    material: Material | LayeredBody
    grid: Grid
    ics: Ics

    @staticmethod
    def of_wire(spec: dict[str, Any]) -> dict[str, Any]:
        """With the layers, which stand in `ics` there, in place of the material."""
        ics = spec.get("ics")
        if not isinstance(ics, dict) or "layers" not in ics:
            return spec
        return {**spec, "material": {name: ics[name] for name in ("layers", "base") if name in ics}}


_AXES = "xyz"


@dataclass(frozen=True, eq=False, repr=False)
class IcTable(HasDict, Shown):
    """Influence coefficients of one body.

    `array[i, j, l, k]` (mm^3/N) is the displacement along axis i at an element whose offset from the loaded element is
    (k dx, l dy), for a unit traction along axis j; axes are x, y, z, and z is the outward normal. Negative offsets
    follow from symmetry: xx, yy, zz are even in both, xy, yx odd in both, xz, zx odd in x, yz, zy odd in y.

    Attributes:
        key: Equal for every shear modulus, element size and extent of the same dimensionless problem; "" of a file .h5.
        origin: "closed_form", "memory", "disk" or "built"; "file" when load_table read it.
        spec: What was asked for, defaults filled in.
        array: Shape [3, 3, ny, nx] (mm^3/N); of a prism [3, 3, ny, ny, nx]: `array[i, j, I, J, k]` is the displacement of
            column I, k elements ahead of a loaded one of column J, axes x, along the outline, and outward of each.
        evidence: How it was made, and how good it is.
        frames: Of a prism, shape [ny, 3]: y and z of the middle of each column (mm), z up, and the angle of its outward
            normal from +z towards +y (rad).
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

    def plot(self, components: Iterable[str] = ("xx", "yy", "zz", "xz"), axes: Axes | None = None) -> Axes:
        """Draws sizes of the components over the distance from the load, along x and along y, on a logarithmic scale.

        Into `axes`, or a figure of its own; returns the axes. Needs matplotlib ("contactd[pictures]").
        """
        from ..pictures.tables import draw_table

        return draw_table(self, components, axes)

    def to_xarray(self) -> xarray.DataArray:
        """The table over displacement, load and offsets (mm), as ``table.to_xarray().sel(displacement="x", load="z")``.

        Needs xarray ("contactd[xarray]").
        """
        from ..xarray_datasets import labelled_table

        return labelled_table(self)

    def __getitem__(self, component: str) -> Array:
        """One component, shape [ny, nx]: ``table["xz"]`` is the displacement along x for a load along z."""
        if len(component) != 2 or not set(component) <= set(_AXES):
            raise KeyError(f"{component!r} is no component; one is two of the letters x, y and z.")
        part: Array = self.array[_AXES.index(component[0]), _AXES.index(component[1])]
        return part


def _recipe(ics: Ics) -> str:
    """Finite elements by their most telling options."""
    if not isinstance(ics, FemIcs):
        return "closed form"
    names = ("preset", "accuracy", "body", "mesh", "order", "L_over_h")
    given = [f"{name} {number(value)}" for name in names if (value := getattr(ics, name)) is not None]
    return " ".join(["finite elements,", *given]) if given else "finite elements"
