"""Writes the blocks of an .out file for a case of basic contact."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping
from typing import Any

from ...values.generated.contact_files import ComputedPatch
from ...values.generated.evidence import ContactEvidence
from ..case import Case
from ..case_results import StressField, pair_of, rolling_step
from ..solved_case import SolvedCase
from .numbers import fixed, fortran_g, general
from .out_division import division, quantities
from .out_heat import heat_lines, largest_temperature
from .out_laws import LABELS_OF_LAWS, NAMES_OF_LAWS, cut_rows
from .out_subsurface import extremes
from .out_text import case_head, digits, g_row, gs_row, interfacial_layer, row, statistics_lines

__all__ = ["basic_lines"]

_VISCOELASTIC = 1  #: M


def basic_lines(solved: SolvedCase) -> list[str]:
    """Returns all lines of a case, according to its digit O."""
    case, (elements,), contact = solved.case, solved.elements, solved.answer.contact
    level, digit, patch = case.digits["O"], case.digits, elements.patch
    assert contact is not None
    if level == 0:
        return []
    lines = case_head(case)
    if level == 1:
        return [*lines, *_totals(case, patch)]
    lines += [*digits(case), *_sentences(case)]
    if digit["Z"] >= 1 and case.values["IPOTCN"] < 0:
        lines += ["", *_hertz(case, patch)]
    if digit["C"] >= 2:
        lines += ["", *_materials(case)]
    if digit["C"] >= 2 and digit["M"] == _VISCOELASTIC:
        lines += ["", *_creep(case.values)]
    if digit["C"] >= 2 and digit["M"] == 4:
        lines += ["", *interfacial_layer(case.values)]
    if digit["L"] != 1:
        lines += ["", *_friction(case)]
    lines += ["", *_motion(case, patch)]
    lines += ["", " TOTAL FORCES, TORSIONAL MOMENT, ELASTIC ENERGY, FRICTIONAL POWER", *_totals(case, patch)]
    lines += ["", *_sensitivities(case), "", *_statistics(case, patch, contact.evidence)]
    if level >= 3:
        lines += ["", *division(elements)]
    if level >= 5:
        lines += ["", *quantities(elements)]
    if case.values.get("SUBS_O", 0) >= 1:
        for number, below in enumerate(patch.blocks, 1):
            lines += ["", *extremes(StressField(below), number)]
    return lines


def _sentences(case: Case) -> Iterator[str]:
    digit, values = case.digits, case.values
    if digit["B"] in (2, 3):
        yield f" NORMAL PROBLEM SKIPPED, {'ELLIPTICAL' if digit['B'] == 2 else 'PARABOLICAL'} TRACTION BOUND"
    else:
        yield f" NORMAL PROBLEM WITH PRESCRIBED {'NORMAL FORCE' if digit['N'] == 1 else 'APPROACH'}, FULL SOLUTION"
    if digit["T"] == 0:
        return
    kind = (" SHIFT TRANSIENT", " TRANSIENT ROLLING", " STEADY STATE ROLLING")[digit["T"] - 1]
    yield kind + (',  "FASTSIM APPROACH"' if digit["M"] == 3 else "")
    yield (" CREEPAGE PRESCRIBED", " X-FORCE,  Y-CREEPAGE PRESCRIBED", " TANGENTIAL FORCE PRESCRIBED")[digit["F"]]
    if pair_of(values).is_quasi_identical or values["MAXOUT"] == 1:
        yield ' JOHNSON"S METHOD IS USED FOR THE FRICTIONAL STRESS'
    else:
        yield f' PANAGIOTOPOULOS" METHOD IS USED FOR THE FRICTIONAL STRESS. MAXOUT={values["MAXOUT"]:3d}'


def _hertz(case: Case, patch: ComputedPatch) -> Iterator[str]:
    values, grid = case.values, patch.grid
    a1, b1, aa, bb = (patch.numbers[name] for name in ("A1", "B1", "AA", "BB"))

    def line(label: str, *numbers: float) -> str:
        return f" {label:<42}" + "".join(map(fortran_g, numbers))

    yield f" 3D HERTZIAN GEOMETRY WITH PRESCRIBED {'NORMAL FORCE' if 'FN' in values else 'APPROACH'}"
    option = values["IPOTCN"]
    if option == -2:
        yield line("CURVATURE AND ELLIPTIC. PRESCRB, A1,AA/BB:", values["A1"], values["AOB"])
    elif option == -1:
        yield line("CURVATURE PRESCRIBED, A1,B1:", values["A1"], values["B1"])
    elif option == -3:
        yield line("SEMIAXES PRESCRIBED, AA,BB:", values["AA"], values["BB"])
    elif option == -6:
        yield line("SEMIAXES PRESCRIBED, AA,BNEG,BPOS:", values["AA"], values["BNEG"], values["BPOS"])
    if option != -1:
        yield line("THE CURVATURES A1,B1 ARE:", a1, b1)
    if option != -3:
        yield line("BASIC SEMIAXES AA,BB, RATIO", aa, bb, aa / bb)
    yield line("EFFECTIVE RAD.CURV RHO, SEMI-AXIS CP", 2 / (a1 + b1), math.sqrt(aa * bb))
    yield line("POTENTIAL CONTACT, SCALE:", grid.x[0] - grid.dx / 2, grid.y[0] - grid.dy / 2, values["SCALE"])
    yield f" {'DISCRETISATION MX,MY, DX,DY:':<42}{grid.nx:6d}{grid.ny:6d}{fortran_g(grid.dx)}{fortran_g(grid.dy)}"


def _materials(case: Case) -> Iterator[str]:
    values, pair = case.values, pair_of(case.values)
    yield " MATERIAL CONSTANTS"
    yield "     NU          G           AK          EPS"
    yield g_row(pair.nu, pair.G, pair.difference, values["EPS"])
    yield ""
    yield "    POISS(1)    POISS(2)     GG(1)       GG(2)"
    yield g_row(*(values[name] for name in ("POISS1", "POISS2", "GG1", "GG2")))
    yield from heat_lines(case)


def _creep(values: Mapping[str, Any]) -> Iterator[str]:
    """Returns the combined pair of the program: relaxed if the bodies have no creep time."""
    velocity = values["VELOC"]
    f1, f2, tau1, tau2 = (values[name] for name in ("FG1", "FG2", "TC1", "TC2"))
    g1, g2 = (G if tau > 0 else G / (1 + f) for G, f, tau in ((values["GG1"], f1, tau1), (values["GG2"], f2, tau2)))
    relaxed = pair_of(values, (g1, g2))
    yield " VISCOELASTIC MATERIAL CONSTANTS"
    yield "     NUV         GV          AKV"
    yield g_row(relaxed.nu, relaxed.G, relaxed.difference)
    yield ""
    yield "     FG(1)       FG(2)       TC(1)       TC(2)       VT(1)       VT(2)"
    yield row([*map(fortran_g, (f1, f2)), *map(general, (tau1, tau2, tau1 * velocity, tau2 * velocity))])


def _friction(case: Case) -> Iterator[str]:
    law, sets = case.values["FRCLAW"], case.friction
    names = NAMES_OF_LAWS[law]
    labels = "".join(f"   {name:<9}" for name in LABELS_OF_LAWS[law]).rstrip()
    yield " FRICTION LAW PARAMETERS"
    if case.values["VARFRC"] != 3:
        yield "  " + labels
        yield g_row(*(sets[0][name] for name in names))
        return
    yield "      IY      " + labels
    yield from cut_rows([[one[name] for name in names] for one in sets], case.digits["O"])


def _motion(case: Case, patch: ComputedPatch) -> Iterator[str]:
    values, digit = case.values, case.digits
    yield " KINEMATIC CONSTANTS"
    x = "FX/FSTAT/FN " if "FX" in values else "  CKSI      "
    y = "FY/FSTAT/FN " if "FY" in values else "  CETA      "
    first = "   CHI         DQ          VELOC     " if digit["T"] >= 2 else "   DT          VELOC     "
    yield f"  {first}{x}{y}  CPHI"
    motion = (values["FX"] if "FX" in values else values["CKSI"], values["FY"] if "FY" in values else values["CETA"])
    given = [general(value) for value in (values["VELOC"], *motion, values["CPHI"])]
    if digit["T"] >= 2:
        yield row([*map(fortran_g, rolling_step(case, patch)), *given])
    else:
        yield row([f"{fixed(1.0, 8, 3)}    ", *given])
    if (values["SPINXO"], values["SPINYO"]) != (0, 0):
        yield "     SPINXO      SPINYO"
        yield gs_row(values["SPINXO"], values["SPINYO"])


def _totals(case: Case, patch: ComputedPatch) -> Iterator[str]:
    numbers, unit = patch.numbers, patch.mu[0] * patch.numbers["FN"] or 1.0
    kind = "POWER" if case.digits["T"] >= 2 else "WORK"
    yield f"     FN          FX          FY          MZ         ELAST.EN.   FRIC.{kind}"
    yield gs_row(*(numbers[name] for name in ("FN", "FX", "FY", "MZ", "ELAST.EN.", "FRIC")))
    labels, shown = "", []
    for axis in "XY":
        found = next((name for name in numbers if name.endswith(f" {axis}")), None)
        share = f"  F{axis}/FN       " if case.values["VARFRC"] == 3 else f"F{axis}/FSTAT/FN  "
        labels += f" {found}     " if found else share[:13]
        shown.append(general(numbers[found] if found else numbers[f"F{axis}"] / unit))
    label, largest = largest_temperature(numbers)
    yield f"     FN/G      {labels}APPROACH     PMAX    {label}"
    approach, pmax = general(numbers["APPROACH"], 6, 4), general(numbers["PMAX"])
    yield row([general(numbers["FN"] / pair_of(case.values).G), *shown, approach, pmax, *largest])


def _sensitivities(case: Case) -> Iterator[str]:
    none = general(0.0, 3, 3)
    if case.digits["T"] == 0:
        yield from (" THE SENSITIVITIES.", " A ZERO MEANS THAT IT HAS NOT BEEN CALCULATED.", "  DFN/DPEN", none)
        return
    yield " THE SENSITIVITIES. (FX,FY) MEANS: (FX,FY)/FN/FSTAT."
    yield " A ZERO ENTRY MEANS THAT IT HAS NOT BEEN CALCULATED."
    yield "         DF/DPEN     DF/DKSI     DF/DETA     DF/DPHI"
    for name in ("FN", "FX", "FY"):
        yield f"   {name} " + none.rjust(12) + 3 * none


def _statistics(case: Case, patch: ComputedPatch, evidence: ContactEvidence) -> Iterator[str]:
    rounds = 1 if evidence.outer is None else evidence.outer.iterations
    *words, last = statistics_lines(patch.numbers, rounds, rounds if case.digits["T"] > 0 else 0)
    yield from (*words, f" {last}")
