"""Lists the reasons for differences between given cases and their printed results. The page is made from this list.
The test of given cases (tests/integration/test_contact_cases.py) fails for a case that differs and is not in it."""

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
    """A reason for differences.

    Attributes:
        name: Name in the tables.
        what: Common property of the cases.
        why: Cause of the difference, and the program that is closer to the truth.
        cases: Numbers of cases by file. Some of them may agree.
        shown: Evidence independent of both programs; empty if there is none yet.
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
        "The force drops abruptly where the region at half the approach includes the second hump, and contactd finds the force beyond "
        "this drop. At the printed height contactd has the same elements as printed and 7 % less force. There contactd limits eps to 1 "
        "in 12 rows; without this limit in the pressures, eight tenths of the difference vanish, but the printed largest pressure "
        "is not reached",
        {"examples/mbench_a22_kpec.inp": (1,)},
    ),
    Reason(
        "virtual penetration",
        "KPEC and ANALYN on rails (B = 5, 6)",
        "CONTACT evaluates depth, curvatures and lengths of rows at elements with linear interpolation, contactd with parabolas. The "
        "moments differ by up to 0.05 mm times mu Fn. Case 6: -994 N mm printed, -1127 in contactd, -1204 on elements of a quarter of "
        "the size. Case 3: -1355, -1361 and -1356, where CONTACT is more accurate",
        {"examples/mbench_a22_kpec.inp": (3, 6)},
        "the same cases on elements of a half and a quarter of the size",
    ),
    Reason(
        "second differences",
        "ANALYN's second differences of a distance whose error is about 1e-5 mm (B = 6)",
        "The differences are 6 N in a force, 23 N mm in a moment, and 7 of 1016 elements. Noise of 1e-5 mm in the distance changes "
        "them by 10 N, 37 N mm and 3 elements",
        {"examples/mbench_a22_kpec.inp": (5,)},
        "the same distance with that noise, six times",
    ),
    Reason(
        "elements at the bound",
        "FASTSIM with elements close to their traction bound",
        "22 or 24 of 1376 elements slip in one program and adhere in the other, and the forces agree. Their slip is less than 1 % of "
        "the creepage. Other cases of the series have no such elements",
        {"examples/tractcurv.inp": (109, 110, 113)},
        "the same cases at a creepage smaller by 0.2 %, which have the printed elements",
    ),
    Reason(
        "moments of shifts",
        "moments of shifts (T = 1) about the origin of the elements",
        "The fourth digit of a moment differs. Most of this moment is a force of four digits times 9 mm, or 40 mm in a conformal "
        "contact",
        {f"{_TRANSIENT}/m1_catt_shift.inp": range(50, 70), f"{_TRANSIENT}/t3_t1_conformal.inp": range(1, 17)},
        "forces and positions of the same cases, which agree",
    ),
    Reason(
        "top of a circle",
        "a creepage of 4e-8 on a leaning roller",
        "The creepages refer to heights that differ by 2e-5 mm, because of small differences in rolling radii. The profile is a "
        "circle, whose top is at 0.4996 - 100 (1 - cos 0.1) = 1.65e-5 mm; contactd uses 1.63e-5 mm, and the printed creepage "
        "corresponds to -0.5e-5 mm",
        {f"{_CONFORMAL}/test-rollers2.inp": (9,)},
        "the top of the circle",
    ),
    Reason(
        "search lines",
        "rails with slices and a search on a mesh (D = 5)",
        "Angle and position of patches with less than 3 % of the load are means over a few nodes, and differ by 1e-3 rad and 0.02 mm. "
        "The lateral origin of CONTACT's mesh is known only to 0.02 mm",
        {f"{_SLICES}/mbench_brute.inp": range(1, 36)},
        "the same cases with the mesh displaced laterally by 0.015 mm: 34 of 35 agree, and the approach of the last one to 2e-7 mm",
    ),
    Reason(
        "moments about places",
        "moments about points that differ in the third decimal",
        "Spin moments differ by 0.1 to 2 %, which is 0.003 mm times the tangential force. The references of contactd differ by 0.002 mm "
        "along or 0.001 mm across the rail. About the printed points the moments agree",
        {_TESTBANK: (31,), f"{_SLICES}/cw_interrupt.inp": (1,), f"{_SLICES}/mbench_locus.inp": (29,)},
        f"the same moments about the printed points (`{_TESTS}`)",
    ),
    Reason(
        "own heat",
        "friction by temperature (L = 6)",
        "The differences reach 3 % of mu Fn. CONTACT counts the effect of an element's heat on itself twice: its temperatures in full "
        "slip are a tenth too high, and converge to the closed form of Hertz's strip from above. contactd agrees with it within 1e-3",
        {f"{_HEAT}/m1_tempdep.inp": (2, 3), f"{_HEAT}/m3_tempdep.inp": (2, 3)},
        "the closed form (`tests/core/temperature/test_surface_temperature.cpp`)",
    ),
    Reason(
        "share of a force",
        "a small component of a force without friction",
        "The lateral component of a normal force of 297 N differs by 0.0006 N. Its direction differs by 2e-6 rad, and the tolerance "
        "is 2e-4 rad",
        {_TESTBANK: (21,)},
        "the normal force times the tolerance of its direction, 0.06 N",
    ),
    Reason(
        "first point",
        "contact at the first point of a rail",
        "The height differs by 0.17 mm, the largest pressure by a quarter, and forces by 0.3 % of mu Fn. CONTACT continues beyond the "
        "first point of the rail, to the border of its area. It warns of this, and has 59 of its 104 elements in that row. In "
        "contactd the rail ends there",
        {_TESTBANK: (29,)},
        "the warning and the elements printed by CONTACT",
    ),
    Reason(
        "springs",
        "massless flexible rails (F = 3) with a prescribed height",
        "Z_WS = 2.0884 is given, 2.0855 and 2.0685 are printed, and the results correspond to the printed heights. The remaining "
        "differences are those of conformal contact",
        {_TESTBANK: (36, 37)},
        f"the same cases at the printed heights (`{_TESTS}`)",
    ),
)


def reason_of(file: str, number: int) -> Reason | None:
    """Returns the reason why the case with this number of a file differs, or None if no reason is known."""
    return next((one for one in REASONS if number in one.cases.get(file, ())), None)
