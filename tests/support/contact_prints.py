"""Reproduces the input that the CONTACT program prints (.ref_out): its number formats, and the rows of numbers that
repeat values of an input file, each with the names of these values."""

from __future__ import annotations

import math
import re
from collections.abc import Callable, Iterator
from dataclasses import dataclass, field
from typing import Any

Case = Any
Format = Callable[[float], str]


def g(value: float) -> str:
    """Returns the number in Fortran's G12.4, without blanks around it."""
    if value == 0:
        return "0.000"
    power = math.floor(math.log10(abs(value))) + 1
    rounded = round(abs(value), 4 - power)
    if 0.1 <= rounded < 10_000:
        digits = 4 - (math.floor(math.log10(rounded)) + 1)
        return f"{value:#.{digits}f}"
    mantissa, exponent = f"{value:.3e}".split("e")
    sign, figures = ("-", mantissa[1:]) if value < 0 else ("", mantissa)
    return f"{sign}0.{figures.replace('.', '')}E{int(exponent) + 1:+03d}"


def gs(figures: int, significant: int) -> Format:
    """Returns the number in the program's own format."""

    def text(value: float) -> str:
        if abs(value) < 1e-20:
            return "0." + "0" * (figures - 1)
        power = math.floor(math.log10(abs(value)) + 1e-7)
        if power >= figures or power <= -2:
            return f"{value:.{significant - 1}E}"
        return f"{value:#.{figures - 1 - power}f}"

    return text


def f(decimals: int) -> Format:
    return lambda value: f"{value:#.{decimals}f}"


def whole(value: float) -> str:
    return str(int(value))


s = gs(4, 4)
#: These names are printed but not read.
_NOT_READ = (None, g)


@dataclass
class Printed:
    """A case of a .ref_out file.

    Attributes:
        number: As printed.
        digits: Control digits by the names of an input file; empty where they are not printed.
        rows: Labels and the rows of words below them, of blocks before the first patch.
        of_patch: The same of the first patch.
        names: Of files of profiles, by RAIL and WHEEL.
    """

    number: int
    digits: dict[str, int] = field(default_factory=dict)
    rows: list[tuple[tuple[str, ...], list[list[str]]]] = field(default_factory=list)
    names: dict[str, str] = field(default_factory=dict)
    maxout: int | None = None


_DIGITS = {
    "CONFIG": "C1", "PVTIME": "P", "BOUND": "B", "TANG": "T", "NORM": "N", "FORCE": "F", "STRESS": "S", "VARFRC": "V",
    "FRCLAW": "L", "DISCNS": "D", "INFLCF": "C", "MATER": "M", "ZTRACK": "Z", "RZNORM": "Z", "EWHEEL": "E", "RZTANG": "E",
    "HEAT": "H", "GAUSEI": "G", "IESTIM": "I", "MATFIL": "A", "OUTPUT": "O", "FLOW": "W", "RETURN": "R",
}  # fmt: skip
_CASE = re.compile(r" Case +(\d+)(?:, result element| for contact problem|$)")
_OUTER = re.compile(r" PANAGIOTOPOULOS\" METHOD .*MAXOUT= *(\d+)")
_PROFILE = re.compile(r" (RAIL|ROLLER|WHEEL) PROFILE \"(.*)\"")
_HERTZ = re.compile(
    r" (SEMIAXES PRESCRIBED, AA,BB|CURVATURE PRESCRIBED, A1,B1|CURVATURE AND ELLIPTIC\. PRESCRB, A1,AA/BB|POTENTIAL CONTACT, SCALE"
    r"|DISCRETISATION MX,MY, DX,DY): +(.*)"
)
_LABEL = re.compile(r"[A-Z][A-Z0-9_()/]*$")


def printed_cases(text: str) -> Iterator[Printed]:
    """Yields the cases of a .ref_out file, with the output before their first patch."""
    case: Printed | None = None
    in_patch, profile = False, ""
    lines = text.splitlines()
    for at, line in enumerate(lines):
        if found := _CASE.match(line):
            if case:
                yield case
            case, in_patch, profile = Printed(int(found[1])), False, ""
        if case is None or in_patch:
            continue
        if re.match(r" +[A-Z]+\. ", line):
            for name, digit in re.findall(r"([A-Z]+) +(\d)(?:,|$)", line):
                if name in _DIGITS:
                    case.digits.setdefault(_DIGITS[name], int(digit))
        elif found := _HERTZ.match(line):
            case.rows.append(((found[1],), [found[2].split()]))
        elif found := _OUTER.match(line):
            case.maxout = int(found[1])
        elif found := _PROFILE.match(line):
            profile = "WHEEL" if found[1] == "WHEEL" else "RAIL"
            case.names[profile] = found[2]
        elif line.startswith(" ----- DATA FOR CONTACT PATCH"):
            in_patch = True
        labels = tuple(line.split())
        if len(labels) > 1 and all(map(_LABEL.match, labels)) and line.startswith("   "):
            if labels[0] == "MIRRORY" or labels[0] == "ZIGTHRS":
                labels = (profile, *labels)
            below = []
            for row in lines[at + 1 : at + 12]:
                if not row.strip():
                    break
                below.append(row.split())
            case.rows.append((labels, below))
    if case:
        yield case


def _names(names: str, *formats: Format) -> tuple[tuple[str | None, Format], ...]:
    listed = [None if name == "-" else name for name in names.split()]
    return tuple(zip(listed, formats if len(formats) > 1 else formats * len(listed), strict=True))


#: Labels of a row, and for each number the name of the value in an input file with its format. First those of both
#: modules, then those of one.
_ROWS: dict[str, tuple[tuple[str | None, Format], ...]] = {
    "POISS(1) POISS(2) GG(1) GG(2)": _names("POISS1 POISS2 GG1 GG2", g),
    "POISS(R) POISS(W) GG(R) GG(W)": _names("POISS1 POISS2 GG1 GG2", g, g, s, s),
    "FG(1) FG(2) TC(1) TC(2) VT(1) VT(2)": _names("FG1 FG2 TC1 TC2 - -", g, g, s, s, g, g),
    "K0_MF ALFAMF BETAMF": _names("K0 ALFA BETA", g),
    "K0_MF ALFAMF BETAMF K_EFF": _names("K0 ALFA BETA -", g),
    "GG3 LAYTHK TAU_C0 K_TAU": _names("GG3 LAYTHK TAU_C0 K_TAU", g),
    "DX DS DQREL A_SEP D_SEP D_COMB": _names("DX DS DQREL A_SEP D_SEP D_COMB", g),
    "DX DS DQREL A_SEP D_SEP D_COMB D_TURN": _names("DX DS DQREL A_SEP D_SEP D_COMB D_TURN", g),
    "GAUGHT RAILY0 RAILZ0 CANT CURV": _names("GAUGHT RAILY0 RAILZ0 CANT CURV", f(3), f(4), f(4), f(4), s),
    "GAUGHT GAUGWD CANT CURV": _names("GAUGHT GAUGWD CANT CURV", f(3), f(3), f(4), s),
    "DYRAIL DZRAIL DROLLR VYRAIL VZRAIL VROLLR": _names("DYRAIL DZRAIL DROLLR VYRAIL VZRAIL VROLLR", f(4), f(4), f(4), s, s, s),
    "KY_RAIL DY_DEFL FY_RAIL KZ_RAIL DZ_DEFL FZ_RAIL": _names("KYRAIL - FYRAIL KZRAIL - FZRAIL", f(4), s, s, f(4), s, s),
    "DXWHL DYWHL DZWHL DROLLW DYAWW DPITCHW": _names("DXWHL DYWHL DZWHL DROLLW DYAWW DPITCHW", s),
    "VXWHL VYWHL VZWHL VROLLW VYAWW VPITCHW": _names("VXWHL VYWHL VZWHL VROLLW VYAWW VPITCHW", s),
    "SPINXO SPINYO": _names("SPINXO SPINYO", g),
    "FKIN FEXP1 SABSH1 FEXP2 SABSH2": _names("FKIN F1 SABSH1 F2 SABSH2", g),
    "FREF TREF DFHEAT DTHEAT": _names("FREF TREF DFHEAT DTHEAT", g),
    "FSTAT FKIN": _names("FSTAT FKIN", g),
    "ALPHA FSTAT FKIN": _names("ALPHVF FSTAT FKIN", g),
    "ALPHA FREF TREF DFHEAT DTHEAT": _names("ALPHVF FREF TREF DFHEAT DTHEAT", g),
    "SVF FSTAT FKIN": _names("SVF FSTAT FKIN", g),
    "IY FSTAT FKIN": _names("IY FSTAT FKIN", whole, g, g),
    "SEMIAXES PRESCRIBED, AA,BB": _names("AA BB", g),
    "CURVATURE PRESCRIBED, A1,B1": _names("A1 B1", g),
    "CURVATURE AND ELLIPTIC. PRESCRB, A1,AA/BB": _names("A1 AOB", g),
    "POTENTIAL CONTACT, SCALE": _names("- - SCALE", g),
    "DISCRETISATION MX,MY, DX,DY": _names("MX MY - -", whole, whole, g, g),
}
_FRICTION = {name for name in _ROWS if name.split()[0] in ("FKIN", "FREF", "FSTAT", "ALPHA", "SVF", "IY")}
_PROFILE_ROWS = {
    "MIRRORY MIRRORZ ISMOOTH LAMBDA": _names("MIRRORY MIRRORZ ISMOOTH SMOOTH", whole, whole, whole, f(4)),
    "MIRRORY MIRRORZ ISMOOTH L_FILT": _names("MIRRORY MIRRORZ ISMOOTH SMOOTH", whole, whole, whole, f(4)),
    "ZIGTHRS KINKHIG KINKLOW KINKWID MAXOMIT": _names("ZIGTHRS KINKHIGH KINKLOW KINKWID MAXOMIT", g),
}


@dataclass(frozen=True)
class Echo:
    """Holds a printed number, and the number that the program would print for the value that was read."""

    name: str
    printed: str
    expected: str


def echoes(case: Case, printed: Printed) -> Iterator[Echo]:
    """Yields all printed values of a case beside the values that were read. `case` is a contactd.contact_files.Case."""
    for name, digit in printed.digits.items():
        yield Echo(name, str(digit), str(case.digits.get(name)))
    if printed.maxout is not None:
        yield Echo("MAXOUT", str(printed.maxout), str(case.values["MAXOUT"]))
    for profile, file in printed.names.items():
        yield Echo(profile, file, case.values["RFNAME" if profile == "RAIL" else "WFNAME"])
    for labels, below in printed.rows:
        row = " ".join(labels)
        if row in _FRICTION:
            yield from _echoes_of_sets(case.friction, row, below)
        elif row in _ROWS:
            yield from _echoes_of(case.values, _ROWS[row], below[0])
        elif labels[0] in ("RAIL", "WHEEL") and " ".join(labels[1:]) in _PROFILE_ROWS:
            names = _PROFILE_ROWS[" ".join(labels[1:])]
            yield from _echoes_of(case.values, [(f"{labels[0]}_{name}", shown) for name, shown in names], below[0])
        elif labels[0] == "BKTEMP":
            for body in (1, 2):
                names = [(f"{name}{body}", g) for name in ("BKTEMP", "HEATCP", "LAMBDA", "DENS")]
                yield from _echoes_of(case.values, names, below[body - 1])
        elif (names := _by_case(case, labels)) is not None:
            yield from _echoes_of(case.values, names, below[0])


def _echoes_of(values: Any, names: Any, words: list[str]) -> Iterator[Echo]:
    for (name, shown), word in zip(names, words, strict=True):
        if name is not None and not (name == "CANT" and "NOMRADR" in values):  # which is 0 on rollers
            yield Echo(name, word, shown(values[name]))


def _echoes_of_sets(sets: Any, row: str, below: list[list[str]]) -> Iterator[Echo]:
    """Three points replace the rows in the middle of many."""
    rows = [words for words in below if words != ["..."]]
    if len(rows) == len(below):
        yield Echo("NVF", str(len(rows)), str(len(sets)))
    for i, words in enumerate(rows):
        one = sets[int(words[0]) - 1] if row.startswith("IY") else sets[i]
        yield from _echoes_of(one, _ROWS[row], words)


def _by_case(case: Case, labels: tuple[str, ...]) -> Any:
    """In these rows the digits of a case determine which numbers repeat the input and which are results."""
    digit = case.digits
    if labels == ("NU", "G", "AK", "EPS"):
        return (*[_NOT_READ] * 3, ("EPS", g if case.module == 3 else s))
    if labels[0] in ("S_WS", "X_WS") and len(labels) == 6:
        z = ("Z_WS", f(4)) if digit["N"] == 0 else _NOT_READ
        return ((labels[0], gs(4, 6)), ("Y_WS", s), z, ("ROLL", s), ("YAW", s), ("PITCH", s))
    if labels[0] in ("VX_WS", "VPITCH_ROL"):
        pitch = _NOT_READ if digit["F"] == 1 else ("VPITCH", f(7))
        first = ("VS", s) if labels[0] == "VX_WS" else ("RPITCH", f(7))
        return (first, ("VY", s), ("VZ", s), ("VROLL", s), ("VYAW", s), pitch)
    if labels[0] in ("CHI", "DT") and case.module == 3:
        motion = (("CKSI" if digit["F"] == 0 else "FX", s), ("FY" if digit["F"] == 2 else "CETA", s), ("CPHI", s))
        if labels[0] == "DT":
            return (_NOT_READ, ("VELOC", s), *motion)
        # Steady rolling advances by an element, except with one solver.
        as_given = (digit["T"] == 2 and digit["M"] not in (2, 3, 4, 5)) or case.values["GAUSEI"] == 2
        return (("CHI", g), ("DQ", g) if as_given else _NOT_READ, ("VELOC", s), *motion)
    return None
