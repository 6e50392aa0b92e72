"""Limits the files that a file may name: a file from an untrusted source must not read files elsewhere."""

from __future__ import annotations

import errno
import os
import stat
from collections.abc import Iterable

__all__ = ["check_within"]


def check_within(path: str | os.PathLike[str], folders: Iterable[str | os.PathLike[str]]) -> None:
    """Raises OSError for a path that is not inside one of the folders after links are resolved."""
    try:
        place = os.path.realpath(path)
        kind = os.stat(place).st_mode if os.path.exists(place) else 0
    except ValueError:
        return  # Such a name is invalid; opening it fails.
    if stat.S_ISCHR(kind) or stat.S_ISBLK(kind) or stat.S_ISSOCK(kind):
        return  # Devices and sockets are refused when they are read.
    for folder in folders:
        top = os.path.realpath(folder)
        if place == top or place.startswith(top.rstrip(os.sep) + os.sep):
            return
    problem = "it is outside the folder of the file that names it; allow its folder with --allow-folder, in Python with allow_folders"
    raise OSError(errno.EACCES, problem, os.fspath(path))
