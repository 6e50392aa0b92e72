"""Tests that page, CSV files and pictures are consistent."""

import re
import shutil

import pytest

from paper.fem.cases import COMPONENTS, PARTS, elements
from paper.fem.section import SECTION
from paper.outputs import write_page, write_part
from paper.rows import read_csv
from paper.store import ResultStore


def invented(case):
    """Creates a result whose errors decrease with the number of unknowns, which suffices for every picture and every
    sentence."""
    if "solve" in case.spec:
        stop = {"iterations": 80, "seconds": 2.0, "residual": 1e-5, "origin_error": -3e-3}
        size = round(1e4 * case.value**0.1)
        return {"elements": size // 15, "dofs": size, "unknowns": size, "nonzeros": 100 * size, "setup_seconds": 0.5,
                "update": stop, "residual": {**stop, "iterations": 120, "residual": 1e-9}}  # fmt: skip
    if "mesh" in case.spec:
        faces = "1 0 1 2; 2 0 1 3; 3 0 2 3; 4 0 2 3"
        return {"elements": 1, "vertices": 4, "positions": "0 0 0 -1 0 0 0 -1 0 0 0 -1", "faces": faces}
    if "whole_block" in case.spec:
        return {name: {"paper_difference": 1e-15, "contactd_difference": 1e-14, "largest": 0.1} for name in COMPONENTS}
    ics = case.spec["ics"]
    size = ics.get("max_dofs") or (elements(ics) * 15 if "accuracy" not in ics else round(30 / ics["accuracy"]))
    error = -(10.0 / size + 0.4 / ics.get("L_over_h", 1000) + (0.02 if ics.get("order") == 1 else 0))
    component = {"origin": error, "largest": 10 * abs(error)}
    errors = {"xx": component, "yy": component, "zz": component, "scaled_xy": 1e-3, "scaled_xz": 2e-3}
    return {
        "elements": size // 15, "dofs": size, "solver": "amg_pcg",
        "iterations": {"z": 12, "x": 13, "y": 12},
        "seconds": {"total": size / 5000}, "cpu_seconds": size / 1e4, "memory_mib": 100.0,
        "mesh": {"L_over_h": 12} if "accuracy" in ics else None,
        "errors": {str(n): errors for n in (10, 20, 40, 80)},
    }  # fmt: skip


@pytest.fixture(scope="module")
def store(tmp_path_factory):
    with ResultStore(tmp_path_factory.mktemp("store") / "results.jsonl", "contactd 1") as store:
        for part in PARTS.values():
            for case in part():
                store.put(case.spec, invented(case))
        yield store


@pytest.fixture(scope="module")
def written(store, tmp_path_factory):
    """Everything, written once."""
    folder = tmp_path_factory.mktemp("docs")
    for name in PARTS:
        write_part(SECTION, name, store, folder, lambda line: None)
    write_page(SECTION, folder, "contactd 1", lambda line: None)
    return folder


@pytest.fixture
def folder(written, tmp_path):
    """A copy to change."""
    return shutil.copytree(written, tmp_path / "docs")


def test_numbers_of_the_page_are_those_of_the_csv_files(folder):
    path = folder / "fig5.csv"
    lines = path.read_text().splitlines()
    linear = [number for number, line in enumerate(lines) if line.startswith("linear")]
    column = lines[0].split(",").index("origin_zz")
    cells = lines[linear[-1]].split(",")
    cells[column] = "-0.0777"
    lines[linear[-1]] = ",".join(cells)
    path.write_text("\n".join(lines) + "\n")
    before = (folder / "fem.md").read_text()

    write_page(SECTION, folder, "contactd 1", lambda line: None)

    assert "7.8 %" in (folder / "fem.md").read_text()
    assert "7.8 %" not in before


def test_every_part_has_a_file_and_every_figure_a_picture(written):
    pictures = {f"{name}.png" for name in SECTION.pictures}
    expected = {"fem.md", "table3-ranges.csv", *(f"{name}.csv" for name in PARTS), *pictures}
    assert {path.name for path in written.iterdir()} == expected


def test_nothing_is_left_to_fill_in(written):
    text = (written / "fem.md").read_text()
    assert "{{" not in text and "[[" not in text


def test_the_page_links_to_files_that_are_there(written):
    links = re.findall(r"\]\(([^)#:]+)\)", (written / "fem.md").read_text())
    assert links
    assert [link for link in links if not link.startswith("..") and not (written / link).is_file()] == []


def test_the_page_waits_for_all_parts(folder):
    (folder / "fig6.csv").unlink()
    (folder / "fem.md").unlink()
    reported = []
    write_page(SECTION, folder, "contactd 1", reported.append)
    assert not (folder / "fem.md").exists()
    assert "fig6" in reported[-1]


def test_the_page_is_not_written_without_a_point_it_speaks_of(folder):
    path = folder / "fig6.csv"
    path.write_text("".join(line for line in path.read_text().splitlines(True) if ",1024," not in line))
    reported = []
    write_page(SECTION, folder, "contactd 1", reported.append)
    assert "L = 1024" in reported[-1]


def test_a_solve_that_did_not_converge_is_left_out_and_named(store, tmp_path):
    case = PARTS["table3"]()[-1]
    reported = []
    with ResultStore(tmp_path / "results.jsonl", "contactd 1") as other:
        for each in PARTS["table3"]():
            other.put(each.spec, store.get(each.spec))
        other.put(case.spec, {"failure": "it did not converge"})
        write_part(SECTION, "table3", other, tmp_path, reported.append)
    assert f"{case.curve}, f = {case.value:g} is left out" in reported[0]
    assert len(read_csv(tmp_path / "table3.csv")) == len(PARTS["table3"]()) - 1
