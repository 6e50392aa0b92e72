"""Tests the contents and the numbers of steps of a session."""

import inspect
import json
from pathlib import Path
from typing import get_type_hints

import numpy as np
import pytest

from contactd import (
    Client,
    FailedPrecondition,
    Grid,
    InvalidArgument,
    Material,
    SavedState,
    Session,
    StepInput,
    TimeoutExpired,
    WheelRailStepInput,
)
from support.fake_server import FakeServer
from support.sessions import NAME, STEP, opened

SCHEMA = json.loads((Path(__file__).parents[3] / "proto" / "schema" / "session.step.params.json").read_text())
TOO_MUCH, LOST = 1e9, 2e9  # forces that the fake refuses, or never answers


@pytest.fixture
def session(tmp_path):
    """Provides a daemon that is at step 7 when a state is restored; `asked` contains its requests."""
    asked = []

    def script(request):
        if request.method == "session.open":
            return [request.result(opened())]
        if request.method == "session.restore":
            return [request.result({"step": 7})]
        if request.method != "session.step":
            return []
        asked.append((request.params["step"], request.params.get("again")))
        if request.params["Fn"] == LOST:
            return []
        if request.params["Fn"] == TOO_MUCH:
            return [request.failure(9, "Too much.")]
        return [request.result({**STEP, "step": request.params["step"]})]

    with FakeServer(tmp_path, script) as server, Client(server.endpoint, timeout=5) as client:
        session = client.session(grid=Grid(3, 2, 1, 1), upper=Material(1, 0))
        session.asked = asked
        yield session


def test_a_step_of_many_says_what_a_single_one_does():
    hints = get_type_hints(Session.step)
    words = set(inspect.signature(Session.step).parameters) - {"self", "timeout", "on_progress", "progress"}
    assert get_type_hints(StepInput) == {word: hints[word] for word in words}


def test_a_step_can_say_what_the_schema_knows():
    known = set(SCHEMA["properties"]) - {"session", "step", "wheelrail"}
    assert known <= StepInput.__annotations__.keys()


def test_a_step_of_a_wheel_can_say_what_the_schema_knows():
    known = {*SCHEMA["properties"]["wheelrail"]["properties"], "fields", "again"}
    assert known == set(WheelRailStepInput.__annotations__)


def test_steps_count_on_from_the_last_one_that_was_solved(session):
    session.step(Fn=1)
    with pytest.raises(FailedPrecondition):
        session.step(Fn=TOO_MUCH)
    assert session.step(Fn=2).step == session.step_number == 2
    assert session.asked == [(1, None), (2, None), (2, None)]


def test_again_takes_back_the_step_that_was_asked_for_last(session):
    session.step(Fn=1)
    session.step(Fn=1)
    assert session.step(Fn=2, again=True).step == 2
    assert session.step(Fn=3, again=True).step == 2
    assert session.step(Fn=1).step == 3
    assert session.asked == [(1, None), (2, None), (2, True), (2, True), (3, None)]


def test_again_after_a_step_that_failed_does_not_take_the_one_before_back(session):
    session.step(Fn=1)
    with pytest.raises(FailedPrecondition):
        session.step(Fn=TOO_MUCH)
    with pytest.raises(FailedPrecondition):
        session.step(Fn=TOO_MUCH, again=True)
    assert session.step(Fn=1, again=True).step == 2
    assert session.asked == [(1, None), (2, None), (2, True), (2, True)]


def test_a_step_that_never_left_was_asked_for_too(session):
    session.step(Fn=1)
    for wrong in ({"mu": np.ma.masked_all((2, 3))}, {"gap": np.full((2, 3), np.nan)}):
        with pytest.raises(InvalidArgument):
            session.step(**wrong)
        session.step(Fn=1, again=True)
    assert session.asked == [(1, None), (2, True), (3, True)]


def test_again_after_an_answer_that_was_lost_asks_for_the_same_number(session):
    session.retries = 0
    session.step(Fn=1)
    with pytest.raises(TimeoutExpired):
        session.step(Fn=LOST, timeout=0.05)
    assert session.step(Fn=1, again=True).step == 2


def test_again_before_the_first_step_is_the_first_step(session):
    assert session.step(Fn=1, again=True).step == 1


def test_again_after_a_restore_takes_the_restored_step_back(session):
    session.step(Fn=1)
    with pytest.raises(FailedPrecondition):
        session.step(Fn=TOO_MUCH)
    session.restore(SavedState("state-1", 7))
    assert session.step(Fn=1, again=True).step == 7
    assert session.step(Fn=1).step == 8


def test_again_in_a_session_that_was_joined_takes_the_last_step_back(tmp_path):
    grid = {"nx": 3, "ny": 2, "dx": 1, "dy": 1}

    def script(request):
        if request.method == "session.info":
            return [request.result({**opened(7), "grid": grid, "motion": "shift"})]
        return [request.result({**STEP, "step": request.params["step"]})]

    with FakeServer(tmp_path, script) as server, Client(server.endpoint, timeout=5) as client:
        assert client.join_session(NAME).step(Fn=1, again=True).step == 7
