"""Writes the blocks of an .out file for a patch of a wheel on a rail."""

from __future__ import annotations

from collections.abc import Iterator

from ...values.generated.wheel_rail.result import WheelRailPatch
from ..answers.rail_results import RailResult
from ..problems.bodies import pair_of
from .numbers import fixed, fortran_g, general
from .out_division import division, quantities
from .out_heat import largest_temperature
from .out_laws import LABELS_OF_LAWS, cut_rows
from .out_subsurface import extremes
from .out_text import g_row, gs_row, row, statistics_lines

__all__ = ["patch_lines"]


def patch_lines(result: RailResult, patch: WheelRailPatch, number: int) -> list[str]:
    """Returns all lines of a patch, according to the digit O."""
    case = result.contact.case
    level = case.digits["O"]
    lines = [f" ----- DATA FOR CONTACT PATCH {number:2d}{_history(result, patch)} -----"]
    if level <= 1:
        return [*lines, *_totals(result, patch)]
    lines += ["", *_reference(result, patch)]
    if case.values["VARFRC"] in (1, 2) and case.values["FRCLAW"] == 0 and case.digits["T"] != 0:
        lines += ["", *_friction(result, patch)]
    lines += ["", *_motion(result, patch)]
    lines += ["", " TOTAL FORCES, TORSIONAL MOMENT, ELASTIC ENERGY, FRICTIONAL POWER", *_totals(result, patch)]
    numbers = result.numbers_of(patch)
    lines += ["", *statistics_lines([int(numbers[name]) for name in ("NPOT", "NCON", "NADH", "NSLIP", "NPLAST") if name in numbers], 1, 1)]
    elements = result.elements_of(patch)
    if level >= 3:
        lines += ["", *division(elements)]
    if patch.place.rows and level >= 3:
        lines += ["", *_surface(patch)]
    if level >= 5:
        lines += ["", *quantities(elements)]
    if case.values.get("SUBS_O", 0) >= 1:
        for block, below in enumerate(result.stresses_of(patch), 1):
            lines += ["", *extremes(below, block)]
    return lines


def _history(result: RailResult, patch: WheelRailPatch) -> str:
    numbers = result.goes_on_from(patch)
    if numbers is None:
        return ""
    return f" (PREV {', '.join(f'{one:2d}' for one in numbers)})" if numbers else " (NEW PATCH)"


def _reference(result: RailResult, patch: WheelRailPatch) -> Iterator[str]:
    reference = patch.place.reference
    yield " CONTACT REFERENCE LOCATION"
    yield "     XCP(TR)     YCP(TR)     ZCP(TR)    DELTCP(TR)   YCP(R)      ZCP(R)"
    on_rail, on_wheel = result.on_rail(patch), result.on_wheel(patch)
    yield _places(reference.x, reference.y, reference.z, reference.angle, *on_rail)
    yield ""
    yield "     XCP(W)      YCP(W)      ZCP(W)"
    yield _places(*on_wheel)


def _places(*numbers: float) -> str:
    return "".join(fixed(number, 12, 4) for number in numbers)


def _friction(result: RailResult, patch: WheelRailPatch) -> Iterator[str]:
    labels = "".join(f"   {label:<9}" for label in LABELS_OF_LAWS[0]).rstrip()
    rows = result.mu_of_rows(patch)
    yield " FRICTION LAW PARAMETERS"
    if not rows:
        mu = result.mu_of(patch)
        yield f"  {labels}"
        yield g_row(mu, mu)
        return
    yield f"      IY      {labels}"
    yield from cut_rows([(mu, mu) for mu in rows], result.contact.case.digits["O"])


def _motion(result: RailResult, patch: WheelRailPatch) -> Iterator[str]:
    motion = patch.place.creepages
    yield " KINEMATIC CONSTANTS"
    yield "     CHI         DQ          VELOC       CKSI        CETA        CPHI"
    given = [general(value) for value in (motion.velocity, motion.xi, motion.eta, motion.phi)]
    yield row([fortran_g(motion.chi), fortran_g(result.contact.step_on(patch.place.grid)), *given])
    centre = result.spin_centre(patch)
    if any(centre):
        yield from ("", "     SPINXO      SPINYO", row([fortran_g(number) for number in centre]))


def _totals(result: RailResult, patch: WheelRailPatch) -> Iterator[str]:
    case, numbers = result.contact.case, result.numbers_of(patch)
    bar, tilde = ("BAR_", "TILDE_") if patch.place.rows else ("", "")
    heads = "".join(f"   {bar + name:<9}" for name in ("FN", "FX", "FS"))
    yield f"  {heads}   MN         ELAST.EN.   FRIC.POWER"
    yield gs_row(*(numbers[name] for name in (f"{bar}FN", f"{bar}FX", f"{bar}FS", "MN", "ELAST.EN.", "FRIC")))
    varies = bool(bar) and case.values["VARFRC"] > 0
    shares = "   FX/FN       FS/FN    " if varies else " FX/FSTAT/FN FS/FSTAT/FN"
    first = "TILDE_FN " if tilde else "FN/G     "
    label, largest = largest_temperature(numbers)
    yield f"     {first}{shares}   APPROACH     PMAX    {label}"
    unit = (1.0 if varies else result.mu_of(patch)) * patch.solution.Fn or 1.0
    normal = patch.solution.Fn if tilde else patch.solution.Fn / pair_of(case.values).G
    approach = general(numbers["APPROACH"], 6, 4)
    tangential = [general(force / unit) for force in (patch.solution.Fx, patch.solution.Fy)]
    yield row([general(normal), *tangential, approach, general(numbers["PMAX"]), *largest])


def _surface(patch: WheelRailPatch) -> Iterator[str]:
    rows = patch.place.rows
    yield f" CURVED REFERENCE SURFACE, TRACK COORDINATES,{len(rows):5d} POINTS:"
    yield "    I        Y(I)       Z(I)       A(I)"
    for number, one in enumerate(rows, 1):
        yield f"{number:6d}{fixed(one.y, 11, 4)}{fixed(one.z, 11, 4)}{fixed(one.angle, 11, 4)}"
