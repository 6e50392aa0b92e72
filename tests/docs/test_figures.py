"""Each measured figure of a page is in a file, and a page differs from its file no longer than until this test runs."""

import re
import shutil
from pathlib import Path

import pytest

from figures import GENERATED, GIVEN, PAGES, RECORDED, REPEATED, ROOT, check, figures, record
from pages import TEMPLATES, read, rendered, write

FILES = (*PAGES, *TEMPLATES.values(), "docs/*.csv", "docs/validation/*.csv", "docs/paper/*.md")


@pytest.fixture
def copy(tmp_path):
    """Pages and their files, to be changed."""
    for path in (path for pattern in FILES for path in ROOT.glob(pattern)):
        target = tmp_path / path.relative_to(ROOT)
        target.parent.mkdir(parents=True, exist_ok=True)
        shutil.copy(path, target)
    return tmp_path


def change(file: Path, column: str, old: str, new: str) -> None:
    """Changes the first row that has this value."""
    rows = read(file)
    next(row for row in rows if row[column] == old)[column] = new
    write(file, rows)


def texts(page: str) -> list[str]:
    return [figure.text for figure in figures("page.md", page)]


def test_every_figure_is_in_a_file_and_every_row_is_on_its_page():
    found = check()
    assert not found.unknown, f"measure and record with python3 bench/figures.py --record COMMAND, or add to {GIVEN}"
    assert not found.stale, f"remove from {RECORDED}, {REPEATED} or {GIVEN}, or correct the page"
    assert not found.wrong, f"correct the page and its row of {REPEATED}"


def test_pages_with_templates_are_those_of_their_files():
    for page, text in rendered().items():
        assert text == (ROOT / page).read_text(), f"{page}: run python3 bench/pages.py; its text is in {TEMPLATES[page]}"


@pytest.mark.parametrize("file", ["docs/recorded.csv", "docs/benchmarks.csv", "docs/performance.csv"])
def test_a_measurement_has_a_commit_a_machine_and_a_date(file):
    for row in read(ROOT / file):
        assert re.fullmatch(r"[0-9a-f]{7,}", row["commit"]), row
        assert row["machine"], row
        assert re.fullmatch(r"\d{4}-\d\d-\d\d", row["date"]), row


def test_every_exception_has_a_reason_and_every_recorded_figure_its_command():
    assert all(row["reason"] for row in read(ROOT / GIVEN))
    assert all(row["command"] for row in read(ROOT / RECORDED))


@pytest.mark.parametrize(
    ("file", "column", "old", "new", "page"),
    [
        ("docs/benchmarks.csv", "value", "357", "358", "docs/benchmarks.md"),
        ("docs/performance.csv", "products", "62.44", "72.44", "docs/performance.md"),
        ("docs/validation/cases.csv", "status", "agrees", "differs", "docs/benchmarks.md"),
    ],
    ids=["benchmarks", "performance", "validation"],
)
def test_a_changed_value_changes_the_page(copy, file, column, old, new, page):
    change(copy / file, column, old, new)
    assert rendered(copy)[page] != (copy / page).read_text()


def test_a_page_that_repeats_a_changed_value_is_found(copy):
    change(copy / "docs" / "validation" / "cases.csv", "status", "agrees", "differs")
    assert {"README.md", "CHANGELOG.md", "docs/faq.md"} <= {figure.page for figure in check(copy).wrong}


def test_a_figure_that_differs_from_its_file_is_found(copy):
    change(copy / RECORDED, "figure", "256 MB", "257 MB")
    found = check(copy)
    assert [figure.text for figure in found.unknown] == ["256 MB"]
    assert [figure.text for figure in found.stale] == ["257 MB"]


def test_new_figures_are_recorded_and_rows_follow_their_figures(copy, monkeypatch):
    monkeypatch.setattr("figures.provenance", lambda root: {"commit": "0123abcd", "machine": "own", "date": "2026-12-01"})
    page = copy / "docs" / "python.md"
    page.write_text(page.read_text().replace("## Install", "## Installation") + "\nA call takes 12 us.\n")
    record("./dev bench", copy)
    assert not check(copy).unknown
    rows = {row["figure"]: row for row in read(copy / RECORDED) if row["page"] == "docs/python.md"}
    assert rows["12 us"]["commit"] == "0123abcd"
    assert rows["94 MB"]["section"] == "installation"
    assert rows["94 MB"]["commit"] != "0123abcd"


def test_generated_pages_are_not_read_twice():
    assert not {figure for page in GENERATED for figure in check().unknown if figure.page == page}
    assert not set(GENERATED) & set(TEMPLATES)


@pytest.mark.parametrize(
    ("page", "expected"),
    [
        ("It takes 2.2 to 3.4 ms, or 1.5 times as long.", ["2.2 to 3.4 ms", "1.5 times"]),
        ("Of 852 public cases 825\nagree; the error is 5\n%.", ["852 public cases", "825 agree", "5 %"]),
        ("Forces agree within 2e-6 in 0.6 of the time.", ["within 2e-6", "0.6 of the time"]),
        ("Elements of 0.4 mm under 50 kN, to 1e-6, version 3.2.", []),
        ("`sleep 5 s` and [a link](page.md#5-s)\n\n    wait 3 s\n\n```\n4 ms\n```\n", []),
        ("| row | time |\n|---|---|\n| 40 | 3.1, 2 |\n| b | - |\n", ["3.1, 2"]),
        ("| row | aim | ms |\n|---|---|---|\n| a | 5 | 7 |\n", ["7"]),
        ("It takes {{a b}} ms. | x |\n", []),
    ],
)  # fmt: skip
def test_what_is_a_figure(page, expected):
    assert texts(page) == expected


def test_a_figure_names_its_section():
    (figure,) = figures("page.md", "# Page\n\n## In process: C\n\nIt takes 3 us.\n")
    assert (figure.page, figure.section, figure.text) == ("page.md", "in-process-c", "3 us")
