"""Identifies files written by contactd. Only these may be overwritten."""

from __future__ import annotations

import os
import stat
from collections.abc import Sequence
from pathlib import Path

from .._version import MARK, __version__

__all__ = ["MARK", "can_be_written_over", "written_by"]

_HDF5 = b"\x89HDF\r\n\x1a\n"
_PIECE = 1 << 16  #: Number of bytes at both ends in which the mark is searched.
_MOST_BYTES = 1 << 27  #: Largest size of a file that is searched completely.
#: Marks of formats with their own: the first lines of printed results, of tables, and of their text.
_OWN_MARKS = (b"|  contactd - ", b"contactd ic table, format ", b"contactd creep-force table\n", b"sums over both bodies, times g = ", b"by contactctl ")
#: Marks of a wear study's measures, and of the answers to its shares.
_OWN_BEGINNINGS = (b'{\n "distance": [', b'{"study": "')
_OF_ARCHIVES = (b"array.npy", b"evidence.npy", b"pair.npy")


def written_by() -> str:
    """Returns the mark with the version, for comments."""
    return f"{MARK} {__version__}"


def can_be_written_over(path: str | os.PathLike[str], heading: Sequence[str] | None = None) -> bool:
    """Returns whether the path has no file, an empty one, or one written by contactd. Links are followed; a broken link
    returns False. For a table without comments, the mark is its `heading`, the start of its column names. Special files
    return True. Raises OSError if the file cannot be read.
    """
    place = Path(path)
    try:
        status = place.stat()
    except FileNotFoundError:
        return not place.is_symlink()
    if not stat.S_ISREG(status.st_mode) or status.st_size == 0:
        return True
    with place.open("rb") as file:
        head = file.read(_PIECE)
        file.seek(max(status.st_size - _PIECE, 0))
        ends = head.lower() + file.read().lower()
        if MARK.encode() in ends or any(mark in ends for mark in _OWN_MARKS):
            return True
        if heading is not None and b"".join((head.split(b"\n", 1)[0].rstrip(b"\r"), b",")).startswith(",".join([*heading, ""]).encode()):
            return True
        if head.startswith(_OWN_BEGINNINGS):
            return True
        if head.startswith(b"PK"):
            return _OF_ARCHIVES[0] in ends and any(name in ends for name in _OF_ARCHIVES[1:])
        if head.startswith((b"{", _HDF5)) and status.st_size <= _MOST_BYTES:
            file.seek(0)
            sought = b"contactd" if head.startswith(_HDF5) else b'"evidence": {'
            return sought in file.read()
    return False
