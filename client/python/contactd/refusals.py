"""What is checked here, before the daemon sees it: that a value is of the kind that is meant."""

from __future__ import annotations

import reprlib

__all__ = ["check_type"]

def check_type(name: str, value: object, *types: type, optional: bool = False) -> None:
    """Raises TypeError when `value` is of none of the types; what is in it is the daemon's business."""
    if isinstance(value, types) or (optional and value is None):
        return
    words = " or ".join(kind.__name__ for kind in types)
    raise TypeError(f"{name} is {reprlib.repr(value)}; it must be of type {words}")
