"""Writes the blocks of an .out file for a case of a wheel on a rail."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import Any

from ...values.generated.wheel_rail.result import WheelRailSolution
from ..case import Case
from ..case_results import is_right, is_roller, pair_of
from ..solved_case import SolvedCase
from .numbers import fixed, fortran_g, general
from .out_heat import heat_lines
from .out_laws import LABELS_OF_LAWS, NAMES_OF_LAWS
from .out_text import case_head, digits, g_row, interfacial_layer, row

__all__ = ["rail_lines"]

_KINDS = {
    1: ("SHIFT TRANSIENT", "SHIFT"),
    2: ("TRANSIENT ROLLING", "CREEPAGE"),
    3: ("STEADY STATE ROLLING", "CREEPAGE"),
}
_FLEXIBLE = (
    ("DXWHL", "DYWHL", "DZWHL", "DROLLW", "DYAWW", "DPITCHW"),
    ("VXWHL", "VYWHL", "VZWHL", "VROLLW", "VYAWW", "VPITCHW"),
)
_DEVIATIONS = ("DYRAIL", "DZRAIL", "DROLLR", "VYRAIL", "VZRAIL", "VROLLR")


def rail_lines(solved: SolvedCase) -> list[str]:
    """Returns the lines of a case above those of its patches, according to its digit O."""
    case = solved.case
    level, digit = case.digits["O"], case.digits
    if level == 0:
        return []
    lines = case_head(case)
    if level >= 2:
        lines += ["", _title(solved), *digits(case)[1:], *_sentences(solved), *_set_up(solved)]
        if digit["E"] >= 1:
            lines += ["", *_wheelset(case, _solution(solved)), ""]
        lines += [""]
    lines += _forces(solved)
    if not solved.answer.patches:
        lines += ["", " ----- NO CONTACT FOUND -----"]
    return lines


def _solution(solved: SolvedCase) -> WheelRailSolution:
    assert solved.answer.wheelrail is not None
    return solved.answer.wheelrail


def _title(solved: SolvedCase) -> str:
    base = "ROLLER" if is_roller(solved.case) else "RAIL"
    count = len(solved.answer.patches)
    patches = "PATCH" if count == 1 else "PATCHES"
    return f" WHEEL-{base} CONTACT, {'RIGHT' if is_right(solved.case) else 'LEFT'} WHEEL,{count:3d} CONTACT {patches}"


def _sentences(solved: SolvedCase) -> Iterator[str]:
    digit, values = solved.case.digits, solved.case.values
    if digit["T"] == 0 and digit["N"] == 0:
        return
    yield f" VERTICAL PROBLEM WITH PRESCRIBED {'VERTICAL FORCE' if digit['N'] == 1 else 'POSITION'}, FULL SOLUTION"
    if digit["T"] == 0:
        return
    kind, motion = _KINDS[digit["T"]]
    yield f" {kind}, {'X-FORCE' if digit['F'] == 1 else motion} PRESCRIBED"
    if pair_of(values).is_quasi_identical or values["MAXOUT"] == 1:
        yield ' JOHNSON"S METHOD IS USED FOR THE FRICTIONAL STRESS'
    else:
        yield f' PANAGIOTOPOULOS" METHOD IS USED FOR THE FRICTIONAL STRESS. MAXOUT={values["MAXOUT"]:3d}'


def _set_up(solved: SolvedCase) -> Iterator[str]:
    case = solved.case
    digit, values = case.digits, case.values
    if digit["C"] >= 2:
        yield from ("", *_materials(values), *heat_lines(case))
        if digit["M"] == 4:
            yield from ("", *interfacial_layer(values))
    if digit["L"] != 1 and digit["T"] != 0:
        yield from ("", *_friction(case))
    if digit["D"] >= 2:
        yield from ("", *_discretisation(values))
    base = "ROLLER" if is_roller(solved.case) else "RAIL"
    if digit["Z"] == 3:
        yield from ("", *_profile(values, base, values["RFNAME"], "RAIL", digit["O"]))
    if digit["Z"] in (1, 3):
        yield from ("", *_track(values))
    if digit["Z"] >= 2 and any(values[name] != 0 for name in _DEVIATIONS):
        yield from ("", f" {base} IRREGULARITY", "     DYRAIL      DZRAIL      DROLLR      VYRAIL      VZRAIL      VROLLR")
        placed = [fixed(values[name], 12, 4) for name in _DEVIATIONS[:3]]
        yield row([*placed, *(general(values[name]) for name in _DEVIATIONS[3:])])
    if digit["E"] in (3, 5):
        yield from ("", *_profile(values, "WHEEL", values["WFNAME"], "WHEEL", digit["O"]))
    if digit["F"] == 3:
        yield from ("", *_deflection(values, _solution(solved)))


def _materials(values: Mapping[str, Any]) -> Iterator[str]:
    pair = pair_of(values)
    yield " MATERIAL CONSTANTS"
    yield "     NU          G           AK          EPS"
    yield row([fortran_g(pair.nu), general(pair.G), fortran_g(pair.difference), general(values["EPS"])])
    yield from ("", "    POISS(R)    POISS(W)     GG(R)       GG(W)")
    yield row([fortran_g(values["POISS1"]), fortran_g(values["POISS2"]), general(values["GG1"]), general(values["GG2"])])


def _friction(case: Case) -> Iterator[str]:
    law = case.values["FRCLAW"]
    place = {1: "ALPHVF", 2: "SVF"}.get(case.values["VARFRC"])
    labels = [*(["ALPHA" if place == "ALPHVF" else "SVF"] if place else []), *LABELS_OF_LAWS[law]]
    names = [*([place] if place else []), *NAMES_OF_LAWS[law]]
    yield " FRICTION LAW PARAMETERS"
    yield "  " + "".join(f"   {label:<9}" for label in labels).rstrip()
    for one in case.friction:
        yield g_row(*(one[name] for name in names))


def _discretisation(values: Mapping[str, Any]) -> Iterator[str]:
    names = ["DX", "DS", "DQREL", "A_SEP", "D_SEP", "D_COMB"]
    if values["D_TURN"] != 2 * values["D_SEP"] - values["D_COMB"]:
        names.append("D_TURN")
    yield " DISCRETISATION PARAMETERS"
    yield "  " + "".join(f"   {name:<9}" for name in names).rstrip()
    yield g_row(*(values[name] for name in names))


def _profile(values: Mapping[str, Any], base: str, name: str, prefix: str, level: int) -> Iterator[str]:
    yield f' {base} PROFILE "{name}"'
    yield f"   MIRRORY     MIRRORZ     ISMOOTH    {'  LAMBDA' if values[f'{prefix}_ISMOOTH'] == 0 else '  L_FILT'}"
    flags = [int(values[f"{prefix}_{flag}"]) for flag in ("MIRRORY", "MIRRORZ", "ISMOOTH")]
    yield f"{flags[0]:7d}{flags[1]:12d}{flags[2]:12d}   {fixed(values[f'{prefix}_SMOOTH'], 12, 4)}"
    if level >= 3:
        yield from ("", "   ZIGTHRS     KINKHIG     KINKLOW      KINKWID     MAXOMIT")
        kinks = [values[f"{prefix}_{limit}"] for limit in ("ZIGTHRS", "KINKHIGH", "KINKLOW", "KINKWID")]
        yield g_row(*kinks, values.get(f"{prefix}_MAXOMIT", 0.5))


def _track(values: Mapping[str, Any]) -> Iterator[str]:
    yield " TRACK DIMENSIONS AND RAIL POSITION"
    curv = general(values["CURV"])
    if values["GAUGHT"] > 0:
        yield "    GAUGHT      GAUGWD        CANT        CURV"
        numbers = [fixed(values["GAUGHT"], 10, 3), fixed(values["GAUGWD"], 12, 3)]
    else:
        yield "    GAUGHT      RAILY0      RAILZ0        CANT        CURV"
        numbers = [fixed(values["GAUGHT"], 10, 3), fixed(values["RAILY0"], 12, 4), fixed(values["RAILZ0"], 12, 4)]
    yield "".join([*numbers, fixed(values.get("CANT", 0.0), 12, 4), curv])


def _deflection(values: Mapping[str, Any], wheel: WheelRailSolution) -> Iterator[str]:
    found = wheel.rail_deflection
    y, z = (0.0, 0.0) if found is None else (found.y, found.z)
    yield " MASSLESS RAIL DEFLECTION"
    yield "     KY_RAIL     DY_DEFL     FY_RAIL     KZ_RAIL     DZ_DEFL     FZ_RAIL"
    yield row([
        fixed(values["KYRAIL"], 12, 4), fixed(y, 12, 4), general(values["FYRAIL"]),
        fixed(values["KZRAIL"], 12, 4), fixed(z, 12, 4), general(values["FZRAIL"]),
    ])  # fmt: skip


def _wheelset(case: Case, wheel: WheelRailSolution) -> Iterator[str]:
    values, roller = case.values, is_roller(case)
    yield " WHEEL-SET POSITION AND VELOCITY"
    yield f"     {'X' if roller else 'S'}_WS        Y_WS        Z_WS        ROLL_WS     YAW_WS      PITCH_WS"
    along = general(values["X_WS"] if roller else values["S_WS"], 4, 6)
    rotated = [general(values[name]) for name in ("ROLL", "YAW", "PITCH")]
    yield row([along, general(values["Y_WS"]), fixed(wheel.z, 12, 4), *rotated])
    yield ""
    yield f"    {'VPITCH_ROL ' if roller else ' VX_WS     '}  VY_WS       VZ_WS       VROLL_WS    VYAW_WS     VPITCH_WS"
    forwards = fixed(values["RPITCH"], 12, 7) if roller else general(values["VS"])
    others = [general(values[name]) for name in ("VY", "VZ", "VROLL", "VYAW")]
    yield row([forwards, *others, fixed(wheel.pitch_rate, 12, 7)])
    for labels in _FLEXIBLE if any(values.get(name, 0) != 0 for row_of in _FLEXIBLE for name in row_of) else ():
        if labels is _FLEXIBLE[0]:
            yield from ("", " FLEXIBLE WHEEL-SET DEVIATIONS")
        yield f"     {''.join(f'{label:<12}' for label in labels)}".rstrip()
        yield row([general(values.get(name, 0.0)) for name in labels])


def _forces(solved: SolvedCase) -> Iterator[str]:
    case, forces = solved.case, _solution(solved).forces
    names = ("FX(TR)", "FY(TR)", "FZ(TR)", "FX(WS)", "FY(WS)", "FZ(WS)")
    if case.digits["O"] >= 2:
        moments = " AND MOMENTS" if case.digits["O"] >= 4 else ""
        yield f" TOTAL FORCES{moments} ON {'ROLLER' if is_roller(solved.case) else 'RAIL'}"
    yield "     FX(TR)      FY(TR)      FZ(TR)      FX(WS)      FY(WS)      FZ(WS)"
    yield "".join(general(solved.answer.numbers[name]) for name in names)
    if case.digits["O"] >= 4:
        at_rail, at_wheel = forces.rail, forces.wheelset
        yield ""
        yield "     MX@R(TR)    MY@R(TR)    MZ@R(TR)    MX@W(WS)    MY@W(WS)    MZ@W(WS)"
        yield "".join(map(general, (at_rail.Mx, at_rail.My, at_rail.Mz, at_wheel.Mx, at_wheel.My, at_wheel.Mz)))
