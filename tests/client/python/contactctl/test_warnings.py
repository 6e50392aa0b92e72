"""What answers warn of, on standard error: sentences for people, whatever Python's own filters say."""

import json

import pytest

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
    """contactctl of a server whose answers warn."""

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


def test_a_study_counts_them(warning):
    warning.write("study.json", {"problem": "contact.yaml", "vary": {"approach": [0.01, 0.02, 0.03]}})
    ended = warning("study", "study.json", "--workers", 2)
    assert ended.code == 0
    assert "warning: It is wrong. (3 answers)" in ended.err
    assert "Traceback" not in ended.err
