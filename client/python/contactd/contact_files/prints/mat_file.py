"""Writes a .mat file: text with a header and one line per element, for the CONTACT program's own scripts."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import Any

import numpy as np

from ..._version import MARK
from ...values.generated.grid import Grid
from ..case_results import LETTERS, Elements, rolling_step, step_on
from ..solved_case import SolvedCase
from .mat_places import PatchPlaces, patch_places
from .numbers import fortran_g
from .out_laws import NAMES_OF_LAWS

__all__ = ["mat_texts"]

_COLUMNS = 11
_OF_MATERIAL: dict[int, tuple[str, ...]] = {1: ("FG1", "FG2", "TC1", "TC2"), 4: ("GG3", "LAYTHK", "TAU_C0", "K_TAU")}
_LAYER, _HEAT = ("TAUCRT", "UPLSX", "UPLSY"), ("TEMP1", "TEMP2")
_FORMAT = 2410.0  #: Version of the format; readers look for it in the last column.

Cell = float | int


def mat_texts(solved: SolvedCase) -> Iterator[tuple[str, str]]:
    """Yields a letter (empty for basic contact) and the text of each contact; nothing if the digit A is 0."""
    case = solved.case
    for index, elements in enumerate(solved.elements if case.digits["A"] != 0 else ()):
        if elements.on_rail is None:
            motion = (*rolling_step(case, elements.patch), case.values["VELOC"])
            yield "", _text(case, PatchPlaces.none(case), motion, elements)
        else:
            creepages = elements.on_rail.place.creepages
            motion = (creepages.chi, step_on(case, elements.patch), creepages.velocity)
            yield LETTERS[index % len(LETTERS)], _text(case, patch_places(solved, index), motion, elements)


def _text(case: Any, places: PatchPlaces, motion: tuple[float, float, float], elements: Elements) -> str:
    values, digits, grid = case.values, case.digits, elements.patch.grid
    chi, dq, velocity = motion
    law = values["FRCLAW"]
    friction = [case.friction[0][name] for name in NAMES_OF_LAWS[law]] if case.friction else []
    if law != 0:
        friction += [values.get("MEMDST", 0.0), values.get("MEM_S0", 0.0)]
    layer, heat = elements.pairs_of(_LAYER), elements.pairs_of(_HEAT)
    width = _COLUMNS + len(layer) + len(heat)

    def header(cells: Sequence[Cell]) -> str:
        return _header(cells, width)

    lines = [
        f"% tim, s_ws, th_ws, y_r, z_r, roll_r, rnom_r, format; {MARK}",
        header([*places.rail, *[0.0] * (width - 1 - len(places.rail)), _FORMAT]),
        "% x_w, y_w, z_w, roll_w, yaw_w, rnom_w",
        header(places.wheel),
        "% xcp_r, ycp_r, zcp_r, deltcp_r, xcp_w, ycp_w, zcp_w, npatch, ipatch, spinxo, spinyo",
        header(places.reference),
        "% mx, my, xl, yl, dx, dy, chi, dq, config, d_digit, y_nom_w",
        header([grid.nx, grid.ny, *_corner(grid, places), grid.dx, grid.dy, chi, dq, digits.get("C1", 0), values["DISCNS"] if
                 case.module == 1 else digits["D"], places.nominal]),
        "% tang, mater, gg1, gg2, poiss1, poiss2",
        header([digits["T"], digits["M"], *(values[name] for name in ("GG1", "GG2", "POISS1", "POISS2", *_OF_MATERIAL.get(digits["M"], ())))]),
        "% frclaw, heat, veloc, friction",
        header([law, digits["H"], velocity, *friction]),
        "%    I    IGS    H             MU            PN            PX            PY            UN            UX            UY"
        "            SREL" + ("          TAUCRT        UPLSX         UPLSY" if layer else "")
        + ("          TEMP1         TEMP2" if heat else ""),
        *_elements(elements, digits["A"] == 1),
    ]  # fmt: skip
    return "\n".join([*lines, ""])


def _corner(grid: Grid, places: PatchPlaces) -> tuple[float, float]:
    x, y = places.counted_from
    return float(grid.x[0] - grid.dx / 2) + x, float(grid.y[0] - grid.dy / 2) + y


def _header(cells: Sequence[Cell], width: int) -> str:
    """Returns the header, padded with zeros; integers are written as such."""
    filled = [*cells, *[0.0] * (width - len(cells))]
    return "".join(f"{cell:6d}        " if isinstance(cell, int) else fortran_g(cell, 14, 6) for cell in filled)


def _elements(elements: Elements, in_contact_only: bool) -> Iterator[str]:
    flat = elements.division.ravel()
    chosen = np.flatnonzero(flat) if in_contact_only else np.arange(flat.size)
    columns = [elements[name] for name in ("H", "MU", "PN", "PX", "PY", "UN", "UX", "UY")]
    columns += [np.hypot(elements["SX"], elements["SY"]), *elements.pairs_of(_LAYER, _HEAT)]
    table = np.stack([column.ravel() for column in columns], axis=1)
    for index in chosen:
        yield f"{index + 1:7d} {int(flat[index]):4d}  " + "".join(fortran_g(float(value), 14, 6) for value in table[index])
