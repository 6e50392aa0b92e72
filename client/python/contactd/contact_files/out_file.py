"""Writes an .out file: its head, and the lines of each case."""

from __future__ import annotations

from collections.abc import Iterable

from .answers.basic_results import BasicResult
from .prints.out_basic import basic_lines
from .prints.out_patches import patch_lines
from .prints.out_rails import rail_lines
from .prints.out_text import case_head, head
from .runner import Outcome

__all__ = ["lines_of", "out_text"]


def lines_of(outcome: Outcome) -> list[str]:
    """Returns the lines of a case, or the reason why it was not computed."""
    if outcome.result is None:
        return [*case_head(outcome.case), f" {outcome.status.upper()}: {outcome.sentence}"]
    if isinstance(outcome.result, BasicResult):
        lines = basic_lines(outcome.result)
    else:
        lines = rail_lines(outcome.result)
        for number, patch in enumerate(outcome.result.patches if lines else (), 1):
            lines += ["", *patch_lines(outcome.result, patch, number)]
    if outcome.sentence and lines:
        lines[2:2] = [f" WARNING: {outcome.sentence}"]
    return lines


def out_text(cases: Iterable[list[str]]) -> str:
    """Returns the whole file from the lines of its cases."""
    return "\n".join([*head(), *(line for lines in cases for line in lines), ""])
