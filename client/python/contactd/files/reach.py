"""Which files a file may name: a stranger's must not have those read that lie elsewhere."""

from __future__ import annotations

import errno
import os
import stat
from collections.abc import Iterable

__all__ = ["check_within"]


def check_within(path: str | os.PathLike[str], folders: Iterable[str | os.PathLike[str]]) -> None:
    """Raises OSError for a path that lies in none of the folders, nor below them, once links are followed."""
    try:
        place = os.path.realpath(path)
        kind = os.stat(place).st_mode if os.path.exists(place) else 0
    except ValueError:
        return  # No file has such a name, and its reader refuses it.
    if stat.S_ISCHR(kind) or stat.S_ISBLK(kind) or stat.S_ISSOCK(kind):
        return  # Every reader refuses devices and sockets.
    for folder in folders:
        top = os.path.realpath(folder)
        if place == top or place.startswith(top.rstrip(os.sep) + os.sep):
            return
    problem = "it lies outside of the folder of the file that names it; allow its folder by --allow-folder, in Python by allow_folders"
    raise OSError(errno.EACCES, problem, os.fspath(path))
