"""Tests a whole input file of the CONTACT program in one call, and its comparison with printed results."""

from __future__ import annotations

import numpy as np
import pytest

import contactd
from contactd import ContactWarning, InvalidArgument, contact_files
from contactd.contact_files.out_file import lines_of, out_text
from support.contact_hertz import INPUT, MU, printed, write_case


@pytest.fixture
def folder(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    write_case(tmp_path)
    return tmp_path


def test_a_case_has_its_forces_patches_and_arrays(client, folder):
    cases = contact_files.run("x.inp", client)
    (case,) = cases
    assert (len(cases), case.number, case.status, case.sentence) == (1, 1, "solved", "")
    assert case.forces.Fn == pytest.approx(80e3)
    assert case.forces.Fx == pytest.approx(-MU * 80e3, rel=1e-4)
    assert case.numbers["FX"] == case.forces.Fx
    (patch,) = case.patches
    assert patch.pressure.shape == (60, 60)
    assert patch.pressure.sum() * patch.grid.dx * patch.grid.dy == pytest.approx(80e3)
    assert case.solution is patch
    assert repr(case).startswith("<SolvedCase 1: status solved, patches 1, FN 80000")
    assert repr(cases) == "<SolvedCases of 1 cases: solved 1>"


def test_the_numbers_agree_with_the_closed_form_that_is_printed(client, folder):
    compared = contact_files.run("x.inp", client).compare("x.out")
    assert compared.agrees
    assert str(compared) == "1 of 1 cases agree"


def test_a_number_that_is_not_in_tolerance_is_named(client, folder):
    (folder / "other.out").write_text(printed(Fx=-23e3))
    compared = contact_files.run("x.inp", client).compare("other.out")
    assert not compared.agrees
    (sentence,) = compared[0].differences
    assert sentence.startswith("FX -24000, printed -23000")
    assert str(compared).splitlines()[0] == "0 of 1 cases agree"


def test_a_text_is_computed_as_a_file(client, folder):
    by_text, by_file = contact_files.run(INPUT, client), contact_files.run("x.inp", client)
    assert np.array_equal(by_text[0].patches[0].traction_x, by_file[0].patches[0].traction_x)


def test_files_that_an_input_names_are_opened_where_they_may_be(client, folder):
    (folder / "below").mkdir()
    named = INPUT.replace("022020 L-D-C", "029020 L-D-C").replace(" 0.28 0.28 82000.", " '../ics.txt'\n 0.28 0.28 82000.")
    (folder / "below" / "c9.inp").write_text(named)
    grid = contactd.Grid(60, 60, 2 * 1.1 * 7 / 60, 2 * 1.1 * 5.5 / 60)
    table = client.get_ic(contactd.steel, grid, contactd.AnalyticIcs())
    contactd.save_table(folder / "ics.txt", table)
    with pytest.warns(ContactWarning, match="it is outside the folder"):
        (refused,) = contact_files.run(folder / "below" / "c9.inp", client)
    assert refused.status == "wrong"
    (opened,) = contact_files.run(folder / "below" / "c9.inp", client, allow_folders=[folder])
    assert opened.forces.Fn == pytest.approx(80e3)


def test_several_cases_are_told_apart_by_their_numbers(client, folder):
    two = INPUT.replace("0 MODULE\n", "") + INPUT.replace("80000.0 0.1", "40000.0 0.1")
    (folder / "two.inp").write_text(two)
    cases = contact_files.run("two.inp", client)
    assert [case.number for case in cases] == [1, 2]
    assert [case.forces.Fn for case in cases] == pytest.approx([80e3, 40e3])
    assert [case.number for case in cases[1:]] == [2]
    compared = cases.compare("x.out")
    assert [one.agrees for one in compared] == [True, False]
    assert str(compared).endswith("case 2: not printed in this file")


def test_a_run_by_several_threads_has_the_order_of_the_file(client, folder):
    many = "".join(INPUT.replace("0 MODULE\n", "").replace("80000.0 0.1", f"{force}.0 0.1") for force in range(10000, 90000, 10000))
    (folder / "many.inp").write_text(many + "0 MODULE\n")
    one, four = (contact_files.run("many.inp", client, workers=workers) for workers in (1, 4))
    assert [case.forces.Fn for case in four] == pytest.approx(list(range(10000, 90000, 10000)))
    assert all(np.array_equal(a.patches[0].pressure, b.patches[0].pressure) for a, b in zip(one, four))


def test_what_is_printed_by_contactd_agrees_with_itself(client, folder):
    (folder / "printing.inp").write_text(INPUT.replace("000001 H-G", "000201 H-G"))
    cases = contact_files.run("printing.inp", client)
    (folder / "own.out").write_text(out_text(map(lines_of, cases)))
    assert cases.compare("own.out").agrees


def test_a_case_that_is_refused_is_told_and_has_no_numbers(client, folder):
    (folder / "refused.inp").write_text(INPUT.replace("203100 P-B", "213100 P-B", 1))
    with pytest.warns(ContactWarning, match="case 1: (refused|wrong|follows)") as told:
        (case,) = contact_files.run("refused.inp", client)
    assert told[0].filename == __file__
    assert (case.solution, case.forces, case.patches, case.numbers) == (None, None, (), {})
    assert case.sentence
    (compared,) = contact_files.run("refused.inp", client).compare("x.out")
    assert not compared.agrees
    assert case.status in str(compared)


def test_files_without_cases_or_that_are_not_there_are_refused(client, folder):
    (folder / "empty.inp").write_text("0 MODULE\n")
    with pytest.raises(InvalidArgument, match=r"empty\.inp has no cases"):
        contact_files.run("empty.inp", client)
    with pytest.raises(FileNotFoundError):
        contact_files.run("none.inp", client)
    cases = contact_files.run("x.inp", client)
    with pytest.raises(InvalidArgument, match=r"x\.inp has no printed case"):
        cases.compare("x.inp")
    with pytest.raises(FileNotFoundError):
        cases.compare("none.out")


def test_the_package_has_it_without_an_import_of_its_own():
    assert contactd.contact_files.run is contact_files.run
