"""Tests the requests: the paper's grids and blocks, with as few tables as possible."""

import json

import pytest

from paper.contact.cases import CHOSEN_L, GRIDS, LENGTHS, PARTS, shared_lengths
from paper.contact.problem import AREA, FZ, PMAX, contact_problem
from paper.contact.section import efforts
from paper.run import distinct

ALL = [case for part in PARTS.values() for case in part()]


def tables(cases):
    requests = [ics for case in cases for ics in (case.spec["ics"], case.spec.get("tangential", {}))]
    return {json.dumps(ics, sort_keys=True) for ics in requests if "preset" in ics}


def case_of(part, n, L):
    return next(case for case in PARTS[part]() if (case.n, case.L) == (n, L))


def test_the_problem_is_the_papers():
    assert [FZ, PMAX, AREA] == pytest.approx([9.195402, 4.3905, 3.141593], rel=1e-5)
    problem = contact_problem({"n": 40, "ics": {}})
    assert problem.grid.dx * 40 == pytest.approx(2.4)
    assert problem.normal.tolerance == problem.tangential.tolerance == 1e-6
    assert problem.tangential.solver == "tangcg"
    assert (problem.approach, problem.friction.mu, problem.friction.rigid_shift) == (0.02, 0.4, (0.00817, 0))


@pytest.mark.parametrize("part", ["fig10", "fig11", "fig13"])
def test_a_figure_over_L_covers_all_block_sizes_on_all_grids(part):
    cases = [case for case in PARTS[part]() if not case.curve.endswith("fem")]
    meshes = 2 if part == "fig13" else 1
    assert len(cases) == meshes * len(GRIDS) * len(LENGTHS)


def test_lengths_are_millimetres():
    assert case_of("fig10", 160, 1024).spec["ics"]["L_over_h"] * 2.4 / 160 == pytest.approx(1024)


def test_every_offset_lies_inside_of_its_block():
    for case in ALL:
        if "L_over_h" in case.spec["ics"]:
            assert case.spec["ics"]["L_over_h"] > case.n - 1


def test_equal_ratios_are_one_table():
    # L/h doubles from 10/2.4*8 to 160/2.4*1024: twelve tables for three grids of eight blocks.
    cases = [case for case in PARTS["fig10"]() if not case.curve.endswith("fem")]
    assert (len(distinct(cases)), len(tables(cases))) == (24, 12)


def test_the_bilinear_figures_cover_all_block_sizes_on_both_meshes():
    cases = PARTS["bilinear"]()
    assert len(cases) == len(CHOSEN_L) * len(GRIDS) * len(LENGTHS)
    assert len(tables(cases)) == len(CHOSEN_L) * 12
    assert {case.spec["ics"]["load_shape"] for case in cases} == {"bilinear"}


def test_larger_blocks_go_on_where_figure_10_ends():
    curves = {}
    for case in [*PARTS["fig10"](), *PARTS["larger"]()]:
        curves.setdefault(case.curve, []).append(case.L)
    assert set(curves) == {f"{n}x{n}{way}" for n in GRIDS for way in ("", ", fem")}
    assert all(lengths == [*LENGTHS, 2048, 4096] for lengths in curves.values())


def test_figure_13_and_14_compute_nothing_new():
    earlier = {json.dumps(case.spec, sort_keys=True) for name in ("fig10", "fig11", "fig12") for case in PARTS[name]()}
    assert {json.dumps(case.spec, sort_keys=True) for name in ("fig13", "fig14") for case in PARTS[name]()} <= earlier


@pytest.mark.parametrize("mesh", CHOSEN_L)
def test_shared_lengths_have_the_ratio_of_another_grid(mesh):
    for n in GRIDS:
        assert CHOSEN_L[mesh] in shared_lengths(mesh, n)


def test_a_table_counts_once_in_the_time_left():
    fine, coarse = case_of("fig10", 160, 8), case_of("fig10", 10, 128)
    both = efforts([fine.spec, coarse.spec])
    assert both[1] < 0.2 < efforts([coarse.spec])[0]
    assert both[0] > 1
