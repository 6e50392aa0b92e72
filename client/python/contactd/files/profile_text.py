"""Reads profile files unchanged for the daemon to parse, and writes them in the formats of other programs."""

from __future__ import annotations

import os
from collections.abc import Sequence
from typing import TYPE_CHECKING, Any, Literal

from ..errors import invalid
from .text_lines import one_line
from .whole import read_whole

if TYPE_CHECKING:
    from ..values.arrays import Array

__all__ = ["ENDINGS", "format_profile", "read_profile_text"]

_MOST_BYTES = 1 << 21  #: Limit in proto/schema.
#: Output formats by file name extension.
ENDINGS = (".prr", ".prw", ".ban", ".whl", ".csv", ".txt")


def read_profile_text(path: str | os.PathLike[str]) -> bytes:
    """Returns the content of a file. Raises OSError if it does not exist or is too large for a profile, and
    InvalidArgument if it is empty.
    """
    content = read_whole(path, _MOST_BYTES)
    if not content:
        raise invalid("file", f"= {os.fspath(path)}: the file is empty. Give a file with the points of a profile, y and z")
    return content


def format_profile(points: Array, kind: Literal["wheel", "rail"], ending: str, remarks: Sequence[str] = ()) -> str:
    """Returns the text of a file with this extension: Simpack, MiniProf, or two columns separated by commas (.csv) or
    blanks.

    `points` are (y, z), shape [n, 2], in mm, y to the field side and z downwards. They are written with all digits.
    """
    if ending in (".ban", ".whl"):
        return _miniprof(points, remarks)
    comments = [f"{'!' if ending in ('.prr', '.prw') else '#'} {one_line(' '.join(remark.split()))}" for remark in remarks]
    if ending in (".csv", ".txt"):
        between = "," if ending == ".csv" else " "
        return "\n".join([*comments, between.join("yz"), *_rows(points, between), ""])
    head = ["header.begin", "  version  = 1", f"  type     = {1 if kind == 'wheel' else 0}", "header.end", "spline.begin"]
    keys = ["  approx.smooth = 0.0", "  units.len.f   = 1000.0", "  units.ang.f   = 1.0", "  point.begin"]
    rows = [f"    {row}" for row in _rows(points, " ")]
    return "\n".join([*comments, *head, *keys, *rows, "  point.end", "spline.end", ""])


def _miniprof(points: Array, remarks: Sequence[str]) -> str:
    """Returns the text of a MiniProf file, in which z is upwards."""
    head = [f"Remark={one_line(' '.join(remark.split()))}" for remark in remarks]
    return "\n".join([*head, "ColumnDef=X,Y", "", *(f"{float(y)!r} {0.0 - float(z)!r}" for y, z in points), ""])


def _rows(points: Any, between: str) -> list[str]:
    return [f"{float(y)!r}{between}{float(z)!r}" for y, z in points]
