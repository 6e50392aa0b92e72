"""Compares cases of the CONTACT program computed by contactd with the results printed by that program."""

import json
import re
from collections import Counter
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from contactd import AnalyticIcs, ContactProblem, Friction, Grid, Material, Rolling, SemiAxes, TableIcs, contact_files
from contactd.contact_files.comparison import case_differences, differences
from contactd.contact_files.out_file import lines_of, out_text
from contactd.contact_files.out_reader import printed_cases
from contactd.contact_files.prints.mat_file import mat_texts
from support.contact_cases import basic_case, rail_case
from support.contact_runs import computed, computed_file, converted, runner_of, write_profiles
from validation.reasons import reason_of

GIVEN = Path(__file__).parents[3] / "shared" / "contact"
NUMBER = re.compile(r"[-+]?(?:\d+\.?\d*|\.\d+)(?:E[-+]\d+)?$")
PICTURE = re.compile(r" +\d+  [ .o*S]+$")
ITERATIONS = re.compile(r"(?: +\d+){6}$")


@pytest.fixture
def folder(shared, tmp_path):
    write_profiles(tmp_path, shared)
    return tmp_path


def lines_below(lines, label, offset):
    """Returns numbers a given number of lines below their label, as scripts look for them."""
    (index,) = [number for number, line in enumerate(lines) if label in line]
    return [float(word) for word in lines[index + offset].split()]


def test_scripts_find_basic_contact_where_they_look(shared, folder):
    case = basic_case(CPHI=1e-4, CETA=-2e-4, SPINXO=0.5, SPINYO=0.0, O=3)
    (outcome,) = computed(shared, [case], folder)
    lines = lines_of(outcome)
    solution = outcome.solution
    assert lines_below(lines, "KINEMATIC CONSTANTS", 2) == pytest.approx([0, 1.1, 3e4, 1e-3, -2e-4, 1e-4], rel=1e-3)
    forces = lines_below(lines, "ELAST.EN.   FRIC", 1)
    assert forces[:4] == pytest.approx([solution.Fn, solution.Fx, solution.Fy, solution.Mz], rel=5e-4)
    assert forces[5] == pytest.approx(-solution.frictional_power / 1000, rel=5e-4)
    shares = lines_below(lines, "ELAST.EN.   FRIC", 3)
    assert shares[1:] == pytest.approx([solution.Fx / 15e3, solution.Fy / 15e3, solution.approach, solution.pmax], rel=5e-4)
    counts = lines_below(lines, "CONTACT STATISTICS", 4)
    assert counts[:4] == [120, solution.elements.contact, solution.elements.adhesion, solution.elements.slip]
    picture = "".join(line[8:] for line in lines if PICTURE.match(line))
    assert (picture.count("*"), picture.count("S")) == (solution.elements.adhesion, solution.elements.slip)
    assert printed_cases(out_text([lines]))[0].numbers["FX"] == pytest.approx(solution.Fx, rel=5e-4)


def test_temperatures_are_where_scripts_look(shared, folder):
    heat = {"HEATCP": 450.0, "LAMBDA": 50e-3, "DENS": 7.85e-6}
    both = {f"{name}{body}": value for body in (1, 2) for name, value in heat.items()}
    case = basic_case(CKSI=0.03, H=3, O=5, A=2, BKTEMP1=0.0, BKTEMP2=150.0, **both)
    (outcome,) = computed(shared, [case], folder)
    lines, solution = lines_of(outcome), outcome.solution
    assert solution.temperature.largest > 80
    assert lines_below(lines, "MAX(T1,T2)", 1)[-1] == pytest.approx(solution.temperature.largest, rel=5e-4)
    assert lines_below(lines, "BKTEMP      HEATCP", 2) == pytest.approx([150, 450, 0.05, 7.85e-6])
    ((_, text),) = mat_texts(outcome)
    rows = [[float(word) for word in line.split()] for line in text.splitlines() if not line.startswith("%")]
    assert {len(row) for row in rows} == {13}
    assert rows[0][-1] == 2410
    upper = np.array([row[-2] for row in rows[6:]]).reshape(solution.upper_temperature.shape)
    np.testing.assert_allclose(upper, solution.upper_temperature, rtol=1e-5, atol=1e-5)


@pytest.mark.parametrize("tau_c0", [0.0, 120.0])
def test_heat_beside_a_layer_is_computed(shared, folder, tau_c0):
    heat = {"BKTEMP": 0.0, "HEATCP": 450.0, "LAMBDA": 50e-3, "DENS": 7.85e-6}
    both = {f"{name}{body}": value for body in (1, 2) for name, value in heat.items()}
    layer = {"M": 4, "GG3": 6500.0, "LAYTHK": 0.06, "TAU_C0": tau_c0, "K_TAU": 0.0, "BETAPL": 0.9}
    case = basic_case(CKSI=0.02, H=3, **both, **layer)
    (outcome,) = computed(shared, [case], folder)
    assert outcome.status == "solved", outcome.sentence
    solution = outcome.solution
    plastic = solution.plastic_power or 0
    assert (plastic > 0) == (tau_c0 > 0)
    heat = solution.temperature.heat_upper + solution.temperature.heat_lower
    assert heat == pytest.approx(solution.frictional_power - 0.1 * plastic, rel=1e-5)


def one_iteration(**changes):
    """Uses a cylinder between bodies of 26 and 79 GPa, by Johnson's process, with 600 mm long elements along it."""
    area = {"IPOTCN": 1, "MX": 120, "MY": 1, "XL": -0.24, "YL": -300.0, "DX": 0.004, "DY": 600.0}
    distance = {"IBASE": 1, "IPLAN": 1, "B1": 0.012, "B2": 0.0, "B3": 0.0, "B4": 0.0, "B5": 0.0, "B6": 0.0}
    bodies = {"POISS1": 0.33, "POISS2": 0.3, "GG1": 26000.0, "GG2": 79000.0}
    motion = {"FN": 9000.0, "CETA": 0.0, "CPHI": 0.0, "CHI": np.pi, "DQ": 0.004, "VELOC": 500.0, "MAXOUT": 1}
    return basic_case(**{**area, **distance, **bodies, **motion, **changes})


@pytest.mark.parametrize(
    ("changes", "force", "accuracy"),
    [({"CKSI": 2.4e-4, "friction": ({"FSTAT": 0.1, "FKIN": 0.1},)}, -151.4, 0.05),
     ({"F": 1, "FX": 0.3, "friction": ({"FSTAT": 5e-4, "FKIN": 5e-4},)}, 1.350, 5e-6)],
)  # fmt: skip
def test_one_outer_iteration_meets_the_tolerance_and_the_force(shared, folder, changes, force, accuracy):
    (outcome,) = computed(shared, [one_iteration(**changes)], folder)
    assert outcome.status == "solved", outcome.sentence
    assert outcome.solution.Fx == pytest.approx(force, abs=accuracy)
    assert outcome.solution.evidence.tangential.converged


@pytest.mark.parametrize("changes", [{}, {"T": 1}, {"CPHI": 2e-4}])
def test_coefficients_of_a_file_are_solved_with(shared, tmp_path, changes):
    (plain,) = computed(shared, [basic_case(**changes)], tmp_path)
    grid = plain.answer.patches[0].grid
    array = 2 * shared.get_ic(Material(G=82000, nu=0.28), grid, AnalyticIcs()).array
    array[0, 2] = array[2, 0] = array[1, 2] = array[2, 1] = 0  # of like bodies
    (tmp_path / "table.txt").write_text(TableIcs(array, grid.dx, grid.dy).to_contact_text(82000))
    (outcome,) = computed(shared, [basic_case(INFLCF=9, CFNAME="table.txt", **changes)], tmp_path)
    assert outcome.status == "solved", outcome.sentence
    for name in ("Fn", "Fx", "Fy", "Mz", "approach", "pmax"):
        assert getattr(outcome.solution, name) == pytest.approx(getattr(plain.solution, name), rel=2e-3, abs=1e-6)
    assert "FN          FX" in "\n".join(lines_of(outcome))
    (tmp_path / "table.txt").write_text("1 1\n0 312\n1 0\nthree")
    (outcome,) = computed(shared, [basic_case(INFLCF=9, CFNAME="table.txt")], tmp_path)
    assert (outcome.status, "line 4" in outcome.sentence) == ("wrong", True)
    (outcome,) = computed(shared, [basic_case(INFLCF=9, CFNAME="none.txt")], tmp_path)
    assert (outcome.status, "none.txt" in outcome.sentence) == ("wrong", True)


@pytest.mark.parametrize("level", range(6))
def test_more_output_has_more_blocks(shared, folder, level):
    (outcome,) = computed(shared, [basic_case(O=level)], folder)
    lines = lines_of(outcome)
    blocks = {"FN          FX": 1, "KINEMATIC": 2, "FORM OF THE CONTACT": 3, "QUANTITIES": 5}
    assert {name for name in blocks if any(name in line for line in lines)} == {name for name, least in blocks.items() if level >= least}


def test_scripts_find_a_wheel_on_a_rail_where_they_look(shared, folder):
    (outcome,) = computed(shared, [rail_case(Y_WS=3.0, YAW=0.002, O=3)], folder)
    lines, solution = lines_of(outcome), outcome.solution
    (patch,) = solution.patches
    assert " WHEEL-RAIL CONTACT, RIGHT WHEEL,  1 CONTACT PATCH" in lines
    assert lines_below(lines, "WHEEL-SET POSITION", 2) == pytest.approx([0, 3, solution.z, 0, 0.002, 0], abs=1e-4)
    assert lines_below(lines, "WHEEL-SET POSITION", 5) == pytest.approx([2000, 0, 0, 0, 0, -4.348])
    track = solution.forces.track
    assert lines_below(lines, "FX(TR)      FY(TR)", 1)[:3] == pytest.approx([track.Fx, track.Fy, track.Fz], rel=5e-4)
    place = lines_below(lines, "CONTACT REFERENCE LOCATION", 2)
    reference = patch.place.reference
    assert place[:4] == pytest.approx([reference.x, reference.y, reference.z, reference.angle], abs=1e-4)
    assert len(lines_below(lines, "CONTACT REFERENCE LOCATION", 5)) == 3
    assert lines_below(lines, "ELAST.EN.   FRIC", 1)[:4] == pytest.approx(
        [patch.solution.Fn, patch.solution.Fx, patch.solution.Fy, patch.solution.Mz], rel=5e-4
    )


@pytest.mark.parametrize("side", [1, 0])
@pytest.mark.parametrize("placed", [{}, {"GAUGHT": -1.0, "RAILY0": 750.0, "RAILZ0": 0.5}])
def test_the_reference_is_told_in_the_axes_of_both_profiles(shared, tmp_path, side, placed):
    """The point is on the curve of the rail, and on that of the wheel except for their overlap."""
    outwards, radius, slope = 1 if side else -1, 300.0, -0.05

    y = np.linspace(-40, 40, 641)
    for name, z in (("rail", radius - np.sqrt(radius**2 - y**2)), ("wheel", slope * y)):
        order = slice(None, None, 1 if name == "rail" else -1)
        (tmp_path / f"{name}.txt").write_text("".join(f"{a!r} {b!r}\n" for a, b in zip(y.tolist()[order], z.tolist()[order])))
    files = {"RFNAME": "rail.txt", "WFNAME": "wheel.txt", "RAIL_MIRRORZ": -1, "WHEEL_MIRRORZ": -1}
    case = rail_case(**files, C1=side, Y_WS=2.0 * outwards, YAW=0.01 * outwards, ROLL=0.002 * outwards, CANT=0.02, **placed)
    case.values["RAILY0"] = 750.0 * outwards
    (outcome,) = computed(shared, [case], tmp_path)
    (numbers,) = (patch.numbers for patch in outcome.answer.patches)
    (patch,) = outcome.answer.wheelrail.patches
    y, z = numbers["YCP(R)"], numbers["ZCP(R)"]
    assert z == pytest.approx(radius - np.sqrt(radius**2 - y**2), abs=2e-4)
    x, y, z = (numbers[f"{axis}CP(W)"] for axis in "XYZ")
    lower = (x * x) / (2 * (460 + slope * outwards * y))  # than the lowest point of the wheel
    assert z + lower == pytest.approx(slope * outwards * y, abs=1.1 * patch.place.penetration)
    assert patch.place.penetration < 0.1


@pytest.mark.parametrize(("kind", "spline"), [(1, "cubic"), (2, "approximating")])
def test_slices_that_are_alike_are_a_straight_rail_and_a_round_wheel(shared, tmp_path, kind, spline):
    y = np.linspace(-40, 40, 161)
    for name, z in (("rail", y**2 / 600), ("wheel", -0.025 * y)):
        lines = [f"{a:.4f} {b:.6f}" for a, b in zip(y[:: 1 if name == "rail" else -1], z[:: 1 if name == "rail" else -1])]
        (tmp_path / f"{name}.txt").write_text("\n".join(lines) + "\n")
    for name, ending, places in (("rail", "slcs", range(-300, 301, 100)), ("wheel", "slcw", np.arange(-0.3, 0.31, 0.1))):
        below = "".join(f"{place:.3f} '{name}.txt'\n" for place in places)
        (tmp_path / f"{name}.{ending}").write_text(f"0 1\n{len(places)}\n0 0 0\n{kind}\n{below}")
    plain = {"RFNAME": "rail.txt", "WFNAME": "wheel.txt", "RAIL_MIRRORZ": -1, "WHEEL_MIRRORZ": -1,
             "GAUGHT": -1.0, "RAILY0": 750.0, "RAILZ0": 0.0}  # fmt: skip
    sliced = rail_case(**{**plain, "RFNAME": "rail.slcs", "WFNAME": "wheel.slcw"})
    (problem,) = converted(shared, [sliced], tmp_path)
    assert problem.wheelrail["setup"]["rail_spline"] == problem.wheelrail["setup"]["wheel_spline"] == spline
    alike, one = computed(shared, [rail_case(**plain), sliced], tmp_path)
    assert (alike.status, one.status) == ("solved", "solved"), f"{alike.sentence}; {one.sentence}"
    assert one.solution.z == pytest.approx(alike.solution.z, abs=1e-4)
    assert one.patches[0].pmax == pytest.approx(alike.patches[0].pmax, rel=5e-3)


@pytest.mark.parametrize(("bottom", "upwards"), [(-2.0, False), (2.0, True)])
def test_a_disc_lies_as_contact_decides(shared, tmp_path, bottom, upwards):
    """Its sides are at `bottom` next to the flat tread at z = 0, so no flange stands out."""
    y = np.linspace(-10, 10, 81)
    z = bottom * np.clip((np.abs(y) - 8) / 2, 0, 1) ** 2
    (tmp_path / "disc.csv").write_text("".join(f"{a:.4f},{b:.6f}\n" for a, b in zip(y, z)))
    write_profiles(tmp_path, shared)
    (problem,) = converted(shared, [rail_case(WFNAME="disc.csv", WHEEL_MIRRORZ=0)], tmp_path)
    assert problem.wheelrail["setup"]["wheel"]["file"]["mirror_z"] is upwards


def test_a_wheel_at_rest_adheres(shared, folder):
    still = dict.fromkeys(("VS", "VY", "VZ", "VROLL", "VYAW", "VPITCH"), 0.0)
    (outcome,) = computed(shared, [rail_case(Y_WS=3.0, O=3, **still)], folder)
    counts = outcome.compared.patches[0]
    assert (counts["NADH"], counts["NSLIP"]) == (counts["NCON"], 0)
    lines = lines_of(outcome)
    assert "S" not in "".join(line[8:] for line in lines if PICTURE.match(line))
    assert any("Chi=" in line for line in lines)


def test_a_thin_sheet_yields_beside_the_bodies(shared, folder):
    """The program multiplies FLXZ by the pressure, in basic contact and on a rail alike, and ignores it where B is
    0."""
    for plain, soft in (
        (basic_case(FLXZ=2e-5), basic_case(B=1, FLXZ=2e-5)),
        (rail_case(FLXZ=2e-5), rail_case(B=1, FLXZ=2e-5)),
    ):
        bodies, sheet = computed(shared, [plain, soft], folder)
        first, second = (one.compared.patches[0] if one.compared.patches else one.compared.numbers for one in (bodies, sheet))
        assert second["PMAX"] < 0.9 * first["PMAX"]
        assert second["NCON"] > first["NCON"]
    (solution,) = sheet.patches
    assert solution.displacement_z.max() > 2e-5 * solution.pmax


def test_steps_go_on_from_each_other_as_a_session_does(shared, folder):
    first = basic_case(number=1, T=1, P=2, CKSI=2e-3, CPHI=0.0)
    back = basic_case(number=2, T=1, P=0, CKSI=-2e-3, CPHI=0.0)
    again = basic_case(number=3, T=1, P=3, CKSI=-1e-3, CPHI=0.0)
    solutions = [outcome.solution for outcome in computed(shared, [first, back, again], folder)]
    problems = [dict(one.contact) for one in converted(shared, [first, back, again])]
    one = shared.call("contact.solve", problems[0])
    assert solutions[0].Fx == one["forces"]["Fx"]
    previous = {name: one[name] for name in ("pressure", "traction_x", "traction_y")}
    for problem, solution in zip(problems[1:], solutions[1:]):
        assert solution.Fx == shared.call("contact.solve", {**problem, "previous": previous})["forces"]["Fx"]


def test_elastic_energy_is_half_the_work_of_the_load(shared, folder):
    """Normal contact stores the energy int Fn d(approach) = 2/5 Fn approach (Hertz)."""
    (outcome,) = computed(shared, [basic_case(T=0, MX=40, MY=40)], folder)
    solution = outcome.solution
    assert outcome.numbers["ELAST.EN."] == pytest.approx(0.4 * solution.Fn * solution.approach / 1000, rel=2e-3)


def test_fastsim_on_elements_is_what_is_printed_and_small_ones_come_to_contactds(shared):
    """Explains why FASTSIM on its own slices has other forces than on elements: whole steps from before the first
    element on, spin evaluated a sixth of a step ahead, and creepage coefficients that are read from a table."""
    assert fastsim_on_elements(44, (0.4937e-4, 0.5152e-4, 0.4090e-4)) == pytest.approx((-15050, -39000), rel=5e-4)
    a, b, bound = 8.0, 4.0, 0.3 * 82000
    motion = Rolling(eta=-0.000625, phi=0.000625)
    problem = ContactProblem(grid=Grid.centred(44, 44, 17.6, 8.8), upper=Material(G=82000, nu=0.28), gap=SemiAxes(a, b), Fn=82000,
                             model="fastsim", friction=Friction(mu=0.3, rolling=motion))  # fmt: skip
    nearly_none = Friction(mu=0.3, rolling=Rolling(phi=1e-9))
    slopes = shared.solve(problem.replace(friction=nearly_none, derivatives=True)).derivatives
    volume = a * a * b
    flexibilities = (
        -8 * volume / (3 * slopes.Fx.xi), -8 * volume / (3 * slopes.Fy.eta), -np.pi * volume * a / (4 * slopes.Fy.phi)
    )  # fmt: skip
    fy, mz = fastsim_on_elements(880, flexibilities)
    solution = shared.solve(problem)
    assert fy == pytest.approx(solution.Fy, abs=8e-3 * bound)
    assert mz == pytest.approx(solution.Mz, rel=0.015)
    assert abs(solution.Fy + 15050) > 0.03 * bound


def fastsim_on_elements(n, flexibilities):
    """Returns Fy and Mz of examples/fastsim.inp, case 2, on n x n elements."""
    a, b, scale, bound = 8.0, 4.0, 1.1, 0.3 * 2 * 82000 / (np.pi * 8 * 4)
    eta, phi, (_, l2, l3) = -0.000625, 0.000625, flexibilities
    dx, dy = 2 * a * scale / n, 2 * b * scale / n
    x, y = (np.arange(n) + 0.5) * dx - a * scale, (np.arange(n) + 0.5) * dy - b * scale
    px, py, fy, mz = np.zeros(n), np.zeros(n), 0.0, 0.0
    for at in x[::-1]:
        limit = np.maximum(0, bound * (1 - (at / a) ** 2 - (y / b) ** 2))
        px, py = px + phi * y / l3 * dx, py - (eta / l2 + phi * (at + dx / 6) / l3) * dx
        size = np.hypot(px, py)
        held = np.where(size > limit, limit / np.where(size > 0, size, 1), 1)
        px, py = px * held, py * held
        fy, mz = fy + py.sum() * dx * dy, mz + (at * py - y * px).sum() * dx * dy
    return fy, mz


@pytest.fixture
def given():
    if not GIVEN.is_dir():
        pytest.skip(f"{GIVEN} is not there: the cases of the CONTACT program are not in the tree")
    return json.loads((GIVEN / "cases_given.json").read_text())


def beside_printed(one, client, chosen):
    """Computes the chosen cases of a given file, each with its printed results."""
    printed = printed_cases((GIVEN / one["reference"]).read_text(errors="replace"))
    cases = contact_files.read(GIVEN / one["file"], client).cases
    theirs = {(case.line, case.number): shown for case, shown in zip(cases, printed, strict=True)}
    found = computed_file(client, GIVEN / one["file"], "bilinear", chosen)
    return [(outcome, theirs[outcome.case.line, outcome.number]) for outcome in found]


@pytest.mark.slow  # solves four hundred given cases
@pytest.mark.timeout(600)
@pytest.mark.parametrize("module", [1, 3])
def test_given_cases_agree_or_are_refused_by_name_or_have_a_reason(shared, given, module):
    counts = Counter()
    unexpected = []
    for one in given["files"]:
        if not any(case["module"] == module for case in one["cases"]):
            continue
        for outcome, theirs in beside_printed(one, shared, lambda case: case.module == module):
            apart = [] if outcome.compared is None else case_differences(outcome.compared, theirs)
            is_met = not apart and outcome.status in ("solved", "refused", "follows")
            counts["known" if not is_met else "agrees" if outcome.solution is not None else outcome.status] += 1
            if not is_met and reason_of(one["file"], outcome.case.number) is None:
                unexpected.append((one["file"], outcome.case.number, outcome.status, outcome.sentence, apart))
    assert unexpected == []
    assert counts["agrees"] >= {1: 362, 3: 200}[module]
    print(counts)


def test_a_public_shift_is_counted_from_the_top_of_a_rail_without_a_point_there(shared):
    """Compares with values printed by the CONTACT program. The rail is an arc of 270 mm, and the wheel a cone of
    1:20."""
    path = GIVEN.parent / "public-cases" / "h3_shift_on_rail.inp"
    if not path.is_file():
        pytest.skip(f"{path} is not there: the public case is not in the tree")
    (outcome,) = computed_file(shared, path, "bilinear")
    (patch,) = outcome.answer.patches
    across = patch.numbers["SPINYO"]
    assert across == pytest.approx(-270 * np.arctan(1 / 20), abs=0.01)
    assert across == pytest.approx(-13.49, abs=0.01)
    assert patch.numbers["MN"] == pytest.approx(19020, rel=1e-3)


@pytest.mark.parametrize("number", [36, 37])
def test_a_given_massless_flexible_rail_is_met_at_the_height_that_is_printed(shared, given, number):
    """Explains why these cases differ: their heights are not those of the file."""
    (one,) = (one for one in given["files"] if one["file"] == "testbank/testbank.inp")
    printed = printed_cases((GIVEN / one["reference"]).read_text(errors="replace"))
    cases = zip(contact_files.read(GIVEN / one["file"], shared).cases, printed, strict=True)
    ((case, theirs),) = (pair for pair in cases if pair[0].number == number)
    assert abs(case.values["Z_WS"] - theirs.numbers["Z_WS"]) > 2.5e-3
    case = replace(case, values={**case.values, "Z_WS": theirs.numbers["Z_WS"]}, digits={**case.digits, "P": 2})
    (outcome,) = computed(shared, [case], GIVEN / "testbank", "bilinear")
    found = outcome.compared
    assert list(differences(found.numbers, theirs.numbers, found.bound)) == []


@pytest.mark.parametrize(
    ("name", "number", "patch"),
    [("testbank/testbank", 31, 1), ("testbank/examples_s+c/cw_interrupt", 1, 0), ("testbank/examples_s+c/mbench_locus", 29, 0)],
)
def test_moments_about_the_places_that_are_printed_are_those_that_are_printed(shared, given, name, number, patch):
    """Explains why these cases differ: moments refer to points that are some thousandths of a millimetre apart."""
    (one,) = (one for one in given["files"] if one["file"] == f"{name}.inp")
    ((outcome, printed),) = beside_printed(one, shared, lambda case: case.number == number)
    ours, theirs, found = outcome.compared.patches[patch], printed.patches[patch], outcome.patches[patch]
    along, across = (theirs[key] - ours[key] for key in ("XCP(TR)", "YCP(TR)"))
    assert 5e-4 < np.hypot(along, across) < 5e-3
    moment = ours["MN"] - along * found.Fy + across * found.Fx
    tolerance = 5e-4 * max(abs(theirs["MN"]), 0.3 * theirs["FN"])
    assert abs(ours["MN"] - theirs["MN"]) > tolerance
    assert moment == pytest.approx(theirs["MN"], abs=tolerance)


def test_given_lines_are_met_but_for_digits(shared, given):
    """Compares each line of a given .out file below the control digits: labels at the same places, numbers within the
    tolerance."""
    met = 0
    for name in ("examples/tractcurv", "examples/spence35", "examples/fastsim"):
        text = (GIVEN / f"{name}.ref_out").read_text(errors="replace")
        blocks = re.split(r"^ Case .*$", text.replace("\r", ""), flags=re.MULTILINE)[1:]
        outcomes = computed_file(shared, GIVEN / f"{name}.inp", chosen=slice(31))
        for outcome, block in zip(outcomes, blocks):
            theirs, ours = block.split("\n"), lines_of(outcome)
            is_simplified = outcome.case.digits["M"] in (3, 5)
            if outcome.solution is None or is_simplified or not any("PBTNFS." in line for line in theirs):
                continue
            for mine, printed in zip(from_digits(ours), from_digits(theirs)):
                assert is_met(mine, printed), f"{name}, case {outcome.case.number}:\n{printed}\n{mine}"
                met += 1
    assert met > 1500


def test_a_given_rail_that_is_interrupted_comes_near_what_is_printed(shared, given):
    file = GIVEN / "testbank/examples_s+c/cw_interrupt.inp"
    printed = printed_cases(file.with_suffix(".ref_out").read_text(errors="replace"))
    for outcome, theirs in zip(computed_file(shared, file, "bilinear"), printed, strict=True):
        assert outcome.status == "solved", outcome.sentence
        for patch, their_patch in zip(outcome.patches, theirs.patches, strict=True):
            assert patch.Fn == pytest.approx(their_patch["FN"], rel=2e-3)


def from_digits(lines):
    (start,) = [number for number, line in enumerate(lines) if "PBTNFS." in line]
    return lines[start:]


def is_met(mine, printed):
    if PICTURE.match(printed):
        return PICTURE.match(mine) and len(mine) == len(printed) and sum(a != b for a, b in zip(mine, printed)) <= 2
    if ITERATIONS.match(printed):  # their iterations are others
        return [int(word) for word in mine.split()[:4]] == pytest.approx([int(word) for word in printed.split()[:4]], abs=3)
    if mine.rstrip() == printed.rstrip():
        return True
    words = list(zip(mine.split(), printed.split(), strict=True))
    return all(a == b or (NUMBER.match(a) and NUMBER.match(b) and is_near(float(a), float(b))) for a, b in words)


def is_near(one, other):
    return abs(one - other) <= max(1.1e-3 * max(abs(one), abs(other)), 1e-6)


def test_given_steps_have_the_lines_that_are_printed(shared, given):
    for name in ("m1_catt_shift", "m1_trans_roll"):
        file = GIVEN / f"testbank/examples_trans/{name}.inp"
        text = file.with_suffix(".ref_out").read_text(errors="replace").replace("\r", "")
        blocks = re.split(r"^ Case .*$", text, flags=re.MULTILINE)[1:]
        for outcome, block in zip(computed_file(shared, file, "bilinear", slice(3)), blocks):
            theirs = from_digits(block.split("\n"))
            for mine, printed in zip(from_digits(lines_of(outcome)), theirs):
                # Their grid may have one column more.
                assert ITERATIONS.match(printed) or not mine.strip(" 0123456789") or is_met(mine, printed), f"{printed}\n{mine}"


def test_elements_of_a_shift_are_counted_from_one_place_on_the_rail(shared, folder):
    """Corners of grids in .mat files are whole elements apart, at any position of the wheel, and moments refer to
    them."""
    corners = []
    for place in (0.0, 0.6, 1.13):
        case = rail_case(T=1, A=2, S_WS=place, VS=0.01, VPITCH=0.0)
        (outcome,) = computed(shared, [case], folder)
        (patch,) = outcome.answer.patches
        ((_, text),) = mat_texts(outcome)
        centre = patch.numbers["SPINXO"], patch.numbers["SPINYO"]
        numbers = [line.split() for line in text.splitlines()]
        assert [float(word) for word in numbers[5][9:11]] == pytest.approx(centre, rel=1e-5)
        corners.append(np.array([float(word) for word in numbers[7][2:4]]))
        (solution,) = outcome.patches
        moment = solution.Mz + centre[0] * solution.Fy - centre[1] * solution.Fx
        assert patch.numbers["MN"] == pytest.approx(moment, rel=1e-9)
    size = np.array([patch.grid.dx, patch.grid.dy])
    for corner in corners:
        apart = (corner - corners[0]) / size
        assert apart == pytest.approx(np.round(apart), abs=1e-3)


def problem_of_first(client, file):
    """Returns set-up and state of the first case of a file, as on the wire."""
    runner, cases = runner_of(client, file.read_text(), file.parent)
    (converted_case,) = runner.converted(cases[:1])
    return converted_case.wheelrail["setup"], converted_case.wheelrail["state"]


@pytest.mark.parametrize("x", [50.0, 57.0, 60.0])
def test_a_patch_around_a_gap_in_the_rail_has_its_place_on_what_is_there(shared, given, x):
    """Uses slices that are joined without features, far from the wheel of the case."""
    file = GIVEN / "testbank/examples_s+c/mbench_brute.inp"
    setup, state = problem_of_first(shared, file)
    state = {**state, "position": {**state["position"], "x": x}}
    solution = shared.call("wheelrail.solve", {"setup": setup, "state": state, "fields": []})
    assert all(np.isfinite(patch["place"]["reference"]["z"]) for patch in solution["patches"])


@pytest.mark.slow  # solves a thousand steps of a wheel along crossings
@pytest.mark.timeout(300)
@pytest.mark.parametrize(
    ("name", "y", "first", "last"), [("cw_interrupt", 40.0, -300, 500), ("cw_interrupt", 0.0, -20, 100), ("mbench_brute", 0.81, 175, 450)]
)
def test_a_wheel_along_a_crossing_jumps_nowhere_but_where_a_patch_appears(shared, given, name, y, first, last):
    file = GIVEN / f"testbank/examples_s+c/{name}.inp"
    setup, state = problem_of_first(shared, file)
    steps = []
    session = shared.call("session.open", {"wheelrail": {"setup": {**setup, "dx": 0.5, "dy": 0.5}}})["session"]
    for number, x in enumerate(range(first, last), 1):
        here = {**state, "position": {**state["position"], "x": float(x), "y": y}}
        answer = shared.call("session.step", {"session": session, "step": number, "wheelrail": {"state": here}, "fields": []})
        steps.append(answer["wheelrail"])
    shared.call("session.close", {"session": session})
    bends = 0
    for before, here, behind in zip(steps, steps[1:], steps[2:]):
        if len({len(step["patches"]) for step in (before, here, behind)}) > 1 or not here["patches"]:
            continue
        lateral = [step["forces"]["track"]["Fy"] for step in (before, here, behind)]
        assert abs(before["z"] - 2 * here["z"] + behind["z"]) < 5e-3
        assert abs(lateral[0] - 2 * lateral[1] + lateral[2]) < 150
        bends += 1
    assert bends > 50
