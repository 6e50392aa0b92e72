"""Provides handmade cases of the CONTACT program's input files, as texts and as read by its reader."""

from __future__ import annotations

import math
from typing import Any

from contactd.contact_files.case import Case

__all__ = ["END", "FIRST", "SECOND", "basic_case", "rail_case"]

FIRST = """\
 3  MODULE
  203100
  022020
 0001201
   999  100  30  1  1e-6
 50000.  0.0005  0.0  0.0001
   0.3   0.3
   0.0   0.5   20000.
   0.28  0.28  82000.  82000.
    -3
   15  15  6.0  4.0  1.1
"""
SECOND = """\
 3  MODULE
  203100
  100000
 0101201
 50000.  0.0020  0.0  0.0001
"""
END = " 0  MODULE\n"

_BASIC = {"P": 2, "B": 0, "T": 3, "N": 1, "F": 0, "S": 0, "V": 0, "L": 0, "D": 2, "C": 2, "M": 0, "Z": 2, "E": 0, "M2": 1,
          "W2": 0, "X": 0, "H": 0, "G": 0, "I": 0, "A": 0, "O": 3, "W": 0, "R": 1}  # fmt: skip
_LIMITS = {"MAXGS": 999, "MAXIN": 20, "MAXNR": 25, "MAXOUT": 1, "EPS": 1e-6}
_STEEL = {"POISS1": 0.28, "POISS2": 0.28, "GG1": 82000.0, "GG2": 82000.0}
_IN_FORCE = {"FRCLAW": 0, "VARFRC": 0, "INFLCF": 2, "GAUSEI": 0, "EXRHS": 0, "DISCNS": 2}
_ELLIPSE = {"IPOTCN": -3, "MX": 12, "MY": 10, "AA": 6.0, "BB": 4.0, "SCALE": 1.1}
_ROLLING = {"CKSI": 1e-3, "CETA": 0.0, "CPHI": 0.0, "SPINXO": 0.0, "SPINYO": 0.0, "CHI": 0.0, "DQ": 0.5, "VELOC": 3e4, "FACPHI": 1 / 6}
_KINKS = {"ISMOOTH": 0, "ZIGTHRS": math.radians(150), "KINKHIGH": math.radians(30), "KINKLOW": math.radians(6), "KINKWID": 2.0}
_PROFILE = {"MIRRORY": 0, "SCALE": 1.0, "SMOOTH": 0.0, "MIRRORZ": 0, "PRFOPT": 0, **_KINKS}
_TRACK = {"GAUGHT": 14.0, "GAUGSQ": 0, "GAUGWD": 1435.0, "CANT": 0.0, "CURV": 0.0, "RFNAME": "rail.prr", "WFNAME": "wheel.prw",
          **{f"RAIL_{name}": value for name, value in _PROFILE.items()},
          **{f"WHEEL_{name}": value for name, value in _PROFILE.items()}}  # fmt: skip
_RAIL = {"DYRAIL": 0.0, "DZRAIL": 0.0, "DROLLR": 0.0, "VYRAIL": 0.0, "VZRAIL": 0.0, "VROLLR": 0.0}
_WHEELSET = {"FBDIST": 1360.0, "FBPOS": -70.0, "NOMRADW": 460.0, "S_WS": 0.0, "Y_WS": 0.0, "ROLL": 0.0, "YAW": 0.0, "PITCH": 0.0,
             "VS": 2000.0, "VY": 0.0, "VZ": 0.0, "VROLL": 0.0, "VYAW": 0.0}  # fmt: skip
_GRID = {"DX": 0.5, "DS": 0.5, "DQREL": 1.0, "A_SEP": math.pi / 2, "D_SEP": 8.0, "D_COMB": 4.0, "D_TURN": 12.0, "G_MISS": -1.0}
_COULOMB = ({"FSTAT": 0.3, "FKIN": 0.3},)


def basic_case(*, friction: Any = _COULOMB, number: int = 1, line: int = 1, **changes: Any) -> Case:
    """Returns steady rolling of an ellipse of 6 by 4 mm under 50 kN. Digits have names of one or two capital letters;
    values have their own names."""
    values = {**_LIMITS, **_STEEL, **_IN_FORCE, **_ELLIPSE, **_ROLLING}
    return _case(3, dict(_BASIC), values, {"FN": 5e4}, friction, number, line, changes)


def rail_case(*, friction: Any = _COULOMB, number: int = 1, line: int = 1, **changes: Any) -> Case:
    """Returns a right wheel in the middle of the track, rolling freely under 10 kN."""
    digits = {**_BASIC, "C1": 1, "Z": 3, "E": 3}
    values = {**_LIMITS, **_STEEL, **_IN_FORCE, **_TRACK, **_RAIL, **_WHEELSET, **_GRID, "NPOT_MAX": 20000}
    return _case(1, digits, values, {"FZ": 1e4, "VPITCH": -4.348}, friction, number, line, changes)


def _case(
    module: int, digits: dict[str, int], values: dict[str, Any], given: dict[str, Any], friction: Any, number: int, line: int,
    changes: dict[str, Any],
) -> Case:  # fmt: skip
    alternatives = {"PEN": "FN", "FX": "CKSI" if module == 3 else "VPITCH", "FY": "CETA", "Z_WS": "FZ"}
    values |= given
    for name, value in changes.items():
        if name in digits:
            digits[name] = value
            continue
        values.pop(alternatives.get(name, ""), None)
        values[name] = value
    own = {"reid": values.pop("reid", None), "cpid": values.pop("cpid", None), "errors": values.pop("errors", ())}
    return Case(number=number, line=line, module=module, digits=digits, values=values, read=(), warnings=(),
                friction=tuple(friction), **own)  # fmt: skip
