"""Tests the rule for all outputs: commands overwrite files written by contactd, and others with --overwrite only."""

import os
import runpy

import numpy as np
import pytest

from contactd.files.marks import MARK, can_be_written_over

from .test_contact import END, FIRST, TWO
from .test_wear import STATES, STUDY

FOREIGN = b"contactd's users keep their own notes here, {}, 1, 2, 3\n"
SWEEP = "problem: contact.yaml\nvary: {approach: [0.01, 0.02]}\nanswers: [forces.Fn]\n"
PROFILE = "".join(f"{y} {y * y / 600}\n" for y in range(-35, 36))
#: Commands, and the files that each writes.
OUTPUTS = [
    *((["solve", "contact.yaml", "--output", f"answer.{ending}"], [f"answer.{ending}"]) for ending in ("json", "h5", "png", "svg", "pdf")),
    (["contact", "run", "two.inp"], ["two.out", "two.0001.mat", "two.0002.mat"]),
    (["contact", "convert", "two.inp", "case.py"], ["case.py"]),
    (["contact", "convert", "two.inp", "case.yaml", "--case", "1"], ["case.yaml"]),
    (["profile", "convert", "points.txt", "rail.prr", "--rail"], ["rail.prr"]),
    (["profile", "convert", "points.txt", "rail.csv", "--rail"], ["rail.csv"]),
    (["profiles", "write", "S1002"], ["S1002.prw", "S1002.whl"]),
    (["study", "sweep.yaml", "--csv", "rows.csv", "--hdf5", "rows.h5"], ["rows.csv", "rows.h5"]),
    (["compare", "contact.yaml", "--models", "full,hertz", "--csv", "models.csv", "--plot", "models.png"], ["models.csv", "models.png"]),
    (["roughness", "record.csv", "--load", "5e4", "--csv", "levels.csv", "--plot", "levels.png"], ["levels.csv", "levels.png"]),
    (["conform", "cnossos", "--csv", "filters.csv", "--plot", "filters.png"], ["filters.csv", "filters.png"]),
    *((["ic", "export", "table.json", "--output", f"table.{ending}"], [f"table.{ending}"]) for ending in ("h5", "npz", "txt")),
]
SLOW = [
    (["wear", "wear.yaml", "--fresh", "--profile", "worn.txt", "--profiles", "worn", "--pictures", "drawn"],
     ["wear.yaml.h5", "worn.txt", "worn/wheel.prw", "worn/wheel.whl", "drawn/wheel-worn.png", "drawn/wheel-wear.gif", "drawn/measures.json"]),
]  # fmt: skip


@pytest.fixture
def there(ctl):
    ctl.write("two.inp", TWO)
    ctl.write("points.txt", PROFILE)
    ctl.write("sweep.yaml", SWEEP)
    ctl.write("wear.yaml", STUDY.replace("until: 60", "until: 20"))
    ctl.write("states.csv", STATES)
    ctl.write("record.csv", "x (mm);r (um)\n" + "".join(f"{x};{x % 7}\n" for x in range(1200)))
    ctl.write("table.json", {"material": {"G": 82000, "nu": 0.28}, "grid": {"nx": 4, "ny": 4, "dx": 1, "dy": 1}, "ics": {"source": "analytic"}})
    return ctl


def check(there, words, names):
    """Files are created, recreated, left unchanged if others have written them, also through a link, and overwritten
    with --overwrite."""
    first = there(*words)
    assert first.code == 0, first.err
    again = there(*words)
    assert again.code == 0, again.err
    for name in names:
        path = there.folder / name
        assert path.is_file() and can_be_written_over(path) is (path.suffix != ".csv" or name == "rail.csv"), name
        made = path.read_bytes()
        for behind_a_link in (False, True):
            path.unlink()
            foreign = there.folder / "notes.txt" if behind_a_link else path
            foreign.write_bytes(FOREIGN)
            if behind_a_link:
                path.symlink_to(foreign)
            refused = there(*words)
            assert refused.code == 2, (name, refused)
            assert f"{name} exists, and contactd did not write it. Name another file, or give --overwrite." in refused.err
            assert foreign.read_bytes() == FOREIGN
        path.unlink()
        path.symlink_to(there.folder / "nowhere")
        assert "is a broken link" in there(*words).err
        assert not (there.folder / "nowhere").exists()
        path.unlink()
        path.write_bytes(FOREIGN)
        taken = there(*words, "--overwrite")
        assert taken.code == 0, taken.err
        assert path.read_bytes() != FOREIGN
        path.write_bytes(made)


@pytest.mark.parametrize(("words", "names"), OUTPUTS, ids=lambda given: "-".join(given[:2]) if isinstance(given, list) else None)
def test_what_others_have_written_is_left_alone(there, words, names):
    check(there, words, names)


@pytest.mark.slow  # a study of wear is made again for each file and link
@pytest.mark.parametrize(("words", "names"), SLOW)
def test_what_others_have_written_is_left_alone_by_studies_of_wear(there, words, names):
    check(there, words, names)


@pytest.mark.parametrize("content", [b"one line without an end", b"two\nlines\n", b"12345678 [1]", b"key,1\n2"])
@pytest.mark.parametrize("words", [["study", "sweep.yaml", "--rows", "kept.rows"], ["study", "sweep.yaml", "--rows", "kept.rows", "--fresh"]])
def test_a_file_that_has_no_rows_is_left_alone(there, words, content):
    (there.folder / "kept.rows").write_bytes(content)
    ended = there(*words)
    assert ended.code == 2 and "is not a file with rows of a study" in ended.err
    assert (there.folder / "kept.rows").read_bytes() == content


def test_rows_of_cases_are_no_file_of_another_program(there):
    (there.folder / "two.out.rows").write_bytes(FOREIGN)
    assert there("contact", "run", "two.inp", "--fresh").code == 2
    assert (there.folder / "two.out.rows").read_bytes() == FOREIGN


def test_the_stages_of_a_study_are_removed_and_nothing_else(there):
    dynamics = "dynamics: {program: [python3, none.py]}"
    there.write("wear.yaml", STUDY.replace("states: states.csv", dynamics))
    kept = there.folder / "wear.yaml.h5.stages" / "mine"
    kept.mkdir(parents=True)
    ended = there("wear", "wear.yaml", "--fresh", "--allow-program")
    assert ended.code == 2 and "is not a stage written by contactd" in ended.err
    assert kept.is_dir()


NAMES = ['a"""\nimport os; os.mkdir("pwned")\n"""b.inp', "quote'd\\.inp", "\x1b[2J\r\nx = 1.inp", "caf\u00e9 \u2028 print(1).inp"]


@pytest.mark.parametrize("name", NAMES)
def test_the_name_of_a_file_of_cases_is_no_code(there, name, monkeypatch):
    wrong = FIRST.replace("50000.  0.0005", "50000.  none")
    there.write(name, wrong + FIRST.replace(" 203100", " 202100") + END)
    ended = there("contact", "convert", name, "case.py")
    assert ended.code in (0, 2, 4), ended.err
    text = (there.folder / "case.py").read_text()
    assert all(character.isprintable() or character == "\n" for character in text)
    monkeypatch.chdir(there.folder)
    before = set(os.listdir())
    compiled = compile(text, "case.py", "exec")
    assert compiled.co_consts[0] == f"Cases of {name}, by contactd."
    program = text.replace("contactd.local()", f"contactd.Client({there.endpoint!r})")
    (there.folder / "case.py").write_text(program)
    runpy.run_path("case.py")
    assert set(os.listdir()) - before <= {"__pycache__"}


def test_numbers_that_are_not_finite_and_texts_are_expressions_of_python():
    from contactd.contact_files.python_text import _written

    for value in (np.inf, -np.inf, 1e-300, "it's \"x\"\n", True, None, b"\x00", [np.array([np.inf, 1.0])]):
        found = eval(_written(value, 0), {"np": np, "float": float})
        assert np.all(np.asarray(found, dtype=object) == np.asarray(value, dtype=object))


def test_a_cell_that_a_spreadsheet_would_compute_is_a_text():
    from contactctl.writing.csv_files import csv_text

    assert csv_text([["=1+1", "-2", -2.0, "a,b", "@x"]]) == "'=1+1,'-2,-2.0,\"a,b\",'@x\n"


def test_the_mark_is_that_of_whole_files_too(tmp_path):
    path = tmp_path / "x"
    path.write_bytes(b"x" * 500_000 + f"# {MARK} 1.0\n".encode())
    assert can_be_written_over(path)
    path.write_bytes(b"x" * 500_000)
    assert not can_be_written_over(path)


@pytest.mark.parametrize("words", [["solve", "NAME"], ["contact", "check", "NAME"], ["profile", "show", "NAME"], ["study", "NAME", "--rows", "r"]])
def test_messages_have_nothing_that_terminals_obey(ctl, words):
    """The rule applies for any names and contents of files."""
    name = "\x1b]0;owned\x07\x1b[2J.json"
    ctl.write(name, '{"\\u001b[2J": 1, "problem": {}, "vary": {"\\u001b[31m": [1]}}')
    ended = ctl(*(name if word == "NAME" else word for word in words))
    assert ended.code in (2, 4) and ended.err
    assert all(character.isprintable() or character == "\n" for character in ended.out + ended.err), ended
