"""Writes the subsurface results of an .out file."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np
import numpy.typing as npt

from ..case_results import StressField
from .numbers import fixed

__all__ = ["extremes"]


def extremes(field: StressField, number: int) -> Iterator[str]:
    """Returns the largest value of each kind, and its position."""
    first = field.principal
    kinds = [
        ("ABSMAX", "SIGHYD", field.hydrostatic), ("MAX", "SIGVM", field.von_mises), ("MAX", "SIGTR", field.tresca),
        ("MAX", "SIGMA1", first[2]), ("MIN", "SIGMA3", first[0]), ("ABSMAX", "SIGXX", field.stress[0]),
        ("ABSMAX", "SIGYY", field.stress[3]), ("ABSMAX", "SIGZZ", field.stress[5]),
    ]  # fmt: skip
    yield f" SUBSURFACE STRESSES BLOCK{number:3d}:"
    yield " "
    for kind, name, values in kinds:
        iz, iy, ix = np.unravel_index(_at(kind, values), values.shape)
        place = ",".join(fixed(float(one), 8, 3) for one in (field.x[ix], field.y[iy], field.z[iz]))
        yield f" {kind:<6} {name:>6} ={fixed(float(values[iz, iy, ix]), 10, 3)} AT (X,Y,Z) = ({place})"


def _at(kind: str, values: npt.NDArray[np.float64]) -> int:
    if kind == "MIN":
        return int(np.argmin(values))
    return int(np.argmax(np.abs(values) if kind == "ABSMAX" else values))
