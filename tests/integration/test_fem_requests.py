"""Tests finite-element tables by their requests: an accuracy, a body, a load shape, any Poisson's ratio."""

from dataclasses import replace

import numpy as np
import pytest

from contactd import AnalyticIcs, FemIcs, Grid, Material
from support.problems import CATTANEO, GRID, STEEL


def scaled_errors(table, exact):
    """Returns the largest error of each component: xx, yy, zz relative, the others times 2 pi G rho / (dx dy)."""
    grid, material = table.spec.grid, table.spec.material
    l, k = np.mgrid[: grid.ny, : grid.nx]
    rho = np.hypot(k * grid.dx, l * grid.dy)
    unit = 2 * np.pi * material.G * rho / (grid.dx * grid.dy)
    errors = {}
    for i in "xyz":
        for j in "xyz":
            difference = np.abs(table[i + j] - exact[i + j])
            errors[i + j] = np.max(difference / exact[i + j] if i == j else difference * unit)
    return errors


@pytest.mark.parametrize("load_shape", ["constant", "bilinear"])
@pytest.mark.parametrize(
    ("nu", "dx", "dy"), [(0, 0.8, 0.8), (0.28, 0.8, 0.8), (0.49, 0.8, 0.8), (0.28, 0.4, 1.6), (0.42, 2, 0.5)]
)
def test_an_accuracy_is_met(shared, nu, dx, dy, load_shape):
    material, grid = Material(82000, nu), Grid(12, 9, dx, dy)
    table = shared.get_ic(material, grid, FemIcs(accuracy=1e-2, load_shape=load_shape))
    exact = shared.get_ic(material, grid, AnalyticIcs(load_shape=load_shape))
    errors = scaled_errors(table, exact)
    assert max(errors.values()) <= 1e-2
    assert table.evidence.errors.zz.largest == pytest.approx(errors["zz"], rel=1e-6)
    assert not table.evidence.errors_estimated
    assert table.evidence.warnings == ()


def test_without_a_mesh_an_accuracy_of_a_thousandth_is_asked_for(shared):
    table = shared.get_ic(STEEL, GRID, FemIcs())
    assert table.spec.ics == FemIcs(accuracy=1e-3, any_nu=False, body="half_space", load_shape="constant")
    assert shared.get_ic(STEEL, GRID, FemIcs(accuracy=1e-3)).origin == "memory"
    assert max(scaled_errors(table, shared.get_ic(STEEL, GRID, AnalyticIcs())).values()) <= 1e-3


def test_accuracies_of_one_level_are_one_table(shared):
    table = shared.get_ic(STEEL, GRID, FemIcs(accuracy=1e-2))
    again = shared.get_ic(STEEL, GRID, FemIcs(accuracy=4e-2))
    assert (again.key, again.origin) == (table.key, "memory")
    assert again.spec.ics.accuracy == 4e-2


def test_the_mesh_that_was_chosen_can_be_asked_for_by_name(shared):
    table = shared.get_ic(STEEL, GRID, FemIcs(accuracy=1e-2))
    named = shared.get_ic(STEEL, GRID, table.evidence.mesh)
    assert named.origin == "built"
    assert named.key != table.key
    assert (named.evidence.elements, named.evidence.dofs) == (table.evidence.elements, table.evidence.dofs)
    np.testing.assert_allclose(named.array, table.array, rtol=0, atol=1e-9 * table.array.max())


def test_a_block_is_stiffer_than_the_half_space_and_the_more_the_smaller(shared):
    exact = shared.get_ic(STEEL, GRID, AnalyticIcs())
    small, large = (shared.get_ic(STEEL, GRID, FemIcs(accuracy=1e-2, body="block", L_over_h=L)) for L in (10, 20))
    for component in ["xx", "yy", "zz"]:
        assert (small[component] < large[component]).all()
        assert (large[component] < exact[component]).all()
    assert small.evidence.errors_estimated
    assert small.evidence.errors.zz.largest <= 1e-2
    assert small.evidence.mesh is None


def test_a_block_on_a_mesh_that_was_named_has_no_errors_to_report(shared):
    block = FemIcs(body="block", order=2, L_over_h=10, f=1.5)
    table = shared.get_ic(STEEL, GRID, block)
    assert table.spec.ics.far_boundary == "clamped"
    assert table.evidence.errors is None
    clamped = shared.get_ic(STEEL, GRID, replace(block, body="half_space", far_boundary="clamped"))
    np.testing.assert_allclose(clamped.array, table.array, rtol=0, atol=1e-7 * table.array.max())
    assert clamped.evidence.errors is not None


def test_a_named_mesh_has_half_space_displacements_on_its_far_faces(shared):
    far, clamped = (
        shared.get_ic(STEEL, GRID, FemIcs(L_over_h=10, f=1.5, far_boundary=boundary)) for boundary in (None, "clamped")
    )
    assert far.spec.ics.far_boundary == "half_space"
    assert far.evidence.errors.zz.largest < 5e-3 < clamped.evidence.errors.zz.largest


def test_advice_of_the_paper_comes_as_warnings(shared):
    table = shared.get_ic(STEEL, GRID, FemIcs("paper-test2", f=1.8, L_over_h=40))
    assert [sentence.split()[0] for sentence in table.evidence.warnings] == ["L_over_h", "f", "The"]
    assert shared.get_ic(STEEL, GRID, FemIcs("paper-test2", L_over_h=80)).evidence.warnings == ()


@pytest.mark.parametrize("solver", ["amg_pcg", "direct"])
def test_the_evidence_names_the_solver(shared, solver):
    table = shared.get_ic(STEEL, GRID, FemIcs("paper-test2", L_over_h=40, solver=solver))
    assert table.evidence.solver == solver


def test_the_update_as_stopping_criterion_is_reported(shared):
    ics = FemIcs("paper-test2", L_over_h=40, stopping_criterion="update", tolerance=1e-6)
    for case in shared.get_ic(STEEL, GRID, ics).evidence.load_cases:
        assert 0 < case.update <= 1e-6


FAMILY = FemIcs(accuracy=1e-2, any_nu=True)


def test_a_family_serves_every_poissons_ratio_also_after_a_restart(daemons):
    grid = Grid(6, 5, 0.8, 0.8)
    first = daemons.start()
    with first.client() as client:
        assert client.get_ic(STEEL, grid, FAMILY).origin == "built"
        tables = {nu: client.get_ic(Material(200, nu), grid, FAMILY) for nu in (0, 0.1, 0.35, 0.49)}
        for nu, table in tables.items():
            assert table.origin == "memory"
            assert table.spec.material.nu == nu
            exact = client.get_ic(Material(200, nu), grid, AnalyticIcs())
            assert max(scaled_errors(table, exact).values()) <= 1e-2
        assert client.info().counters["builds_started"] == 1
    assert first.stop() == 0
    with daemons.start().client() as client:
        smaller = client.get_ic(Material(100, 0.35), Grid(4, 3, 0.4, 0.4), FAMILY)
        assert smaller.origin == "disk"
        np.testing.assert_allclose(smaller.array, tables[0.35].array[..., :3, :4], rtol=1e-12)
        assert client.get_ic(Material(100, 0.2), grid, FAMILY).origin == "memory"
        assert client.info().counters["builds_started"] == 0


def test_interpolation_adds_less_than_a_tenth_of_the_accuracy(client):
    for nu in (0, 0.123, 0.28, 0.47, 0.481):  # if both have the same mesh
        family, direct = (
            client.get_ic(Material(82000, nu), GRID, FemIcs(accuracy=1e-2, any_nu=any_nu)) for any_nu in (True, False)
        )
        assert family.key != direct.key
        assert max(scaled_errors(family, direct).values()) < 1e-3
        assert family.evidence.interpolation_error < 1e-3
        assert family.evidence.family_nu[0] == 0
        assert family.evidence.family_nu[-1] == pytest.approx(0.49)


def test_a_family_counts_with_all_its_tables_in_the_memory(client):
    family = client.get_ic(STEEL, GRID, FAMILY)
    table_bytes = family.array.nbytes
    assert client.info().cache["bytes"] == len(family.evidence.family_nu) * table_bytes


@pytest.mark.parametrize("load_shape", ["constant", "bilinear"])
def test_a_solve_with_an_accuracy_is_as_good_as_its_table(shared, load_shape):
    problem = CATTANEO.replace(grid=Grid.centred(16, 16, 2.4, 2.4))
    exact = shared.solve(problem.replace(ics=AnalyticIcs(load_shape=load_shape)))
    solution = shared.solve(problem.replace(ics=FemIcs(accuracy=1e-2, load_shape=load_shape)))
    assert solution.Fn == pytest.approx(exact.Fn, rel=1e-2)
    assert solution.Fx == pytest.approx(exact.Fx, rel=1e-2)
    assert solution.evidence.ics["upper"].evidence.errors.zz.largest <= 1e-2


def test_two_materials_of_a_solve_share_one_family(client):
    problem = CATTANEO.replace(grid=Grid.centred(8, 8, 2.4, 2.4), lower=Material(400, 0.3), friction=None)
    solution = client.solve(problem.replace(ics=FAMILY))
    uses = solution.evidence.ics
    assert uses["upper"].key == uses["lower"].key
    assert client.info().counters["builds_started"] == 1
    assert solution.Fn == pytest.approx(client.solve(problem).Fn, rel=1e-2)


def test_a_block_takes_more_force_than_the_half_space(shared):
    problem = CATTANEO.replace(grid=Grid.centred(8, 8, 2.4, 2.4), friction=None)
    block = shared.solve(problem.replace(ics=FemIcs(accuracy=1e-2, body="block", L_over_h=20)))
    assert block.Fn > 1.05 * shared.solve(problem).Fn


def test_a_contact_on_a_block_is_told_how_far_its_elements_differ(shared):
    problem = CATTANEO.replace(grid=Grid.centred(8, 8, 2.4, 2.4), friction=None)
    small, large = (
        shared.solve(problem.replace(ics=FemIcs(accuracy=1e-2, body="block", L_over_h=L))) for L in (10, 1000)
    )
    stated = [solution.evidence.ics["upper"].evidence.modelling_error for solution in (small, large)]
    assert stated[0] > 1e-2 > stated[1]
    assert any("depend on the position of the load" in warning for warning in small.warnings)
    assert not any("depend on the position of the load" in warning for warning in large.warnings)
