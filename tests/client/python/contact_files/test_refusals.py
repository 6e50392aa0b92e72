"""Tests cases that are refused or invalid, each with its message."""

from __future__ import annotations

from typing import Any

import pytest

import contactd
from contactd.contact_files.runner import chains_of
from support.contact_cases import basic_case, rail_case
from support.contact_runs import computed, runner_of, text_of_cases, write_profiles

SLOPE = {"K0": 1.0, "ALFA": 1.0, "BETA": 1.0}
CREEP = {"M": 1, "FG1": 1.0, "FG2": 1.0, "TC1": 0.1, "TC2": 0.1}
HEAT = {f"{name}{body}": value for body in (1, 2)
        for name, value in (("BKTEMP", 0.0), ("HEATCP", 450.0), ("LAMBDA", 0.05), ("DENS", 7.85e-6))}  # fmt: skip
CORNER = {"IPOTCN": 1, "MX": 6, "MY": 4, "XL": -3.0, "YL": -1.0, "DX": 1.0, "DY": 0.5}
DISTANCES = {**CORNER, "IBASE": 9, "IPLAN": 1, "GAP": [0.01 * (i % 5) for i in range(24)]}
PATCHES = {**CORNER, "IBASE": 1, "B1": 1e-3, "B2": 0.0, "B3": 2e-3, "B4": 0.0, "B5": 0.0, "B6": 0.0, "IPLAN": 4, "NPATCH": 2,
           "PATCH_LIMITS": (-3.0, -0.5, -1.0, 1.0, 0.5, 3.0, -1.0, 1.0), "PATCH_FACTORS": (0.5,)}  # fmt: skip
BY_HEAT = {"FREF": 0.3, "TREF": 20.0, "DFHEAT": -0.18, "DTHEAT": 400.0}
ROLLER: dict[str, Any] = {"C1": 5, "NOMRADR": 500.0, "RPITCH": 4.0, "X_WS": 0.0}
ROTATED = {"INFLCF": 4, "IF_METH": 0}
NO_FORCE = {"N": 0, "PEN": 0.02, "F": 1, "FX": 0.5}


def _shift(**changes: Any) -> list[Any]:
    return [basic_case(T=1), basic_case(T=1, number=2, **changes)]


def _falls(fkin: float, velocity: float) -> dict[str, float]:
    return {"FKIN": fkin, "F1": 0.1, "SABSH1": velocity, "F2": 0.0, "SABSH2": 1.0}


#: Unsupported features, each with cases of which the last one is refused.
EXAMPLES: dict[str, list[Any]] = {
    "tractions from the pressures of the case before (P = 1)": _shift(P=1),
    "viscoelastic bodies except in steady rolling (M = 1, T < 3)": [basic_case(**CREEP, T=2)],
    "FASTSIM or FaStrip without Hertz's contact (M = 3, 5, IBASE > 1)": [basic_case(M=3, **SLOPE, **DISTANCES)],
    "FASTSIM with one flexibility (M = 2)": [basic_case(M=2, FLX=1.0, **SLOPE)],
    "variants of the simplified theory (M = 6, 7)": [basic_case(M=6)],
    "friction by temperature without heat (L = 6, H = 0)": [basic_case(FRCLAW=6, friction=[BY_HEAT])],
    "falling friction with laws that differ from place to place (V)": [
        basic_case(V=3, VARFRC=3, FRCLAW=4, friction=[_falls(0.1 + 0.01 * i, 100.0 * i) for i in range(1, 11)])
    ],
    "damping (M2), where CDAMPN or CDAMPT is not 0": [basic_case(CDAMPN=1.0, CDAMPT=0.0, DFNMAX=1.0, DFTMAX=1.0)],
    "surface temperature under bilinear tractions (H, C = 3)": [basic_case(H=3, INFLCF=3, **HEAT)],
    "potential contact areas of more elements than the service accepts (MX, MY; limits.max_grid_elements)": [
        basic_case(MX=30_000, MY=30_000)
    ],
    "shares of a normal force that is not known before the solve (N = 0, F > 0, dissimilar bodies)": [
        basic_case(**NO_FORCE, POISS1=0.0)
    ],
    "shares of a normal force of viscoelastic bodies that is not known before the solve (M = 1, N = 0, F > 0)": [
        basic_case(**NO_FORCE, **CREEP)
    ],
    "friction by temperature that differs between rows (V, L = 6)": [
        basic_case(H=3, FRCLAW=6, V=3, VARFRC=3, friction=[{**BY_HEAT, "TREF": 20.0 + i} for i in range(10)], **HEAT)
    ],
    "prescribed pressures of dissimilar bodies (B = 2, 3, 4)": [basic_case(B=2, POISS1=0.0)],
    "prescribed pressures of a line (B = 2, 3, IPOTCN = -4, -5)": [basic_case(B=2, IPOTCN=-4, A1=5e-3, BB=8.0)],
    "parabolic traction bound with FaStrip (B = 3, M = 5)": [basic_case(B=3, M=5, **SLOPE)],
    "pressures over two half ellipses that are not prescribed (IPOTCN = -6, B = 0)": [
        basic_case(IPOTCN=-6, AA=4.0, BNEG=1.0, BPOS=3.0, SCALE=1.1)
    ],
    "rotated half-spaces (C = 4)": [basic_case(**ROTATED, VARIANT=4, ANGLE_Y=[-1.0, 1.0], ANGLE=[0.0, 0.0])],
    "patches that share their displacements, except with pressures of the full theory (IPLAN = 4, B > 1)": [
        basic_case(B=5, N=0, PEN=0.01, **PATCHES)
    ],
    "viscoelastic bodies on rails (M = 1)": [rail_case(**CREEP)],
    "FASTSIM or FaStrip on rails with pressures of the full theory (M = 3, 5, B = 0)": [rail_case(M=3, **SLOPE)],
    "bilinear tractions on rails (C = 3)": [rail_case(INFLCF=3)],
    "rotated half-spaces in a planar contact (C = 4)": [rail_case(**ROTATED, VARIANT=4)],
    "half-spaces that rotate with their loads (C = 4, VARIANT = 1, 2)": [rail_case(**ROTATED, D=4, DISCNS=4, VARIANT=2)],
    "variants of the discretisation (D = 6 to 9)": [rail_case(D=6, DISCNS=6)],
    "a roller placed by its gauge that deviates with its axle (DZRAIL)": [rail_case(**ROLLER, DZRAIL=1.0)],
}  # fmt: skip


@pytest.fixture(scope="module")
def client():
    with contactd.local(in_process=True, config={"workers": 1}) as opened:
        yield opened


@pytest.fixture(scope="module")
def folder(client, tmp_path_factory):
    place = tmp_path_factory.mktemp("profiles")
    write_profiles(place, client)
    return place


@pytest.mark.parametrize("row", EXAMPLES)
def test_unsupported_features_are_refused_with_a_sentence(client, folder, row: str) -> None:
    *before, refused = computed(client, EXAMPLES[row], folder)
    assert all(one.solution is not None for one in before), [one.sentence for one in before]
    assert refused.status == "refused", (refused.status, refused.sentence)
    assert refused.sentence.endswith(".")


@pytest.mark.parametrize(
    ("changes", "sentence"),
    [
        ({"AA": 0.0}, "AA is 0; it must be positive"),
        ({"BB": -1.0}, "BB is -1; it must be positive"),
        ({"AA": 1e200}, "AA is 1e+200; it must be positive, from 1e-30 to 1e+30"),
        ({"AA": 1e8, "BB": 1.0}, "AA/BB is 1e+08; it must be from 1e-06 to 1e+06"),
        ({"SCALE": 0.0}, "SCALE is 0"),
        ({"M": 4, "GG3": 1000.0, "LAYTHK": -0.1, "TAU_C0": 0.0, "K_TAU": 0.0}, "LAYTHK is -0.1; it must be zero or positive"),
        ({"GG1": 0.0}, "GG1 is 0; it must be positive"),
        ({"POISS1": 0.6, "POISS2": 0.2}, "POISS1 is 0.6; it must be from 0 to 0.5"),
        ({"EPS": 0.0}, "EPS is 0; it must be positive"),
        ({"IPOTCN": -1, "A1": 0.001, "B1": 0.0}, "B1 is 0"),
        ({"IPOTCN": -1, "A1": 1e-12, "B1": 1e12}, "A1/B1 is 1e-24"),
        ({"IPOTCN": -2, "A1": 0.001, "AOB": 1e7}, "AOB is 1e+07"),
        ({"IPOTCN": -4, "A1": 0.001, "BB": 0.0}, "BB is 0"),
        ({"N": 0, "PEN": 0.0}, "PEN is 0; it must be positive, from 1e-30 to 1e+30"),
    ],
)
def test_values_that_are_none_are_told_by_name(client, folder, changes: dict[str, Any], sentence: str) -> None:
    (one,) = computed(client, [basic_case(**changes)], folder)
    assert one.status == "wrong"
    assert sentence in one.sentence


def test_a_refusal_has_the_names_of_the_file(client, folder) -> None:
    one, file = computed(client, [rail_case(DX=1e-9), rail_case(RFNAME="nowhere.prr")], folder)
    assert (one.status, file.status) == ("refused", "wrong")
    assert one.sentence.startswith("DX (setup.dx)")
    assert "nowhere.prr" in file.sentence and "No such file" in file.sentence


def test_values_in_memory_without_effect_do_not_matter(client, folder) -> None:
    cases = [basic_case(MEMDST=0.1, MEM_S0=1.0, FG1=1.0, FLXZ=1.0), basic_case(IPOTCN=-4, A1=0.001, BB=500.0)]
    assert [one.status for one in computed(client, cases, folder)] == ["solved", "solved"]


def test_steps_that_go_on_are_chained_and_others_stand_alone() -> None:
    first, next_step = basic_case(number=1, T=2), basic_case(number=2, T=2, P=0)
    steady, shift = basic_case(number=3), basic_case(number=4, T=1, P=0)
    assert [[case.number for case in chain] for chain in chains_of([first, next_step, steady, shift])] == [[1, 2], [3, 4]]
    without_digits = basic_case(errors=("line 2, column 1: no digits",))
    without_digits.digits.clear()
    assert [len(chain) for chain in chains_of([without_digits, without_digits, shift])] == [1, 2]


def test_result_elements_have_histories_of_their_own() -> None:
    cases = [basic_case(reid=reid, number=number, T=1, P=2 if number == 1 else 0) for number in (1, 2) for reid in (5, 7)]
    chains = chains_of(cases)
    assert [[(case.reid, case.number) for case in chain] for chain in chains] == [[(5, 1), (5, 2)], [(7, 1), (7, 2)]]


def test_what_follows_from_a_case_that_is_refused_is_told_and_others_go_on(client, folder) -> None:
    cases = [
        basic_case(T=1, reid=1, **CREEP), basic_case(T=1, reid=2), basic_case(T=1, P=0, reid=1),
        basic_case(T=1, P=0, reid=2), basic_case(T=1, reid=1),
    ]  # fmt: skip
    runner, read = runner_of(client, text_of_cases(cases, folder), folder)
    for outcomes, computable in ((runner.checked(read), "read"), (computed(client, cases, folder), "solved")):
        assert [one.status for one in outcomes] == ["refused", computable, "follows", computable, computable]
        assert "viscoelastic" in outcomes[0].sentence
        assert outcomes[2].sentence == f"It continues case 1 in line {read[0].line}, which is not computed."
