"""Tests the requests: the paper's meshes, each computed once."""

import pytest

from paper.__main__ import SECTIONS, parts_of
from paper.fem.cases import FACTORISATIONS, GRIDS, LENGTHS, PARTS, PLAIN, TESTS, H, clamped, elements, full_ics
from paper.run import distinct

ALL = [case for part in PARTS.values() for case in part()]
TABLES = [case for case in ALL if "ics" in case.spec and "whole_block" not in case.spec]


@pytest.mark.parametrize(
    ("mesh", "test", "L", "expected"),
    [
        ("hex", "test3", 64, 1120),
        ("hex", "test3", 128, 1312),
        ("hex", "test3", 512, 1648),
        ("hex", "test3", 1024, 1840),
        ("hex", "test1", 512, 6100),
        ("hex", "test2", 512, 880),
        ("prism", "test2", 128, 4080),
        ("prism", "test2", 256, 5168),
        ("prism", "test3", 64, 9984),
    ],
)
def test_elements_are_those_of_the_tests(mesh, test, L, expected):
    assert elements(clamped(mesh, test, L / H)["ics"]) == expected


def test_a_preset_stands_for_the_row_of_table_2():
    full = full_ics({"preset": "paper-mesh2-test1", "L_over_h": 80})
    assert (full["mesh"], full["l_over_h"], full["h_over_hs"], full["f"]) == ("prism", *TESTS["test1"])


def test_named_fields_win_over_a_preset():
    assert full_ics({"preset": "paper-test2", "f": 2})["f"] == 2


def test_the_figures_have_the_papers_curves():
    curves = {name: {case.curve for case in PARTS[name]()} for name in ("fig5", "fig6", "fig7", "fig8")}
    assert curves["fig5"] == {"linear", "quadratic"}
    assert curves["fig6"] == {"test2", "test3"}
    assert curves["fig7"] == {"20x20", "40x40", "80x80"}
    assert curves["fig8"] >= {"test1", "test2", "test3"}


@pytest.mark.parametrize("part", ["fig5", "fig6", "fig7", "mesh2_grids"])
def test_a_figure_covers_all_block_sizes(part):
    cases = PARTS[part]()
    for curve in {case.curve for case in cases}:
        assert [case.value for case in cases if case.curve == curve] == list(LENGTHS)


def test_every_offset_lies_inside_of_its_block():
    for case in TABLES:
        extent = case.spec["grid"]["nx"]
        assert case.table <= extent
        if "accuracy" not in case.spec["ics"]:
            assert extent - 1 < case.spec["ics"]["L_over_h"], case


def test_errors_are_taken_over_extents_that_are_measured():
    assert {case.table for case in TABLES} <= set(GRIDS)


def test_equal_meshes_are_computed_once():
    # Uses L/h = 160 on the 20 x 20 grid, and on the 10 x 10 grid with a block twice as large.
    cases = [case for case in [*PARTS["fig6"](), *PARTS["fig7"]()] if case.spec["ics"]["preset"] == "paper-test3"]
    assert len(distinct(cases)) == len({case.spec["ics"]["L_over_h"] for case in cases}) == len(LENGTHS) + 3


def test_every_factorisation_is_tried_at_the_papers_lengths_and_one_on_all_meshes():
    lengths = {curve: [case.value for case in PARTS["incomplete"]() if case.curve == curve] for curve in FACTORISATIONS}
    assert all(set(LENGTHS[4:]) <= {round(L, 6) for L in found} for found in lengths.values())
    meshes = {round(case.spec["ics"]["L_over_h"], 6) for part in ("fig6", "fig7") for case in PARTS[part]()}
    assert {round(L / H, 6) for L in lengths[PLAIN]} == meshes


def test_the_costs_of_loads_are_measured_where_table_3_recommends_its_meshes():
    assert {(case.curve, case.value) for case in PARTS["components"]()} == {
        (mesh, L) for mesh in ("hex", "prism") for L in (64, 128, 256, 512, 1024)
    }


def test_a_value_that_the_preset_has_anyway_makes_no_other_request():
    assert clamped("hex", "test3", 80, f=1.2) == clamped("hex", "test3", 80)


def test_a_part_that_is_not_there_is_refused_with_those_that_are():
    with pytest.raises(ValueError, match="'fig9' is not a part of fem; the parts are fig5"):
        parts_of(SECTIONS["fem"], "fig5,fig9")
