"""Tests that page, CSV files and pictures of cross-sections are consistent."""

import pytest

from paper.outputs import write_page, write_part
from paper.sections.cases import (
    BODIES,
    BODIES_IN_GROOVES,
    DISTANCES,
    GROOVES,
    HALF_ANGLES,
    PARTS,
    SHIFTS,
    SOLID_ORDERS,
    WAYS,
)
from paper.sections.findings import more
from paper.sections.findings_checks import GROOVE_PROTOTYPE, solid_seconds
from paper.sections.propagation import MESHES
from paper.sections.section import SECTION
from paper.store import ResultStore


def invented(case):
    """Creates the results that the text of the page expects."""
    spec = case.spec
    if spec["kind"] == "edge":
        near = 1 / (1 + 10 * spec["distance"] ** 2) if spec["body"] == "block" else 0
        return {"pmax": 2000 * (1 - 0.4 * near), "approach": 0.03 * (1 + 0.5 * (near + 0.01))}
    if spec["kind"] == "throat":
        off = {"off": -0.05, "half_space": 0.02, "rotated": -0.005, "fem": 0}[spec["conformal"]]
        if spec["y"] == SHIFTS[-1] and off:
            off -= 0.3  # contact over the whole corner
        return {"pmax": 2000 * (1 + off), "approach": 0.1, "Fx": 1000 * (1 - off), "Fy": -20000}
    if spec["kind"] == "persson":
        exact, places = 2 - spec["half_angle"] / 60, range(-spec["half_angle"], spec["half_angle"] + 1)
        lists = {"angles": " ".join(map(str, places)), "pressures": " ".join("0.5" for _ in places)}
        return {"p0": 1.001 * exact, "p0_exact": exact, "half_angle": 1.004 * spec["half_angle"], **lists}
    if spec["kind"] == "groove":
        frames, rotated, approach = GROOVE_PROTOTYPE[spec["radius"]][0], -0.001, 1.035
        more = {"half_space": 1 + frames, "rotated": 1 + rotated, "sections": 1.0}[spec["body"]]
        return {"pmax": 400 * more, "approach": 0.02 * (approach if spec["body"] == "sections" else 1)}
    if spec["kind"] == "propagation":
        error = 0.2 / (spec["edges"] ** spec["order"]) ** 2
        more = {"p0_error": 0.5 * error, "extent_error": -0.1 * error, "approach_error": error}
        return {"unknowns": 1000, "ic_origin": -error, "ic_largest": error, **more, "finest_error": 1e-4}
    if spec["kind"] == "solid":
        found, iterations = 10.0 ** -(1 + spec["order"]), 0 if spec["factor"] else 200
        counts = {"elements": 1000, "dofs": 2000 * spec["order"] ** 3, "loads": 9, "iterations": iterations, "many_loads": 240}
        seconds = {"seconds": 30.0, "assembly_seconds": 3.0, "setup_seconds": 9.0, "solve_seconds": 18.0, "transform_seconds": 3.0}
        many = {"many_dofs": 60000 * spec["order"] ** 3, "transform_error": 4e-4}
        return {"found": found, "stated": 3e-5, **counts, **seconds, **many}
    errors = {"stated": 0.4 * spec["accuracy"] + 4e-3, "reciprocity": 4e-3, "found": 0.1 * spec["accuracy"]}
    return {**errors, "finest_asked": 1e-4, "finest": 4.1e-3, "seconds": 2.0, "preset": "production"}


def written(folder, results):
    reported = []
    with ResultStore(folder / "store" / "sections.jsonl", "contactd 1") as store:
        for part in PARTS.values():
            for case in part():
                store.put(case.spec, results(case))
        for name in PARTS:
            write_part(SECTION, name, store, folder, lambda line: None)
    write_page(SECTION, folder, "contactd 1", reported.append)
    return reported


def test_the_page_has_all_figures_and_numbers_and_no_surprise(tmp_path):
    reported = written(tmp_path, invented)
    page = (tmp_path / "sections.md").read_text()
    assert [line for line in reported if "contradicts its text" in line] == []
    assert "{{" not in page
    assert "[[" not in page
    for name in PARTS:
        assert (tmp_path / f"{name}.csv").is_file()
        assert f"({name}.csv)" in page
        assert (name in SECTION.pictures) == (f"({name}.png)" in page)
        if name in SECTION.pictures:
            assert (tmp_path / f"{name}.png").read_bytes().startswith(b"\x89PNG")
    assert page.count("\n| edge at") == 4
    assert "−40.0 %" in page


def test_a_stated_error_that_is_no_bound_is_told(tmp_path):
    reported = written(tmp_path, lambda case: {**invented(case), "found": 1} if case.part == "tables" else invented(case))
    assert any("stated_bounds" in line for line in reported)


def test_every_curve_is_complete():
    cases = {name: part() for name, part in PARTS.items()}
    assert len(cases["edges"]) == 2 * len(DISTANCES)
    assert len(cases["throat"]) == len(WAYS) * len(SHIFTS)
    assert len(cases["tables"]) == 2 * len(BODIES)
    assert len(cases["persson"]) == len(HALF_ANGLES)
    assert len(cases["groove"]) == len(BODIES_IN_GROOVES) * len(GROOVES)
    assert len(cases["propagation"]) == 2 * len(MESHES)
    assert len(cases["solid"]) == len(SOLID_ORDERS)


def test_a_difference_is_taken_where_both_curves_have_a_point():
    rows = [
        {"curve": "a", "value": 1.0, "pmax": 3.0},
        {"curve": "a", "value": 2.0, "pmax": 3.0},
        {"curve": "b", "value": 1.0, "pmax": 2.0},
    ]
    assert more(rows, "pmax", "a", "b") == [(1.0, pytest.approx(0.5))]


def test_the_time_of_three_dimensions_grows_with_loads_and_unknowns():
    times = {"seconds": 20.0, "assembly_seconds": 10.0, "setup_seconds": 10.0, "solve_seconds": 20.0}
    row = {**times, "loads": 3, "dofs": 1000, "many_loads": 240, "many_dofs": 4000}
    assert solid_seconds(row) == pytest.approx(20 * 0.75 / 3 * 240 * 4)


@pytest.mark.parametrize(
    ("part", "change", "verdict"),
    [
        ("tables", {"stated": 0.02}, "stated_within"),
        ("persson", {"p0": 3.0}, "persson_pressures"),
        ("persson", {"half_angle": 1.0}, "persson_angles"),
        ("groove", {"approach": 0.02}, "groove_approach"),
        ("propagation", {"ic_largest": 0.03}, "propagation_paper"),
        ("propagation", {"p0_error": 3.0}, "propagation_paper"),
        ("solid", {"found": 1e-2}, "solid_meets"),
        ("solid", {"transform_seconds": 1e9}, "solid_dear"),
    ],
)
def test_a_check_that_is_missed_is_told(tmp_path, part, change, verdict):
    reported = written(tmp_path, lambda case: {**invented(case), **(change if case.part == part else {})})
    assert any(verdict in line for line in reported)
