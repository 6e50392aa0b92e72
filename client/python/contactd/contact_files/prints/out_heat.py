"""Writes the thermal properties of the bodies and the largest temperature."""

from __future__ import annotations

from collections.abc import Iterator, Mapping

from ..case import Case
from .numbers import general
from .out_text import g_row

__all__ = ["heat_lines", "largest_temperature"]


def heat_lines(case: Case) -> Iterator[str]:
    """Returns the thermal properties of both bodies, for cases with heat."""
    if case.digits["H"] == 0:
        return
    yield from ("", "     BKTEMP      HEATCP      LAMBDA      DENSITY")
    for number in "12":
        yield g_row(*(case.values[name + number] for name in ("BKTEMP", "HEATCP", "LAMBDA", "DENS")))


def largest_temperature(numbers: Mapping[str, float]) -> tuple[str, list[str]]:
    """Returns label and number to append to a row; nothing for cases without heat."""
    largest = numbers.get("MAX(T1,T2)")
    return ("", []) if largest is None else ("  MAX(T1,T2)", [general(largest)])
