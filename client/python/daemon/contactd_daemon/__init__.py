"""Provides the daemon and builder of contactd with all libraries that they need, including the loader: the content of
the wheel contactd-daemon.

``contactd.local()`` and ``LocalDaemon`` find them here. ``contactd`` and ``contactd-ic`` are commands of the environment.
"""

from __future__ import annotations

import os
import sys
from pathlib import Path
from typing import NoReturn

__all__ = ["program"]


def program(name: str = "contactd") -> Path:
    """Returns the path of the program `name`, contactd or contactd-ic. Raises ValueError for others."""
    if name not in ("contactd", "contactd-ic"):
        raise ValueError(f"name is {name!r}; it must be contactd or contactd-ic")
    return Path(__file__).parent / "bin" / name


def _become(name: str) -> NoReturn:
    path = program(name)
    os.execv(path, [str(path), *sys.argv[1:]])


def _contactd() -> NoReturn:
    _become("contactd")


def _contactd_ic() -> NoReturn:
    _become("contactd-ic")
