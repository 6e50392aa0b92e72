"""Tests verdicts of section 3: from rows to True if the paper agrees."""

import pytest

from paper.fem.cases import COMPARED_LOADS, COMPONENTS, FACTORISATIONS, GRIDS, LENGTHS, H
from paper.fem.findings_discussion import components, finer_grids, orders
from paper.fem.findings_solver import PAPER_ITERATIONS, incomplete, table1


def order_rows(linear):
    def row(curve, L, error):
        return {"curve": curve, "L": L, "h": H, "origin_zz": error, "dofs": 1000.0}

    curves = {**dict.fromkeys(("test1, linear", "test2, linear", "test3, linear"), linear), "test2, quadratic": -2e-3}
    return {"orders": [row(curve, L, error) for curve, error in curves.items() for L in LENGTHS[3:]]}


@pytest.mark.parametrize(("linear", "agrees"), [(-0.028, True), (0.028, True), (-0.009, False)])
def test_quadratic_elements_are_preferable_where_linear_ones_miss_the_target(linear, agrees):
    assert orders(order_rows(linear))[1] == {"quadratic_mesh2": agrees}


@pytest.mark.parametrize(("at_80", "agrees"), [(-0.005, True), (-0.012, False)])
def test_finer_grids_on_mesh2_are_judged_from_80_elements_on(at_80, agrees):
    def row(n, L):
        h = 8 / n
        return {"curve": f"{n}x{n}", "L": L, "h": h, "origin_zz": at_80 if L / h >= 79 else -0.2}

    rows = {"mesh2_grids": [row(n, L) for n in GRIDS[1:] for L in LENGTHS], "fig8": []}
    values, verdicts = finer_grids(rows)
    assert verdicts == {"mesh2_target_from_80": agrees}
    assert values["mesh2_grids_ratio"] == "10240"


def component_rows(yy=5e-3, iterations_y=29, seconds_y=2.0):
    counts = {"iterations_z": 30, "iterations_x": 29, "iterations_y": iterations_y}
    scan = {"parameter": "f", "value": 1.5, "origin_zz": 1e-3, "origin_xx": 1e-3, "origin_yy": yy, "scaled_xy": 1e-3}
    seconds = {"z": 2.0, "x": 1.9, "y": seconds_y}
    solves = [
        {"curve": f"{mesh}, load along {load}", "L": L, "setup_seconds": 0.5, "update_seconds": seconds[load]}
        for mesh, L in COMPARED_LOADS.items() for load in "zxy"
    ]  # fmt: skip
    return {
        "components": [{"curve": mesh, "L": L, **counts} for mesh in ("hex", "prism") for L in LENGTHS[3:]],
        "incomplete": solves,
        "table3": [{"curve": "prism, L/h = 80", **scan}, {"curve": "hex, L/h = 80", **scan}],
    }


def test_other_load_directions_are_judged_by_accuracy_by_iterations_and_by_time():
    assert components(component_rows())[1] == {"table3_components": True, "equal_times": True}
    assert components(component_rows(yy=0.011))[1] == {"table3_components": False, "equal_times": True}
    for change in ({"iterations_y": 60}, {"seconds_y": 4.0}):
        assert components(component_rows(**change))[1] == {"table3_components": True, "equal_times": False}


def solver_rows(counts, growth=1.0):
    def row(curve, number, L):
        unknowns = 1e4 * 2**number
        iterations = counts[number] * growth**number
        stops = {"update_iterations": iterations, "residual_iterations": 2 * iterations, "update_seconds": 1e-4 * unknowns}
        errors = {"update_origin_error": -3e-3, "residual_origin_error": -3.001e-3, "update_residual": 1e-5}
        return {"curve": curve, "L": L, "unknowns": unknowns, "setup_seconds": 0.1, **stops, **errors}

    return {"incomplete": [row(name, i, L) for name in FACTORISATIONS for i, L in enumerate((128, 256, 512, 1024))]}


def test_iterations_are_compared_with_the_papers_four_numbers():
    verdicts = incomplete(solver_rows(PAPER_ITERATIONS))[1]
    assert verdicts == {"ilu_mild": True, "ilu_counts": True, "ilu_within_bound": True, "ilu_update_suffices": True}
    assert incomplete(solver_rows((44, 46, 48, 50)))[1]["ilu_counts"] is False


def test_iterations_that_grow_with_the_mesh_are_neither_mild_nor_within_the_bound():
    verdicts = incomplete(solver_rows(PAPER_ITERATIONS, growth=1.5))[1]
    assert (verdicts["ilu_mild"], verdicts["ilu_within_bound"]) == (False, False)


@pytest.mark.parametrize(("component", "kind"), [("zy", "paper_difference"), ("xx", "contactd_difference")])
def test_one_coefficient_that_differs_from_the_whole_block_is_enough(component, kind):
    good = {"paper_difference": 1e-15, "contactd_difference": 1e-15, "largest": 0.1}
    found = [{"curve": name, **good} for name in COMPONENTS]
    near = {"curve": "test3, half_space", "L": 8, "scaled_xy": 1e-4, "scaled_xz": 1e-4}
    near |= {f"largest_{name}": 1e-3 for name in ("xx", "yy", "zz")}
    rows = {"table1": found, "checks": [near]}
    assert table1(rows)[1] == {"table1_paper": True, "table1_contactd": True}
    found[COMPONENTS.index(component)][kind] = 1e-3
    assert [name for name, agrees in table1(rows)[1].items() if not agrees] == [f"table1_{kind.split('_')[0]}"]
