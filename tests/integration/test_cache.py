"""Tests that one build serves every shear modulus, every element size and every smaller extent, also after a
restart."""

from dataclasses import replace

import numpy as np
import pytest

from contactd import Grid, Material
from support.problems import CATTANEO, GRID, QUICK, STEEL


@pytest.fixture(scope="module")
def built(shared_daemon):
    """Provides the table that the tests of this module find in the cache."""
    with shared_daemon.client() as client:
        table = client.get_ic(STEEL, GRID, QUICK)
        assert table.origin == "built"
        return table


@pytest.fixture
def builds_nothing(shared, built):
    before = shared.info().counters["builds_started"]
    yield
    assert shared.info().counters["builds_started"] == before


@pytest.mark.usefixtures("builds_nothing")
def test_the_same_request_is_answered_from_memory(shared, built):
    again = shared.get_ic(STEEL, GRID, QUICK)
    assert again.origin == "memory"
    assert again.key == built.key
    np.testing.assert_array_equal(again.array, built.array)


@pytest.mark.usefixtures("builds_nothing")
def test_another_shear_modulus_scales_the_table(shared, built):
    soft = shared.get_ic(Material(G=STEEL.G / 8, nu=STEEL.nu), GRID, QUICK)
    np.testing.assert_allclose(soft.array, 8 * built.array, rtol=1e-14)


@pytest.mark.usefixtures("builds_nothing")
@pytest.mark.parametrize("factor", [0.1, 3, 1e3 / 7])
def test_another_element_size_of_the_same_ratio_scales_the_table(shared, built, factor):
    grid = replace(GRID, dx=factor * GRID.dx, dy=factor * GRID.dy)
    scaled = shared.get_ic(STEEL, grid, QUICK)
    np.testing.assert_allclose(scaled.array, factor * built.array, rtol=1e-13)


@pytest.mark.usefixtures("builds_nothing")
def test_a_smaller_extent_is_a_part_of_the_table(shared, built):
    part = shared.get_ic(STEEL, replace(GRID, nx=2, ny=4), QUICK)
    np.testing.assert_array_equal(part.array, built.array[:, :, :4, :2])


@pytest.mark.usefixtures("builds_nothing")
def test_named_defaults_mean_the_same_table(shared, built):
    spelt_out = built.spec.ics
    assert shared.get_ic(STEEL, GRID, spelt_out).key == built.key


@pytest.mark.usefixtures("builds_nothing")
def test_a_solve_uses_the_table(shared, built):
    grid = Grid.centred(6, 6, 2.4, 2.4)
    solution = shared.solve(CATTANEO.replace(grid=grid, upper=replace(STEEL, G=200), ics=QUICK))
    assert solution.evidence.ics["upper"].origin == "memory"
    assert solution.evidence.ics["upper"].key == built.key


@pytest.mark.parametrize(
    "change",
    [
        {"material": replace(STEEL, nu=0.3)},
        {"grid": replace(GRID, dy=0.4)},
        {"ics": replace(QUICK, f=1.6)},
        {"ics": replace(QUICK, L_over_h=50)},
        {"ics": replace(QUICK, sampling="linear")},
    ],
    ids=["nu", "aspect", "f", "L", "sampling"],
)
def test_what_changes_the_numbers_is_another_table(shared, built, change):
    request = {"material": STEEL, "grid": GRID, "ics": QUICK, **change}
    table = shared.get_ic(**request)
    assert table.origin == "built"
    assert table.key != built.key


def test_a_larger_extent_is_built_and_then_serves_the_smaller(daemon, client):
    small = client.get_ic(STEEL, GRID, QUICK)
    large = client.get_ic(STEEL, replace(GRID, nx=8), QUICK)
    assert large.origin == "built"
    assert large.key == small.key
    again = client.get_ic(STEEL, GRID, QUICK)
    assert again.origin == "memory"
    np.testing.assert_allclose(again.array, small.array, rtol=0, atol=1e-6 * small.array.max())
    assert len(daemon.tables()) == 1


def test_a_restarted_daemon_finds_the_table_on_disk(daemons):
    first = daemons.start()
    with first.client() as client:
        built = client.get_ic(STEEL, GRID, QUICK)
    assert first.stop() == 0
    with daemons.start().client() as client:
        smaller = client.get_ic(Material(1, STEEL.nu), Grid(3, 2, 1, 1), QUICK)
        assert smaller.origin == "disk"
        np.testing.assert_allclose(
            smaller.array, built.array[:, :, :2, :3] * STEEL.G / GRID.dx, rtol=1e-13, atol=1e-16 * built.array.max()
        )
        counters = client.info().counters
    assert (counters["builds_started"], counters["disk_hits"]) == (0, 1)


def test_two_daemons_share_a_store(daemons):
    store = {"folder": str(daemons.folder / "shared")}
    with daemons.start("a", store=store).client() as a, daemons.start("b", store=store).client() as b:
        assert a.get_ic(STEEL, GRID, QUICK).origin == "built"
        assert b.get_ic(STEEL, GRID, QUICK).origin == "disk"


def test_a_memory_of_nothing_still_serves_from_disk(daemons):
    with daemons.start(store={"memory_budget_bytes": 0}).client() as client:
        client.get_ic(STEEL, GRID, QUICK)
        assert client.get_ic(STEEL, GRID, QUICK).origin == "disk"
        assert client.info().cache["bytes"] == 0


def test_eight_simultaneous_requests_start_one_build(client, background):
    ics = replace(QUICK, order=2)
    futures = [background(client.get_ic, STEEL, GRID, ics) for _ in range(8)]
    tables = [future.result() for future in futures]
    counters = client.info().counters
    assert counters["builds_started"] == 1
    assert counters["builds_joined"] + counters["memory_hits"] == 7
    for table in tables:
        np.testing.assert_array_equal(table.array, tables[0].array)


def test_a_smaller_request_joins_the_build_of_a_larger_table(client, background):
    ics = replace(QUICK, order=2, L_over_h=640)
    large = background(client.get_ic, STEEL, GRID, ics)
    while not client.jobs():
        pass
    small = client.get_ic(Material(1, STEEL.nu), replace(GRID, nx=3), ics)
    assert small.origin in ("built", "memory")
    assert client.info().counters["builds_started"] == 1
    np.testing.assert_allclose(small.array, large.result().array[..., :3] * STEEL.G, rtol=1e-13)
