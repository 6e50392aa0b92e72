"""Tests tables as operators: products with pressures and tractions."""

from __future__ import annotations

import sys

import numpy as np
import pytest

import contactd
from contactd import (
    AnalyticIcs,
    ContactProblem,
    Friction,
    Grid,
    InvalidArgument,
    Material,
    MissingExtra,
    Paraboloid,
    TableIcs,
    steel,
)
from contactd.materials import aluminium

GRID = Grid(7, 5, 0.3, 0.4)
LOADS = np.random.default_rng(57).uniform(-1, 1, (3, 5, 7))


@pytest.fixture(scope="module")
def table(client):
    return client.get_ic(steel, GRID, AnalyticIcs())


def summed(table, loads):
    """Returns the displacements by the double sum over elements, with the parities of the documentation."""
    _, ny, nx = loads.shape
    odd_x = {"xy", "yx", "xz", "zx"}
    odd_y = {"xy", "yx", "yz", "zy"}
    found = np.zeros_like(loads)
    for i, j in np.ndindex(3, 3):
        name = "xyz"[i] + "xyz"[j]
        for l, k, b, a in np.ndindex(ny, nx, ny, nx):
            sign = (-1 if name in odd_x and k < a else 1) * (-1 if name in odd_y and l < b else 1)
            found[i, l, k] += sign * table[name][abs(l - b), abs(k - a)] * loads[j, b, a]
    return found


def test_a_product_is_the_sum_over_the_elements(table):
    expected = summed(table, LOADS)
    assert table.apply(LOADS) == pytest.approx(expected, abs=1e-14 * np.abs(expected).max() * LOADS.size)


def test_pressures_give_the_displacements_into_the_body(table):
    normal = np.zeros_like(LOADS)
    normal[2] = LOADS[2]
    assert table.apply(LOADS[2]) == pytest.approx(table.apply(normal)[2], rel=1e-12)
    assert (table.apply(np.ones(GRID.shape)) > 0).all()


def test_a_part_of_the_table_is_that_of_a_smaller_grid(client, table):
    small = client.get_ic(steel, Grid(4, 3, 0.3, 0.4), AnalyticIcs())
    loads = LOADS[:, :3, :4]
    assert table.apply(loads) == pytest.approx(small.apply(loads), rel=1e-10, abs=1e-18)


def test_a_pair_has_the_displacements_of_a_solve(client):
    problem = ContactProblem(
        grid=Grid.centred(24, 20, 0.9, 0.9), gap=Paraboloid(50, 40), upper=steel, lower=aluminium, Fn=100,
        friction=Friction(0.3, rigid_shift=(1e-4, 2e-4)), displacements=True,
    )  # fmt: skip
    solution = client.solve(problem)
    upper, lower = (client.get_ic(material, problem.grid, AnalyticIcs()) for material in (steel, aluminium))
    found = TableIcs.from_table(upper, lower).apply([solution.traction_x, solution.traction_y, solution.pressure])
    for part, expected in zip(found, (solution.displacement_x, solution.displacement_y, solution.displacement_z)):
        assert part == pytest.approx(expected, abs=1e-12 * np.abs(expected).max())


def test_a_longitudinally_uniform_body_is_summed_over_its_columns(client):
    section = {"slab": {"thickness": 10, "width": 100}}
    grid = Grid(6, 4, 0.5, 0.5)
    table = client.get_ic(steel, grid, AnalyticIcs(body="longitudinally_uniform", section=section))
    loads = np.random.default_rng(58).uniform(-1, 1, (3, 4, 6))
    expected = np.zeros_like(loads)
    for i, j in np.ndindex(3, 3):
        is_odd = i != j and 0 in (i, j)
        for row, k, column, a in np.ndindex(4, 6, 4, 6):
            sign = -1 if is_odd and k < a else 1
            expected[i, row, k] += sign * table.array[i, j, row, column, abs(k - a)] * loads[j, column, a]
    assert table.apply(loads) == pytest.approx(expected, abs=1e-14 * np.abs(expected).max() * loads.size)
    dense = table.operator(tractions=True)
    identity = np.eye(loads.size)
    assert (dense.adjoint() @ identity) == pytest.approx((dense @ identity).T, abs=1e-16)


@pytest.mark.parametrize("shape", [(7,), (6, 7), (5, 8), (2, 5, 7), (3, 5, 7, 1), (0, 7)])
def test_other_shapes_are_refused(table, shape):
    with pytest.raises(InvalidArgument, match=r"tractions has shape .*; it must be \[ny, nx\], at most \[5, 7\]"):
        table.apply(np.ones(shape))


def test_what_is_not_finite_is_refused(table):
    with pytest.raises(InvalidArgument, match="not finite"):
        table.apply(np.full(GRID.shape, np.nan))


# --- as a linear operator of scipy --------------------------------------------------------------------------------------


def test_an_operator_is_symmetric_and_positive_definite(client, table):
    pytest.importorskip("scipy")
    dense = table.operator() @ np.eye(35)
    assert dense == pytest.approx(dense.T, abs=1e-14 * dense.max())
    assert np.linalg.eigvalsh(dense).min() > 0
    assert dense @ LOADS[2].ravel() == pytest.approx(table.apply(LOADS[2]).ravel(), rel=1e-10)


def test_the_operator_of_tractions_has_its_adjoint(table):
    pytest.importorskip("scipy")
    whole = table.operator(3, 4, tractions=True)
    dense = whole @ np.eye(36)
    assert whole.shape == (36, 36)
    assert whole.adjoint() @ np.eye(36) == pytest.approx(dense.T, abs=1e-14 * dense.max())
    assert dense @ LOADS[:, :3, :4].ravel() == pytest.approx(table.apply(LOADS[:, :3, :4]).ravel(), rel=1e-10)


def test_an_equation_with_it_is_solved_by_scipy():
    linalg = pytest.importorskip("scipy.sparse.linalg")
    matrix = contactd.operator(steel, GRID) + contactd.operator(Material(G=27000, nu=0.3), GRID)
    pressure, ended = linalg.cg(matrix, np.full(35, 1e-3), rtol=1e-12)
    assert ended == 0
    assert matrix @ pressure == pytest.approx(np.full(35, 1e-3), rel=1e-8)
    assert pressure.min() > 0
    contactd.default_client().close()


def test_an_operator_beyond_the_table_is_refused(table):
    pytest.importorskip("scipy")
    with pytest.raises(InvalidArgument, match=r"shape is \[6, 7\]; the table has \[5, 7\] offsets"):
        table.operator(6)


def test_without_scipy_the_sentence_says_what_to_install(table, monkeypatch):
    monkeypatch.setitem(sys.modules, "scipy.sparse.linalg", None)
    with pytest.raises(MissingExtra, match=r'A linear operator needs scipy: pip install "contactd\[fit\]"'):
        table.operator()
    with pytest.raises(MissingExtra, match=r'contactd\[fit\]'):
        contactd.operator(steel, GRID)
