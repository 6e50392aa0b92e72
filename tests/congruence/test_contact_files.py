"""Tests that input files of the CONTACT program have the same answers by contact_file.run and by the drop-in
library."""

from pathlib import Path

import pytest

from congruence.contact_answers import differing, pairs
from congruence.own_contact_files import END, OWN, PROFILES
from validation.given import FilesMissing, given_files

GIVEN = Path(__file__).parents[3] / "shared" / "contact"
#: Files that take seconds.
SLOW = {"groove_li", "chalmers_flat_fz125", "rounded_flat_d09", "mbench_brute", "mbench_locus", "t3_t1_conformal"}


def given():
    try:
        files = given_files(GIVEN)
    except FilesMissing as error:
        return [pytest.param(None, marks=pytest.mark.skip(reason=str(error)))]
    marks = [(pytest.mark.slow,) if Path(one.name).stem in SLOW else () for one in files]
    return [pytest.param(one.path, marks=mark, id=Path(one.name).stem) for one, mark in zip(files, marks)]


def differences(path, folder):
    """Returns quantities that differ, with the outcomes of their cases."""
    compared = list(pairs(path, folder))
    assert compared
    return [
        f"case {case.number}: {quantity} ({ours.status} {ours.sentence} / {theirs.status} {theirs.sentence})"
        for case, ours, theirs in compared
        for quantity in differing(ours, theirs)
    ], compared


@pytest.mark.timeout(120)
@pytest.mark.parametrize("path", given())
def test_given_cases_are_the_same(path, tmp_path):
    assert differences(path, tmp_path)[0] == []


@pytest.mark.parametrize("name", OWN)
def test_own_cases_are_the_same_and_solved(name, tmp_path):
    for file, points in PROFILES.items():
        (tmp_path / file).write_text(points)
    path = tmp_path / "own.inp"
    path.write_text(OWN[name] + END)
    (tmp_path / "cases").mkdir()
    found, compared = differences(path, tmp_path / "cases")
    assert found == []
    assert all(ours.quantities for _, ours, _ in compared)
