"""Writes an .out file: its head, and the lines of each case."""

from __future__ import annotations

from collections.abc import Iterable

from .prints.out_basic import basic_lines
from .prints.out_patches import patch_lines
from .prints.out_rails import rail_lines
from .prints.out_text import case_head, head
from .solved_case import SolvedCase

__all__ = ["lines_of", "out_text"]


def lines_of(solved: SolvedCase) -> list[str]:
    """Returns the lines of a case, or the reason why it was not computed."""
    if solved.solution is None:
        return [*case_head(solved.case), f" {solved.status.upper()}: {solved.sentence}"]
    if solved.answer.wheelrail is None:
        lines = basic_lines(solved)
    else:
        lines = rail_lines(solved)
        for number, elements in enumerate(solved.elements if lines else (), 1):
            lines += ["", *patch_lines(elements, number)]
    if solved.sentence and lines:
        lines[2:2] = [f" WARNING: {solved.sentence}"]
    return lines


def out_text(cases: Iterable[list[str]]) -> str:
    """Returns the whole file from the lines of its cases."""
    return "\n".join([*head(), *(line for lines in cases for line in lines), ""])
