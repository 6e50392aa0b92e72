"""Reads the numbers of an .out file from any program: cases with rows of labels above rows of numbers."""

from __future__ import annotations

import re
from collections.abc import Iterator
from dataclasses import dataclass, field

__all__ = ["PrintedCase", "printed_cases"]

_CASE = re.compile(r" Case +(\d+)(?:, result element +(\d+)| for contact problem +(\d+) on result element +(\d+))?\s*$")
_PATCH = re.compile(r" -+ DATA FOR CONTACT PATCH +(\d+)")
_LABEL = re.compile(r"(?:CREEP|SHIFT) [XYS]|\S+")
#: First labels of the rows whose numbers are read.
_FIRST = ("FN", "BAR_FN", "TILDE_FN", "FN/G", "NPOT", "FX(TR)", "XCP(TR)", "XCP(W)", "S_WS", "X_WS", "VX_WS", "CHI", "DT", "KY_RAIL")
_LONGEST_LINE = 1000


@dataclass
class PrintedCase:
    """One case as printed.

    Attributes:
        number: Number of the case (its memory).
        reid: Result element, or None.
        line: Its first line in the file, from 1.
        numbers: Numbers of the whole case by their labels; for module 3, all numbers.
        patches: Numbers of each patch by their labels.
        cpid: Its contact problem, or None.
    """

    number: int
    reid: int | None
    line: int
    numbers: dict[str, float] = field(default_factory=dict)
    patches: list[dict[str, float]] = field(default_factory=list)
    cpid: int | None = None


def printed_cases(text: str) -> list[PrintedCase]:
    """Returns the cases of a file in order. Rows without known labels are skipped."""
    cases: list[PrintedCase] = []
    lines = [line[:_LONGEST_LINE].rstrip() for line in text.splitlines()]
    for index, line in enumerate(lines):
        if begins := _CASE.match(line):
            reid, cpid = begins[2] or begins[4], begins[3]
            cases.append(PrintedCase(int(begins[1]), _whole(reid), index + 1, cpid=_whole(cpid)))
        elif cases and _PATCH.match(line):
            cases[-1].patches.append({})
        elif cases and index + 1 < len(lines):
            rows = cases[-1].patches
            (rows[-1] if rows else cases[-1].numbers).update(_row(line, lines[index + 1]))
    return cases


def _whole(text: str | None) -> int | None:
    return None if text is None else int(text)


def _row(labels: str, numbers: str) -> Iterator[tuple[str, float]]:
    words = labels.split(maxsplit=1)
    if not words or words[0] not in _FIRST:
        return
    names = [found.group() for found in _LABEL.finditer(labels)]
    values = numbers.split()
    if len(names) != len(values):
        return
    for name, value in zip(names, values):
        try:
            yield _plain(name), float(value)
        except ValueError:
            return


def _plain(name: str) -> str:
    """Gives the work of shifts and the power of rolling one name; no case has both."""
    return "FRIC" if name.startswith("FRIC.") else name
