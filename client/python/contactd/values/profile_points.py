"""Implements methods of profiles from points and from files."""

from __future__ import annotations

import os
import re
from typing import Any

import numpy.typing as npt

from ..errors import invalid
from .arrays import array_of
from .registry import extra

__all__ = ["FileOfProfile", "MeasuredProfile"]


class MeasuredProfile:
    """A profile given by its points."""

    @staticmethod
    def _write_points(given: npt.ArrayLike, field: str) -> Any:
        points = array_of(given)
        if points.ndim != 2 or points.shape[1] != 2:
            raise invalid(field, f"has shape {list(points.shape)}; it must be [n, 2]", "ARRAY_INVALID")
        return points


class FileOfProfile:
    """A profile given by the text of a file, which is read once, on construction."""

    name: Any
    text: Any

    def __post_init__(self) -> None:
        """Reads the file. Raises OSError if it cannot be read, and InvalidArgument if it is empty."""
        text = extra("ProfileFile.text")(self.name) if self.text is None else self.text
        object.__setattr__(self, "name", os.fspath(self.name))
        object.__setattr__(self, "text", text if isinstance(text, str) else _text_of(text))

    def __repr__(self) -> str:
        given = ", ".join(f"{name}={value!r}" for name, value in vars(self).items() if name not in ("name", "text") and value is not None)
        return f"{type(self).__name__}({self.name!r}{given and ', '}{given})"

    @staticmethod
    def _write_name(given: str, field: str) -> str:
        """Writes the name without its folder, which is private."""
        return re.split(r"[\\/]", given)[-1]


def _text_of(content: bytes) -> str:
    """Decodes the text; comments of old files may have any encoding."""
    try:
        return content.decode()
    except UnicodeDecodeError:
        return content.decode("latin-1")
