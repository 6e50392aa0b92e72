"""Cases of basic contact as problems of contactd."""

from __future__ import annotations

import math

import numpy as np
import pytest

from contactd import (
    ContactProblem,
    FrictionMemory,
    Grid,
    HalfEllipses,
    InterfacialLayer,
    KineticFriction,
    Material,
    Rolling,
    SecondTerm,
    SimplifiedSettings,
    SlopeReduction,
    TableIcs,
    TemperatureFriction,
    ThermalBodies,
    ThermalBody,
    ViscoelasticBody,
)
from contactd.contact_files.problems.basic import BasicContact, State, goes_on
from contactd.contact_files.problems.features import Missing, missing
from contactd.values.generated.contact_files import ContactCase
from support.contact_cases import basic_case

CORNER = {"IPOTCN": 1, "MX": 6, "MY": 4, "XL": -3.0, "YL": -1.0, "DX": 1.0, "DY": 0.5, "IBASE": 1, "IPLAN": 1,
          "B1": 1e-3, "B2": 0.0, "B3": 2e-3, "B4": 0.0, "B5": 0.0, "B6": 0.0}  # fmt: skip


def no_force(_: ContactProblem) -> float:
    raise AssertionError("no normal force is asked for")


def made(**changes: object) -> BasicContact:
    return BasicContact.of(basic_case(**changes), no_force)


def rolling(contact: BasicContact) -> Rolling:
    assert contact.problem.friction is not None and contact.problem.friction.rolling is not None
    return contact.problem.friction.rolling


def test_the_load_is_a_force_or_an_approach() -> None:
    assert made().problem.Fn == 5e4
    assert made(N=0, PEN=0.02).problem.approach == 0.02


def test_bodies_that_hardly_differ_are_one_material() -> None:
    contact = made(POISS1=0.28, POISS2=0.28001, GG1=82000.0, GG2=82000.0)
    assert contact.problem.lower is None
    assert contact.pair.nu == pytest.approx(0.280005)
    others = made(POISS1=0.28, GG1=200.0, POISS2=0.28, GG2=1.0)
    assert (others.problem.upper, others.problem.lower) == (Material(G=200, nu=0.28), Material(G=1, nu=0.28))
    assert others.pair.G == pytest.approx(2 / (1 / 200 + 1))
    assert others.pair.difference == pytest.approx(others.pair.G / 4 * (0.44 / 200 - 0.44))


def test_steady_rolling_goes_along_x_by_elements_but_by_convexgs() -> None:
    dx = 2 * 6 * 1.1 / 12
    assert (rolling(made(CHI=0.7)).chi, rolling(made(CHI=0.7)).dq) == (0.0, pytest.approx(dx))
    assert rolling(made(CHI=3.1415)).chi == math.pi
    by_convexgs = made(CHI=0.7, GAUSEI=2)
    assert (by_convexgs.chi, by_convexgs.dq) == (0.7, 0.5)
    assert (rolling(by_convexgs).chi, rolling(by_convexgs).dq, rolling(by_convexgs).kind) == (0.7, pytest.approx(dx), "steady")
    transient = rolling(made(T=2, CHI=0.7))
    assert (transient.chi, transient.dq, transient.kind) == (0.7, 0.5, "transient")


def test_spin_is_evaluated_ahead_and_about_its_centre() -> None:
    found = rolling(made(CKSI=1e-3, CETA=2e-3, CPHI=1e-4, SPINXO=3.0, SPINYO=-2.0))
    assert (found.xi, found.eta, found.phi) == pytest.approx((1e-3 - 2e-4, 2e-3 - 3e-4, 1e-4))
    assert found.spin_offset == 1 / 6
    assert rolling(made(FACPHI=0.5)).spin_offset == 0.5


def test_a_shift_is_one_and_knows_no_way_ahead() -> None:
    friction = made(T=1, CKSI=3e-3, CPHI=1e-4).problem.friction
    assert friction is not None
    assert (friction.rigid_shift, friction.rotation, friction.rolling) == ((3e-3, 0.0), 1e-4, None)


def test_shares_of_forces_are_of_the_bound() -> None:
    assert rolling(made(F=1, FX=-0.6)).force == (-0.6 * 0.3 * 5e4, None)
    assert rolling(made(F=2, FX=-0.6, FY=0.1)).force == pytest.approx((-0.6 * 0.3 * 5e4, 0.1 * 0.3 * 5e4))
    by_rows = [{"IY": row, "FSTAT": 0.2 + row / 100, "FKIN": 0.2} for row in range(1, 11)]
    assert rolling(made(F=1, FX=-0.1, V=3, VARFRC=3, friction=by_rows)).force == (-0.1 * 5e4, None)
    found = BasicContact.of(basic_case(N=0, PEN=0.02, F=1, FX=0.5), lambda problem: 1000.0)
    assert rolling(found).force == (0.5 * 0.3 * 1000, None)


def test_shares_of_a_force_that_nobody_knows_are_refused() -> None:
    with pytest.raises(Missing, match="not known before the solve"):
        made(N=0, PEN=0.02, F=1, FX=0.5, POISS1=0.0)


def test_rows_have_their_own_friction() -> None:
    by_rows = [{"IY": row, "FSTAT": 0.2 + row / 100, "FKIN": 0.2} for row in range(1, 11)]
    friction = made(V=3, VARFRC=3, friction=by_rows).problem.friction
    assert friction is not None
    assert np.shape(friction.mu) == (10, 12)
    assert np.asarray(friction.mu)[3] == pytest.approx(0.24)


def test_laws_that_fall_are_those_of_contactd() -> None:
    values = {"FKIN": 0.12, "F1": 0.18, "SABSH1": 100.0, "F2": 0.0, "SABSH2": 1e-4}
    linear = made(L=2, FRCLAW=2, friction=[values]).problem.friction
    assert linear is not None
    assert (linear.mu, linear.kinetic) == (pytest.approx(0.3), KineticFriction(0.12, 200.0, "linear"))
    exponential = made(L=4, FRCLAW=4, friction=[values]).problem.friction
    assert exponential is not None and exponential.kinetic is not None
    fallen = 0.12 + 0.18 * math.exp(-250 / exponential.kinetic.slip_velocity)
    assert fallen == pytest.approx(0.12 + 0.18 * 2 ** (-250 / 100))
    other_term = {"FKIN": 0.12, "F1": 0.0, "SABSH1": 1e-4, "F2": 0.18, "SABSH2": 100.0}
    both = made(L=4, FRCLAW=4, friction=[other_term]).problem.friction
    assert both is not None and both.kinetic == exponential.kinetic


def test_elements_slip_by_themselves() -> None:
    slip = list(np.linspace(0, 1, 120))
    friction = made(E=9, EXRHS=9, SLIP_X=slip, SLIP_Y=slip[::-1]).problem.friction
    assert friction is not None and friction.rigid_slip is not None
    assert np.asarray(friction.rigid_slip[0])[2, 5] == slip[2 * 12 + 5]
    none = made(E=0, EXRHS=9, SLIP_X=slip, SLIP_Y=slip).problem.friction
    assert none is not None and none.rigid_slip is None


def test_spin_in_one_direction_alone() -> None:
    contact = made(E=2, EXRHS=2, CPHI=1e-3, CHI=0.0)
    friction = contact.problem.friction
    assert friction is not None and friction.rigid_slip is not None
    assert rolling(contact).phi == 0
    assert np.asarray(friction.rigid_slip[0])[:, 0] == pytest.approx(-1e-3 * contact.area.grid.y)
    assert not np.asarray(friction.rigid_slip[1]).any()


def test_tolerances_get_smaller_and_never_larger() -> None:
    loose = made(EPS=1e-4).problem
    assert loose.normal is loose.tangential is loose.outer is None
    tight = made(EPS=1e-9).problem
    assert tight.normal is not None and tight.tangential is not None
    assert (tight.normal.tolerance, tight.tangential.tolerance) == (1e-9, 1e-9)
    once = made(POISS1=0.0, MAXOUT=1).problem
    assert once.outer is not None and once.outer.max_iterations == 1


def test_a_step_goes_on_from_tractions_that_may_lie_elsewhere() -> None:
    before = Grid(6, 4, 1.0, 0.5, -3.0, -1.0)
    numbers = np.arange(24.0).reshape(4, 6)
    start = State(before, numbers, numbers + 100, numbers + 200)
    case = basic_case(T=2, P=0, **{**CORNER, "MX": 8, "XL": -2.0, "YL": -1.5})
    previous = BasicContact.of(case, no_force, start).problem.previous
    assert previous is not None and previous.pressure is not None
    assert previous.pressure.shape == (4, 8)
    assert not previous.pressure[0].any()
    assert previous.pressure[1].tolist() == [1, 2, 3, 4, 5, 0, 0, 0]
    assert previous.traction_y is not None and previous.traction_y[3].tolist() == [213, 214, 215, 216, 217, 0, 0, 0]


def test_shifts_and_transient_steps_go_on_unless_they_start_anew() -> None:
    assert goes_on(basic_case(P=0, T=1)) and goes_on(basic_case(P=0, T=2))
    assert not any(goes_on(basic_case(P=p, T=t)) for p, t in ((2, 1), (2, 2), (0, 3), (0, 0)))


def test_a_thin_sheet_is_there_where_the_bound_says_so() -> None:
    assert made(B=1, FLXZ=2e-5).problem.sheet_flexibility == 2e-5
    assert not made(B=0, FLXZ=2e-5).problem.sheet_flexibility


SLOPE = {"K0": 1.0, "ALFA": 1.0, "BETA": 1.0}


def test_fastsim_is_that_of_whole_elements_with_the_bound_of_the_case() -> None:
    problem = made(M=3, B=3, **SLOPE).problem
    assert problem.model == "fastsim"
    assert problem.simplified == SimplifiedSettings(on_elements=True, blended=True, coefficients="printed")
    elliptic = made(M=3, B=2, **SLOPE).problem.simplified
    assert elliptic is not None and elliptic.bound == "elliptic"


def test_a_reduced_slope_is_one_where_something_is_reduced() -> None:
    reduced = made(M=3, B=3, K0=0.54, ALFA=0.02, BETA=0.62).problem.simplified
    assert reduced is not None and reduced.slope == SlopeReduction(0.54, 0.02, 0.62)
    plain = made(M=3, B=3, K0=1.0, ALFA=1.0, BETA=5.0).problem.simplified
    assert plain is not None and plain.slope is None


def test_fastrip_has_strips_and_no_bound_of_its_own() -> None:
    problem = made(M=5, B=2, **SLOPE).problem
    assert problem.model == "fastrip"
    assert problem.simplified == SimplifiedSettings(blended=True, coefficients="printed")


@pytest.mark.parametrize(("digit", "normal"), [(5, "kpec"), (6, "analyn")])
def test_pressures_from_the_overlap_go_with_every_theory_of_friction(digit: int, normal: str) -> None:
    assert (made(B=digit).problem.normal_model, made(B=digit).problem.model) == (normal, None)
    quick = made(B=digit, M=3, **SLOPE, **CORNER).problem
    assert (quick.normal_model, quick.model) == (normal, "fastsim")


def test_friction_of_simplified_models_has_no_memory() -> None:
    falls: dict[str, object] = {"FRCLAW": 4, "MEMDST": 0.1, "MEM_S0": 1.0}
    falls["friction"] = [{"FKIN": 0.1, "F1": 0.1, "F2": 0.0, "SABSH1": 990.0, "SABSH2": 1.0}]
    friction = made(M=3, B=3, **SLOPE, **falls).problem.friction
    assert friction is not None and friction.kinetic is not None and friction.kinetic.memory is None
    particles = made(**falls).problem.friction
    assert particles is not None and particles.kinetic is not None and particles.kinetic.memory is not None


def test_an_interfacial_layer_is_that_of_the_digit() -> None:
    values = {"GG3": 8200.0, "LAYTHK": 1.25, "TAU_C0": 150.0, "K_TAU": 9000.0}
    friction = made(M=4, **values).problem.friction
    assert friction is not None and friction.layer == InterfacialLayer(1.25 / 8200, 150.0, 9000.0)
    friction = made(M=4, **{**values, "TAU_C0": 0.0}).problem.friction
    assert friction is not None and friction.layer == InterfacialLayer(1.25 / 8200, None, None)
    friction = made(M=0, **values).problem.friction
    assert friction is not None and friction.layer is None


@pytest.mark.parametrize(("law", "name", "share"), [(2, "linear", 0.5), (3, "rational", 1.0), (4, "exponential", math.log(2))])
def test_friction_falls_by_two_terms_with_memory(law: int, name: str, share: float) -> None:
    one = {"FKIN": 0.15, "F1": 0.12, "SABSH1": 60.0, "F2": 0.08, "SABSH2": 25.0}
    friction = made(FRCLAW=law, friction=(one,), MEMDST=0.003, MEM_S0=1.0).problem.friction
    assert friction is not None and friction.mu == pytest.approx(0.35)
    assert friction.kinetic == KineticFriction(
        0.15, 60 / share, name, None, SecondTerm(0.08, 25 / share), FrictionMemory(0.003, 1.0)
    )
    friction = made(FRCLAW=law, friction=({**one, "F2": 0.0},), MEMDST=0.0, MEM_S0=1.0).problem.friction
    assert friction is not None and friction.kinetic == KineticFriction(0.15, 60 / share, name)


HEAT = {"BKTEMP1": 0.0, "HEATCP1": 450.0, "LAMBDA1": 50e-3, "DENS1": 7.85e-6,
        "BKTEMP2": 150.0, "HEATCP2": 500.0, "LAMBDA2": 40e-3, "DENS2": 7e-6}  # fmt: skip


def test_heat_is_that_of_both_bodies_in_watt_metre_and_kilogram() -> None:
    found = made(H=3, T=3, **HEAT).problem.temperature
    assert found is not None and isinstance(found, ThermalBodies)
    for body, expected in zip((found.upper, found.lower), ((0, 50, 450, 7850), (150, 40, 500, 7000))):
        assert isinstance(body, ThermalBody)
        values = (body.bulk_temperature, body.conductivity, body.heat_capacity, body.density)
        assert values == pytest.approx(expected)
    assert found.plastic_share is None
    assert made(H=0, T=3, **HEAT).problem.temperature is None
    assert made(H=3, T=2, **HEAT).problem.temperature is None


@pytest.mark.parametrize("yields", [False, True])
def test_heat_beside_a_layer_has_its_share_of_the_plastic_work(yields: bool) -> None:
    layer = {"M": 4, "GG3": 6500.0, "LAYTHK": 0.06, "TAU_C0": 120.0 * yields, "K_TAU": 0.0}
    problem = made(H=3, T=3, BETAPL=0.9, **layer, **HEAT).problem
    assert problem.temperature is not None and problem.temperature.plastic_share == 0.9
    assert problem.friction is not None and problem.friction.layer is not None
    assert (problem.friction.layer.yield_stress is not None) == yields


def test_friction_by_temperature_may_have_memory() -> None:
    sets = [{"FREF": 0.3, "TREF": 20.0, "DFHEAT": -0.18, "DTHEAT": 400.0}]
    friction = made(H=3, T=3, FRCLAW=6, friction=sets, MEMDST=1e-3, MEM_S0=1.0, **HEAT).problem.friction
    assert friction is not None and friction.temperature is not None
    assert friction.temperature.memory == FrictionMemory(1e-3, 1.0)


def test_friction_may_follow_the_temperature() -> None:
    sets = [{"FREF": 0.3, "TREF": 20.0, "DFHEAT": -0.18, "DTHEAT": 400.0}]
    friction = made(H=3, T=3, FRCLAW=6, friction=sets, **HEAT).problem.friction
    assert friction is not None
    assert (friction.mu, friction.kinetic) == (0.3, None)
    assert friction.temperature == TemperatureFriction(change=-0.18, reference=20, range=400)
    with pytest.raises(Missing, match="from row to row"):
        made(H=3, T=3, FRCLAW=6, VARFRC=3, friction=[*sets, {**sets[0], "TREF": 30.0}], **HEAT)


CREEP = {"M": 1, "FG1": 1.0, "FG2": 1.0, "TC1": 0.009, "TC2": 0.009}


def test_bodies_that_creep_alike_are_one_and_others_two() -> None:
    alike = made(**CREEP).problem
    assert (alike.upper, alike.lower) == (ViscoelasticBody(G=82000, nu=0.28, f=1, tau=0.009), None)
    others = made(**{**CREEP, "FG2": 0.0}).problem
    assert others.upper == alike.upper
    assert others.lower == ViscoelasticBody(G=82000, nu=0.28, f=0, tau=0.009)
    assert made(**{**CREEP, "M": 0}).problem.upper == Material(G=82000, nu=0.28)


@pytest.mark.parametrize(
    ("changes", "name"),
    [
        ({"P": 1}, "P = 1"), ({"B": 2, "IPOTCN": -4}, "of a line"), ({"M": 1, "T": 2}, "viscoelastic"), ({"M": 1, "CHI": 1.5}, "viscoelastic"),
        ({"M": 1, "N": 0, "PEN": 0.02, "F": 1, "FX": 0.2, "FG1": 1.0, "FG2": 1.0, "TC1": 0.1, "TC2": 0.1}, "shares of a normal force"), ({"M": 2}, "one flexibility"),
        ({"M": 5, "B": 3, "K0": 1.0, "ALFA": 1.0, "BETA": 1.0}, "parabolic"), ({"FRCLAW": 6}, "temperature"),
        ({"H": 1, "INFLCF": 3}, "temperature"), ({"CDAMPN": 1.0, "CDAMPT": 0.0}, "damping"),
        ({"INFLCF": 4}, "half-spaces that turn"), ({"IPOTCN": -6}, "half ellipses"),
        ({"IPOTCN": 1, "IPLAN": 4, "B": 5}, "share their displacements"),
    ],
)  # fmt: skip
def test_what_contactd_lacks_is_told_by_name(changes: dict[str, object], name: str) -> None:
    (told,) = missing(basic_case(**changes))
    assert name in told
    with pytest.raises(Missing, match=name):
        made(**changes)


def test_coefficients_of_a_file_take_the_place_of_the_bodies_and_end_where_it_ends() -> None:
    array = np.random.default_rng(1).normal(size=(3, 3, 4, 6))
    asked: list[float] = []

    def coefficients(case: ContactCase, modulus: float) -> TableIcs:
        asked.append(modulus)
        return TableIcs(array, 0.5, 0.25)

    case = basic_case(INFLCF=9, CFNAME="there.txt", GG1=60000.0, GG2=30000.0)
    problem = BasicContact.of(case, no_force, coefficients=coefficients).problem
    assert asked == [pytest.approx(40000.0)]
    assert problem.upper is None
    assert isinstance(problem.ics, TableIcs)
    ny, nx = problem.grid.shape
    assert problem.ics.shape == (max(ny, 4), max(nx, 6))
    np.testing.assert_array_equal(problem.ics.array[:, :, :4, :6], array)
    assert not problem.ics.array[:, :, 4:].any()
    with pytest.raises(Missing, match="C = 9"):
        BasicContact.of(case, no_force)


def test_pressures_are_prescribed_over_an_ellipse_or_two_halves() -> None:
    assert made(B=2).problem.normal_model == "elliptic"
    assert made(B=3).problem.normal_model == "parabolic"
    halves = made(B=4, IPOTCN=-6, AA=4.0, BNEG=1.0, BPOS=3.0, SCALE=1.1, MX=12, MY=10)
    assert (halves.problem.normal_model, halves.problem.gap) == ("elliptic", HalfEllipses(4, 1, 3))
    assert halves.problem.grid.y[0] == pytest.approx(-2.2 + 0.22)
    assert made(B=2, M=3, K0=1.0, ALFA=1.0, BETA=1.0).problem.normal_model is None  # FASTSIM is bounded by it
    with pytest.raises(Missing, match="dissimilar"):
        made(B=2, GG1=200.0, GG2=1.0)


def test_what_is_in_memory_and_does_not_act_is_no_matter() -> None:
    assert missing(basic_case(MEMDST=0.1, MEM_S0=1.0, FG1=1.0, IPLAN=4, FLXZ=1.0)) == []
    assert missing(basic_case(CDAMPN=1.0, CDAMPT=1.0, M2=0)) == []


def test_limits_of_iterations_are_those_of_the_file() -> None:
    few = made(MAXGS=80, POISS1=0.0, MAXOUT=7).problem
    assert few.normal is not None and few.tangential is not None and few.outer is not None
    assert (few.normal.max_iterations, few.tangential.max_iterations, few.outer.max_iterations) == (80, 80, 7)


@pytest.mark.parametrize(("prescribed", "shares"), [(1, (1.5, 0.0)), (2, (0.9, -1.2))])
def test_a_force_beyond_friction_becomes_full_slip(prescribed: int, shares: tuple[float, float]) -> None:
    motion = rolling(made(F=prescribed, FX=shares[0], **({"FY": shares[1]} if prescribed == 2 else {})))
    assert motion.force is not None and motion.force[0] is not None
    full = 0.3 * 5e4
    assert motion.force[0] == pytest.approx(shares[0] / 1.5 * full, rel=1e-5)
    assert motion.force[0] < full and (motion.force[1] is None) == (prescribed == 1)
    if motion.force[1] is not None:
        assert np.hypot(motion.force[0], motion.force[1]) < (1 - 1e-6) * full
