"""Labels and values of friction laws by the digit L."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from .numbers import fortran_g

__all__ = ["LABELS_OF_LAWS", "NAMES_OF_LAWS", "cut_rows"]

_SHOWN = 2  #: Number of rows printed at either end of a shortened list.
_ALL = 4  #: Digit O from which all rows are printed.

LABELS_OF_LAWS = {
    0: ("FSTAT", "FKIN"),
    2: ("FKIN", "FLIN1", "SABSH1", "FLIN2", "SABSH2"),
    3: ("FKIN", "FRAT1", "SABSH1", "FRAT2", "SABSH2"),
    4: ("FKIN", "FEXP1", "SABSH1", "FEXP2", "SABSH2"),
    6: ("FREF", "TREF", "DFHEAT", "DTHEAT"),
}
NAMES_OF_LAWS = {
    0: ("FSTAT", "FKIN"),
    **dict.fromkeys((2, 3, 4), ("FKIN", "F1", "SABSH1", "F2", "SABSH2")),
    6: ("FREF", "TREF", "DFHEAT", "DTHEAT"),
}


def cut_rows(rows: Sequence[Sequence[float]], level: int) -> Iterator[str]:
    """Returns the values of each row of elements with its number. Below a `level` of output, middle rows are
    omitted.
    """
    cut = len(rows) > 2 * _SHOWN and level < _ALL
    for number, values in enumerate(rows, 1):
        if cut and number == _SHOWN + 1:
            yield "                      ..."
        if not cut or number <= _SHOWN or number > len(rows) - _SHOWN:
            yield f"{number:10d}    " + "".join(map(fortran_g, values))
