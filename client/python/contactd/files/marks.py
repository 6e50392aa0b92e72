"""The mark of files that contactd has written, by which they are told from others: only these are written over."""

from __future__ import annotations

import os
import stat
from collections.abc import Sequence
from pathlib import Path

from .._version import MARK, __version__

__all__ = ["MARK", "can_be_written_over", "written_by"]

_HDF5 = b"\x89HDF\r\n\x1a\n"
_PIECE = 1 << 16  #: bytes at both ends in which a mark is looked for
_MOST_BYTES = 1 << 27  #: of a file that is searched as a whole
#: Of formats that have a mark of their own: the first lines of printed results, of tables, and of their text.
_OWN_MARKS = (b"|  contactd - ", b"contactd ic table, format ", b"sums over both bodies, times g = ", b"by contactctl ")
#: Of a wear study's measures, and of the answers to its shares.
_OWN_BEGINNINGS = (b'{\n "distance": [', b'{"study": "')
_OF_ARCHIVES = (b"array.npy", b"evidence.npy", b"pair.npy")


def written_by() -> str:
    """The mark with the version, for comments."""
    return f"{MARK} {__version__}"


def can_be_written_over(path: str | os.PathLike[str], heading: Sequence[str] | None = None) -> bool:
    """Whether there is no file at the path, an empty one, or one that contactd has written; links are followed. A table without
    comments has the mark in its `heading`, how the names of its columns begin. What is no ordinary file is written to as it is. A link
    to nothing is none that contactd makes. Raises OSError for what cannot be read."""
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
