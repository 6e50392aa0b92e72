"""Formats numbers like the CONTACT program: Fortran's G format, and the program's general format."""

from __future__ import annotations

import math

__all__ = ["fixed", "fortran_g", "general"]

_NOTHING = 1e-20  #: Smaller numbers are printed as zero.


def fortran_g(value: float, width: int = 12, digits: int = 4) -> str:
    """Formats as Fortran's Gwidth.digits: without exponent and with four trailing blanks if 0.1 <= |value| < 10^digits
    after rounding.
    """
    if value == 0:
        return f"{0:.{digits - 1}f}    ".rjust(width)
    mantissa, exponent = _rounded(value, digits)
    sign = "-" if value < 0 else ""
    if 0 <= exponent <= digits:
        return f"{sign}{_placed(mantissa, exponent)}    ".rjust(width)
    return f"{sign}0.{mantissa}E{exponent:+03d}".rjust(width)


def general(value: float, fixed_digits: int = 4, digits: int = 4, width: int = 12) -> str:
    """Formats in the program's general format: with `fixed_digits` digits if they suffice for the integer part and at
    most one digit is lost to a leading zero; otherwise with an exponent and `digits` digits.
    """
    if abs(value) < _NOTHING:
        return f"{0:.{fixed_digits - 1}f}".rjust(width)
    decade = math.floor(math.log10(abs(value)) + 1e-7)
    if decade >= fixed_digits or decade <= -2:
        return f"{value:#.{digits - 1}E}".rjust(width)
    return f"{value:#.{fixed_digits - 1 - decade}f}".rjust(width)


def fixed(value: float, width: int, decimals: int) -> str:
    """Formats as Fortran's Fwidth.decimals; asterisks if the number does not fit."""
    text = f"{value:#.{decimals}f}".rjust(width)
    return text if len(text) <= width else "*" * width


def _rounded(value: float, digits: int) -> tuple[str, int]:
    """Returns the digits, and the exponent of 0.digits."""
    mantissa, exponent = f"{abs(value):.{digits - 1}e}".split("e")
    return mantissa.replace(".", ""), int(exponent) + 1


def _placed(mantissa: str, exponent: int) -> str:
    return f"{mantissa[:exponent] or '0'}.{mantissa[exponent:]}"
