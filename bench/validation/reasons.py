"""Why given cases differ from what is printed of them. The one list: the page is made from it, and the test of given
cases (tests/integration/test_contact_cases.py) takes no case that differs and is not in it."""

from __future__ import annotations

from collections.abc import Collection, Mapping
from dataclasses import dataclass

__all__ = ["REASONS", "Reason", "reason_of"]

_TESTS = "tests/integration/test_contact_cases.py"
_TESTBANK = "testbank/testbank.inp"
_CONFORMAL = "testbank/examples_conformal"
_TRANSIENT = "testbank/examples_trans"
_SLICES = "testbank/examples_s+c"
_HEAT = "testbank/examples_temp"


@dataclass(frozen=True)
class Reason:
    """Why cases differ.

    Attributes:
        name: In the tables.
        what: What the cases have in common.
        why: What makes the difference, and which program is nearer to the truth.
        cases: Numbers of cases by file. Not all of them need differ.
        shown: What shows it that is neither of the two programs as they are; empty: nothing yet.
    """

    name: str
    what: str
    why: str
    cases: Mapping[str, Collection[int]]
    shown: str = ""


REASONS = (
    Reason(
        "humps under KPEC",
        "KPEC of surfaces with two humps (B = 5)",
        "Its force jumps down where the region of half the approach takes in the second hump, and contactd finds the force beyond "
        "the jump. At the printed height contactd has the printed elements and 7 % less force. There eps exceeds 1 in 12 rows, which "
        "contactd cuts; not cut in the pressures, it brings eight tenths of that force, but not the printed largest pressure",
        {"examples/mbench_a22_kpec.inp": (1,)},
    ),
    Reason(
        "virtual penetration",
        "KPEC and ANALYN on rails (B = 5, 6)",
        "Depth, curvatures and lengths of rows are taken at elements and by straight lines between them in CONTACT, by parabolas in "
        "contactd: up to 0.05 mm of mu Fn in a moment. Case 6: -994 N mm printed, -1127 in contactd, -1204 on elements a quarter as "
        "large. Case 3: -1355, -1361 and -1356, where CONTACT is nearer",
        {"examples/mbench_a22_kpec.inp": (3, 6)},
        "the same cases on elements of a half and a quarter of the size",
    ),
    Reason(
        "second differences",
        "ANALYN's second differences of a distance that is not known to 1e-5 mm (B = 6)",
        "6 N of a force, 23 N mm of a moment, 7 elements of 1016. A noise of 1e-5 mm in the distance moves them by 10 N, 37 N mm "
        "and 3 elements",
        {"examples/mbench_a22_kpec.inp": (5,)},
        "the same distance with that noise, six times",
    ),
    Reason(
        "elements at the bound",
        "FASTSIM with elements that are next to their bound",
        "22 or 24 elements of 1376 slip here and adhere there, and forces agree. They are those that slip by less than 1 % of the "
        "creepage; other cases of the series have none such",
        {"examples/tractcurv.inp": (109, 110, 113)},
        "the same cases at a creepage that is 0.2 % smaller, which have the printed elements",
    ),
    Reason(
        "moments of shifts",
        "moments of shifts (T = 1) about where elements are counted from",
        "The fourth digit of a moment of which most is a force of four digits times 9 mm, or in a conformal contact 40 mm",
        {f"{_TRANSIENT}/m1_catt_shift.inp": range(50, 70), f"{_TRANSIENT}/t3_t1_conformal.inp": range(1, 17)},
        "forces and places of the same cases, which agree",
    ),
    Reason(
        "top of a circle",
        "a creepage of 4e-8 of a leaning roller",
        "2e-5 mm of the height at which it is taken, of rolling radii that differ by less. The profile is a circle, whose top lies "
        "at 0.4996 - 100 (1 - cos 0.1) = 1.65e-5 mm; contactd has 1.63e-5 mm, and the printed creepage is that of -0.5e-5 mm",
        {f"{_CONFORMAL}/test-rollers2.inp": (9,)},
        "the top of the circle",
    ),
    Reason(
        "search lines",
        "rails of slices, a search on a mesh (D = 5)",
        "Where patches carry less than 3 % of the load their angle and place are means over a few nodes, by 1e-3 rad and 0.02 mm. "
        "Where the mesh begins across the rail is known to 0.02 mm only",
        {f"{_SLICES}/mbench_brute.inp": range(1, 36)},
        "the same cases with the mesh 0.015 mm farther across: printed numbers in 34 of 35, the approach of the last one to 2e-7 mm",
    ),
    Reason(
        "moments about places",
        "moments about places that differ in the third decimal",
        "0.1 to 2 % of a spin moment, which is 0.003 mm of the tangential force: contactd has the reference there by 0.002 mm along or "
        "0.001 mm across the rail. About the printed places its moments are those printed",
        {_TESTBANK: (31,), f"{_SLICES}/cw_interrupt.inp": (1,), f"{_SLICES}/mbench_locus.inp": (29,)},
        f"the same moments about the printed places (`{_TESTS}`)",
    ),
    Reason(
        "own heat",
        "friction by temperature (L = 6)",
        "Up to 3 % of mu Fn. CONTACT counts the heat of an element on itself twice: temperatures of full slip are a tenth higher, "
        "and come to the closed form of Hertz's strip from above as elements become smaller. contactd is within 1e-3 of it",
        {f"{_HEAT}/m1_tempdep.inp": (2, 3), f"{_HEAT}/m3_tempdep.inp": (2, 3)},
        "the closed form (`tests/core/temperature/test_surface_temperature.cpp`)",
    ),
    Reason(
        "share of a force",
        "a small share of a force without friction",
        "0.0006 N of 297 N: the lateral share of a normal force, whose direction differs by 2e-6 rad, where 2e-4 rad are in tolerance",
        {_TESTBANK: (21,)},
        "the normal force times the tolerance of its direction, 0.06 N",
    ),
    Reason(
        "first point",
        "contact with the first point of a rail",
        "The height by 0.17 mm, the largest pressure by a quarter, forces by 0.3 % of mu Fn. CONTACT goes on beyond the rail's first "
        "point, to the border of its area: it warns of that, and has 59 of its 104 elements in the row there. In contactd the "
        "rail ends",
        {_TESTBANK: (29,)},
        "the warning and the elements that CONTACT prints",
    ),
    Reason(
        "springs",
        "massless flexible rails (F = 3) with the height given",
        "Z_WS 2.0884 is given, 2.0855 and 2.0685 are printed, and the results are those of the printed heights; what remains "
        "then is that of conformal contact",
        {_TESTBANK: (36, 37)},
        f"the same cases at the printed heights (`{_TESTS}`)",
    ),
)


def reason_of(file: str, number: int) -> Reason | None:
    """Why the case with this number of a file differs; None: no reason is known."""
    return next((one for one in REASONS if number in one.cases.get(file, ())), None)
