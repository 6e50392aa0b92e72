"""Where the programs of contactd are on this machine."""

from __future__ import annotations

import importlib.util
from pathlib import Path

__all__ = ["program_of"]


def program_of(name: str) -> str:
    """The program `name` of the package contactd-daemon, where that is installed for this Python; else the name, for PATH."""
    found = importlib.util.find_spec("contactd_daemon")
    for folder in (found.submodule_search_locations or ()) if found is not None else ():
        program = Path(folder, "bin", name)
        if program.exists():
            return str(program)
    return name
