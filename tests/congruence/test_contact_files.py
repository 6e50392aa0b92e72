"""Input files of the CONTACT program have the same answers both ways: by `contactctl contact` and by the drop-in library."""

import csv
from pathlib import Path

import pytest

from congruence.contact_answers import differing, pairs
from congruence.own_contact_files import END, OWN, PROFILES
from validation.given import FilesMissing, given_files

GIVEN = Path(__file__).parents[3] / "shared" / "contact"
#: Each quantity of a given case that differs today: file, case, quantity and reason. Nothing else differs.
LIST = Path(__file__).with_name("contact_differences.csv")
#: Files that take seconds.
SLOW = {"groove_li", "chalmers_flat_fz125", "rounded_flat_d09", "mbench_brute", "mbench_locus", "t3_t1_conformal"}


def given():
    try:
        files = given_files(GIVEN)
    except FilesMissing as error:
        return [pytest.param(None, None, marks=pytest.mark.skip(reason=str(error)))]
    marks = [(pytest.mark.slow,) if Path(one.name).stem in SLOW else () for one in files]
    return [pytest.param(one.name, one.path, marks=mark, id=Path(one.name).stem) for one, mark in zip(files, marks)]


@pytest.mark.timeout(120)
@pytest.mark.parametrize(("name", "path"), given())
def test_given_cases_differ_only_as_listed(name, path, tmp_path):
    with LIST.open(newline="") as file:
        listed = {(row["case"], row["quantity"]) for row in csv.DictReader(file) if row["file"] == name}
    found, said = set(), {}
    for case, ours, theirs in pairs(path, tmp_path):
        differences = {(str(case.number), quantity) for quantity in differing(ours, theirs)}
        found |= differences
        said |= dict.fromkeys(differences, f"{ours.status} {ours.sentence} / {theirs.status} {theirs.sentence}")
    new = [f"{name},{case},{quantity}, ({said[case, quantity]})" for case, quantity in sorted(found - listed)]
    gone = [f"{name},{case},{quantity}," for case, quantity in sorted(listed - found)]
    assert not new, "differences that are not listed:\n" + "\n".join(new)
    assert not gone, "differences that are listed and gone:\n" + "\n".join(gone)


@pytest.mark.parametrize("name", OWN)
def test_own_cases_differ_only_as_listed(name, tmp_path):
    for file, points in PROFILES.items():
        (tmp_path / file).write_text(points)
    path = tmp_path / "own.inp"
    text, expected = OWN[name]
    path.write_text(text + END)
    (tmp_path / "cases").mkdir()
    compared = list(pairs(path, tmp_path / "cases"))
    assert compared
    for _, ours, theirs in compared:
        assert ours.quantities, ours.sentence
        assert set(differing(ours, theirs)) == expected, (ours.status, ours.sentence, theirs.status, theirs.sentence)
