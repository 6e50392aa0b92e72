"""Tests tables that the daemon exports to files and that return in a contact problem."""

import dataclasses

import numpy as np
import pytest

from contactd import (
    AnalyticIcs,
    Client,
    ContactProblem,
    FemIcs,
    Grid,
    IcTable,
    InvalidArgument,
    Material,
    TableIcs,
    load_table,
    save_table,
)
from support.daemons import eventually
from support.problems import CATTANEO, CATTANEO_PARAMS, GRID, QUICK, STEEL

SOFT, HARD = CATTANEO.upper, Material(G=800, nu=0.1)
RECTANGLES = Grid(7, 4, 0.8, 0.4)
EXPORT_PARAMS = {
    "material": {"G": 82000, "nu": 0.28},
    "grid": {"nx": 6, "ny": 5, "dx": 0.8, "dy": 0.8},
    "ics": {"source": "analytic"},
    "format": "contact",
}


def by_values(problem: ContactProblem) -> ContactProblem:
    """Uses the gap as an array. For a paraboloid between materials, solvers start from Hertz's theory, which does not
    apply to tables."""
    x, y = np.meshgrid(problem.grid.x, problem.grid.y)
    return problem.replace(gap=x**2 / (2 * problem.gap.Rx) + y**2 / (2 * problem.gap.Ry))


@pytest.fixture(scope="module", params=[AnalyticIcs(), QUICK], ids=["analytic", "fem"])
def cattaneo(request, shared_daemon):
    """Solves the Cattaneo problem with coefficients of either kind."""
    problem = by_values(CATTANEO.replace(ics=request.param))
    with shared_daemon.client() as client:
        return problem, client.solve(problem)


def assert_same_solution(solution, expected):
    assert solution.converged
    assert (solution.Fn, solution.Fx) == pytest.approx((expected.Fn, expected.Fx), rel=1e-12)
    assert solution.elements == expected.elements
    np.testing.assert_allclose(solution.pressure, expected.pressure, rtol=1e-10, atol=1e-10)
    np.testing.assert_allclose(solution.traction_x, expected.traction_x, rtol=1e-9, atol=1e-9)
    np.testing.assert_array_equal(solution.element_division, expected.element_division)


# --- there and back ---------------------------------------------------------------------------------------------------


def test_contacts_text_solves_to_the_same(shared, cattaneo, tmp_path):
    problem, expected = cattaneo
    path = tmp_path / "cattaneo.txt"
    path.write_bytes(shared.export_ic(problem.upper, problem.grid, problem.ics, "contact"))
    assert_same_solution(shared.solve(problem.replace(upper=None, ics=TableIcs.from_contact_text(path))), expected)


@pytest.mark.parametrize("suffix", ["npz", "h5", "txt"])
def test_files_of_the_client_solve_to_the_same(shared, cattaneo, tmp_path, suffix):
    problem, expected = cattaneo
    path = tmp_path / f"cattaneo.{suffix}"
    if suffix == "h5":
        path.write_bytes(shared.export_ic(problem.upper, problem.grid, problem.ics))
    else:
        save_table(path, shared.get_ic(problem.upper, problem.grid, problem.ics))
    table = load_table(path)
    ics = TableIcs.from_table(table) if isinstance(table, IcTable) else table
    assert_same_solution(shared.solve(problem.replace(ics=ics)), expected)


@pytest.mark.parametrize(
    "ics",
    [AnalyticIcs(load_shape="bilinear"), QUICK, FemIcs(accuracy=1e-2, any_nu=True)],
    ids=["analytic", "fem", "family"],
)
def test_an_ic_file_holds_the_table_and_what_made_it(shared, tmp_path, ics):
    path = tmp_path / "table.h5"
    path.write_bytes(shared.export_ic(STEEL, RECTANGLES, ics, "hdf5"))
    table, expected = load_table(path), shared.get_ic(STEEL, RECTANGLES, ics)
    np.testing.assert_array_equal(table.array, expected.array)
    assert table.evidence == expected.evidence
    assert (table.spec.material, table.spec.grid) == (STEEL, RECTANGLES)
    for field in dataclasses.fields(ics):
        # The file contains the values that determine the numbers, and no others.
        if (value := getattr(table.spec.ics, field.name)) is not None:
            assert value == getattr(expected.spec.ics, field.name), field.name
    assert type(table.spec.ics) is type(ics)


def test_an_ic_file_is_hdf5_for_everybody(shared, tmp_path):
    h5py = pytest.importorskip("h5py")
    path = tmp_path / "table.h5"
    path.write_bytes(shared.export_ic(STEEL, RECTANGLES, AnalyticIcs()))
    with h5py.File(path) as file:
        assert file["influence_coefficients"].shape == (3, 3, 4, 7)
        assert file["influence_coefficients"].attrs["units"].startswith("mm^3/N")
        assert (file["spec"].attrs["G"], file["spec"].attrs["dx"], file["spec"].attrs["dy"]) == (82000, 0.8, 0.4)


def test_a_file_of_the_store_is_read_without_dimensions(daemon, tmp_path):
    with daemon.client() as client:
        expected = client.get_ic(STEEL, GRID, QUICK)
    (path,) = daemon.tables()
    table = load_table(path)
    assert (table.spec.material, table.spec.grid) == (Material(1, 0.28), Grid(6, 6, 1, 1))
    np.testing.assert_allclose(table.array * GRID.dx / STEEL.G, expected.array, rtol=1e-15)


def test_an_exported_file_put_into_the_store_is_set_aside(daemons):
    daemon = daemons.start()
    with daemon.client() as client:
        expected = client.get_ic(STEEL, GRID, QUICK)
        exported = client.export_ic(STEEL, GRID, QUICK)
    daemon.stop()
    (path,) = daemon.tables()
    path.write_bytes(exported)
    with daemons.start().client() as client:
        np.testing.assert_allclose(client.get_ic(STEEL, GRID, QUICK).array, expected.array, rtol=1e-9)
        assert client.info().counters["tables_set_aside"] == 1


def test_an_exported_table_is_imported_by_another_daemon(daemons, shared):
    expected, file = shared.get_ic(STEEL, GRID, QUICK), shared.export_ic(STEEL, GRID, QUICK)
    with daemons.start(builds={"program": "/bin/false"}).client() as client:
        assert client.import_ic(file).ics.key == expected.key
        np.testing.assert_allclose(client.get_ic(STEEL, GRID, QUICK).array, expected.array, rtol=1e-14)


# --- CONTACT's text ---------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("lower", [None, HARD], ids=["equal", "different"])
def test_daemon_and_client_write_the_same_text(shared, lower):
    upper = shared.get_ic(SOFT, RECTANGLES, AnalyticIcs())
    pair = TableIcs.from_table(upper, None if lower is None else shared.get_ic(lower, RECTANGLES, AnalyticIcs()))
    text = shared.export_ic(SOFT, RECTANGLES, AnalyticIcs(), "contact", lower=lower)
    assert text.decode() == pair.to_contact_text()


def test_the_text_is_that_of_both_bodies_times_the_combined_modulus(shared):
    table = shared.get_ic(STEEL, RECTANGLES, AnalyticIcs())
    lines = shared.export_ic(STEEL, RECTANGLES, AnalyticIcs(), "contact").decode().splitlines()
    assert [line.split()[:4] for line in lines[:4]] == [
        ["1", "1"],
        ["0", "312"],
        ["1", "0"],
        ["7", "4", *lines[3].split()[2:]],
    ]
    assert [float(word) for word in lines[3].split()[2:]] == [0.8, 0.4]
    # The file has CONTACT's format: blocks of two comments and mx lines for y offsets from -my+1 on.
    for block, iy in enumerate(range(-3, 4)):
        first = 4 + block * 9
        assert lines[first].startswith("%")
        assert lines[first + 1].startswith("%")
        for ix in range(7):
            row = [float(word) for word in lines[first + 2 + ix].split()]
            assert row[:2] == [ix, ix * 0.8]
            assert row[2] == pytest.approx(2 * 82000 * table["zz"][abs(iy), ix], rel=1e-15)
            assert row[7] == pytest.approx(2 * 82000 * table["xy"][abs(iy), ix] * (-1 if iy < 0 else 1), rel=1e-15)
    assert len(lines) == 4 + 7 * 9


def test_different_bodies_go_by_text_as_they_go_by_materials(shared, tmp_path):
    problem = by_values(CATTANEO.replace(lower=HARD, friction=None))
    path = tmp_path / "pair.txt"
    path.write_bytes(shared.export_ic(SOFT, problem.grid, AnalyticIcs(), "contact", lower=HARD))
    ics = TableIcs.from_contact_text(path)
    assert ics.G == pytest.approx(320)
    assert_same_solution(shared.solve(problem.replace(ics=ics)), shared.solve(problem))


# --- the method -------------------------------------------------------------------------------------------------------


def test_exports_join_builds_and_use_the_cache(daemon, background):
    progress = []
    with daemon.client() as client:
        table = background(client.get_ic, STEEL, Grid(30, 30, 0.8, 0.8), QUICK)
        files = [
            background(client.export_ic, STEEL, Grid(20, 20, 0.8, 0.8), QUICK, kind, on_progress=progress.append)
            for kind in ("hdf5", "contact", "hdf5")
        ]
        assert table.result().origin == "built"
        assert all(len(file.result()) > 1000 for file in files)
        client.export_ic(STEEL, GRID, QUICK, "contact", lower=STEEL)
        counters = client.info().counters
    assert counters["builds_started"] <= 2  # a file with a smaller extent may have been written first
    assert counters["builds_joined"] + counters["memory_hits"] >= 3


def test_the_answer_says_where_the_coefficients_came_from(raw):
    answer = raw.ask("ic.export", {**EXPORT_PARAMS, "lower": {"G": 1000, "nu": 0.17}})
    assert set(answer.result["ics"]) == {"upper", "lower"}
    assert answer.result["ics"]["lower"]["origin"] == "closed_form"
    assert answer.result["ics"]["upper"]["key"] != answer.result["ics"]["lower"]["key"]
    assert list(raw.ask("ic.export", {**EXPORT_PARAMS, "format": "hdf5"}).result["ics"]) == ["upper"]


def test_bytes_may_come_as_a_list(raw):
    params = {**EXPORT_PARAMS, "format": "hdf5"}
    listed = raw.ask("ic.export", params, arrays="list")
    assert listed.frames == []
    assert bytes(listed.result["file"]).startswith(b"contactd ic table")
    assert len(listed.result["file"]) == len(raw.ask("ic.export", params).frames[0])


@pytest.mark.parametrize(
    ("changes", "field"),
    [
        ({"format": "npz"}, "format"),
        ({"path": "/etc/passwd"}, "path"),
        ({"format": "hdf5", "lower": {"G": 1, "nu": 0}}, "lower"),
        ({"lower": {"G": 0, "nu": 0}}, "lower.G"),
        ({"lower": {"G": 1, "nu": 0.5}, "ics": {"source": "fem"}}, "lower.nu"),
        ({"material": {"G": 1, "nu": 0.5}, "ics": {"source": "fem"}}, "material.nu"),
        ({"ics": {"source": "table"}}, "ics.source"),
        ({"grid": {"nx": 0, "ny": 5, "dx": 1, "dy": 1}}, "grid.nx"),
        ({"grid": {"nx": 1000, "ny": 1000, "dx": 1, "dy": 1}}, "grid.nx"),
        ({"grid": {"nx": 4_000_000, "ny": 4_000_000, "dx": 1, "dy": 1}}, "grid.nx"),
    ],
    ids=str,
)  # fmt: skip
def test_an_export_that_cannot_be_asked_for(raw, changes, field):
    answer = raw.ask("ic.export", {**EXPORT_PARAMS, **changes})
    assert answer.status == "INVALID_ARGUMENT"
    assert field in answer.fields


# --- coefficients with the problem ------------------------------------------------------------------------------------


@pytest.fixture(scope="module")
def pair(shared_daemon):
    """Returns the coefficients of the Cattaneo problem."""
    with shared_daemon.client() as client:
        return TableIcs.from_table(client.get_ic(SOFT, CATTANEO.grid, AnalyticIcs()))


def given(pair, **changes):
    return CATTANEO.replace(upper=None, ics=dataclasses.replace(pair, **changes))


def changed(pair, component, ix, iy, value):
    array = pair.array.copy()
    array["xyz".index(component[0]), "xyz".index(component[1]), iy, ix] = value
    return array


def test_the_solution_says_that_coefficients_were_given(shared, pair):
    use = shared.solve(given(pair)).evidence.ics
    assert list(use) == ["pair"]
    assert (use["pair"].origin, use["pair"].evidence.source, len(use["pair"].key)) == ("given", "table", 64)
    other = shared.solve(given(pair, array=pair.array * 1.1)).evidence.ics
    assert other["pair"].key != use["pair"].key


def test_a_softer_table_gives_less_force(shared, pair):
    problem = CATTANEO.replace(friction=None)
    whole = shared.solve(problem.replace(ics=pair))
    half = shared.solve(problem.replace(ics=dataclasses.replace(pair, array=2 * pair.array)))
    assert half.Fn == pytest.approx(whole.Fn / 2, rel=1e-5)


def test_a_table_may_cover_more_than_the_grid(shared, pair):
    grid = Grid(31, 20, pair.dx, pair.dy)
    problem = by_values(CATTANEO.replace(grid=grid))
    assert_same_solution(shared.solve(problem.replace(ics=pair)), shared.solve(problem))


def test_a_table_in_the_message_itself_may_cover_more_than_the_grid(raw, pair):
    params = {**CATTANEO_PARAMS, "grid": {"nx": 3, "ny": 2, "dx": pair.dx, "dy": pair.dy}}
    del params["bodies"]
    table = np.ascontiguousarray(pair.array[:, :, :4, :5])
    reference = {"$array": {"frame": 1, "dtype": "<f8", "shape": list(table.shape)}}
    ics = {"source": "table", "dx": pair.dx, "dy": pair.dy}
    framed = raw.ask("contact.solve", {**params, "ics": {**ics, "table": reference}}, table.tobytes())
    listed = raw.ask("contact.solve", {**params, "ics": {**ics, "table": table.tolist()}})
    expected = raw.ask("contact.solve", {**CATTANEO_PARAMS, "grid": params["grid"]})
    assert framed.result["forces"] == listed.result["forces"]
    for name, force in expected.result["forces"].items():
        assert framed.result["forces"][name] == pytest.approx(force, rel=1e-12, abs=1e-15)


def test_bodies_are_only_superfluous_with_a_table(shared, shared_daemon, pair):
    with Client(shared_daemon.endpoint) as client, pytest.raises(InvalidArgument, match=r"bodies is missing"):
        client.solve(CATTANEO.replace(upper=None))
    assert shared.solve(CATTANEO.replace(upper=Material(1, 0), ics=pair)).Fn == pytest.approx(9.1973, rel=1e-4)


@pytest.mark.parametrize(
    ("change", "says"),
    [
        (lambda pair: {"dx": 0.061}, r"ics\.dx is 0\.061; the grid's elements are 0\.06 along x"),
        (lambda pair: {"dy": 0.12}, r"ics\.dy is 0\.12"),
        (lambda pair: {"array": pair.array[:, :, :, :39]}, r"ics\.table has shape \[3,3,40,39\]"),
        (lambda pair: {"array": changed(pair, "zz", 0, 0, 0)}, r"contains 0 for zz at the offset \(0, 0\)"),
        (lambda pair: {"array": -pair.array}, r"must be positive"),
        (lambda pair: {"array": changed(pair, "yy", 2, 1, 1)}, r"contains 1 for yy at the offset \(2, 1\); .*must be the largest"),
        (lambda pair: {"array": pair.array[:, :, ::-1, ::-1]}, r"the value at \(0, 0\), the first in the table, must be the largest"),
    ],
    ids=["dx", "dy", "extent", "zero", "minus", "larger", "reversed"],
)  # fmt: skip
def test_a_table_that_cannot_be_solved_with_is_named(shared_daemon, pair, change, says):
    with Client(shared_daemon.endpoint) as client, pytest.raises(InvalidArgument, match=says):
        client.solve(given(pair, **change(pair)))


def test_friction_with_a_table_that_couples_is_that_of_its_bodies(shared):
    soft, hard = (shared.get_ic(material, CATTANEO.grid, AnalyticIcs()) for material in (SOFT, HARD))
    of_bodies = shared.solve(by_values(CATTANEO.replace(upper=SOFT, lower=HARD)))
    of_table = shared.solve(by_values(CATTANEO.replace(ics=TableIcs.from_table(soft, hard))))
    assert of_table.evidence.outer.converged
    assert_same_solution(of_table, of_bodies)


def test_coupling_of_the_size_of_rounding_is_taken_for_none(shared, pair):
    own = pair["zz"][0, 0]
    expected = shared.solve(given(pair))
    assert_same_solution(shared.solve(given(pair, array=changed(pair, "xz", 1, 0, 0.9e-6 * own))), expected)
    assert shared.solve(given(pair, array=changed(pair, "zy", 1, 1, -1.1e-6 * own))).evidence.outer.converged


def test_a_solve_with_a_table_builds_nothing(daemon):
    with daemon.client() as client:
        pair = TableIcs.from_table(client.get_ic(SOFT, GRID, AnalyticIcs()))
        before = client.info().counters
        client.solve(ContactProblem(grid=GRID, gap=CATTANEO.gap, approach=0.02, ics=pair))
        after = client.info().counters
        eventually(lambda: not client.jobs())
    assert after["solves"] == before["solves"] + 1
    assert {name: after[name] for name in ("closed_form", "memory_hits")} == {
        name: before[name] for name in ("closed_form", "memory_hits")
    }
