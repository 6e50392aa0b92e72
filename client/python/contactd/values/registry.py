"""Registers methods of values that other parts of this package implement, such as plots. Functions are registered by
name, and their modules are imported on first use.

contactd fills it from contactd.extras on import.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from importlib import import_module
from typing import Any

__all__ = ["extra", "register"]

_FUNCTIONS: dict[str, str] = {}


def register(functions: Mapping[str, str]) -> None:
    """Registers functions, such as ``{"ContactSolution.plot": "contactd.pictures.contact:draw_contact"}``."""
    _FUNCTIONS.update(functions)


def extra(name: str) -> Callable[..., Any]:
    """Returns the function that implements `name`."""
    module, _, function = _FUNCTIONS[name].partition(":")
    found: Callable[..., Any] = getattr(import_module(module), function)
    return found
