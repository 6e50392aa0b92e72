"""Tests the table of ./dev bench: the time of each row, and its ratio to the recorded one."""

import pytest

from run import print_table, ratio

PRODUCT = {"name": "bench_core.A_p/n:25", "seconds": 2e-5}


def ratio_of(row, *others):
    return ratio(row, {one["name"]: one for one in (row, *others)})


def test_a_row_is_divided_by_its_baseline():
    row = {"name": "bench_core.NORM/n:25", "seconds": 4e-4}
    assert ratio_of(row, PRODUCT) == (pytest.approx(20), "A*p")


def test_a_row_that_measures_its_ratio_itself_needs_no_baseline():
    row = {"name": "bench_contact.normal_of_bodies_that_creep/n:25", "seconds": 4e-4, "of_elastic": 2.5}
    assert ratio_of(row) == (2.5, "elastic bodies")


def test_a_row_whose_baseline_did_not_run_has_its_time_alone(capsys):
    row = {"name": "bench_core.NORM/n:25", "seconds": 4e-4}
    assert ratio_of(row) is None
    print_table([row])
    assert capsys.readouterr().out.splitlines()[-1].split() == ["bench_core.NORM/n:25", "400.00", "us"]
