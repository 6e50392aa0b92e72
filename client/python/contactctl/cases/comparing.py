"""Compares rows of cases with those printed by another program."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from contactd.contact_files.comparison import Compared, case_differences, matched
from contactd.contact_files.out_reader import PrintedCase

__all__ = ["compared_rows"]


def compared_rows(rows: Sequence[dict[str, Any]], printed: Sequence[PrintedCase]) -> list[list[str]]:
    """Returns the differences of each row from the printed case with the same number, result element and contact
    problem, in order.
    """
    named = [row["values"] for row in rows]
    theirs = matched(((one["number"], one["reid"], one.get("cpid")) for one in named), printed)
    return [_differences(row, other) for row, other in zip(rows, theirs)]


def _differences(row: dict[str, Any], theirs: PrintedCase | None) -> list[str]:
    if theirs is None:
        return ["the file for comparison does not contain it"]
    numbers = row["answers"].get("numbers")
    return [] if numbers is None else case_differences(Compared(**numbers), theirs)
