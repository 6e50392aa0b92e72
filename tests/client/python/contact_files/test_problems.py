"""Tests the conversion of cases of the CONTACT program to problems by contact_file.convert."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest

import contactd
from support.contact_cases import basic_case, rail_case
from support.contact_runs import converted, write_profiles

FAR = 1e6  #: mm, of elements that cannot touch
QUADRATIC = {"IBASE": 1, "IPLAN": 1, "B1": 1e-3, "B2": 0.0, "B3": 2e-3, "B4": 0.0, "B5": 0.0, "B6": 0.0}
CORNER = {"IPOTCN": 1, "MX": 6, "MY": 4, "XL": -3.0, "YL": -1.0, "DX": 1.0, "DY": 0.5}
X, Y = np.arange(6) - 2.5, (np.arange(4) - 1.5) / 2
SLOPE = {"K0": 1.0, "ALFA": 1.0, "BETA": 1.0}
HEAT = {"BKTEMP1": 0.0, "HEATCP1": 450.0, "LAMBDA1": 50e-3, "DENS1": 7.85e-6,
        "BKTEMP2": 150.0, "HEATCP2": 500.0, "LAMBDA2": 40e-3, "DENS2": 7e-6}  # fmt: skip
ROLLER: dict[str, Any] = {"C1": 5, "NOMRADR": 500.0, "RPITCH": 4.0, "X_WS": 0.0}


@pytest.fixture(scope="module")
def client():
    with contactd.local(in_process=True, config={"workers": 1}) as opened:
        yield opened


@pytest.fixture(scope="module")
def folder(client, tmp_path_factory):
    place = tmp_path_factory.mktemp("profiles")
    write_profiles(place, client)
    return place


@pytest.fixture(scope="module")
def made(client, folder):
    def problem_of(**changes: Any) -> Any:
        (one,) = converted(client, [basic_case(**changes)], folder)
        assert one.status == "read", one.sentence
        return one.contact

    return problem_of


@pytest.fixture(scope="module")
def on_rails(client, folder):
    def problem_of(**changes: Any) -> Any:
        (one,) = converted(client, [rail_case(**changes)], folder)
        assert one.status == "read", one.sentence
        return one.wheelrail

    return problem_of


def grid_of(problem: Any) -> list[float]:
    return [problem["grid"][name] for name in ("nx", "ny", "dx", "dy", "x0", "y0")]


def test_all_ways_to_place_elements_mean_the_same(made) -> None:
    for place in (
        {"IPOTCN": 1, "XL": -2.0, "YL": -0.5, "DX": 1.0, "DY": 0.5},
        {"IPOTCN": 2, "XL": -2.0, "YL": -0.5, "XH": 4.0, "YH": 1.5},
        {"IPOTCN": 3, "XC1": -1.5, "YC1": -0.25, "DX": 1.0, "DY": 0.5},
        {"IPOTCN": 4, "XC1": -1.5, "YC1": -0.25, "XCM": 3.5, "YCM": 1.25},
    ):
        assert grid_of(made(**QUADRATIC, MX=6, MY=4, **place)) == [6, 4, 1.0, 0.5, -2.0, -0.5]


def test_a_hertzian_box_is_as_large_as_its_scale_says(made) -> None:
    problem = made()
    assert problem["grid"]["nx"] * problem["grid"]["dx"] == pytest.approx(2 * 6 * 1.1)
    assert problem["grid"]["ny"] * problem["grid"]["dy"] == pytest.approx(2 * 4 * 1.1)
    assert problem["gap"]["semi_axes"] == {"a": 6.0, "b": 4.0}
    curved = made(IPOTCN=-1, A1=1e-3, B1=2e-3)["gap"]["paraboloid"]
    assert [curved["Rx"], curved["Ry"]] == pytest.approx([500, 250])


def test_a_line_of_a_given_length_ends_there(made) -> None:
    line = {"IPOTCN": -5, "MX": 10, "MY": 7, "AA": 0.5, "BB": 10.0}
    problem = made(**line, SCALE=1.5)
    assert problem["grid"]["dy"] == pytest.approx(20 / 5)  # 7/1.5 is nearest to 5, which is odd like 7
    h = gap_of(problem)
    assert (h[[0, -1]] >= FAR).all() and (h[1:-1] < 1).all()
    assert made(**line, SCALE=1.0)["grid"]["dy"] == pytest.approx(20 / 7)


def gap_of(problem: Any) -> Any:
    return np.asarray(problem["gap"]["array"])


def test_a_quadratic_distance_with_all_its_terms(made) -> None:
    terms = {"B2": 0.3, "B4": 0.1, "B5": -0.2, "B6": 0.05}
    x, y = X[None, :], Y[:, None]
    expected = 1e-3 * x * x + 0.3 * x * y + 2e-3 * y * y + 0.1 * x - 0.2 * y + 0.05
    assert gap_of(made(**{**QUADRATIC, **CORNER, **terms})) == pytest.approx(expected)


def test_a_profile_goes_on_straight_beyond_its_ends(made) -> None:
    rows = {"IBASE": 2, "IPLAN": 1, "XM": 0.5, "RM": 100.0, "Y1": -0.5, "DY1": 0.5, "HEIGHTS": [0.3, 0.1, 0.0]}
    heights = np.array([0.4, 0.2, 0.05, -0.05])
    assert gap_of(made(**CORNER, **rows)) == pytest.approx(heights[:, None] + (X[None, :] - 0.5) ** 2 / 200)


def test_waves_and_radii(made) -> None:
    waves = {f"B{i}": value for i, value in enumerate((0.1, 2.0, 0.3, 0.2, 1.5, -0.4, 50.0, 80.0), 1)}
    x, y = X[None, :], Y[:, None]
    expected = 0.1 * np.sin(2 * (x - 0.3)) - 0.2 * np.sin(1.5 * (x + 0.4)) + x * x / 50 + y * y / 80
    assert gap_of(made(**CORNER, IBASE=3, IPLAN=1, **waves)) == pytest.approx(expected)


def test_distances_of_the_elements_come_by_rows(made) -> None:
    assert gap_of(made(**CORNER, IBASE=9, IPLAN=1, GAP=[float(i) for i in range(24)]))[2, 1] == 13


def test_elements_outside_of_the_planform_do_not_touch(made) -> None:
    circle = {"IPLAN": 2, "P1": 1.0, "P2": 0.0, "P3": 1.0, "P4": 0.0, "P5": 0.0, "P6": -1.0}
    h = gap_of(made(**{**QUADRATIC, **CORNER, **circle}))
    assert ((h >= FAR) == (X[None, :] ** 2 + Y[:, None] ** 2 >= 1)).all()
    names = ("XL1", "XH1", "YL1", "YH1", "XL2", "XH2", "YL2", "YH2")
    rectangles = {"IPLAN": 3, **dict(zip(names, (-3.0, -2.0, -1.0, 1.0, 2.0, 3.0, 0.0, 1.0)))}
    h = gap_of(made(**{**QUADRATIC, **CORNER, **rectangles}))
    assert ((h < FAR) == [[1, 0, 0, 0, 0, 0]] * 2 + [[1, 0, 0, 0, 0, 1]] * 2).all()


def test_patches_of_a_planform_are_regions_with_the_factors_between_them(made) -> None:
    limits = (-3.0, -2.0, -1.0, 1.0, -1.0, 1.0, -1.0, 1.0, 2.0, 3.0, 0.0, 1.0)
    patches = {"IPLAN": 4, "NPATCH": 3, "PATCH_FACTORS": (0.5, 0.25, 0.0), "PATCH_LIMITS": limits}
    problem = made(**{**QUADRATIC, **CORNER, **patches})
    assert ((gap_of(problem) < FAR) == [[1, 0, 1, 1, 0, 0]] * 2 + [[1, 0, 1, 1, 0, 1]] * 2).all()
    assert problem["regions"]["limits"][1] == {"x": [-1.0, 1.0], "y": [-1.0, 1.0]}
    assert problem["regions"]["shares"] == [1.0, 0.5, 0.25, 0.5, 1.0, 0.0, 0.25, 0.0, 1.0]
    assert "regions" not in made(**QUADRATIC, **CORNER)


def test_the_load_is_a_force_or_an_approach(made) -> None:
    assert made()["Fn"] == 5e4
    assert made(N=0, PEN=0.02)["approach"] == 0.02


def test_bodies_that_hardly_differ_are_one_material(made) -> None:
    bodies = made(POISS1=0.28, POISS2=0.28001, GG1=82000.0, GG2=82000.0)["bodies"]
    assert bodies["upper"]["nu"] == pytest.approx(0.280005) and bodies.get("lower", bodies["upper"]) == bodies["upper"]
    others = made(POISS1=0.28, GG1=200.0, POISS2=0.28, GG2=1.0)["bodies"]
    assert [others[body]["G"] for body in ("upper", "lower")] == [200, 1]


def rolling(problem: Any) -> Any:
    return problem["friction"]["rolling"]


def step_of(problem: Any) -> float:
    return rolling(problem).get("dq", problem["grid"]["dx"])


def test_steady_rolling_goes_along_x_by_elements_but_by_convexgs(made) -> None:
    dx = pytest.approx(2 * 6 * 1.1 / 12)
    ahead = made(CHI=0.7)
    assert (rolling(ahead).get("chi", 0.0), step_of(ahead)) == (0.0, dx)
    assert rolling(made(CHI=3.1415))["chi"] == math.pi
    options = {"OMEGAH": 0.9, "OMEGAS": 1.0, "INISLP": 0, "OMGSLP": 1.0}
    by_convexgs = made(CHI=0.7, GAUSEI=2, **options)
    assert (rolling(by_convexgs)["chi"], step_of(by_convexgs), rolling(by_convexgs)["kind"]) == (0.7, dx, "steady")
    transient = made(T=2, CHI=0.7)
    assert (rolling(transient)["chi"], rolling(transient)["dq"], rolling(transient)["kind"]) == (0.7, 0.5, "transient")


def test_spin_is_evaluated_ahead_and_about_its_centre(made) -> None:
    found = rolling(made(CKSI=1e-3, CETA=2e-3, CPHI=1e-4, SPINXO=3.0, SPINYO=-2.0))
    assert [found[name] for name in ("xi", "eta", "phi")] == pytest.approx([1e-3 - 2e-4, 2e-3 - 3e-4, 1e-4])
    assert found["spin_offset"] == 1 / 6
    assert rolling(made(FACPHI=0.5))["spin_offset"] == 0.5


def test_a_shift_is_one_and_knows_no_way_ahead(made) -> None:
    friction = made(T=1, CKSI=3e-3, CPHI=1e-4)["friction"]
    assert (friction["rigid_shift"], friction["rotation"], "rolling" in friction) == ([3e-3, 0.0], 1e-4, False)


def force_of(problem: Any) -> list[float | None]:
    found: list[float | None] = rolling(problem)["force"]
    return found


def test_shares_of_forces_are_of_the_bound(made, client) -> None:
    assert force_of(made(F=1, FX=-0.6)) == [pytest.approx(-0.6 * 0.3 * 5e4), None]
    assert force_of(made(F=2, FX=-0.6, FY=0.1)) == pytest.approx([-0.6 * 0.3 * 5e4, 0.1 * 0.3 * 5e4])
    by_rows = [{"IY": row, "FSTAT": 0.2 + row / 100, "FKIN": 0.2 + row / 100} for row in range(1, 11)]
    assert force_of(made(F=1, FX=-0.1, V=3, VARFRC=3, friction=by_rows)) == [pytest.approx(-0.1 * 5e4), None]
    found = made(N=0, PEN=0.02, F=1, FX=0.5)
    force = client.call("contact.solve", {**found, "friction": {"mu": 0.3, "rolling": {"xi": 0.0}}})["forces"]["Fn"]
    assert "Fn" not in found and force_of(found)[0] == pytest.approx(0.5 * 0.3 * force, rel=1e-6)


@pytest.mark.parametrize(("prescribed", "shares"), [(1, (1.5, 0.0)), (2, (0.9, -1.2))])
def test_a_force_beyond_friction_becomes_full_slip(made, prescribed: int, shares: tuple[float, float]) -> None:
    fx, fy = force_of(made(F=prescribed, FX=shares[0], **({"FY": shares[1]} if prescribed == 2 else {})))
    full = 0.3 * 5e4
    assert fx == pytest.approx(shares[0] / 1.5 * full, rel=1e-5)
    assert fx is not None and fx < full and (fy is None) == (prescribed == 1)
    assert np.hypot(fx, fy or 0) < (1 - 1e-6) * full


def test_rows_have_their_own_friction(made) -> None:
    by_rows = [{"IY": row, "FSTAT": 0.2 + row / 100, "FKIN": 0.2 + row / 100} for row in range(1, 11)]
    mu = np.asarray(made(V=3, VARFRC=3, friction=by_rows)["friction"]["mu"])
    assert mu.shape == (10, 12) and mu[3] == pytest.approx(0.24)


@pytest.mark.parametrize(("law", "name", "share"), [(2, "linear", 0.5), (3, "rational", 1.0), (4, "exponential", math.log(2))])
def test_friction_falls_by_two_terms_with_memory(made, law: int, name: str, share: float) -> None:
    one = {"FKIN": 0.15, "F1": 0.12, "SABSH1": 60.0, "F2": 0.08, "SABSH2": 25.0}
    friction = made(FRCLAW=law, friction=(one,), MEMDST=0.003, MEM_S0=1.0)["friction"]
    assert friction["mu"] == pytest.approx(0.35)
    kinetic = friction["kinetic"]
    assert (kinetic["mu"], kinetic["slip_velocity"], kinetic["law"]) == (0.15, pytest.approx(60 / share), name)
    assert (kinetic["second"]["fall"], kinetic["second"]["slip_velocity"]) == (0.08, pytest.approx(25 / share))
    assert (kinetic["memory"]["distance"], kinetic["memory"]["least_velocity"]) == (0.003, 1.0)
    alone = made(FRCLAW=law, friction=({**one, "F2": 0.0},))["friction"]["kinetic"]
    assert "second" not in alone and "memory" not in alone
    if law != 3:
        other = made(FRCLAW=law, friction=({**one, "F1": 0.0, "F2": 0.12, "SABSH2": 60.0},))["friction"]["kinetic"]
        assert alone == pytest.approx(other)


def test_elements_slip_by_themselves(made) -> None:
    slip = np.linspace(0, 1, 120).tolist()
    friction = made(E=9, EXRHS=9, SLIP_X=slip, SLIP_Y=slip[::-1])["friction"]
    assert np.asarray(friction["rigid_slip"]["x"])[2, 5] == slip[2 * 12 + 5]
    alone = made(E=2, EXRHS=2, CPHI=1e-3, CHI=0.0)
    y = (np.arange(10) - 4.5) * alone["grid"]["dy"]
    assert rolling(alone).get("phi", 0.0) == 0
    assert np.asarray(alone["friction"]["rigid_slip"]["x"])[:, 0] == pytest.approx(-1e-3 * y)
    assert not np.asarray(alone["friction"]["rigid_slip"]["y"]).any()


def test_tolerances_get_smaller_and_limits_are_those_of_the_file(made) -> None:
    own = made()["settings"] if "settings" in made() else {}
    assert made(EPS=1e-4).get("settings", {}) == own
    tight = made(EPS=1e-9)["settings"]
    assert [tight[solver]["tolerance"] for solver in ("normal", "tangential")] == [1e-9, 1e-9]
    assert made(POISS1=0.0, MAXOUT=1)["settings"]["outer"]["max_iterations"] == 1
    few = made(MAXGS=80, POISS1=0.0, MAXOUT=7)["settings"]
    assert [few[solver]["max_iterations"] for solver in ("normal", "tangential", "outer")] == [80, 80, 7]


def test_models_are_those_of_the_digits(made) -> None:
    assert made(B=1, FLXZ=2e-5)["sheet_flexibility"] == 2e-5
    fastsim = made(M=3, B=3, **SLOPE)
    assert fastsim["model"] == "fastsim"
    assert {name: fastsim["simplified"][name] for name in ("on_elements", "blended", "coefficients")} == {
        "on_elements": True, "blended": True, "coefficients": "printed",
    }  # fmt: skip
    assert made(M=3, B=2, **SLOPE)["simplified"]["bound"] == "elliptic"
    reduced = made(M=3, B=3, K0=0.54, ALFA=0.02, BETA=0.62)["simplified"]["slope"]
    assert sorted(reduced.values()) == [0.02, 0.54, 0.62]
    assert made(M=5, B=2, **SLOPE)["model"] == "fastrip"
    for digit, normal in ((5, "kpec"), (6, "analyn")):
        overlap = {"B": digit, "N": 0, "PEN": 0.01}
        assert made(**overlap, **QUADRATIC, **CORNER)["normal_model"] == normal
        quick = made(**overlap, M=3, **SLOPE, **QUADRATIC, **CORNER)
        assert (quick["normal_model"], quick["model"]) == (normal, "fastsim")


def test_friction_of_simplified_models_has_no_memory(made) -> None:
    falls: dict[str, Any] = {"FRCLAW": 4, "MEMDST": 0.1, "MEM_S0": 1.0}
    falls["friction"] = [{"FKIN": 0.1, "F1": 0.1, "F2": 0.0, "SABSH1": 990.0, "SABSH2": 1.0}]
    assert "memory" not in made(M=3, B=3, **SLOPE, **falls)["friction"]["kinetic"]
    assert "memory" in made(**falls)["friction"]["kinetic"]


def test_an_interfacial_layer_is_that_of_the_digit(made) -> None:
    values = {"GG3": 8200.0, "LAYTHK": 1.25, "TAU_C0": 150.0, "K_TAU": 9000.0}
    layer = made(M=4, **values)["friction"]["layer"]
    assert (layer["flexibility"], layer["yield_stress"], layer["hardening"]) == (pytest.approx(1.25 / 8200), 150.0, 9000.0)
    assert "yield_stress" not in made(M=4, **{**values, "TAU_C0": 0.0})["friction"]["layer"]
    assert "layer" not in made(M=0, **values)["friction"]


def test_heat_is_that_of_both_bodies_in_watt_metre_and_kilogram(made) -> None:
    found = made(H=3, T=3, **HEAT)["temperature"]
    for body, expected in zip(("upper", "lower"), ((0, 50, 450, 7850), (150, 40, 500, 7000))):
        names = ("bulk_temperature", "conductivity", "heat_capacity", "density")
        assert [found[body].get(name, 0) for name in names] == pytest.approx(expected)
    assert "temperature" not in made(H=0, T=3, **HEAT)
    for yields in (False, True):
        layer = {"M": 4, "GG3": 6500.0, "LAYTHK": 0.06, "TAU_C0": 120.0 * yields, "K_TAU": 0.0}
        problem = made(H=3, T=3, BETAPL=0.9, **layer, **HEAT)
        assert problem["temperature"]["plastic_share"] == 0.9
        assert ("yield_stress" in problem["friction"]["layer"]) == yields


@pytest.mark.parametrize("distance", [0.0, 1e-3])
def test_friction_may_follow_the_temperature(made, distance: float) -> None:
    sets = [{"FREF": 0.3, "TREF": 20.0, "DFHEAT": -0.18, "DTHEAT": 400.0}]
    friction = made(H=3, T=3, FRCLAW=6, friction=sets, MEMDST=distance, MEM_S0=1.0, **HEAT)["friction"]
    law = friction["temperature"]
    assert (friction["mu"], "kinetic" in friction) == (0.3, False)
    assert (law["change"], law["reference"], law["range"]) == (-0.18, 20, 400)
    assert ("memory" in law) == (distance > 0)


def test_bodies_that_creep_alike_are_one_and_others_two(made) -> None:
    creep = {"M": 1, "FG1": 1.0, "FG2": 1.0, "TC1": 0.009, "TC2": 0.009}
    alike = made(**creep)["bodies"]
    assert alike["upper"]["viscoelastic"] == {"f": 1.0, "tau": 0.009}
    assert alike.get("lower", alike["upper"]) == alike["upper"]
    others = made(**{**creep, "FG2": 0.0})["bodies"]
    assert (others["upper"], others["lower"]["viscoelastic"]["f"]) == (alike["upper"], 0.0)


def test_pressures_are_prescribed_over_an_ellipse_or_two_halves(made) -> None:
    assert [made(B=bound)["normal_model"] for bound in (2, 3)] == ["elliptic", "parabolic"]
    halves = made(B=4, IPOTCN=-6, AA=4.0, BNEG=1.0, BPOS=3.0, SCALE=1.1, MX=12, MY=10)
    assert (halves["normal_model"], [*halves["gap"]]) == ("elliptic", ["half_ellipses"])
    assert sorted(halves["gap"]["half_ellipses"].values()) == [1, 3, 4]
    assert made(B=2, M=3, **SLOPE)["normal_model"] == "of_model"  # it bounds FASTSIM


@pytest.mark.parametrize("cant", [0.0, 0.025])
def test_a_roller_has_the_cant_of_the_rail_before_and_leans_with_it(client, folder, cant: float) -> None:
    _, roller = converted(client, [rail_case(CANT=cant), rail_case(**ROLLER)], folder)
    track = roller.wheelrail["setup"]["track"]
    assert (track["cant"], track["roller_radius"], track["roller_leans"]) == (cant, 500, cant != 0)


def test_friction_along_the_track_has_the_mean_numbers_half_way_and_equal_laws_are_one(on_rails) -> None:
    def along(*sets: tuple[float, dict[str, float]], law: int = 4, **changes: Any) -> Any:
        friction = [{"SVF": place, **numbers} for place, numbers in sets]
        return on_rails(friction=friction, V=2, VARFRC=2, L=law, FRCLAW=law, **changes)["setup"]["friction"]

    def law(fkin: float, f1: float, s1: float, f2: float, s2: float) -> dict[str, float]:
        return {"FKIN": fkin, "F1": f1, "SABSH1": s1, "F2": f2, "SABSH2": s2}

    one, other, mean = law(0.3, 0, 1e-4, 0, 1e-4), law(0.1, 0.2, 400, 0.1, 2000), law(0.2, 0.1, 200.00005, 0.05, 1000.00005)
    same = on_rails(friction=[mean], L=4, FRCLAW=4)["setup"]["friction"]
    for sets in ([(-10, one), (10, other)], [(-10, mean), (20, mean)], [(0, mean), (20, other)], [(-20, other), (-10, mean)]):
        assert along(*sets) == same
    hot = {"FREF": 0.4, "TREF": 20.0, "DFHEAT": -0.2, "DTHEAT": 100.0}
    cold = {"FREF": 0.2, "TREF": 40.0, "DFHEAT": -0.1, "DTHEAT": 300.0}
    by_heat = along((-10, hot), (10, cold), law=6, H=3, **HEAT)["temperature"]
    assert (by_heat["change"], by_heat["reference"], by_heat["range"]) == (pytest.approx(-0.15), 30, 200)
    coulomb = [(0, {"FSTAT": 0.2, "FKIN": 0.2}), (10, {"FSTAT": 0.4, "FKIN": 0.4})]
    assert along(*coulomb, law=0, **{**ROLLER, "X_WS": 5.0})["mu"] == pytest.approx(0.3)


def test_forces_do_not_follow_slopes_along_the_track(on_rails, client, folder) -> None:
    assert on_rails(**ROLLER)["setup"]["slope_forces"] == "none"
    (folder / "rail.slcs").write_text("0 1\n2\n0 0 0\n1\n-10. 'rail.prr'\n10. 'rail.prr'\n")
    assert on_rails(RFNAME="rail.slcs")["setup"]["slope_forces"] == "none"


@pytest.mark.parametrize("plane", [2, 3, 4, 5])
def test_wheels_displaced_along_the_track_turn_about_the_rigid_axle_in_planes_only(on_rails, plane: int) -> None:
    rest = dict.fromkeys(("DYWHL", "DZWHL", "DROLLW", "DYAWW", "DPITCHW", "VXWHL", "VYWHL", "VROLLW", "VYAWW", "VPITCHW"), 0.0)
    wheel = on_rails(D=plane, DISCNS=plane, E=5, DXWHL=3.0, VYAW=0.01, VPITCH=-4.0, VZWHL=0.5, **rest)["state"]["wheel"]
    stays = plane in (3, 4)
    assert wheel["x"] == 3
    assert wheel.get("y_velocity", 0.0) == pytest.approx(0 if stays else 0.03)
    assert wheel["z_velocity"] == pytest.approx(0.5 if stays else 12.5)


@pytest.mark.parametrize("distance", [0.0, 0.01])
@pytest.mark.parametrize("alike", [False, True])
def test_friction_by_temperature_and_angle_has_memory(on_rails, distance: float, alike: bool) -> None:
    sets = [
        {"ALPHVF": angle, "FREF": 0.4, "TREF": 20.0, "DFHEAT": change, "DTHEAT": 400.0}
        for angle, change in ((-1.0, -0.1), (0.5, -0.1 if alike else -0.2))
    ]
    friction = on_rails(V=1, VARFRC=1, L=6, FRCLAW=6, friction=sets, MEMDST=distance, MEM_S0=5.0, H=3, **HEAT)["setup"]["friction"]
    assert [one["change"] for one in friction["temperature_by_angle"]] == [-0.1, -0.1 if alike else -0.2]
    assert friction.get("memory") == ({"distance": 0.01, "least_velocity": 5.0} if distance > 0 else None)


def test_distances_and_angles_of_patches_of_zero_part_all_that_can_be_parted(on_rails) -> None:
    found = on_rails(A_SEP=0.0, D_SEP=0.0, D_COMB=0.0, D_TURN=0.0)["setup"]["patches"]
    distances = [found[f"distance_{name}"] for name in ("combine", "separate", "turn")]
    assert 0 < distances[0] < distances[1] < distances[2] < 1e-5
    assert 0 < found["angle_separate"] < 1e-5
    assert on_rails(A_SEP=90.0)["setup"]["patches"]["angle_separate"] == math.pi
