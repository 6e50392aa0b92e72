"""Registry of what values do by parts of this package that they do not know, such as pictures: by name, functions of modules that are
imported when they are first called.

contactd fills it from contactd.extras before anybody has a value.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from importlib import import_module
from typing import Any

__all__ = ["extra", "register"]

_FUNCTIONS: dict[str, str] = {}


def register(functions: Mapping[str, str]) -> None:
    """Names functions, such as ``{"Solution.plot": "contactd.pictures.contact:draw_contact"}``."""
    _FUNCTIONS.update(functions)


def extra(name: str) -> Callable[..., Any]:
    """The function that does `name`."""
    module, _, function = _FUNCTIONS[name].partition(":")
    found: Callable[..., Any] = getattr(import_module(module), function)
    return found
