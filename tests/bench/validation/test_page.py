"""Tests that the page of given cases agrees with its tables, and that its reasons form one list."""

from collections import Counter
from pathlib import Path

import pytest

from paper.rows import read_csv
from validation.figures import has_numbers
from validation.findings import find
from validation.outputs import CASES, PAGE, TIMES, render, write_tables
from validation.reasons import REASONS, reason_of
from validation.table import COLUMNS
from validation.times import COLUMNS as TIMED

FOLDER = Path(__file__).parents[3] / "docs" / "validation"


def case(family="examples", name="own", number=1.0, **values):
    row = dict.fromkeys(COLUMNS, "")
    return {
        **row,
        "family": family,
        "file": f"{family}/{name}.inp",
        "case": number,
        "status": "agrees",
        "over": 0.5,
        "Fx_over": 0.5,
        **values,
    }


def timed(family="examples", name="own"):
    row = {
        "family": family,
        "file": f"{family}/{name}.inp",
        "cases": 2.0,
        "computed": 2.0,
        "printed_seconds": 10.0,
        "seconds": 0.5,
    }
    return {**dict.fromkeys(TIMED, ""), **row, "processors": 2.0, "load": 0.1, "preset": "production", "version": "1.0"}


@pytest.fixture
def committed():
    return read_csv(FOLDER / CASES), read_csv(FOLDER / TIMES)


def test_the_page_is_that_of_its_tables():
    text, surprises = render(FOLDER)
    assert text == (FOLDER.parent / PAGE).read_text()
    assert surprises == []


def test_every_family_with_numbers_has_a_picture_on_the_page(committed):
    page = (FOLDER.parent / PAGE).read_text()
    cases, _ = committed
    names = {row["family"] for row in cases if has_numbers([row])}
    assert names == {picture.stem for picture in FOLDER.glob("*.png")}
    assert all(f"(validation/{name}.png)" in page for name in names)


def test_both_tables_have_the_same_files_and_cases(committed):
    cases, times = committed
    counts = Counter(row["file"] for row in cases if row["patch"] == "")
    assert counts == {row["file"]: row["cases"] for row in times}


def test_a_case_stands_under_one_reason():
    listed = Counter(
        (file, number) for reason in REASONS for file, numbers in reason.cases.items() for number in numbers
    )
    assert max(listed.values()) == 1
    assert reason_of("examples/mbench_a22_kpec.inp", 6).name == "virtual penetration"
    assert reason_of("examples/mbench_a22_kpec.inp", 2) is None


def test_a_case_that_differs_without_a_reason_is_told():
    differs = case(number=2.0, status="differs", over=12.0, Fx_over=12.0, note="A remark.")
    values, verdicts = find([case(), differs], [timed()], "validation")
    assert verdicts == {"explained": False}
    assert "| `own` 2 | 12 | A remark. |" in values["unexplained"]
    assert (values["agree"], values["differ"], values["ratio"]) == ("1", "1", "1/20.0")
    assert "| `examples` | 2 | 1 | 1 | 0 | 12: `Fx` of `own` 2 | 1/20.0 |" in values["families"]


def test_what_is_missing_is_counted_by_feature():
    note = "contactd does not have: transient contact on rails (T = 1, 2), interfacial layer (M = 4)."
    refused = [case(number=float(n), status="refused", over="", Fx_over="", note=note) for n in (1, 2)]
    values, _ = find(
        [*refused, case(number=3.0, status="follows", over="", Fx_over="", note="It goes on.")], [timed()], "validation"
    )
    assert "| transient contact on rails (T = 1, 2) | 2 |\n| interfacial layer (M = 4) | 2 |" in values["missing"]
    assert "| continues from a case that is not computed | 1 |" in values["missing"]


def test_a_family_that_is_computed_again_takes_the_place_of_its_rows(tmp_path):
    write_tables([], [case(), case("mbench")], [timed(), timed("mbench")], tmp_path)
    write_tables([], [case("mbench", "new", number=7.0)], [timed("mbench", "new")], tmp_path)
    assert [(row["file"], row["case"]) for row in read_csv(tmp_path / CASES)] == [
        ("examples/own.inp", 1),
        ("mbench/new.inp", 7),
    ]
    assert [row["file"] for row in read_csv(tmp_path / TIMES)] == ["examples/own.inp", "mbench/new.inp"]
