"""Solutions of which only some arrays are requested."""

import copy
import json
import pickle
from pathlib import Path
from typing import get_args

import numpy as np
import pytest

import contactd
from contactd import (
    Client,
    ContactProblem,
    ContactSolution,
    Estimate,
    Friction,
    Grid,
    Material,
    NotFound,
    Paraboloid,
    ProtocolError,
    StepSolution,
)
from contactd.values.solution import Field
from support import answers
from support.fake_server import FakeServer

PROBLEM = ContactProblem(Grid(3, 2, 1, 1), Material(1, 0), Paraboloid(1, 1), Fn=1)
ARRAYS = ["element_division", "pressure", "traction_x", "traction_y"]
FAILED = {"code": 5, "name": "NOT_FOUND", "message": "Gone."}


def answered(request, **changes):
    """Answers like contact.solve and contact.solve_many, with the requested arrays."""

    def solution(params):
        result, *frames = answers.solution(2, 3)
        left_out = set(ARRAYS) - set(params.get("fields", ARRAYS))
        return {name: part for name, part in result.items() if name not in left_out} | changes, frames

    if request.method == "server.info":
        return [request.result(answers.INFO)]
    if request.method == "contact.solve":
        result, frames = solution(request.params)
        return [request.result(result, *frames)]
    first, *_ = request.params["problems"]
    result, frames = solution(first)
    solved = {"status": {"code": 0, "name": "OK", "message": ""}, "result": result}
    return [request.result({"solutions": [solved, {"status": FAILED}]}, *frames)]


@pytest.fixture
def fake(tmp_path):
    with FakeServer(tmp_path, answered) as server, Client(server.endpoint, timeout=5) as client:
        yield server, client


def test_the_names_are_those_of_the_schema():
    schema = Path(__file__).parents[3] / "proto" / "schema" / "definitions.json"
    fields = json.loads(schema.read_text())["definitions"]["fields"]
    assert list(get_args(Field)) == fields["items"]["enum"]


def test_a_solve_without_fields_says_nothing_of_them_and_has_all_arrays(fake):
    server, client = fake
    solution = client.solve(PROBLEM)
    assert type(solution) is ContactSolution
    assert "fields" not in server.requests[0].params
    assert all(getattr(solution, name).shape == (2, 3) for name in ARRAYS)


@pytest.mark.parametrize(
    ("fields", "sent"),
    [([], []), ("pressure", ["pressure"]), (("pressure", "slip_x"), ["pressure", "slip_x"]), (iter(["slip_y"]), ["slip_y"])],
)
def test_a_solve_has_the_arrays_that_were_named(fake, fields, sent):
    server, client = fake
    solution = client.solve(PROBLEM, fields=fields)
    assert type(solution) is ContactSolution
    assert server.requests[0].params["fields"] == sent
    assert [name for name in get_args(Field) if hasattr(solution, name)] == sorted(sent, key=get_args(Field).index)
    if "slip_x" in sent:
        assert solution.slip_x is None, "without friction there is no slip"
    assert repr(solution).startswith("<ContactSolution on 3 x 2 elements: Fn 9.2")


@pytest.mark.parametrize("name", get_args(Field))
def test_an_array_that_was_not_requested_is_named_by_the_error(fake, name):
    _, client = fake
    solution = client.solve(PROBLEM, fields=[])
    for one in (solution, copy.copy(solution), pickle.loads(pickle.dumps(solution))):
        with pytest.raises(AttributeError, match=f"This solution has no {name}: include it in `fields`"):
            getattr(one, name)


def test_a_solution_has_the_same_arrays_after_a_conversion(fake):
    _, client = fake
    solution = client.solve(PROBLEM, fields="pressure")
    told = contactd.to_dict(solution)
    assert {*ARRAYS} & told.keys() == {"pressure"}
    read = contactd.from_dict(told)
    assert [name for name in ARRAYS if hasattr(read, name)] == ["pressure"]
    assert read.grid == PROBLEM.grid


def test_the_former_name_is_an_alias(fake):
    _, client = fake
    with pytest.warns(DeprecationWarning, match="use ContactSolution"):
        assert contactd.PartialSolution is ContactSolution
    told = {**contactd.to_dict(client.solve(PROBLEM, fields=[])), "type": "PartialSolution", "pressure": None}
    read = contactd.from_dict(told)
    assert type(read) is ContactSolution
    assert not hasattr(read, "pressure")


def test_fields_stand_beside_those_of_the_problem(fake):
    server, client = fake
    given = {name: value for name, value in vars(PROBLEM).items() if value is not None}
    assert not hasattr(client.solve(**given, fields="pressure"), "traction_x")
    client.solve(PROBLEM, fields="pressure")
    assert server.requests[0].params == server.requests[1].params


def test_each_of_many_problems_says_the_same_fields(fake):
    server, client = fake
    solution, error = client.solve_many([PROBLEM, PROBLEM.replace(Fn=2)], fields=iter(["pressure"]))
    assert [problem["fields"] for problem in server.requests[0].params["problems"]] == [["pressure"]] * 2
    assert isinstance(solution, ContactSolution)
    assert (solution.pressure.shape, hasattr(solution, "traction_y")) == ((2, 3), False)
    assert isinstance(error, NotFound)


@pytest.mark.parametrize(
    ("fields", "answer", "problem"),
    [
        ("pressure", {"pressure": None}, "lacks the requested pressure"),
        ("traction_x", {"traction_x": [1.0]}, r"result\.traction_x is a list"),
        ("slip_x", {"slip_x": answers.array(2, (3, 2))}, r"slip_x has shape \[3, 2\] instead of \[2, 3\]"),
        (None, {"slip_y": answers.array(2, (6,))}, r"slip_y has shape \[6\] instead of \[2, 3\]"),
    ],
)
def test_other_arrays_than_were_asked_for_break_the_protocol(tmp_path, fields, answer, problem):
    def script(request):
        return answered(request, **answer)

    with FakeServer(tmp_path, script) as server, Client(server.endpoint, timeout=5) as client:
        for ask in (client.solve, lambda *given, **options: client.solve_many([*given, PROBLEM], **options)):
            with pytest.raises(ProtocolError, match=problem):
                ask(PROBLEM, fields=fields)


@pytest.mark.parametrize("field", ["previous", "initial"])
def test_a_solution_without_its_tractions_is_nowhere_to_start_from(fake, field):
    _, client = fake
    friction = Friction(0.3, rigid_shift=(0, 0))
    forces = client.solve(PROBLEM, fields="traction_x")
    with pytest.raises(TypeError, match=rf"{field} has no pressure, traction_y: include them in `fields`"):
        client.solve(PROBLEM.replace(friction=friction, **{field: forces}))
    client.solve(PROBLEM.replace(friction=friction, **{field: Estimate(traction_x=forces.traction_x)}))
    whole = client.solve(PROBLEM, fields=ARRAYS[1:])
    client.solve(PROBLEM.replace(friction=friction, **{field: whole}))
    with pytest.raises(TypeError, match="solution has no pressure, traction_y"):
        client.subsurface(PROBLEM, forces, points=np.zeros((1, 3)))


def test_a_step_is_a_solution():
    assert issubclass(StepSolution, ContactSolution)
