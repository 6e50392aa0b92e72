"""Where the programs of contactd are on this machine, and the configuration of those that are started here."""

from __future__ import annotations

import importlib.util
from collections.abc import Mapping
from pathlib import Path
from typing import Any

__all__ = ["checked", "laid_over", "program_of"]


def checked(config: Mapping[str, Any] | None) -> Mapping[str, Any]:
    """Returns what was given as a configuration; none is an empty one. Raises TypeError."""
    if config is not None and not isinstance(config, Mapping):
        raise TypeError(f'config is {config!r}; it must be a mapping of sections, such as {{"workers": 4}}')
    return config or {}


def laid_over(own: Mapping[str, Any], config: Mapping[str, Any]) -> dict[str, Any]:
    """`own` with what `config` says in its place, section by section."""
    laid = dict(own)
    for name, value in config.items():
        both = isinstance(value, Mapping) and isinstance(laid.get(name), Mapping)
        laid[name] = {**laid[name], **value} if both else value
    return laid


def program_of(name: str) -> str:
    """The program `name` of the package contactd-daemon, where that is installed for this Python; else the name, for PATH."""
    found = importlib.util.find_spec("contactd_daemon")
    for folder in (found.submodule_search_locations or ()) if found is not None else ():
        program = Path(folder, "bin", name)
        if program.exists():
            return str(program)
    return name
