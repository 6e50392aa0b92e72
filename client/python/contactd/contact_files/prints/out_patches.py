"""Writes the blocks of an .out file for a patch of a wheel on a rail."""

from __future__ import annotations

from collections.abc import Iterator

from ...values.generated.contact_files import ComputedPatch
from ...values.generated.wheel_rail.result import WheelRailPatch
from ..case_results import Elements, StressField, pair_of, step_on
from .numbers import fixed, fortran_g, general
from .out_division import division, quantities
from .out_heat import largest_temperature
from .out_laws import LABELS_OF_LAWS, cut_rows
from .out_subsurface import extremes
from .out_text import g_row, gs_row, row, statistics_lines

__all__ = ["patch_lines"]


def patch_lines(elements: Elements, number: int) -> list[str]:
    """Returns all lines of a patch, according to the digit O."""
    case, patch, on_rail = elements.case, elements.patch, elements.on_rail
    assert on_rail is not None
    level = case.digits["O"]
    lines = [f" ----- DATA FOR CONTACT PATCH {number:2d}{_history(patch)} -----"]
    if level <= 1:
        return [*lines, *_totals(elements, on_rail)]
    lines += ["", *_reference(patch)]
    if case.values["VARFRC"] in (1, 2) and case.values["FRCLAW"] == 0 and case.digits["T"] != 0:
        lines += ["", *_friction(elements, on_rail)]
    lines += ["", *_motion(elements, on_rail)]
    lines += ["", " TOTAL FORCES, TORSIONAL MOMENT, ELASTIC ENERGY, FRICTIONAL POWER", *_totals(elements, on_rail)]
    lines += ["", *statistics_lines(patch.numbers, 1, 1)]
    if level >= 3:
        lines += ["", *division(elements)]
    if on_rail.place.rows and level >= 3:
        lines += ["", *_surface(on_rail)]
    if level >= 5:
        lines += ["", *quantities(elements)]
    if case.values.get("SUBS_O", 0) >= 1:
        for block, below in enumerate(patch.blocks, 1):
            lines += ["", *extremes(StressField(below), block)]
    return lines


def _history(patch: ComputedPatch) -> str:
    if patch.previous is None:
        return ""
    return f" (PREV {', '.join(f'{one:2d}' for one in patch.previous)})" if patch.previous else " (NEW PATCH)"


def _reference(patch: ComputedPatch) -> Iterator[str]:
    yield " CONTACT REFERENCE LOCATION"
    yield "     XCP(TR)     YCP(TR)     ZCP(TR)    DELTCP(TR)   YCP(R)      ZCP(R)"
    yield _places(patch, "XCP(TR)", "YCP(TR)", "ZCP(TR)", "DELTCP(TR)", "YCP(R)", "ZCP(R)")
    yield ""
    yield "     XCP(W)      YCP(W)      ZCP(W)"
    yield _places(patch, "XCP(W)", "YCP(W)", "ZCP(W)")


def _places(patch: ComputedPatch, *names: str) -> str:
    return "".join(fixed(patch.numbers[name], 12, 4) for name in names)


def _friction(elements: Elements, on_rail: WheelRailPatch) -> Iterator[str]:
    labels = "".join(f"   {label:<9}" for label in LABELS_OF_LAWS[0]).rstrip()
    mus = elements.patch.mu
    yield " FRICTION LAW PARAMETERS"
    if not on_rail.place.rows:
        yield f"  {labels}"
        yield g_row(mus[0], mus[0])
        return
    yield f"      IY      {labels}"
    yield from cut_rows([(mu, mu) for mu in mus], elements.case.digits["O"])


def _motion(elements: Elements, on_rail: WheelRailPatch) -> Iterator[str]:
    motion = on_rail.place.creepages
    yield " KINEMATIC CONSTANTS"
    yield "     CHI         DQ          VELOC       CKSI        CETA        CPHI"
    given = [general(value) for value in (motion.velocity, motion.xi, motion.eta, motion.phi)]
    yield row([fortran_g(motion.chi), fortran_g(step_on(elements.case, elements.patch)), *given])
    centre = [elements.patch.numbers[name] for name in ("SPINXO", "SPINYO")]
    if any(centre):
        yield from ("", "     SPINXO      SPINYO", row([fortran_g(number) for number in centre]))


def _totals(elements: Elements, on_rail: WheelRailPatch) -> Iterator[str]:
    case, numbers, forces = elements.case, elements.patch.numbers, on_rail.solution.forces
    bar = "BAR_" if on_rail.place.rows else ""
    heads = "".join(f"   {bar + name:<9}" for name in ("FN", "FX", "FS"))
    yield f"  {heads}   MN         ELAST.EN.   FRIC.POWER"
    yield gs_row(*(numbers[name] for name in (f"{bar}FN", f"{bar}FX", f"{bar}FS", "MN", "ELAST.EN.", "FRIC")))
    varies = bool(bar) and case.values["VARFRC"] > 0
    shares = "   FX/FN       FS/FN    " if varies else " FX/FSTAT/FN FS/FSTAT/FN"
    label, largest = largest_temperature(numbers)
    yield f"     {'TILDE_FN ' if bar else 'FN/G     '}{shares}   APPROACH     PMAX    {label}"
    unit = (forces.Fn if varies else elements.patch.friction_bound) or 1.0
    normal = forces.Fn if bar else forces.Fn / pair_of(case.values).G
    approach = general(numbers["APPROACH"], 6, 4)
    tangential = [general(force / unit) for force in (forces.Fx, forces.Fy)]
    yield row([general(normal), *tangential, approach, general(numbers["PMAX"]), *largest])


def _surface(patch: WheelRailPatch) -> Iterator[str]:
    rows = patch.place.rows
    yield f" CURVED REFERENCE SURFACE, TRACK COORDINATES,{len(rows):5d} POINTS:"
    yield "    I        Y(I)       Z(I)       A(I)"
    for number, one in enumerate(rows, 1):
        yield f"{number:6d}{fixed(one.y, 11, 4)}{fixed(one.z, 11, 4)}{fixed(one.angle, 11, 4)}"
