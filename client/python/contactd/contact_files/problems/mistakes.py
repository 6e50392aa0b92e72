"""Invalid values of a case: each by its name, with the valid values. For them, formulas of Hertz's contact do not end
or return NaN, and lists by elements do not match the elements.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from ...values.generated.contact_files import ContactCase as Case

__all__ = ["mistakes"]

_HERTZ = {-1: ("A1", "B1"), -2: ("A1", "AOB"), -3: ("AA", "BB"), -4: ("A1", "BB"), -5: ("AA", "BB"),
          -6: ("AA", "BNEG", "BPOS")}  # fmt: skip
_LINES = (-4, -5)
_LAYERED = 4  #: M
_LEAST, _LARGEST = 1e-30, 1e30  #: Bounds whose cubes are finite.
_SLENDEREST = 1e6  #: Ratio of semi-axes.
_STEEPEST = 1e10  #: Ratio of curvatures, for slightly less slender semi-axes.
_OF_ELEMENTS = (("GAP", "the undeformed distance (IBASE = 9)"), ("SLIP_X", "the extra rigid slip (E = 9)"))


def mistakes(case: Case) -> list[str]:
    """Returns sentences without full stops about a case that was read without errors."""
    found = _out_of_range(case, ("GG1", "GG2", "EPS"))
    found += [
        f"{name} is {case.values[name]:g}; it must be from 0 to 0.5"
        for name in ("POISS1", "POISS2")
        if not 0 <= case.values[name] <= 0.5
    ]
    if case.digits["M"] == _LAYERED:
        found += _out_of_range(case, ("GG3",))
        if not 0 <= case.values["LAYTHK"] <= _LARGEST:  # 0 is a layer that only yields
            found.append(f"LAYTHK is {case.values['LAYTHK']:g}; it must be zero or positive, up to {_LARGEST:g}")
    return found if case.module != 3 else [*found, *_of_hertz(case), *_of_elements(case)]


def _out_of_range(case: Case, names: tuple[str, ...]) -> list[str]:
    return [
        f"{name} is {case.values[name]:g}; it must be positive, from {_LEAST:g} to {_LARGEST:g}"
        for name in names
        if not _LEAST <= case.values[name] <= _LARGEST
    ]


def _of_hertz(case: Case) -> list[str]:
    values, kind = case.values, case.values["IPOTCN"]
    if kind > 0:
        return []
    load = "FN" if "FN" in values else "PEN"
    if found := _out_of_range(case, (load, *_HERTZ[kind], "SCALE")):
        return found
    return _too_slender(case) if kind not in _LINES else []


def _too_slender(case: Case) -> list[str]:
    values, kind = case.values, case.values["IPOTCN"]
    first, second = _HERTZ[kind][:2]
    name, ratio = ("AOB", values["AOB"]) if kind == -2 else (f"{first}/{second}", values[first] / values[second])
    largest = _STEEPEST if kind == -1 else _SLENDEREST
    if 1 / largest <= ratio <= largest:
        return []
    return [f"{name} is {ratio:g}; it must be from {1 / largest:g} to {largest:g}; use a line contact (IPOTCN = -4, -5) for longer ones"]


def _of_elements(case: Case) -> list[str]:
    """Names lists that were kept while MX and MY changed."""
    values = case.values
    acts = {"GAP": values["IPOTCN"] > 0 and values.get("IBASE") == 9, "SLIP_X": case.digits["E"] != 0 and values.get("EXRHS") == 9}
    columns, rows = values["MX"], values["MY"]
    return [
        f"{what} is kept for {len(values[name])} elements, but MX, MY are {columns}, {rows}; give it anew"
        for name, what in _OF_ELEMENTS
        if acts[name] and len(values[name]) != columns * rows
    ]
