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
_FLATS = "testbank/examples_oor"
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
        "Up to 0.2 % of mu Fn, and of moments 0.05 mm of mu Fn. Not decided",
        {"examples/mbench_a22_kpec.inp": (3, 6)},
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
        "conformal",
        "conformal contact (D = 4)",
        "0.1 % to 0.3 % of mu Fn, and printed creepages by 0.5 %. Creepages are a fit that is not told in full, and friction "
        "by angle goes by the rail's angle at each row in contactd. 3 % of mu Fn in case 3 of `t3_t2_conformal`, of which a patch is "
        "told at an angle that is another by 0.015 rad",
        {
            "examples/mbench_a22_varfric.inp": (5, 7),
            f"{_TRANSIENT}/t3_t1_conformal.inp": range(1, 17),
            f"{_TRANSIENT}/t3_t2_conformal.inp": range(1, 7),
            _TESTBANK: (35,),
        },
    ),
    Reason(
        "shifts on flanks",
        "shifts (T = 1) of patches on flanks",
        "Elements are fixed to the rail, and where the mesh of the wheel lies then is not told: on surfaces that bend by an "
        "element's width the approach differs by 1 %, and forces of small patches with it. Not decided",
        {f"{_TRANSIENT}/t1_npotmax.inp": (1, 2), f"{_TRANSIENT}/t1_zws.inp": range(1, 6), _TESTBANK: (38,)},
    ),
    Reason(
        "patch that splits",
        "a patch that splits in a shift",
        "Up to 3 % of a force. In contactd the displacements that the parts brought each other are left out before the step as they "
        "are behind it, so that the split alone brings no slip. Not decided",
        {_TESTBANK: (39,)},
    ),
    Reason(
        "moments of shifts",
        "moments of shifts (T = 1) about where elements are counted from",
        "The fourth digit of a moment of which most is a force of four digits times 9 mm",
        {f"{_TRANSIENT}/m1_catt_shift.inp": range(50, 70)},
        "forces and places of the same cases, which agree",
    ),
    Reason(
        "half-spaces that turn",
        "half-spaces that turn (C = 4)",
        "Up to 1 % of the approach, and up to 9 % of a creepage that a force makes. Other corrections of the coefficients",
        {f"{_CONFORMAL}/groove_li.inp": range(5, 9)},
    ),
    Reason(
        "slip of surfaces",
        "slip of surfaces (D = 3), radii of 0.1 m",
        "Up to 2.5 % of mu Fn, and of creepages that are none here 4e-4. contactd takes it row by row, and not along x",
        {f"{_CONFORMAL}/test-rollers3.inp": range(1, 13)},
    ),
    Reason(
        "rails of slices",
        "rails of slices",
        "0.1 % of mu Fn, more of patches that carry little; spin moments 0.7 %. Not decided. The two are nearer to each other "
        "than to what quintic splines between slices give (1 % to 4 %)",
        {
            f"{_SLICES}/cw_interrupt.inp": (1, 2),
            f"{_SLICES}/mbench_brute.inp": range(1, 36),
            f"{_SLICES}/mbench_locus.inp": range(1, 36),
        },
    ),
    Reason(
        "wheels of slices",
        "wheels of slices",
        "0.4 % of mu Fn; the largest pressure below a rounded flat by up to 10 %, spin moments by up to 0.06 mm of mu Fn. Not decided",
        {f"{_FLATS}/chalmers_flat_fz125.inp": range(1, 27), f"{_FLATS}/rounded_flat_d09.inp": range(1, 16)},
    ),
    Reason(
        "own heat",
        "friction by temperature (L = 6)",
        "Up to 3 % of mu Fn. CONTACT counts the heat of an element on itself twice: temperatures of full slip are a tenth higher, "
        "and come to the closed form of Hertz's strip from above as elements become smaller. contactd is within 1e-3 of it",
        {f"{_HEAT}/m1_tempdep.inp": (2,), f"{_HEAT}/m3_tempdep.inp": (2, 3)},
        "the closed form (`tests/core/temperature/test_surface_temperature.cpp`)",
    ),
    Reason(
        "share of a force",
        "a small share of a force without friction",
        "0.0006 N of 297 N: the lateral share of a normal force, whose direction differs by 2e-6 rad",
        {_TESTBANK: (21,)},
    ),
    Reason(
        "kinks at a dent",
        "a rail with eight kinks at a dent",
        "The height by 0.02 mm, forces by 3 %. Not decided",
        {_TESTBANK: (28,)},
    ),
    Reason(
        "first point",
        "contact with the first point of a rail",
        "The height by 0.17 mm, the largest pressure by a quarter, forces by 0.3 % of mu Fn. Not decided",
        {_TESTBANK: (29,)},
    ),
    Reason(
        "side of the head",
        "a patch at the side of the rail's head",
        "0.1 % of its spin moment. Not decided",
        {_TESTBANK: (31,)},
    ),
    Reason(
        "three patches",
        "three patches, friction by angle",
        "0.06 % of a force, 0.002 rad of the angle of a patch whose surfaces bend. Not decided",
        {_TESTBANK: (33, 34)},
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
