"""Checks numbers and arrays given by users of this package."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import numpy.typing as npt

from ..errors import InvalidArgument, invalid

__all__ = ["Array", "check_number", "checked_array", "refused"]

Array = npt.NDArray[np.float64]


def refused(field: str, value: object, problem: str) -> InvalidArgument:
    """Returns the error `<field> = <value>: <problem>`; the problem ends with its cure."""
    shown = f"{value:g}" if isinstance(value, float) else repr(value)
    return invalid(field, f"= {shown}: {problem}")


def check_number(field: str, value: Any, unit: str, low: float, high: float, cure: str = "") -> None:
    """Raises InvalidArgument unless the value is a number within [low, high]."""
    if isinstance(value, bool) or not isinstance(value, (int, float, np.integer, np.floating)) or not math.isfinite(value):
        raise refused(field, value, f"it must be a finite number ({unit})." if unit else "it must be a finite number.")
    if not low <= value <= high:
        bounds = f"it must lie between {low:g} and {high:g} {unit}".rstrip()
        raise refused(field, float(value), f"{bounds}.{f' {cure}' if cure else ''}")


def checked_array(field: str, values: Any, least: int) -> Array:
    """Returns finite numbers in one dimension, at least `least` of them."""
    try:
        found = np.ascontiguousarray(np.ma.filled(np.ma.asarray(values, dtype=np.float64), np.nan))
    except (TypeError, ValueError):
        raise invalid(field, "is not an array of numbers. Give one number per position.") from None
    if found.ndim != 1 or found.size < least:
        raise invalid(field, f"has the shape {list(found.shape)}. Give at least {least} numbers in one dimension.")
    if not np.isfinite(found).all():
        index = int(np.flatnonzero(~np.isfinite(found))[0])
        raise invalid(f"{field}[{index}]", f"= {found[index]:g}: it must be finite. Interpolate or remove the missing values.")
    return found
