"""Converts answers to xarray objects with names, coordinates and units: ``pip install "contactd[xarray]"``."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from .errors import MissingExtra
from .values.generated.array_labels import ARRAY_LABELS
from .values.generated.grid import Grid
from .values.generated.subsurface import SubsurfaceStress
from .values.solution import ContactSolution
from .values.subsurface_methods import INVARIANTS
from .values.tables import IcTable

if TYPE_CHECKING:
    import xarray

__all__ = ["solution_dataset", "stress_dataset", "table_array"]

_NUMBERS = {"Fn": "N", "Fx": "N", "Fy": "N", "Mz": "N mm", "approach": "mm", "pmax": "N/mm^2"}


def _xarray() -> Any:
    try:
        import xarray
    except ImportError:
        raise MissingExtra("to_xarray()", "xarray", "xarray", "python3-xarray") from None
    return xarray


def _length(dimension: str | tuple[str, ...], values: Any) -> Any:
    return (dimension, np.asarray(values, dtype=float), {"units": "mm"})


def _places(grid: Grid) -> dict[str, Any]:
    return {"y": _length("y", grid.y), "x": _length("x", grid.x)}


def solution_dataset(solution: ContactSolution) -> xarray.Dataset:
    """Implements ContactSolution.to_xarray."""
    if solution.grid is None:
        raise ValueError("grid is None; only solutions of a client have coordinates")
    arrays: dict[str, Any] = {
        name: (("y", "x"), values, {"long_name": words, **({"units": unit} if unit else {})})
        for name, (words, unit) in ARRAY_LABELS.items()
        if (values := getattr(solution, name, None)) is not None
    }
    arrays |= {name: ((), getattr(solution, name), {"units": unit}) for name, unit in _NUMBERS.items()}
    attributes = {"converged": int(solution.converged), "warnings": list(solution.warnings)}
    dataset: xarray.Dataset = _xarray().Dataset(arrays, _places(solution.grid), attributes)
    return dataset


def table_array(table: IcTable) -> xarray.DataArray:
    """Implements IcTable.to_xarray."""
    grid, axes = table.spec.grid, list("xyz")
    offsets = {"dy": _length("dy", np.arange(grid.ny) * grid.dy), "dx": _length("dx", np.arange(grid.nx) * grid.dx)}
    array_with_labels: xarray.DataArray = _xarray().DataArray(
        table.array, {"displacement": axes, "load": axes, **offsets}, ("displacement", "load", "dy", "dx"),
        "influence_coefficients", {"units": "mm^3/N", "key": table.key, "origin": table.origin},
    )  # fmt: skip
    return array_with_labels


def stress_dataset(stress: SubsurfaceStress) -> xarray.Dataset:
    """Implements SubsurfaceStress.to_xarray."""
    if stress.block is not None:
        dimensions: tuple[str, ...] = ("z", "y", "x")
        places = {name: _length(name, np.atleast_1d(getattr(stress.block, name))) for name in dimensions}
    elif stress.points is not None:
        dimensions = ("point",)
        places = {name: _length("point", stress.points[:, i]) for i, name in enumerate("xyz")}
    else:
        raise ValueError("block and points are None; only stresses of a client have coordinates")
    names = ["xx", "yy", "zz", "xy", "xz", "yz", "von_mises"]
    names += [name for name in INVARIANTS if getattr(stress, name) is not None]
    arrays = {name: (dimensions, getattr(stress, name), {"units": "N/mm^2"}) for name in names}
    dataset: xarray.Dataset = _xarray().Dataset(arrays, places, {"largest_von_mises": stress.largest.von_mises})
    return dataset
