"""Tests that warnings of answers become warnings of Python: for every client, once per answer, at the line of the
call."""

import asyncio
import copy
import json
import pickle
import subprocess
import sys
import warnings
from pathlib import Path

import pytest

import contactd
from contactd import AsyncClient, Client, ContactWarning
from contactd.calls.answer_warnings import _PARTS, sentences_in
from contactd.wheel_rail import WheelRailSetup, WheelRailState, WheelsetPosition
from support.fake_server import FakeServer
from support.problems import CATTANEO

pytestmark = pytest.mark.filterwarnings("error::contactd.ContactWarning")

SCHEMAS = Path(__file__).parents[3] / "proto" / "schema"
SOLVED = {
    "approach": 0.02, "forces": {"Fn": 1.0, "Fx": 0.0, "Fy": 0.0, "Mz": 0.0}, "pmax": 1.0,
    "area": {"contact": 1.0, "adhesion": 1.0, "slip": 0.0},
    "elements": {"contact": 1, "adhesion": 1, "slip": 0, "border": 0}, "converged": True,
    "evidence": {"normal": {"iterations": 1, "residual": 0.0, "converged": True, "seconds": 0.0},
                 "ics": {"upper": {"origin": "built", "key": "a",
                                   "evidence": {"source": "fem", "version": "1", "warnings": ["The mesh is coarse."]}}}},
    "warnings": ["It is wrong.", "It is far off."],
}  # fmt: skip
TABLE = {"evidence": {"source": "fem", "version": "1", "warnings": ["The mesh is coarse."]}}


def example(method):
    return json.loads((SCHEMAS / f"{method}.result.json").read_text())["examples"][0]


def quiet(answer):
    """Returns the answer without the part that causes the warning."""
    if isinstance(answer, dict):
        return {name: quiet(value) for name, value in answer.items() if name != "warnings" or value == []}
    return [quiet(item) for item in answer] if isinstance(answer, list) else answer


@pytest.fixture
def answering(tmp_path):
    """Provides a client of a server with this answer."""
    with_them = []

    def make(answer):
        server = FakeServer(tmp_path, lambda request: [request.result(answer(request) if callable(answer) else answer)])
        client = Client(server.endpoint, timeout=20)
        with_them.extend((client, server))
        return client

    yield make
    for made in with_them:
        made.__exit__(None, None, None)


def test_a_warning_comes_once_an_answer_with_all_sentences_and_points_at_the_caller(answering):
    client = answering(SOLVED)
    with pytest.warns(ContactWarning) as caught:
        solution = client.solve(CATTANEO, fields=[])
    (warning,) = caught
    assert warning.filename == __file__
    assert Path(__file__).read_text().splitlines()[warning.lineno - 1].strip() == "solution = client.solve(CATTANEO, fields=[])"
    assert warning.message.sentences == ("It is wrong.", "It is far off.", "The mesh is coarse.")
    assert str(warning.message) == "It is wrong. It is far off. The mesh is coarse."
    assert solution.warnings == ("It is wrong.", "It is far off.")


def test_an_answer_without_warnings_says_nothing(answering):
    assert answering(quiet(SOLVED) | {"warnings": []}).solve(CATTANEO, fields=[]).warnings == ()


def test_a_filter_silences_it_or_makes_it_an_exception(answering):
    client = answering(SOLVED)
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", ContactWarning)
        client.solve(CATTANEO, fields=[])
    with warnings.catch_warnings():
        warnings.filterwarnings("ignore", "It is wrong", ContactWarning)
        client.solve(CATTANEO, fields=[])
    with pytest.raises(ContactWarning, match="It is far off"):
        client.solve(CATTANEO, fields=[])
    with pytest.warns(ContactWarning):  # and the client continues
        client.solve(CATTANEO, fields=[])


def test_by_default_each_line_of_a_program_says_it_once(tmp_path):
    with FakeServer(tmp_path, lambda request: [request.result(SOLVED)]) as server:
        (tmp_path / "program.py").write_text(
            f"import contactd\nwith contactd.Client({server.endpoint!r}) as client:\n"
            "    for _ in range(3):\n        client.call('contact.solve')\n    client.call('contact.solve')\n"
        )
        ended = subprocess.run([sys.executable, tmp_path / "program.py"], capture_output=True, text=True, timeout=60, check=True)
    assert ended.stderr.count("ContactWarning: It is wrong. It is far off.") == 2
    assert "program.py:4: ContactWarning" in ended.stderr
    assert "program.py:5: ContactWarning" in ended.stderr


def test_of_many_problems_it_says_which(answering):
    def answer(request):
        ok = {"code": 0, "name": "OK", "message": ""}
        plain = quiet(SOLVED) | {"warnings": []}
        return {"solutions": [{"status": ok, "result": result} for result in (SOLVED, plain, SOLVED)]}

    with pytest.warns(ContactWarning) as caught:
        answering(answer).solve_many([CATTANEO] * 3, fields=[])
    (warning,) = caught
    assert warning.message.sentences[0] == "problems[0], problems[2]: It is wrong."
    assert warning.filename == __file__


def test_of_many_with_the_same_sentence_it_names_a_few():
    parts = {"solutions": [{"result": {"warnings": ["It is wrong."]}}] * 1000}
    (sentence,) = sentences_in("contact.solve_many", parts)
    assert sentence == "problems[0], problems[1], problems[2], problems[3], problems[4] and 995 more: It is wrong."


def test_what_a_wheel_tells_by_place_its_patches_do_not_repeat():
    patches = [{"solution": {"warnings": ["It is cut off."]}}, {"solution": {"warnings": ["It is far off."]}}]
    left = {"warnings": ["The contact at y = -711 mm: It is cut off."], "patches": patches}
    right = {"warnings": [], "patches": [{"solution": {"warnings": ["It is cut off."]}}]}
    assert sentences_in("wheelrail.wheelset", {"left": left, "right": right}) == (
        "left: The contact at y = -711 mm: It is cut off.",
        "right.patches[0]: It is cut off.",
        "left.patches[1]: It is far off.",
    )


def test_an_awaited_call_warns_where_it_is_awaited(tmp_path):
    async def ask(endpoint):
        async with AsyncClient(endpoint, timeout=20) as client:
            await client.solve(CATTANEO, fields=[])  # here

    with FakeServer(tmp_path, lambda request: [request.result(SOLVED)]) as server, pytest.warns(ContactWarning) as caught:
        asyncio.run(ask(server.endpoint))
    (warning,) = caught
    assert warning.filename == __file__
    assert "# here" in Path(__file__).read_text().splitlines()[warning.lineno - 1]


def test_steps_of_sessions_warn_and_a_filter_that_raises_leaves_them_taken(answering):
    opened = example("session.open")

    def answer(request):
        match request.method:
            case "session.open":
                return quiet(opened)
            case "session.step":
                return SOLVED | {"step": request.params["step"]}
        return {}

    client = answering(answer)
    with client.session(CATTANEO) as session:
        with pytest.raises(ContactWarning):
            session.step()
        with pytest.warns(ContactWarning, match="It is wrong") as caught:
            assert session.step().step == 2
        assert [warning.filename for warning in caught] == [__file__]


def test_tables_warn_by_their_evidence(answering):
    with pytest.warns(ContactWarning, match=r"^The mesh is coarse\.$"):
        answering({**example("ic.get"), **TABLE}).call("ic.get")


def test_health_warns(answering):
    with pytest.warns(ContactWarning, match="The store is full"):
        assert answering({"state": "serving", "warnings": ["The store is full."]}).health() == "serving"


def test_lists_of_the_store_do_not(answering):
    answer = copy.deepcopy(example("ic.list"))
    answer["tables"][0]["evidence"] = TABLE["evidence"]
    tables = list(answering(answer | {"next": None}).stored_ics(evidence=True))
    assert tables[0].evidence.warnings == ("The mesh is coarse.",)


def test_in_process_it_warns_too():
    pytest.importorskip("contactd_local")
    beside = WheelRailState(position=WheelsetPosition(y=2000))
    with contactd.local(in_process=True) as client, pytest.warns(ContactWarning, match="above the rail") as caught:
        client.wheel_rail(WheelRailSetup(), beside, fields=[])
    assert [warning.filename for warning in caught] == [__file__]


def test_a_warning_can_be_pickled():
    warning = pickle.loads(pickle.dumps(ContactWarning("It is wrong.", "It is far off.")))
    assert warning.sentences == ("It is wrong.", "It is far off.")


def places(schema, file, part, found, depth=0):
    """Lists the warnings of the schema: names in levels, without the brackets of lists."""
    if not isinstance(schema, dict) or depth > 40:
        return
    if "$ref" in schema:
        name, _, path = schema["$ref"].partition("#")
        at = json.loads((SCHEMAS / (name or file)).read_text())
        for step in filter(None, path.split("/")):
            at = at[step]
        places(at, name or file, part, found, depth + 1)
    for name, member in schema.get("properties", {}).items():
        if name == "warnings":
            found.add(part)
        places(member, file, (*part, name), found, depth + 1)
    places(schema.get("items"), file, part, found, depth + 1)
    for word in ("allOf", "oneOf", "anyOf"):
        for member in schema.get(word, ()):
            places(member, file, part, found, depth + 1)
    for word in ("then", "else"):
        places(schema.get(word), file, part, found, depth + 1)


@pytest.mark.parametrize("path", sorted(SCHEMAS.glob("*.result.json")), ids=lambda path: path.name)
def test_every_place_where_an_answer_has_warnings_is_looked_at(path):
    found = set()
    places(json.loads(path.read_text()), path.name, (), found)
    if path.name not in ("ic.list.result.json", "ic.import.result.json"):
        assert all(set(part) <= _PARTS.keys() for part in found), found
