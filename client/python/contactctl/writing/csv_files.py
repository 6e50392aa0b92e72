"""Writes tables as CSV."""

from __future__ import annotations

import csv
import io
from collections.abc import Iterable, Sequence
from typing import Any

__all__ = ["csv_text"]

_COMMANDS = "=+-@\t\r"  #: First characters of cells that spreadsheets evaluate.


def csv_text(rows: Iterable[Sequence[Any]]) -> str:
    """Returns the rows, including column names. An apostrophe precedes texts that a spreadsheet would evaluate."""
    written = io.StringIO()
    csv.writer(written, lineterminator="\n").writerows([_cell(value) for value in row] for row in rows)
    return written.getvalue()


def _cell(value: Any) -> Any:
    return f"'{value}" if isinstance(value, str) and value.startswith(tuple(_COMMANDS)) else value
