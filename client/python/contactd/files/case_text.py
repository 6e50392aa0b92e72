"""Reads text files of the CONTACT program."""

from __future__ import annotations

import os

from .whole import read_whole

__all__ = ["text_of"]

_MOST_BYTES = 16 << 20


def text_of(path: str | os.PathLike[str]) -> str:
    """Returns the text of a file. Raises OSError if it cannot be read or is larger than 16 MiB."""
    content = read_whole(path, _MOST_BYTES)
    try:
        return content.decode("utf-8-sig")
    except UnicodeDecodeError:
        return content.decode("latin-1")
