"""Rows of cases beside what another program printed of them."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from contactd.contact_files.answers.compared import Compared
from contactd.contact_files.comparison import case_differences
from contactd.contact_files.out_reader import PrintedCase

__all__ = ["compared_rows"]


def compared_rows(rows: Sequence[dict[str, Any]], printed: Sequence[PrintedCase]) -> list[list[str]]:
    """The differences of each row: to the printed case with the same number of the same result element and contact problem,
    in order."""
    waiting: dict[tuple[int, Any], list[PrintedCase]] = {}
    for case in printed:
        waiting.setdefault((case.number, case.reid), []).append(case)
    return [_differences(row, waiting) for row in rows]


def _differences(row: dict[str, Any], waiting: dict[tuple[int, Any], list[PrintedCase]]) -> list[str]:
    values, numbers = row["values"], row["answers"].get("numbers")
    there = waiting.get((values["number"], values["reid"])) or waiting.get((values["number"], None), [])
    theirs = next((case for case in there if case.cpid in (None, values.get("cpid") or 1)), None)
    if theirs is None:
        return ["the file to compare with does not have it"]
    there.remove(theirs)
    return [] if numbers is None else case_differences(Compared(**numbers), theirs)
