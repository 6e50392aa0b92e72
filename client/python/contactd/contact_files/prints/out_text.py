"""Writes the common parts of all blocks of an .out file: head, rows of labels and numbers, control digits."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from typing import Any

from ..._version import __version__
from ..case import Case
from .numbers import fortran_g, general

__all__ = ["IS_OURS", "case_head", "digits", "g_row", "gs_row", "head", "interfacial_layer", "row", "statistics_lines"]

IS_OURS = "|  contactd - "  #: Text in the second line of files written by contactd.

_WIDTH = 72
_LINES = {
    3: (("PBTNFS", "PVTIME BOUND TANG NORM FORCE STRESS"), ("VLDCMZE", "VARFRC FRCLAW DISCNS INFLCF MATER RZNORM RZTANG")),
    1: (("CPBTNFS", "CONFIG PVTIME BOUND TANG NORM FORCE STRESS"), ("VLDCMZE", "VARFRC FRCLAW DISCNS INFLCF MATER ZTRACK EWHEEL")),
}  # fmt: skip
_LAST = ("HGIAOWR", "HEAT GAUSEI IESTIM MATFIL OUTPUT FLOW RETURN")


def head() -> list[str]:
    """Returns the first eight lines. Readers of such files look for the words of the second line."""
    texts = ("contactd - detailed investigation of 3D frictional contact problems", "in the layout of the CONTACT program", "",
            f"Version: {__version__}", "", "")  # fmt: skip
    line = "   " + "-" * _WIDTH
    return [line, *(f"   |  {text:<{_WIDTH - 4}}|" for text in texts), line]


def case_head(case: Case) -> list[str]:
    """Returns a blank line and the number of the case."""
    number = f"{case.number:6d}" if case.number < 100_000 else f"{case.number:8d}"
    element = "" if case.reid is None else f", result element{case.reid:4d}"
    return ["", f" Case{number}{element}"]


def digits(case: Case) -> list[str]:
    """Returns the three lines of control digits."""
    first, second = _LINES[case.module]
    lines = [_digit_line(*first, case.digits)]
    if case.module == 3 and case.digits["V"] == 0:
        lines.append(_digit_line("LDCMZE", second[1].split(" ", 1)[1], case.digits))
    else:
        lines.append(_digit_line(*second, case.digits))
    return [" ", *lines, _digit_line(*_LAST, case.digits)]


def _digit_line(letters: str, names: str, values: Mapping[str, int]) -> str:
    keys = ["C1" if letter == "C" and letters.startswith("CP") else letter for letter in letters]
    words = ", ".join(f"{name:<6}{values.get(key, 0):2d}" for key, name in zip(keys, names.split()))
    shown = f"{letters:>7}."
    return f" {shown}" + " " * (2 if len(letters) == 7 else 12) + words


def row(numbers: Sequence[str]) -> str:
    """Formats numbers 12 characters wide, indented by two columns."""
    return "  " + "".join(numbers)


def g_row(*values: float) -> str:
    """Formats numbers with Fortran's G12.4."""
    return row([fortran_g(value) for value in values])


def gs_row(*values: float) -> str:
    """Formats numbers in the program's general format."""
    return row([general(value) for value in values])


def interfacial_layer(values: Mapping[str, Any]) -> Iterator[str]:
    """Returns the constants of M = 4."""
    yield " INTERFACIAL LAYER PARAMETERS"
    yield "     GG3         LAYTHK      TAU_C0      K_TAU"
    yield g_row(*(values[name] for name in ("GG3", "LAYTHK", "TAU_C0", "K_TAU")))


def statistics_lines(numbers: Mapping[str, float], normal: int, tangential: int) -> Iterator[str]:
    """Returns the numbers of elements, in the contact and its parts, and the numbers of iterations."""
    yield " CONTACT STATISTICS"
    yield " N: NUMBER OF ELEMENTS IN REGION,  I: NUMBER OF ITERATIONS,"
    yield " POT: POTENTIAL CONTACT AREA,  CON: CONTACT,  ADH: ADHESION"
    counts = [int(numbers[name]) for name in ("NPOT", "NCON", "NADH", "NSLIP", "NPLAST") if name in numbers]
    plastic = "  NPLAST" if "NPLAST" in numbers else ""
    yield f"    NPOT   NCON   NADH  NSLIP{plastic}{' INORM' if plastic else '  INORM'}  ITANG"
    yield "".join(f"{count:7d}" for count in (*counts, normal, tangential))
