"""Arrays, as callers give them and as answers have them."""

from __future__ import annotations

from typing import Any

import numpy as np
import numpy.typing as npt

__all__ = ["Array", "array_of"]

Array = npt.NDArray[np.float64]


def array_of(value: Any) -> np.ndarray[Any, Any]:
    """`value` as an array that still has its mask, should it have one, for `encode` to refuse."""
    if isinstance(value, (list, tuple)) and any(isinstance(row, np.ma.MaskedArray) for row in value):
        masked: np.ndarray[Any, Any] = np.ma.array(value)
        return masked
    return np.asanyarray(value)
