"""Implements construction and wire format of friction; `friction` declares the fields."""

from __future__ import annotations

import reprlib
from collections.abc import Sequence
from typing import Any

import numpy as np
import numpy.typing as npt

from .arrays import array_of
from .params import HasParams

__all__ = ["Force", "FrictionMethods"]

_MOTIONS = {"rigid_shift", "force", "rolling", "rigid_slip"}  #: The wire requires one of these.

#: (Fx, Fy) on the upper body (N); None if the motion is prescribed.
Force = tuple[float | None, float | None]


class FrictionMethods(HasParams):
    """Methods of a Friction."""

    @staticmethod
    def _completed(written: dict[str, Any]) -> dict[str, Any]:
        """Adds a zero shift if there is no motion."""
        return written if _MOTIONS & written.keys() else {**written, "rigid_shift": [0.0, 0.0]}

    @staticmethod
    def _write_mu(mu: float | npt.ArrayLike, _field: str) -> Any:
        coefficient = array_of(mu)
        return coefficient if coefficient.ndim or np.ma.is_masked(coefficient) else coefficient.item()

    @staticmethod
    def _write_rigid_slip(slip: tuple[npt.ArrayLike, npt.ArrayLike], _field: str) -> dict[str, Any]:
        if not isinstance(slip, Sequence) or len(slip) != 2:
            raise TypeError(f"rigid_slip is {reprlib.repr(slip)}; it must be a pair of arrays, along x and along y")
        x, y = slip
        return {"x": array_of(x), "y": array_of(y)}
