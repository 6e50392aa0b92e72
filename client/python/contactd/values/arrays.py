"""Arrays from callers and in answers."""

from __future__ import annotations

from typing import Any

import numpy as np
import numpy.typing as npt

__all__ = ["Array", "array_of"]

Array = npt.NDArray[np.float64]


def array_of(value: Any) -> np.ndarray[Any, Any]:
    """Returns `value` as an array. A mask is kept, so that `encode` can refuse it."""
    if isinstance(value, (list, tuple)) and any(isinstance(row, np.ma.MaskedArray) for row in value):
        masked: np.ndarray[Any, Any] = np.ma.array(value)
        return masked
    return np.asanyarray(value)
