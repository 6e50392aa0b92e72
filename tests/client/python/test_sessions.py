"""Tests how the client sends the options of sessions."""

from dataclasses import fields
from typing import get_args

import pytest

from contactd import (
    Client,
    ContactProblem,
    ContactSolution,
    Friction,
    Grid,
    Material,
    Paraboloid,
    Rolling,
    Session,
    StepSolution,
)
from contactd.values.solution import Field
from support import answers
from support.fake_server import FakeServer
from support.sessions import NAME, STEP, opened

GRID, STEEL = Grid(3, 2, 1, 1), Material(82000, 0.28)

@pytest.fixture
def fake(tmp_path):
    def script(request):
        if request.method == "session.open":
            return [request.result(opened())]
        if request.method == "session.info":
            grid = {"nx": 3, "ny": 2, "dx": 1, "dy": 1, "x0": 5, "y0": 0}
            return [request.result({**opened(7), "states": 0, "grid": grid, "motion": "rolling"})]
        arrays = {name: answers.array(1, (2, 3)) for name in request.params.get("fields", [])}
        return [request.result({**STEP, **arrays, "step": request.params.get("step", 7)}, *[bytes(48)] * bool(arrays))]

    with FakeServer(tmp_path, script) as server, Client(server.endpoint, timeout=5) as client:
        yield server, client


def test_a_session_takes_a_whole_problem_as_solve_does(fake):
    server, client = fake
    friction = Friction(mu=0.3, rolling=Rolling(xi=1e-3))
    problem = ContactProblem(grid=GRID, upper=STEEL, gap=Paraboloid(1, 1), Fn=5, friction=friction)
    whole = client.session(problem, lease=60)
    by_fields = client.session(grid=GRID, upper=STEEL, gap=Paraboloid(1, 1), Fn=5, friction=friction, lease=60)
    assert server.requests[0].params == server.requests[1].params
    whole.step(force=(-2.0, None))
    by_fields.step(force=(-2.0, None))
    assert server.requests[2].params["friction"] == server.requests[3].params["friction"] == {
        "rolling": {"force": [-2.0, None]}
    }  # fmt: skip


@pytest.mark.parametrize("call", [Client.session, Client.solve])
def test_a_problem_and_fields_are_not_taken_together_nor_anything_else(fake, call):
    _, client = fake
    problem = ContactProblem(grid=GRID, upper=STEEL, gap=Paraboloid(1, 1), Fn=5)
    with pytest.raises(TypeError, match="accepts a ContactProblem or its fields, not both: Fn"):
        call(client, problem, Fn=3)
    with pytest.raises(TypeError, match="problem is Grid.*; it must be of type ContactProblem"):
        call(client, GRID)


def test_a_session_is_joined_by_its_name_where_it_is(fake):
    server, client = fake
    name = client.session(grid=GRID, upper=STEEL).name
    assert name == NAME
    joined = client.join_session(name)
    assert isinstance(joined, Session)
    assert (joined.step_number, joined.lease_seconds, joined.grid) == (7, 60, Grid(3, 2, 1, 1, 5, 0))
    joined.step(Fn=5, force=(None, 1.0))
    assert server.requests[-1].params["step"] == 8
    assert server.requests[-1].params["friction"] == {"rolling": {"force": [None, 1.0]}}, "it rolls"


def test_one_field_may_be_named_without_a_list(fake):
    server, client = fake
    session = client.session(grid=GRID, upper=STEEL)
    session.step(Fn=5, fields="pressure")
    session.step(Fn=5, fields=("pressure", "slip_x"))
    assert [request.params["fields"] for request in server.requests[1:]] == [["pressure"], ["pressure", "slip_x"]]


def test_a_step_asks_for_derivatives_only_where_it_says_so(fake):
    server, client = fake
    session = client.session(grid=GRID, upper=STEEL, derivatives=True)
    session.step(Fn=5)
    session.step(Fn=5, derivatives=False)
    assert [request.params.get("derivatives") for request in server.requests] == [True, None, False]


def test_what_is_no_pair_is_left_to_the_daemon_to_name(fake):
    server, client = fake
    client.session(grid=GRID, upper=STEEL).step(Fn=5, rigid_shift=0.1)
    assert server.requests[1].params["friction"] == {"rigid_shift": 0.1}


def test_a_session_shows_where_it_is_and_not_its_key(fake):
    _, client = fake
    session = client.join_session(NAME)
    text = repr(session)
    assert text == (
        f"<Session 012345... of {client.endpoint}: last step 7, grid 3 x 2 elements of 1 x 1, lease 60 s>"
    )
    assert NAME not in text + session._repr_html_()


def test_a_step_has_the_fields_of_a_solution_and_its_number(fake):
    _, client = fake
    solution = client.session(grid=GRID, upper=STEEL).step(Fn=9)
    assert isinstance(solution, ContactSolution)
    of_step, of_problem = ({field.name for field in fields(kind)} for kind in (StepSolution, ContactSolution))
    assert of_step == of_problem | {"step"}
    assert (solution.step, solution.Fn) == (1, 9)
    assert not any(hasattr(solution, name) for name in get_args(Field))
