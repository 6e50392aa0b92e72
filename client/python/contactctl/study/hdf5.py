"""Writes all rows of a study to one HDF5 file: an array for each answer, over the varied fields.

Axes are dimension scales as in netCDF: `xarray.open_dataset(path, engine="h5netcdf")` gives each array its coordinates.
"""

from __future__ import annotations

import json
from collections.abc import Sequence
from pathlib import Path
from typing import Any

import numpy as np

import contactd
from contactd.files.whole import write_whole

from ..output import plain_json
from .plan import Plan

__all__ = ["write_hdf5"]


def write_hdf5(path: Path, plan: Plan, rows: Sequence[dict[str, Any]]) -> None:
    """Writes the rows in the order of the plan's cases. The file is never incomplete. Needs h5py.

    Each answer is a dataset with one dimension per axis: float64 with NaN for failed rows, int8 for booleans with -1
    for failed rows, otherwise JSON. `code` contains the exit code of each row. Fields that vary together share an axis,
    named after the first.
    """
    import h5py

    def write(into: Any) -> None:
        with h5py.File(into, "w") as file:
            file.attrs.update(method=plan.method, problem=json.dumps(plain_json(plan.problem)), contactd=contactd.__version__)
            scales = [_written_axis(file, axis) for axis in plan.axes]
            shape = [len(scale) for scale in scales]
            arrays = {"code": np.array([row["code"] for row in rows], dtype=np.int8)}
            for name in plan.answers:
                if name not in plan.names:
                    arrays[name] = _array([row.get("answers", {}).get(name) for row in rows])
            for name, array in arrays.items():
                dataset = file.create_dataset(name, data=array.reshape(shape), **_storage(array))
                for number, scale in enumerate(scales):
                    dataset.dims[number].attach_scale(scale)

    write_whole(path, write)


def _written_axis(file: Any, axis: dict[str, list[Any]]) -> Any:
    """Writes the scale of the first field; others are coordinates along it."""
    first, *others = (file.create_dataset(name, data=_array(values)) for name, values in axis.items())
    first.make_scale(next(iter(axis)))
    for other in others:
        other.dims[0].attach_scale(first)
    return first


def _array(values: Sequence[Any]) -> Any:
    """Returns the array; None marks missing values."""
    kinds = {type(value) for value in values if value is not None}
    if kinds == {bool}:
        return np.array([-1 if value is None else value for value in values], dtype=np.int8)
    if kinds <= {int, float}:
        return np.array([np.nan if value is None else value for value in values], dtype=np.float64)
    return np.array([json.dumps(plain_json(value)) for value in values], dtype=object)


def _storage(array: Any) -> dict[str, Any]:
    return {} if array.dtype == object or not array.shape[0] else {"compression": "gzip", "shuffle": True}
