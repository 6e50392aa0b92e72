"""Writes the blocks of an .out file for a case of basic contact."""

from __future__ import annotations

from collections.abc import Iterator

from ..answers.basic_results import BasicResult
from ..problems.bodies import combined, is_viscoelastic
from .numbers import fixed, fortran_g, general
from .out_division import division, quantities
from .out_heat import heat_lines, largest_temperature
from .out_laws import LABELS_OF_LAWS, NAMES_OF_LAWS, cut_rows
from .out_subsurface import extremes
from .out_text import case_head, digits, g_row, gs_row, interfacial_layer, row, statistics_lines

__all__ = ["basic_lines"]

def basic_lines(result: BasicResult) -> list[str]:
    """Returns all lines of a case, according to its digit O."""
    case = result.contact.case
    level, digit = case.digits["O"], case.digits
    if level == 0:
        return []
    lines = case_head(case)
    if level == 1:
        return [*lines, *_totals(result)]
    lines += [*digits(case), *_sentences(result)]
    if digit["Z"] >= 1 and case.values["IPOTCN"] < 0:
        lines += ["", *_hertz(result)]
    if digit["C"] >= 2:
        lines += ["", *_materials(result)]
    if digit["C"] >= 2 and is_viscoelastic(case):
        lines += ["", *_creep(result)]
    if digit["C"] >= 2 and digit["M"] == 4:
        lines += ["", *interfacial_layer(case.values)]
    if digit["L"] != 1:
        lines += ["", *_friction(result)]
    lines += ["", *_motion(result)]
    lines += ["", " TOTAL FORCES, TORSIONAL MOMENT, ELASTIC ENERGY, FRICTIONAL POWER", *_totals(result)]
    lines += ["", *_sensitivities(result), "", *_statistics(result)]
    if level >= 3:
        lines += ["", *division(result.elements)]
    if level >= 5:
        lines += ["", *quantities(result.elements)]
    if case.values.get("SUBS_O", 0) >= 1:
        for number, below in enumerate(result.stresses, 1):
            lines += ["", *extremes(below, number)]
    return lines



def _sentences(result: BasicResult) -> Iterator[str]:
    digit, values = result.contact.case.digits, result.contact.case.values
    if digit["B"] in (2, 3):
        yield f" NORMAL PROBLEM SKIPPED, {'ELLIPTICAL' if digit['B'] == 2 else 'PARABOLICAL'} TRACTION BOUND"
    else:
        yield f" NORMAL PROBLEM WITH PRESCRIBED {'NORMAL FORCE' if digit['N'] == 1 else 'APPROACH'}, FULL SOLUTION"
    if digit["T"] == 0:
        return
    kind = (" SHIFT TRANSIENT", " TRANSIENT ROLLING", " STEADY STATE ROLLING")[digit["T"] - 1]
    yield kind + (',  "FASTSIM APPROACH"' if digit["M"] == 3 else "")
    yield (" CREEPAGE PRESCRIBED", " X-FORCE,  Y-CREEPAGE PRESCRIBED", " TANGENTIAL FORCE PRESCRIBED")[digit["F"]]
    if result.contact.pair.is_quasi_identical or values["MAXOUT"] == 1:
        yield ' JOHNSON"S METHOD IS USED FOR THE FRICTIONAL STRESS'
    else:
        yield f' PANAGIOTOPOULOS" METHOD IS USED FOR THE FRICTIONAL STRESS. MAXOUT={values["MAXOUT"]:3d}'


def _hertz(result: BasicResult) -> Iterator[str]:
    values, grid, ellipse = result.contact.case.values, result.contact.area.grid, result.contact.area.ellipse
    assert ellipse is not None

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
        yield line("THE CURVATURES A1,B1 ARE:", ellipse.a1, ellipse.b1)
    if option != -3:
        yield line("BASIC SEMIAXES AA,BB, RATIO", ellipse.aa, ellipse.bb, ellipse.aa / ellipse.bb)
    yield line("EFFECTIVE RAD.CURV RHO, SEMI-AXIS CP", ellipse.rho, ellipse.cp)
    yield line("POTENTIAL CONTACT, SCALE:", grid.x[0] - grid.dx / 2, grid.y[0] - grid.dy / 2, values["SCALE"])
    yield f" {'DISCRETISATION MX,MY, DX,DY:':<42}{grid.nx:6d}{grid.ny:6d}{fortran_g(grid.dx)}{fortran_g(grid.dy)}"


def _materials(result: BasicResult) -> Iterator[str]:
    values, pair = result.contact.case.values, result.contact.pair
    yield " MATERIAL CONSTANTS"
    yield "     NU          G           AK          EPS"
    yield g_row(pair.nu, pair.G, pair.difference, values["EPS"])
    yield ""
    yield "    POISS(1)    POISS(2)     GG(1)       GG(2)"
    yield g_row(*(values[name] for name in ("POISS1", "POISS2", "GG1", "GG2")))
    yield from heat_lines(result.contact.case)


def _creep(result: BasicResult) -> Iterator[str]:
    """Returns the combined pair of the program: relaxed if the bodies have no creep time."""
    values, velocity = result.contact.case.values, result.velocity
    f1, f2, tau1, tau2 = (values[name] for name in ("FG1", "FG2", "TC1", "TC2"))
    relaxed = [G if tau > 0 else G / (1 + f) for G, f, tau in ((values["GG1"], f1, tau1), (values["GG2"], f2, tau2))]
    nu, G, difference = combined(values["POISS1"], values["POISS2"], *relaxed)
    yield " VISCOELASTIC MATERIAL CONSTANTS"
    yield "     NUV         GV          AKV"
    yield g_row(nu, G, difference)
    yield ""
    yield "     FG(1)       FG(2)       TC(1)       TC(2)       VT(1)       VT(2)"
    yield row([*map(fortran_g, (f1, f2)), *map(general, (tau1, tau2, tau1 * velocity, tau2 * velocity))])


def _friction(result: BasicResult) -> Iterator[str]:
    case = result.contact.case
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


def _motion(result: BasicResult) -> Iterator[str]:
    contact, values, digit = result.contact, result.contact.case.values, result.contact.case.digits
    yield " KINEMATIC CONSTANTS"
    x = "FX/FSTAT/FN " if "FX" in values else "  CKSI      "
    y = "FY/FSTAT/FN " if "FY" in values else "  CETA      "
    first = "   CHI         DQ          VELOC     " if digit["T"] >= 2 else "   DT          VELOC     "
    yield f"  {first}{x}{y}  CPHI"
    motion = (values["FX"] if "FX" in values else values["CKSI"], values["FY"] if "FY" in values else values["CETA"])
    given = [general(value) for value in (result.velocity, *motion, values["CPHI"])]
    if digit["T"] >= 2:
        yield row([fortran_g(contact.chi), fortran_g(contact.dq), *given])
    else:
        yield row([f"{fixed(1.0, 8, 3)}    ", *given])
    if (values["SPINXO"], values["SPINYO"]) != (0, 0):
        yield "     SPINXO      SPINYO"
        yield gs_row(values["SPINXO"], values["SPINYO"])


def _totals(result: BasicResult) -> Iterator[str]:
    case, numbers, unit = result.contact.case, result.numbers, result.force_unit or 1.0
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
    yield row([general(numbers["FN"] / result.contact.pair.G), *shown, approach, pmax, *largest])


def _sensitivities(result: BasicResult) -> Iterator[str]:
    none = general(0.0, 3, 3)
    if result.contact.case.digits["T"] == 0:
        yield from (" THE SENSITIVITIES.", " A ZERO MEANS THAT IT HAS NOT BEEN CALCULATED.", "  DFN/DPEN", none)
        return
    yield " THE SENSITIVITIES. (FX,FY) MEANS: (FX,FY)/FN/FSTAT."
    yield " A ZERO ENTRY MEANS THAT IT HAS NOT BEEN CALCULATED."
    yield "         DF/DPEN     DF/DKSI     DF/DETA     DF/DPHI"
    for name in ("FN", "FX", "FY"):
        yield f"   {name} " + none.rjust(12) + 3 * none


def _statistics(result: BasicResult) -> Iterator[str]:
    numbers, outer = result.numbers, result.solution.evidence.outer
    counts = [int(numbers[name]) for name in ("NPOT", "NCON", "NADH", "NSLIP", "NPLAST") if name in numbers]
    rounds = 1 if outer is None else outer.iterations
    *words, last = statistics_lines(counts, rounds, rounds if result.contact.case.digits["T"] > 0 else 0)
    yield from (*words, f" {last}")
