"""Tests rows of the tables of given cases: status, difference over tolerance, printed times."""

import json
from pathlib import Path

import pytest

from contactd.contact_files.comparison import Compared
from contactd.contact_files.out_reader import PrintedCase
from support.contact_cases import basic_case, rail_case
from validation import times
from validation.findings import ratio
from validation.given import FilesMissing, GivenFile, families, given_files, printed_seconds
from validation.measure import Computed, Run
from validation.table import COLUMNS, is_case, rows_of

TIMERS = """\
|Timer name                      |    cpu time        |    wall clock      |
|                     |  #times  |    sec     |  %    |    sec     |  %    |
|Total                |        1 |       24.2 | 100.0 |       25.3 | 100.0 |
|Non-Hertzian cases   |      120 |       23.2 |  96.0 |       24.3 |  96.0 |
"""


def file_of(name):
    return GivenFile(name, Path(name), Path(name))


def computed(case, numbers=None, status="solved", sentence=""):
    return Computed(case, status, sentence, 0.25, numbers)


def basic(**numbers):
    return Compared({"FN": 1e4, "FX": -1000.0, "APPROACH": 0.02, "NCON": 120, **numbers}, 3000.0)


PRINTED = PrintedCase(4, None, 1, {"FN": 1e4, "FX": -1001.0, "APPROACH": 0.02, "NCON": 121})


def test_a_case_in_tolerance_agrees():
    (row,) = rows_of(file_of("examples/own.inp"), computed(basic_case(number=4), basic()), PRINTED, None)
    assert set(row) <= set(COLUMNS)
    assert (row["family"], row["case"], row["status"], row["reason"]) == ("examples", 4, "agrees", "")
    assert (row["Fx_printed"], row["Fx"], row["Fx_over"]) == ("-1001", "-1000", "0.667")
    assert (row["contact_over"], row["over"], row["seconds"]) == ("0.333", "0.667", "0.25")
    assert "patch" not in row


def test_a_case_out_of_tolerance_differs_by_so_many_times_the_tolerance():
    (row,) = rows_of(file_of("examples/own.inp"), computed(basic_case(), basic(FX=-1010.0)), PRINTED, None)
    assert (row["status"], row["reason"], row["over"]) == ("differs", "", "6")


def test_a_case_whose_reason_is_known_has_its_name():
    (row,) = rows_of(file_of("examples/tractcurv.inp"), computed(basic_case(number=109), basic(FX=-1010.0)), PRINTED, None)
    assert (row["status"], row["reason"]) == ("differs", "elements at the bound")


def test_a_case_of_a_known_reason_that_agrees_does_so():
    (row,) = rows_of(file_of("examples/tractcurv.inp"), computed(basic_case(number=109), basic()), PRINTED, None)
    assert (row["status"], row["reason"]) == ("agrees", "")


@pytest.mark.parametrize("status", ["refused", "follows", "failed"])
def test_a_case_without_numbers_tells_why(status):
    (row,) = rows_of(file_of("examples/own.inp"), computed(basic_case(), None, status, "A reason."), PRINTED, None)
    assert (row["status"], row["note"], row["reason"]) == (status, "A reason.", "")
    assert "over" not in row


PATCHES = [{"FN": 6000.0, "FX": 0.0}, {"FN": 4000.0, "FX": 5.0}]


def rails(*patches):
    return Compared({"FX(TR)": 5.0, "Z_WS": 0.5}, 3000.0, list(patches), [0.3 * one["FN"] for one in patches])


def test_patches_have_rows_of_their_own():
    printed = PrintedCase(1, None, 1, {"FX(TR)": 5.0, "Z_WS": 0.505}, PATCHES)
    case, file = rail_case(), file_of("testbank/examples_trans/own.inp")
    exact = computed(case, rails(PATCHES[0], {"FN": 4004.0, "FX": 5.0}))
    whole, first, second = rows_of(file, computed(case, rails(*PATCHES)), printed, exact)
    assert [row.get("patch") for row in (whole, first, second)] == [None, 1, 2]
    assert {row["status"] for row in (whole, first, second)} == {"agrees"}
    assert (whole["family"], whole["position_z_over"], second["Fn"]) == ("trans", "0.5", "4000")
    assert (first["over_exact"], second["over_exact"]) == ("0", "2")


def test_another_number_of_patches_differs_and_is_told():
    printed = PrintedCase(1, None, 1, {"FX(TR)": 5.0, "Z_WS": 0.5}, PATCHES)
    (row,) = rows_of(file_of("testbank/own.inp"), computed(rail_case(), rails(PATCHES[0])), printed, None)
    assert (row["status"], row["note"]) == ("differs", "1 patches, printed 2.")


def test_the_printed_time_is_that_of_the_clock():
    assert printed_seconds(TIMERS) == 25.3
    assert printed_seconds("no timers") is None


def test_printed_times_count_by_the_share_of_cases_that_are_computed(tmp_path):
    (tmp_path / "a.ref_out").write_text(TIMERS)
    file = GivenFile("examples/a.inp", tmp_path / "a.inp", tmp_path / "a.ref_out")
    run = Run([computed(basic_case(), basic()), computed(basic_case(), None, "refused")], 2.53)
    row = times.row_of(file, run, None, "production")
    assert set(row) == set(times.COLUMNS)
    assert (row["cases"], row["computed"], row["printed_seconds"], row["seconds"]) == (2, 1, "25.3", "2.53")
    timed = {"cases": 2.0, "computed": 1.0, "printed_seconds": 25.3, "seconds": 2.53}
    assert ratio([timed]) == pytest.approx(0.2)
    assert ratio([timed, {**timed, "computed": 0.0}, {**timed, "printed_seconds": ""}]) == pytest.approx(0.2)
    assert ratio([]) is None


def test_a_family_is_a_folder_and_the_manchester_benchmark_is_one():
    names = [
        "examples/a.inp",
        "examples/mbench_a.inp",
        "testbank/a.inp",
        "testbank/examples_s+c/mbench_a.inp",
        "examples/b.inp",
    ]
    assert families([file_of(name) for name in names]) == ["examples", "mbench", "testbank", "s+c"]


def test_files_that_are_not_there_are_named(tmp_path):
    with pytest.raises(FilesMissing, match=r"cases_given\.json is missing: .* --cases"):
        given_files(tmp_path)
    listed = [{"file": "a.inp", "reference": "a.ref_out"}, {"file": "b.inp", "reference": None}]
    (tmp_path / "cases_given.json").write_text(json.dumps({"files": listed}))
    (tmp_path / "a.inp").write_text("0 MODULE\n")
    with pytest.raises(FilesMissing, match=r"a\.ref_out is not there"):
        given_files(tmp_path)
    (tmp_path / "a.ref_out").write_text("")
    assert [one.name for one in given_files(tmp_path)] == ["a.inp"]


def test_rows_of_cases_are_told_from_those_of_patches():
    assert is_case({"patch": ""})
    assert not is_case({"patch": 1.0})
