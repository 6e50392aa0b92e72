"""Writes the elements of an .out file: a picture of the contact, and quantities by element."""

from __future__ import annotations

import math
from collections.abc import Iterator

import numpy as np
import numpy.typing as npt

from ..case_results import Elements
from .numbers import fixed, fortran_g

__all__ = ["division", "quantities"]

_SIGNS = np.array([".", "*", "S", "|"])
_SPACED = 46  #: Maximum number of columns printed with blanks between them.
_TENS = 10  #: Number of columns from which tens are printed, too.
_WHOLE = 5  #: Number of exterior rows or columns that are still printed.
_COLUMNS = "     X         H-PEN        PN      TRCBND    ABS(PT)     ARG(PT;-S)  ABS(S)      {}"


def division(elements: Elements) -> Iterator[str]:
    """Returns the picture of adhesion and slip, with rows from the top. A large exterior is cropped to the border of
    the contact.
    """
    shown = _SIGNS[elements.division]
    touches = shown != "."
    rows, columns = _range(touches.any(axis=1)), _range(touches.any(axis=0))
    for iy in (rows[0], rows[-1]):
        for ix in (columns[0], columns[-1]):
            shown[iy, ix] = "o" if shown[iy, ix] == "." else shown[iy, ix]
    blank = " " if len(columns) <= _SPACED else ""
    yield " FORM OF THE CONTACT, ADHESION AND SLIP-AREA`S:"
    for iy in reversed(rows):
        yield f"{iy + 1:6d}  " + "".join(blank + shown[iy, ix] for ix in columns)
    numbers = [ix + 1 for ix in columns]
    if len(numbers) >= _TENS:
        tens = (str(number // 10 % 10) if number % 10 == 0 else " " for number in numbers)
        yield f"        {''.join(blank + ten for ten in tens)}".rstrip()
    yield "        " + "".join(f"{blank}{number % 10}" for number in numbers)
    direction = f"        Chi={fixed(math.degrees(elements.chi), 6, 2)} degrees" if elements.case.digits["T"] >= 2 else ""
    yield f"     X  -->{direction}"


def _range(is_touched: npt.NDArray[np.bool_]) -> range:
    there = np.flatnonzero(is_touched)
    if len(there) == 0:
        return range(len(is_touched))
    first, last = max(0, int(there[0]) - 1), min(len(is_touched) - 1, int(there[-1]) + 1)
    return range(first, last + 1) if len(is_touched) - (last + 1 - first) > _WHOLE else range(len(is_touched))


def quantities(elements: Elements) -> Iterator[str]:
    """Returns a line for each element in contact, by rows."""
    yield " QUANTITIES DISTRIBUTED OVER THE CONTACT AREA:"
    yield ' "H-PEN" IS THE UNDEFORMED DISTANCE WITH THE APPROACH TAKEN INTO ACCOUNT.'
    *sentences, labels = _heads(elements.case.digits["T"])
    heat, grid = elements.pairs_of(("TEMP1", "TEMP2")), elements.patch.grid
    yield from (*sentences, f"{labels}     TEMP1      TEMP2" if heat else labels)
    for iy in range(grid.ny):
        there = np.flatnonzero(elements.division[iy])
        if len(there):
            yield from ("", f" Y = {fortran_g(float(grid.y[iy]))} ROW{iy + 1:3d} OF THE POTENTIAL CONTACT", "")
        for ix in there:
            yield _line(elements, (iy, int(ix)))


def _heads(tangential: int) -> Iterator[str]:
    if tangential == 0:
        yield " PN IS THE NORMAL PRESSURE, PT IS THE TANGENTIAL TRACTION (2-VECTOR)."
        yield " X, H AND PEN ARE IN MM, PN AND PT ARE IN N/MM^2, AND ARGUMENTS ARE IN DEGREES."
        yield from ("", "     X          H-PEN        PN       ABS(PT)        ARG(PT)")
        return
    yield " PN IS THE NORMAL PRESSURE, PT THE TANGENTIAL TRACTION (2-VECTOR)."
    if tangential == 1:
        yield " S IS THE SLIP DISTANCE PER STEP, WHICH IS OPPOSITE TO THE TANGENTIAL TRACTION."
        yield " RIGID SHIFT(X, Y) ARE THE (X, Y) COMPONENTS OF THE RIGID SHIFT DISTANCE W."
        yield " X, H, PEN, S AND W ARE IN MM, PN AND PT ARE IN N/MM^2, AND ARGUMENTS ARE IN DEGREES."
        yield from ("", "", _COLUMNS.format("RIGID SHIFT(X, Y)"))
        return
    yield " S IS THE RELATIVE SLIP VELOCITY, WHICH IS OPPOSITE TO THE TANGENTIAL TRACTION."
    yield " RIGID SLIP(X, Y) ARE THE (X, Y) COMPONENTS OF THE RELATIVE RIGID SLIP VELOCITY W."
    yield " X, H AND PEN ARE IN MM, PN AND PT ARE IN N/MM^2, S AND W ARE DIMENSIONLESS, ARGUMENT IS IN DEGREES."
    yield from ("", _COLUMNS.format("RIGID SLIP(X, Y)"))


def _line(elements: Elements, at: tuple[int, int]) -> str:
    def values(*names: str) -> list[float]:
        return [float(elements[name][at]) for name in names]

    px, py, pressure, h = values("PX", "PY", "PN", "H")
    argument = math.degrees(math.atan2(py, px))
    x, e = float(elements.patch.grid.x[at[1]]), h - elements.patch.numbers["APPROACH"]
    size = float(elements.traction_size[at])
    if elements.is_frictionless:
        return f" {fortran_g(x)}{fortran_g(e)}{fortran_g(pressure)}{fortran_g(size)}{fixed(argument, 10, 1)}"
    tractions = [fortran_g(value, 11, 3) for value in (e, pressure, float(elements.bound[at]), size)]
    rigid = [slip + found for slip, found in zip(values("WX", "WY"), elements.found)]
    heat = [float(temperature[at]) for temperature in elements.pairs_of(("TEMP1", "TEMP2"))]
    slips = [fortran_g(value, 11, 3) for value in (math.hypot(*values("SX", "SY")), *rigid, *heat)]
    return f" {fortran_g(x)}{''.join(tractions)}{fixed(argument, 10, 1)}  {''.join(slips)}"
