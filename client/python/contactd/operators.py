"""Wraps tables of influence coefficients as scipy linear operators."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from .errors import MissingExtra, invalid
from .refusals import public
from .transport.shared_client import shared_client
from .values.generated.fem_ics import FemIcs
from .values.generated.grid import Grid
from .values.generated.ics import AnalyticIcs
from .values.generated.materials import LayeredBody, Material
from .values.products import displacements_by, transposed
from .values.tables import IcTable

if TYPE_CHECKING:
    from scipy.sparse.linalg import LinearOperator

__all__ = ["linear_operator", "operator"]


@public
def operator(
    material: Material | LayeredBody,
    grid: Grid,
    ics: AnalyticIcs | FemIcs | None = None,
    *,
    tractions: bool = False,
    timeout: float | None = None,
) -> LinearOperator:
    """Returns the displacements of one body's surface under pressures as a scipy.sparse.linalg.LinearOperator, using
    the default client::

        K = contactd.operator(steel, Grid.centred(40, 40, 2, 2))
        inward = K @ pressure.ravel()  # mm, from N/mm^2, row by row
        pair = K + contactd.operator(aluminium, grid)

    The operator has shape (n, n), n = nx ny, and is symmetric and positive definite. With `tractions` it has shape (3n,
    3n): it maps tractions along x, y and the outward normal, [3, ny, nx], to displacements along these axes. `ics` are
    the coefficients; if None, those of the half-space in closed form. Products use FFTs. Needs scipy ("contactd[fit]").
    """
    _scipy()
    table: IcTable = shared_client().get_ic(material, grid, AnalyticIcs() if ics is None else ics, timeout=timeout)
    return linear_operator(table, None, None, tractions)


def linear_operator(table: IcTable, ny: int | None, nx: int | None, tractions: bool) -> LinearOperator:
    """Implements IcTable.operator."""
    most = table.array.shape[-2:]
    shape = (most[0] if ny is None else ny, most[1] if nx is None else nx)
    if not all(0 < size <= there for size, there in zip(shape, most)) or (table.frames is not None and shape[0] != most[0]):
        raise invalid("shape", f"is {list(shape)}; the table has {list(most)} offsets", "ARRAY_INVALID")
    whole = (3, *shape) if tractions else shape
    size = int(np.prod(whole))
    adjoint = transposed(table.array)

    def product(vector: Any) -> Any:
        return displacements_by(table.array, np.reshape(vector, whole)).ravel()

    def adjoint_product(vector: Any) -> Any:
        return displacements_by(adjoint, np.reshape(vector, whole)).ravel()

    made: LinearOperator = _scipy().LinearOperator((size, size), matvec=product, rmatvec=adjoint_product, dtype=np.float64)
    return made


def _scipy() -> Any:
    try:
        import scipy.sparse.linalg as linalg
    except ImportError:
        raise MissingExtra("A linear operator", "scipy", "fit", "python3-scipy") from None
    return linalg
