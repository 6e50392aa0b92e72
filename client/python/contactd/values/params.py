"""What values have in common on their way to the wire."""

from __future__ import annotations

import functools
from dataclasses import fields
from typing import Any

import numpy as np

from ..errors import invalid

__all__ = ["array_of", "plain", "whole"]


def plain(value: Any) -> dict[str, Any]:
    """The fields of a dataclass that are not None, as the wire names them."""
    return {name: item for name in _names(value.__class__) if (item := getattr(value, name)) is not None}


@functools.cache
def _names(kind: type) -> tuple[str, ...]:
    """Of the fields of a dataclass, looked at once: steps are told thousands of times a second."""
    return tuple(field.name for field in fields(kind))


def array_of(value: Any) -> np.ndarray[Any, Any]:
    """`value` as an array that still has its mask, should it have one, for `encode` to refuse."""
    if isinstance(value, (list, tuple)) and any(isinstance(row, np.ma.MaskedArray) for row in value):
        masked: np.ndarray[Any, Any] = np.ma.array(value)
        return masked
    return np.asanyarray(value)


def whole(array: np.ndarray[Any, Any], field: str) -> np.ndarray[Any, Any]:
    """`array`; raises InvalidArgument where elements are masked, since contact has no word for what is not there."""
    if np.ma.is_masked(array):
        problem = f"has {np.count_nonzero(np.ma.getmaskarray(array))} masked values; every value must be there, as in array.filled(...)"
        raise invalid(field, problem, "ARRAY_INVALID")
    return array
