"""Tests warnings of answers on standard error, which are sentences regardless of Python's own filters."""

import json

import pytest

from contactctl.output import warn_of
from support.fake_server import FakeServer

SOLVED = {
    "approach": 0.02, "forces": {"Fn": 1.0, "Fx": 0.0, "Fy": 0.0, "Mz": 0.0}, "pmax": 1.0,
    "area": {"contact": 1.0, "adhesion": 1.0, "slip": 0.0},
    "elements": {"contact": 1, "adhesion": 1, "slip": 0, "border": 0}, "converged": True,
    "evidence": {"normal": {"iterations": 1, "residual": 0.0, "converged": True, "seconds": 0.0},
                 "ics": {"upper": {"origin": "built", "key": "a", "evidence": {"warnings": ["The mesh is coarse."]}}}},
    "warnings": ["It is wrong."],
}  # fmt: skip


@pytest.fixture
def warning(lonely):
    """Runs contactctl with a server whose answers contain warnings."""

    def answer(request):
        result = {
            "contact.solve": SOLVED, "session.open": {"session": "s"}, "session.step": SOLVED | {"step": request.params.get("step")},
            "server.health": {"state": "serving", "warnings": ["The store is full."]}, "job.list": {"jobs": []},
        }  # fmt: skip
        return [request.result(result.get(request.method, {}))]

    with FakeServer(lonely.folder, answer) as server:
        lonely.endpoint = lonely.environment["CONTACTD_ENDPOINT"] = server.endpoint
        yield lonely


@pytest.mark.parametrize("filters", ["", "error", "ignore"])
def test_a_solve_says_them_once_and_json_stays_json(warning, filters):
    for json_too in ([], ["--json"]):
        ended = warning.alone("solve", "contact.yaml", *json_too, PYTHONWARNINGS=filters)
        assert ended.code == 0
        assert ended.err == "warning: It is wrong.\nwarning: The mesh is coarse.\n"
        assert "warning" not in ended.out.replace('"warnings"', "")
        if json_too:
            assert json.loads(ended.out)["warnings"] == ["It is wrong."]


def test_health_says_them(warning):
    ended = warning("health")
    assert (ended.code, ended.out, ended.err) == (0, "serving\n", "warning: The store is full.\n")


def test_steps_say_them_with_their_numbers(warning):
    warning.write("history.json", {"open": {"grid": {}}, "steps": [{"Fn": 1}, {"Fn": 2}]})
    ended = warning("session", "history.json")
    assert ended.code == 0
    assert [line for line in ended.err.splitlines() if "It is wrong" in line] == [
        "warning: step 1: It is wrong.",
        "warning: step 2: It is wrong.",
    ]


def test_a_study_names_their_rows(warning):
    warning.write("study.json", {"problem": "contact.yaml", "vary": {"approach": [0.01, 0.02, 0.03]}})
    ended = warning("study", "study.json", "--workers", 2)
    assert ended.code == 0
    rows = "rows 1 (approach = 0.01), 2 (approach = 0.02) and 3 (approach = 0.03)"
    assert [line for line in ended.err.splitlines() if "wrong" in line] == [f"warning: {rows}: It is wrong."]
    assert "Traceback" not in ended.err
    # Existing rows keep their warnings.
    again = warning("study", "study.json", "--json")
    assert [row["warnings"] for row in again.json["rows"]] == 3 * [["It is wrong.", "The mesh is coarse."]]
    assert f"warning: {rows}: It is wrong." in again.err


def test_a_share_of_a_study_names_rows_of_the_whole(warning):
    warning.write("study.json", {"problem": "contact.yaml", "vary": {"approach": [0.01, 0.02, 0.03]}})
    assert "warning: row 2 (approach = 0.02): It is wrong." in warning("study", "study.json", "--share", "1/2").err


def test_sentences_of_many_cases_name_the_first_five(capsys):
    warn_of("case", [(str(number), "It is wrong.") for number in range(1, 9)] + [("3", "It is cold.")])
    assert capsys.readouterr().err == "warning: cases 1, 2, 3, 4, 5 and 3 more: It is wrong.\nwarning: case 3: It is cold.\n"


def test_more_sentences_than_anybody_reads_are_counted(capsys):
    warn_of("step", [(str(number), f"It is wrong by {number} mm.") for number in range(25)])
    assert capsys.readouterr().err.endswith("warning: step 19: It is wrong by 19 mm.\nand 5 other warnings.\n")
