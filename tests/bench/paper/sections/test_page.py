"""Page, CSV files and pictures of cross-sections belong together."""

import pytest

from paper.outputs import write_page, write_part
from paper.sections.cases import BODIES, DISTANCES, PARTS, SHIFTS, WAYS
from paper.sections.findings import more
from paper.sections.section import SECTION
from paper.store import ResultStore


def invented(case):
    """As the text of the page expects it."""
    spec = case.spec
    if spec["kind"] == "edge":
        near = 1 / (1 + 10 * spec["distance"] ** 2) if spec["body"] == "block" else 0
        return {"pmax": 2000 * (1 - 0.4 * near), "approach": 0.03 * (1 + 0.5 * (near + 0.01))}
    if spec["kind"] == "throat":
        off = {"off": -0.05, "half_space": 0.02, "rotated": -0.005, "fem": 0}[spec["conformal"]]
        if spec["y"] == SHIFTS[-1] and off:
            off -= 0.3  # contact from end to end of the corner
        return {"pmax": 2000 * (1 + off), "approach": 0.1, "Fx": 1000 * (1 - off), "Fy": -20000}
    return {"stated": 0.4 * spec["accuracy"], "found": 0.1 * spec["accuracy"], "finest": 5e-5, "seconds": 2.0}


def written(folder, results):
    said = []
    with ResultStore(folder / "store" / "sections.jsonl", "contactd 1") as store:
        for part in PARTS.values():
            for case in part():
                store.put(case.spec, results(case))
        for name in PARTS:
            write_part(SECTION, name, store, folder, lambda line: None)
    write_page(SECTION, folder, "contactd 1", said.append)
    return said


def test_the_page_has_all_figures_and_numbers_and_no_surprise(tmp_path):
    said = written(tmp_path, invented)
    page = (tmp_path / "sections.md").read_text()
    assert [line for line in said if "came out otherwise" in line] == []
    assert "{{" not in page
    assert "[[" not in page
    for name in PARTS:
        assert (tmp_path / f"{name}.csv").is_file()
        assert (tmp_path / f"{name}.png").read_bytes().startswith(b"\x89PNG")
        assert f"({name}.png)" in page
    assert page.count("\n| edge at") == 2
    assert "−40.0 %" in page


def test_a_stated_error_that_is_no_bound_is_told(tmp_path):
    said = written(tmp_path, lambda case: {**invented(case), "found": 1} if case.part == "tables" else invented(case))
    assert any("stated_bounds" in line for line in said)


def test_every_curve_is_complete():
    cases = {name: part() for name, part in PARTS.items()}
    assert len(cases["edges"]) == 2 * len(DISTANCES)
    assert len(cases["throat"]) == len(WAYS) * len(SHIFTS)
    assert len(cases["tables"]) == 2 * len(BODIES)


def test_a_difference_is_taken_where_both_curves_have_a_point():
    rows = [
        {"curve": "a", "value": 1.0, "pmax": 3.0},
        {"curve": "a", "value": 2.0, "pmax": 3.0},
        {"curve": "b", "value": 1.0, "pmax": 2.0},
    ]
    assert more(rows, "pmax", "a", "b") == [(1.0, pytest.approx(0.5))]
