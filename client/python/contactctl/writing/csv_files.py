"""Tables as CSV, for programs of all kinds."""

from __future__ import annotations

import csv
import io
from collections.abc import Iterable, Sequence
from typing import Any

__all__ = ["csv_text"]

_COMMANDS = "=+-@\t\r"  #: with which a cell begins that a spreadsheet computes


def csv_text(rows: Iterable[Sequence[Any]]) -> str:
    """The rows, the names of columns among them. A text that a spreadsheet would compute begins with an apostrophe."""
    written = io.StringIO()
    csv.writer(written, lineterminator="\n").writerows([_cell(value) for value in row] for row in rows)
    return written.getvalue()


def _cell(value: Any) -> Any:
    return f"'{value}" if isinstance(value, str) and value.startswith(tuple(_COMMANDS)) else value
