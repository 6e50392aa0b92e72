"""Tests that files may only name files beside and below them, and no programs, unless the command line allows it."""

import pytest

from .test_wear import STATES, STUDY

RAIL_CASE = """\
 1 MODULE
 1203100
 0022033
 0000001
 100 30 5 1 1e-6
 0.3 0.3
 .28 .28 82000. 82000.
 0.2 0.25 1. 90d 8. 4.
 14. 0 1435. 0.025
 'NAME' 0 1. 0.
 0. 0. 1.5d 0. 0. 0.
 1360. -70. 460.
 'wheel.prw' 1 1. 10. -1
 0. 1.5 10000. 0.001 0. 0.
 2000. 0. 0. 0. 0. -4.348
 0 MODULE
"""
REFUSED = "is outside the folder of the file that names it; allow its folder with --allow-folder"


@pytest.fixture
def nested(ctl):
    """Creates adjacent folders with files; commands are given those of `own`."""
    for name in ("own", "other"):
        (ctl.folder / name).mkdir()
    (ctl.folder / "own" / "rail.csv").write_text("x (mm);r (um)\n" + "".join(f"{x};{x % 7}\n" for x in range(1200)))
    (ctl.folder / "other" / "gap.txt").write_text("1 1\n1 1\n")
    (ctl.folder / "other" / "rail.txt").write_text("secret words\n1 2\n3\n")
    (ctl.folder / "other" / "states.csv").write_text(STATES)
    (ctl.folder / "other" / "problem.yaml").write_text("grid: {nx: 2, ny: 2, dx: 1, dy: 1}\n")
    return ctl


DOCUMENTS = {
    "array": (["solve"], "{grid: {nx: 2, ny: 2, dx: 1, dy: 1}, gap: {array: {$file: NAME}}}", "gap.txt"),
    "profile": (["wheelrail", "solve"], "{setup: {rail: {file: NAME}}, state: {Fz: 1e4}}", "rail.txt"),
    "problem of a study": (["study"], "{problem: NAME, vary: {Fn: [1, 2]}}", "problem.yaml"),
    "array of a study": (["study"], "{problem: {grid: {nx: 2, ny: 2, dx: 1, dy: 1}}, vary: {gap.array: [{$file: NAME}]}}", "gap.txt"),
    "states": (["wear"], STUDY.replace("states.csv", "NAME"), "states.csv"),
    "contact of a roughness": (["roughness", "own/rail.csv", "--case"], "{grid: {nx: 2, ny: 2, dx: 1, dy: 1}, gap: {array: {$file: NAME}}}", "gap.txt"),
    "steps": (["session"], "{open: {grid: {nx: 2, ny: 2, dx: 1, dy: 1}}, steps: NAME}", "states.csv"),
}


@pytest.mark.parametrize("way", ["relative", "absolute", "link"])
@pytest.mark.parametrize("kind", DOCUMENTS)
def test_a_document_names_no_file_outside_of_its_folder(nested, kind, way):
    words, text, target = DOCUMENTS[kind]
    names = {"relative": f"../other/{target}", "absolute": str(nested.folder / "other" / target), "link": f"link-{target}"}
    if way == "link":
        (nested.folder / "own" / names[way]).symlink_to(nested.folder / "other" / target)
    (nested.folder / "own" / "given.yaml").write_text(text.replace("NAME", names[way]))
    ended = nested(*words, "own/given.yaml")
    assert ended.code == 2 and REFUSED in ended.err, ended.err
    assert REFUSED not in nested(*words, "own/given.yaml", "--allow-folder", "other").err
    assert REFUSED in nested(*words, "own/given.yaml", "--allow-folder", "oth").err


@pytest.mark.parametrize("name", ["../other/rail.txt", "..\\other\\rail.txt", "PLACE/other/rail.txt", "link.txt", "list.slcs"])
def test_cases_name_no_profile_outside_of_their_folder(nested, name):
    own = nested.folder / "own"
    (own / "link.txt").symlink_to(nested.folder / "other" / "rail.txt")
    (own / "list.slcs").write_text("0 1\n2\n0 0 0\n1\n0.0 '../other/rail.txt'\n100.0 '../other/rail.txt'\n")
    (own / "cases.inp").write_text(RAIL_CASE.replace("NAME", name.replace("PLACE", str(nested.folder))))
    ended = nested("contact", "run", "own/cases.inp", "--json")
    (row,) = ended.json["cases"]
    assert (ended.code, row["status"]) == (2, "wrong") and REFUSED in row["why"], row["why"]
    (own / "cases.out").unlink()
    allowed = nested("contact", "run", "own/cases.inp", "--json", "--allow-folder", "other").json["cases"][0]
    assert REFUSED not in allowed["why"] and "cannot be used" in allowed["why"]


def test_a_study_runs_no_program_by_itself(ctl):
    ctl.write("wear.yaml", STUDY.replace("states: states.csv", "dynamics: {program: [touch, ran]}"))
    ended = ctl("wear", "wear.yaml")
    assert ended.code == 2
    assert "wear.yaml: dynamics.program = ['touch', 'ran']: a study does not run a program by itself. Check it, and give --allow-program." in ended.err
    assert not (ctl.folder / "ran").exists() and not (ctl.folder / "wear.yaml.h5").exists()
    ctl("wear", "wear.yaml", "--allow-program")
    assert (ctl.folder / "ran").exists()


def test_cases_beside_their_profiles_need_no_option(nested):
    text = "".join(f"{y} {y * y / 600}\n" for y in range(-35, 36))
    (nested.folder / "own" / "below").mkdir()
    (nested.folder / "own" / "below" / "rail.txt").write_text(text)
    (nested.folder / "own" / "cases.inp").write_text(RAIL_CASE.replace("NAME", "below/rail.txt"))
    row = nested("contact", "run", "own/cases.inp", "--json").json["cases"][0]
    assert REFUSED not in row["why"] and '"wheel.prw" cannot be read: No such file' in row["why"], row["why"]
