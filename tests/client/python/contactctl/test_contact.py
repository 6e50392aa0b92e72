"""Tests contact: cases of input files of the CONTACT program, checked, computed, compared and converted."""

import signal
from pathlib import Path

import numpy as np
import pytest

from contactctl.cases.rows import keys_of
from contactctl.codes import Code
from contactd import Client
from contactd.contact_files.named_files import NamedFiles
from support.contact_cases import END, FIRST, SECOND, rail_case

VISCOUS = """\
 3  MODULE
  202100
  102100
 0100201
 50000.  0.0020  0.0  0.0001
   0.0   0.5   20000.
   0.28  0.28  82000.  82000.
  100.0  0.01   0.0  0.0
 3  MODULE
  002100
  100100
 0100201
 50000.  0.0020  0.0  0.0001
"""
TWO = FIRST + SECOND + END


def test_a_file_that_can_be_computed_is_said_to_be(ctl):
    ctl.write("two.inp", TWO)
    ended = ctl("contact", "check", "two.inp")
    assert (ended.code, ended.out) == (Code.DONE, "2 cases: 2 can be computed\n")


def test_what_cannot_be_computed_is_told_by_case_line_and_feature(ctl):
    ctl.write("viscous.inp", FIRST + VISCOUS + END)
    ended = ctl("contact", "check", "viscous.inp", "--json")
    assert ended.code == Code.REFUSED
    first, second, third = ended.json["cases"]
    assert (first["status"], first["line"]) == ("can be computed", 2)
    assert (second["status"], second["line"]) == ("refused", 13)
    assert "viscoelastic" in second["why"]
    assert third["status"] == "refused"


def test_a_word_that_does_not_fit_has_its_line_and_column_and_others_are_computed(ctl):
    wrong = SECOND.replace("0.0020  0.0", "0.0020  none")
    ctl.write("wrong.inp", FIRST + wrong + END)
    ended = ctl("contact", "run", "wrong.inp")
    assert ended.code == Code.USAGE
    assert "1 solved, 1 wrong" in ended.out
    assert "line 16, column 18" in ended.out
    written = (ctl.folder / "wrong.out").read_text()
    assert " WRONG: line 16, column 18" in written


def test_warnings_name_their_cases_once(ctl):
    """Errors occur in the reader and in answers: half of a pair of values, and elements that are too large."""
    coarse = FIRST.replace("15  15  6.0  4.0  1.1", " 5   5  6.0  4.0  1.1")
    text = coarse + SECOND.replace("0.0001\n", "0.0001  7.0\n") + FIRST + END
    ctl.write("three.inp", text)
    behind = "SPINXO without SPINYO"
    for command in ("check", "run"):
        ended = ctl("contact", command, "three.inp")
        assert ended.code == 0, ended.err
        reader = [line for line in ended.err.splitlines() if behind in line]
        assert len(reader) == 1 and reader[0].startswith("warning: case 2 (line 13): line 16 has SPINXO without SPINYO"), ended.err
        assert "cases[" not in ended.err
    few = [line for line in ended.err.splitlines() if "elements across, fewer than" in line]
    assert len(few) == 1 and few[0].startswith("warning: cases 1 (line 2) and 2 (line 13): "), ended.err
    assert "cases 1 (line 2) and 2 (line 13)" in ctl("contact", "run", "three.inp").err
    (full, second, third) = ctl("contact", "run", "three.inp", "--json").json["cases"]
    assert full["warnings"] == second["warnings"] and "warnings" not in third
    compared = ctl("compare", "three.inp", "--case", "3", "--models", "full,hertz", "--repeats", "1")
    assert compared.err.count(behind) == 1 and "cases[" not in compared.err


def test_a_run_writes_what_contact_would(ctl):
    ctl.write("two.inp", TWO)
    ended = ctl("contact", "run", "two.inp")
    assert (ended.code, ended.out) == (Code.DONE, "2 cases: 2 solved. They are in two.out.\n")
    assert sorted(path.name for path in ctl.folder.iterdir() if path.name.startswith("two")) == ["two.0001.mat", "two.0002.mat", "two.inp", "two.out"]
    lines = (ctl.folder / "two.out").read_text().splitlines()
    assert "detailed investigation of 3D" in lines[1]
    assert [line for line in lines if line.startswith(" Case")] == [" Case     1", " Case     2"]


def test_matlab_loads_a_mat_file(ctl):
    ctl.write("two.inp", TWO)
    ctl("contact", "run", "two.inp")
    path = ctl.folder / "two.0002.mat"
    table = np.loadtxt(path, comments="%")
    lines = path.read_text().splitlines()
    assert [number for number, line in enumerate(lines, 1) if line.startswith("%")] == [1, 3, 5, 7, 9, 11, 13]
    assert table.shape[1] == 11
    assert table[0, -1] == 2410
    assert table[3, :2].tolist() == [15, 15]
    assert (table[5, 2], table[5, 3]) == (20000, 0.3)
    elements = table[6:]
    assert set(elements[:, 1]) == {1, 2}
    area = table[3, 4] * table[3, 5]
    assert elements[:, 4].sum() * area == pytest.approx(50000, rel=1e-5)
    slips = elements[:, 1] == 2
    traction = np.hypot(elements[:, 5], elements[:, 6])
    assert traction[slips] == pytest.approx(0.3 * elements[slips, 4], rel=1e-4)
    # In contact surfaces touch: the undeformed distance minus the approach, plus the displacements.
    assert np.ptp(elements[:, 2] + elements[:, 7]) < 1e-5 * elements[:, 7].max()
    assert elements[~slips, 10].max() < 1e-5 * 2e-3


def test_numbers_are_compared_with_printed_ones(ctl):
    ctl.write("two.inp", TWO)
    ctl("contact", "run", "two.inp")
    text = (ctl.folder / "two.out").read_text()
    ctl.write("same.ref", text)
    assert ctl("contact", "run", "two.inp", "--compare", "same.ref").code == Code.DONE
    fx = next(line for number, line in enumerate(text.splitlines()) if "FRIC.POWER" in text.splitlines()[number - 1]).split()[1]
    ctl.write("other.ref", text.replace(fx, f"{1.01 * float(fx):.4g}", 1))
    ended = ctl("contact", "run", "two.inp", "--compare", "other.ref")
    assert ended.code == Code.NOT_CONVERGED
    assert "1 differs" in ended.out and "FX" in ended.out
    ctl.write("short.ref", text[: text.index(" Case     2")])
    assert "does not contain it" in ctl("contact", "run", "two.inp", "--compare", "short.ref").out


def test_a_mat_file_of_a_layer_has_its_yield_stress_and_accumulated_plastic_slip(ctl):
    layered = FIRST.replace("022020", "022420").replace("0.28  0.28  82000.  82000.", "0.  0.  82000.  82000.\n 8200. .164 120. 9000.")
    ctl.write("layer.inp", layered.replace("0.0005  0.0  0.0001", "0.0020  0.0  0.0") + END)
    assert ctl("contact", "run", "layer.inp").code == Code.DONE
    path = ctl.folder / "layer.0001.mat"
    table = np.loadtxt(path, comments="%")  # requires equally many columns in all lines
    assert path.read_text().splitlines()[12].split()[-4:] == ["SREL", "TAUCRT", "UPLSX", "UPLSY"]
    assert table.shape[1] == 14
    elements = table[6:]
    plastic = elements[:, 1] == 3
    assert plastic.sum() > 5
    slip = np.hypot(elements[:, 12], elements[:, 13])
    assert elements[:, 11] == pytest.approx(120 + 9000 * slip, rel=1e-4)  # all of it has one direction
    assert np.hypot(elements[plastic, 5], elements[plastic, 6]) == pytest.approx(elements[plastic, 11], rel=1e-4)


def test_cases_of_result_elements_that_number_alike_are_told_apart(ctl):
    first, second = (FIRST.replace(" 3  MODULE", f" 3 {reid} {cpid}") for reid, cpid in ((4, 1), (7, 2)))
    ctl.write("two.inp", first + second.replace("50000.", "60000.") + END)
    assert ctl("contact", "run", "two.inp").code == Code.DONE
    text = (ctl.folder / "two.out").read_text()
    assert [line for line in text.splitlines() if line.startswith(" Case")] == [
        " Case     1, result element   4", " Case     1, result element   7",
    ]  # fmt: skip
    ctl.write("other.ref", text.replace("5.000E+04", "5.100E+04").replace("6.000E+04", "6.100E+04"))
    ended = ctl("contact", "run", "two.inp", "--compare", "other.ref")
    assert ended.code == Code.NOT_CONVERGED
    heading, *rows = (line.split("  ") for line in ended.out.splitlines() if "differs" in line or "why" in line)
    words = [word.strip() for word in heading if word.strip()]
    assert words[:3] == ["case", "result element", "contact problem"]
    assert [[word.strip() for word in row if word.strip()][:3] for row in rows[:2]] == [["1", "4", "1"], ["1", "7", "2"]]
    answer = ctl("contact", "run", "two.inp", "--compare", "other.ref", "--json").json
    assert [(case["case"], case["reid"], case["cpid"]) for case in answer["cases"]] == [(1, 4, 1), (1, 7, 2)]
    checked = ctl("contact", "check", "two.inp", "--json").json
    assert [(case["case"], case["reid"], case["cpid"]) for case in checked["cases"]] == [(1, 4, 1), (1, 7, 2)]


def test_a_file_of_another_program_is_never_written_over(ctl):
    ctl.write("two.inp", TWO)
    ctl.write("two.out", "   --------\n   |  CONTACT - detailed investigation of 3D frictional contact problems  |\n")
    ended = ctl("contact", "run", "two.inp")
    assert ended.code == Code.USAGE
    assert "contactd did not write it" in ended.err
    assert "CONTACT - " in (ctl.folder / "two.out").read_text()


def test_files_of_elements_without_a_mark_are_written_over_only_when_asked_to(ctl):
    """The CONTACT program and versions before 0.1.0 write such files."""
    ctl.write("two.inp", TWO)
    ctl.write("two.0002.mat", "% Meta-data\n  1.0  2.0  3.0\n")
    ended = ctl("contact", "run", "two.inp")
    assert ended.code == Code.USAGE
    assert "two.0002.mat exists, and contactd did not write it. Name another file, or give --overwrite." in ended.err
    assert "versions of contactd before 0.1.0 write .mat and .subs files without a mark." in ended.err
    assert not (ctl.folder / "two.out").exists()
    assert ctl("contact", "run", "two.inp", "--overwrite").code == Code.DONE
    assert ctl("contact", "run", "two.inp").code == Code.DONE  # these have the mark


def test_a_run_that_was_killed_goes_on(ctl):
    many = FIRST.replace("15  15", "90  90") + SECOND.replace("0101201", "0100201") * 60 + END
    ctl.write("many.inp", many)
    process = ctl.start("contact", "run", "many.inp", "--workers", "1")
    rows = ctl.folder / "many.out.rows"
    while not rows.exists() or rows.read_bytes().count(b"\n") < 3:
        assert process.poll() is None, "it ended before it was killed"
    process.send_signal(signal.SIGTERM)
    _, told = process.communicate(timeout=60)
    assert process.returncode == Code.TERMINATED
    assert "repeat the command to continue" in told
    assert not (ctl.folder / "many.out").exists()
    kept = rows.read_bytes().count(b"\n")
    ended = ctl("contact", "run", "many.inp")
    assert ended.code == Code.DONE
    assert f"{kept} of 61 cases are in many.out.rows." in ended.err
    assert not rows.exists()


def test_rows_of_other_files_are_not_taken_up(tmp_path):
    (tmp_path / "list.slcs").write_text("'a.prr'\n'../b.prr'\n'sub/../list.slcs'\n")
    (tmp_path / "a.prr").write_text("first")
    files = NamedFiles(tmp_path)
    cases = [rail_case(RFNAME="list.slcs", WFNAME="nothere.prw")]
    before = files.digests(cases)
    (tmp_path / "a.prr").write_text("second")
    after = files.digests(cases)
    assert {Path(name).name for name in after if after[name] != before[name]} == {"a.prr"}
    assert {Path(name).name for name in after} == {"list.slcs", "a.prr", "b.prr", "nothere.prw"}
    assert keys_of(cases, {"files": before}) != keys_of(cases, {"files": after})


def test_the_number_of_workers_changes_no_answer(ctl):
    ctl.write("many.inp", FIRST + SECOND.replace("0101201", "0100201") * 5 + END)
    ctl("contact", "run", "many.inp", "--output", "one.out", "--workers", "1")
    ctl("contact", "run", "many.inp", "--output", "three.out", "--workers", "3")
    assert (ctl.folder / "one.out").read_text() == (ctl.folder / "three.out").read_text()


def test_a_case_becomes_yaml_that_solves_to_the_same(ctl):
    ctl.write("two.inp", TWO)
    assert ctl("contact", "convert", "two.inp", "case.yaml", "--case", "2").code == Code.DONE
    solved = ctl("solve", "case.yaml", "--json").json
    cases = ctl("contact", "run", "two.inp", "--json").json["cases"]
    assert cases[1]["numbers"]["numbers"]["FX"] == solved["forces"]["Fx"]
    assert "choose one with --case" in ctl("contact", "convert", "two.inp", "case.yaml").err
    assert "has 2 cases" in ctl("contact", "convert", "two.inp", "case.yaml", "--case", "3").err


def test_cases_become_a_program_that_solves_them(ctl):
    ctl.write("two.inp", TWO)
    assert ctl("contact", "convert", "two.inp", "cases.py").code == Code.DONE
    compile((ctl.folder / "cases.py").read_text(), "cases.py", "exec")
    assert "must end in" in ctl("contact", "convert", "two.inp", "cases.txt").err


def test_a_file_that_is_not_there_is_told(ctl):
    ended = ctl("contact", "check", "none.inp")
    assert ended.code == Code.USAGE
    assert "none.inp" in ended.err


def test_what_is_beyond_a_limit_is_refused_and_not_called_a_failure(ctl):
    """The same limit of the service applies whether the case is checked or computed."""
    ctl.write("large.inp", FIRST.replace("15  15  6.0", "2500000  15  6.0") + END)
    with Client(ctl.endpoint) as client:
        most = client.info().limits.max_grid_elements
    for command in ("check", "run"):
        ended = ctl("contact", command, "large.inp")
        assert ended.code == Code.REFUSED and "1 case: 1 refused" in ended.out
        assert f"MX MY is 37500000 elements; at most {most} are accepted." in ended.out
        ctl.write("large.inp", FIRST.replace("15  15  6.0", f"{most // 15 + 1}  15  6.0") + END)
        assert f"MX MY is {15 * (most // 15 + 1)} elements; at most {most}" in ctl("contact", command, "large.inp").out
        ctl.write("large.inp", FIRST.replace("15  15  6.0", "2500000  15  6.0") + END)


def test_mistakes_of_a_case_are_told_apart(ctl):
    ctl.write("wrong.inp", TWO.replace("15  15  6.0", "0  15  6.0"))
    ended = ctl("contact", "check", "wrong.inp", "--json")
    assert ended.code == Code.USAGE
    assert "could not be read completely; line" in ended.json["cases"][1]["why"]


def test_a_folder_is_no_input_file(ctl):
    ended = ctl("contact", "run", ".")
    assert ended.code == Code.USAGE and "is a folder; it must be an input file" in ended.err


def test_a_file_without_printed_cases_is_nothing_to_compare_with(ctl):
    ctl.write("two.inp", TWO)
    ctl.write("other.out", "Fn 5\n")
    ended = ctl("contact", "run", "two.inp", "--compare", "other.out")
    assert ended.code == Code.USAGE and "the file has no printed case" in ended.err


@pytest.mark.parametrize("command", [("check",), ("run",), ("convert", "cases.py")])
@pytest.mark.parametrize("text", [TWO.replace("203100", "2o3100", 1), FIRST + " 7  MODULE\n" + END, TWO.replace("6.0  4.0  1.1", "0.0  4.0  1.1")])
def test_files_with_mistakes_end_with_a_code_of_their_own(ctl, command, text):
    ctl.write("wrong.inp", text)
    ended = ctl("contact", command[0], "wrong.inp", *command[1:])
    assert ended.code == Code.USAGE
    assert "Traceback" not in ended.err
