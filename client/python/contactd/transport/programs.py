"""Locations of contactd's programs on this machine, and configurations of daemons started here."""

from __future__ import annotations

import importlib.util
from collections.abc import Mapping
from pathlib import Path
from typing import Any

__all__ = ["checked", "laid_over", "program_of"]


def checked(config: Mapping[str, Any] | None) -> Mapping[str, Any]:
    """Returns the given configuration; None becomes an empty one. Raises TypeError."""
    if config is not None and not isinstance(config, Mapping):
        raise TypeError(f'config is {config!r}; it must be a mapping of sections, such as {{"workers": 4}}')
    return config or {}


def laid_over(own: Mapping[str, Any], config: Mapping[str, Any]) -> dict[str, Any]:
    """Returns `own` with the values of `config` replacing its own, section by section."""
    laid = dict(own)
    for name, value in config.items():
        both = isinstance(value, Mapping) and isinstance(laid.get(name), Mapping)
        laid[name] = {**laid[name], **value} if both else value
    return laid


def program_of(name: str) -> str:
    """Returns the program `name` of the package contactd-daemon if it is installed for this Python; otherwise the name,
    for PATH.
    """
    found = importlib.util.find_spec("contactd_daemon")
    for folder in (found.submodule_search_locations or ()) if found is not None else ():
        program = Path(folder, "bin", name)
        if program.exists():
            return str(program)
    return name
