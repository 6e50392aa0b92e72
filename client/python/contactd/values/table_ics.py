"""Influence coefficients that the caller brings along instead of asking the daemon for them."""

from __future__ import annotations

import math
import os
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from ..errors import TableFileError
from ..files.contact_text import format_text, parse_text
from ..files.whole import MOST_BYTES, read_whole
from ..transport.frames import array_of, whole
from .representation import Rows, Shown

if TYPE_CHECKING:
    from .grid import Array
    from .materials import LayeredBody, Material
    from .tables import IcTable

__all__ = ["TableIcs", "check_finite", "combined_modulus"]

_AXES = "xyz"
#: What to do with the table of a prism.
_IMPORT = (
    "export it where it was built (export_ic) and give the file to the daemon that solves (import_ic), where FemIcs with its "
    "section asks for it"
)
#: Largest relative difference of element sizes that counts as rounding.
_SIZE_TOLERANCE = 1e-6


def combined_modulus(upper: Material | LayeredBody, lower: Material | LayeredBody | None = None) -> float:
    """The modulus that CONTACT multiplies the coefficients of a pair by: 1/G = (1/G_upper + 1/G_lower)/2 (N/mm^2)."""
    if lower is None or lower.G == upper.G:
        return upper.G
    return 2 / (1 / upper.G + 1 / lower.G)


def check_finite(array: Array) -> None:
    """Raises ValueError naming the first coefficient that is no finite number."""
    for at in np.argwhere(~np.isfinite(array))[:1]:
        i, j, *rows, k = at
        place = f"the offset ({k}, {rows[0]})" if len(rows) == 1 else f"the columns {rows[0]} and {rows[1]}, offset {k}"
        raise ValueError(f"array holds {array[tuple(at)]} for {_AXES[i] + _AXES[j]} at {place}; every coefficient must be finite")


def _require_offsets(table: IcTable) -> None:
    if table.frames is not None:
        raise ValueError(f"the table is a prism's, of columns instead of offsets; {_IMPORT}")


@dataclass(frozen=True, eq=False, repr=False)
class TableIcs(Shown):
    """A table of influence coefficients of a pair of bodies, for `ContactProblem.ics`; materials are not needed then. Or of one
    body, for `upper_ics` or `lower_ics`: then `array` is as that of an IcTable (see `of_body`).

    `array[i, j, l, k]` (mm^3/N) is the difference (upper less lower body) of the displacements along axis i at an element
    whose offset from the loaded element is (k dx, l dy), for unit tractions along axis j, positive on the upper body;
    axes x, y, z with z from the lower to the upper body. For bodies whose own tables (IcTable) are U and L this is L + U,
    but L - U for xz, zx, yz and zy. Offsets start at 0; at least as many as the grid has elements are needed.

    Where xz, zx, yz and zy are below 1e-6 of zz at the origin they are taken for rounding; larger ones couple normal and
    tangential contact.

    Attributes:
        array: Shape [3, 3, ny, nx].
        dx: Element size along x that the table is for (mm); that of the grid, to 1e-6.
        dy: Element size along y (mm).
        G: Combined_modulus of the bodies (N/mm^2): for writing CONTACT's text only.
    """

    array: Array
    dx: float
    dy: float
    G: float | None = None

    def __post_init__(self) -> None:
        array = np.asarray(whole(array_of(self.array), "array"), dtype=np.float64)
        if array.ndim == 5:
            raise ValueError(f"array has shape {list(array.shape)}, that of a prism's columns; {_IMPORT}")
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

    @property
    def shape(self) -> tuple[int, int]:
        """Extent (ny, nx) of the offsets."""
        return (self.array.shape[2], self.array.shape[3])

    def __getitem__(self, component: str) -> Array:
        """One component, shape [ny, nx]: ``ics["zx"]`` is the displacement along z for a load along x."""
        if len(component) != 2 or not set(component) <= set(_AXES):
            raise KeyError(f"{component!r} is no component; one is two of the letters x, y and z.")
        part: Array = self.array[_AXES.index(component[0]), _AXES.index(component[1])]
        return part

    @classmethod
    def from_table(cls, upper: IcTable, lower: IcTable | None = None) -> TableIcs:
        """The pair of two bodies with these tables; two equal ones when `lower` is left out.

        Where the extents differ the smaller one counts.
        """
        lower = upper if lower is None else lower
        for table in (upper, lower):
            _require_offsets(table)
        grid, other = upper.spec.grid, lower.spec.grid
        for name in ("dx", "dy"):
            size, of_other = getattr(grid, name), getattr(other, name)
            if abs(size - of_other) > _SIZE_TOLERANCE * size:
                raise ValueError(f"the tables have different {name}, {size} and {of_other}; a pair must have the same")
        ny = min(upper.array.shape[2], lower.array.shape[2])
        nx = min(upper.array.shape[3], lower.array.shape[3])
        array = lower.array[:, :, :ny, :nx] + upper.array[:, :, :ny, :nx]
        for i, j in ((0, 2), (2, 0), (1, 2), (2, 1)):
            array[i, j] = lower.array[i, j, :ny, :nx] - upper.array[i, j, :ny, :nx]
        return cls(array, grid.dx, grid.dy, combined_modulus(upper.spec.material, lower.spec.material))

    @classmethod
    def of_body(cls, table: IcTable) -> TableIcs:
        """One body with this table, for `ContactProblem.upper_ics` or `lower_ics`."""
        _require_offsets(table)
        return cls(table.array, table.spec.grid.dx, table.spec.grid.dy)

    @classmethod
    def from_contact_text(
        cls, path: str | os.PathLike[str], G: float | None = None, *, tolerance: float = 1e-6
    ) -> TableIcs:
        """Reads the text in which the CONTACT program takes numerical influence coefficients.

        `G` is the combined modulus of CONTACT's two materials (N/mm^2), by which the values are multiplied; texts of
        contactd tell it themselves. What contradicts the symmetry of the bodies in y by more than `tolerance` (of the
        largest coefficient) is refused. Raises TableFileError naming the line.
        """
        try:
            array, dx, dy, modulus = parse_text(read_whole(path, MOST_BYTES).decode("ascii", "replace"), G, tolerance)
        except TableFileError as error:
            raise TableFileError(f"{os.fspath(path)}, {error}") from None
        return cls(array, dx, dy, modulus)

    def to_contact_text(self, G: float | None = None) -> str:
        """That text, in 17 digits: what is read back differs by the rounding of the product with G. `G` as there."""
        modulus = self.G if G is None else G
        if modulus is None:
            raise ValueError("G is None; CONTACT's text holds coefficients times the combined modulus of the bodies")
        return format_text(self.array, self.dx, self.dy, modulus)
