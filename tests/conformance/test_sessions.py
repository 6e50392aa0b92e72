"""Tests sessions: each number is answered once, failures change nothing, states can be restored, and ended sessions
stay ended."""

import time

import pytest

from conformance.requests import ENDLESS, SOLVE
from conformance.wire import (
    ABORTED,
    CANCELLED,
    DEADLINE_EXCEEDED,
    FAILED_PRECONDITION,
    INVALID_ARGUMENT,
    NOT_FOUND,
    OK,
    RESOURCE_EXHAUSTED,
)


@pytest.fixture
def session(peer):
    name = peer.ask("session.open", SOLVE).result["session"]
    yield name
    peer.ask("session.close", {"session": name})


def step(peer, session, number, **changes):
    return peer.ask("session.step", {"session": session, "step": number, **changes})


def test_a_step_answers_with_the_arrays_that_it_names(peer, session):
    plain = step(peer, session, 1)
    assert (plain.code, plain.frames) == (OK, [])
    assert len(step(peer, session, 2, fields=["pressure", "element_division"]).frames) == 2


def test_a_step_has_derivatives_as_it_or_the_session_says(peer, session):
    assert "derivatives" not in step(peer, session, 1).result
    assert step(peer, session, 2, derivatives=True).result["derivatives"]["Fn"]["approach"] > 0
    assert "derivatives" not in step(peer, session, 3).result
    eager = peer.ask("session.open", {**SOLVE, "derivatives": True}).result["session"]
    assert set(step(peer, eager, 1, Fn=5).result["derivatives"]["approach"]) == {"Fn"}
    assert "derivatives" not in step(peer, eager, 2, derivatives=False).result
    peer.ask("session.close", {"session": eager})


def test_the_last_number_is_answered_again(peer, session):
    first = step(peer, session, 1, fields=["pressure"])
    again = step(peer, session, 1, fields=["pressure"])
    assert (again.result, again.frames) == (first.result, first.frames)


def test_any_other_number_is_out_of_order(peer, session):
    for number in (2, 7):
        reply = step(peer, session, number)
        assert (reply.code, reply.reason) == (FAILED_PRECONDITION, "STEP_OUT_OF_ORDER")
    assert step(peer, session, 1).code == OK
    reply = step(peer, session, 1, fields=["pressure"])
    assert (reply.code, reply.reason) == (FAILED_PRECONDITION, "STEP_DIFFERS")


def test_a_step_that_fails_leaves_its_number_free(peer, session):
    assert step(peer, session, 1, friction={"mu": -1}).code == INVALID_ARGUMENT
    assert step(peer, session, 1).code == OK


def test_a_step_that_does_not_converge_is_aborted(peer):
    settings = {"normal": {"tolerance": 1e-14, "max_iterations": 1}}
    session = peer.ask("session.open", {**SOLVE, "settings": settings}).result["session"]
    reply = step(peer, session, 1)
    assert (reply.code, reply.reason) == (ABORTED, "NOT_CONVERGED")
    assert peer.ask("session.close", {"session": session}).result["step"] == 0


def test_a_saved_state_is_restored_with_its_number(peer, session):
    step(peer, session, 1)
    state = peer.ask("session.save", {"session": session}).result
    assert state["step"] == 1
    for _ in range(2):
        assert step(peer, session, 2).code == OK
        restored = peer.ask("session.restore", {"session": session, "state": state["state"]})
        assert restored.result["step"] == 1
    assert peer.ask("session.forget", {"session": session, "state": state["state"]}).code == OK
    gone = peer.ask("session.restore", {"session": session, "state": state["state"]})
    assert (gone.code, gone.reason) == (NOT_FOUND, "STATE_UNKNOWN")


def test_a_closed_session_is_not_found_and_none_is_listed_by_name(peer):
    session = peer.ask("session.open", {**SOLVE, "lease_seconds": 60}).result["session"]
    listed = peer.ask("session.list")
    assert [entry["lease_seconds"] for entry in listed.result["sessions"]].count(60) == 1
    assert session not in str(listed.envelope)
    assert peer.ask("session.close", {"session": session}).code == OK
    for method in ("session.step", "session.save", "session.close"):
        more = {"step": 1} if method == "session.step" else {}
        reply = peer.ask(method, {"session": session, **more})
        assert (reply.code, reply.reason) == (NOT_FOUND, "SESSION_UNKNOWN")


def test_a_session_that_nobody_uses_expires(peer):
    session = peer.ask("session.open", {**SOLVE, "lease_seconds": 0.1}).result["session"]
    while any(entry["lease_seconds"] == 0.1 for entry in peer.ask("session.list").result["sessions"]):
        time.sleep(0.02)
    reply = step(peer, session, 1)
    assert (reply.code, reply.reason) == (NOT_FOUND, "SESSION_EXPIRED")


def test_sessions_and_their_states_are_bounded(start):
    daemon = start(sessions={"max_sessions": 1, "max_states": 1})
    with daemon.peer() as peer:
        session = peer.ask("session.open", SOLVE).result["session"]
        second = peer.ask("session.open", SOLVE)
        assert (second.code, second.reason) == (RESOURCE_EXHAUSTED, "SESSION_LIMIT")
        assert peer.ask("session.save", {"session": session}).code == OK
        second = peer.ask("session.save", {"session": session})
        assert (second.code, second.reason) == (RESOURCE_EXHAUSTED, "SESSION_LIMIT")
        assert peer.ask("session.close", {"session": session}).code == OK
        assert peer.ask("session.open", SOLVE).code == OK


def test_a_step_that_is_given_up_leaves_its_number_free(peer):
    session = peer.ask("session.open", ENDLESS).result["session"]
    reply = peer.ask("session.step", {"session": session, "step": 1}, timeout_ms=60)
    assert (reply.code, reply.reason) == (DEADLINE_EXCEEDED, "DEADLINE_PASSED")
    name = peer.send("session.step", {"session": session, "step": 1})
    peer.send("request.cancel", {"id": name})
    assert [peer.reply().code, peer.reply().code] == [CANCELLED, OK]
    assert step(peer, session, 1, friction={"rolling": {"steps": 1}}).code == OK
    assert peer.ask("session.close", {"session": session}).result == {"step": 1}


def test_two_sockets_share_a_session_by_its_name(shared, peer, session):
    assert step(peer, session, 1).code == OK
    with shared.peer() as other:
        assert step(other, session, 2).code == OK


def test_who_is_handed_the_name_of_a_session_learns_where_it_is(shared, peer, session):
    assert peer.ask("session.info", {"session": session}).result["step"] == 0
    step(peer, session, 1)
    state = peer.ask("session.save", {"session": session}).result["state"]
    with shared.peer() as other:
        info = other.ask("session.info", {"session": session}).result
        assert (info["step"], info["states"]) == (1, 1)
        assert (info["grid"]["nx"], info["grid"]["ny"]) == (SOLVE["grid"]["nx"], SOLVE["grid"]["ny"])
        assert step(other, session, info["step"] + 1).code == OK
    peer.ask("session.forget", {"session": session, "state": state})


def test_a_session_tells_its_step_after_the_requests_that_came_before(peer):
    session = peer.ask("session.open", SOLVE).result["session"]
    for number in (1, 2, 3):
        peer.send("session.step", {"session": session, "step": number})
    peer.send("session.info", {"session": session})
    assert [peer.reply().result["step"] for _ in range(4)] == [1, 2, 3, 3]
    assert peer.ask("session.close", {"session": session}).code == OK


def test_steps_sent_without_awaiting_answers_run_in_their_order(peer):
    session = peer.ask("session.open", SOLVE).result["session"]
    numbers = list(range(1, 101))
    for number in numbers:
        peer.send("session.step", {"session": session, "step": number}, priority="low" if number % 3 else "high")
    replies = [peer.reply() for _ in numbers]
    assert [(reply.code, reply.result["step"]) for reply in replies] == [(OK, number) for number in numbers]
    assert peer.ask("session.close", {"session": session}).code == OK


def test_a_session_that_is_none_tells_nothing(peer):
    reply = peer.ask("session.info", {"session": "0" * 32})
    assert (reply.code, reply.reason) == (NOT_FOUND, "SESSION_UNKNOWN")


# --- wheels on rails --------------------------------------------------------------------------------------------------

WHEEL = {"wheelrail": {"setup": {"side": "left", "dx": 1, "dy": 1, "friction": {"mu": 0.3}}}}
ROLLING = {"velocity": {"x": 2000, "pitch": -4.3}, "Fz": 10000}


@pytest.fixture
def wheel(peer):
    name = peer.ask("session.open", WHEEL).result["session"]
    yield name
    peer.ask("session.close", {"session": name})


def test_a_wheel_is_stepped_by_its_state(peer, wheel):
    wheelrail = {"state": {**ROLLING, "position": {"y": 1}}, "friction": {"mu": 0.2}, "gap": True}
    first = step(peer, wheel, 1, wheelrail=wheelrail, fields=["pressure"])
    assert (first.code, first.result["step"], len(first.frames)) == (OK, 1, 2 * len(first.result["wheelrail"]["patches"]))
    alone = peer.ask("wheelrail.solve", {**WHEEL["wheelrail"], "state": ROLLING, "fields": []}).result
    second = step(peer, wheel, 2, wheelrail={"state": ROLLING})
    assert second.frames == []
    assert second.result["wheelrail"]["forces"]["track"]["Fy"] == pytest.approx(alone["forces"]["track"]["Fy"], abs=0.05)


def test_a_wheels_session_is_told_by_its_side(peer, wheel):
    step(peer, wheel, 1, wheelrail={"state": ROLLING})
    info = peer.ask("session.info", {"session": wheel}).result
    assert (info["side"], info["step"]) == ("left", 1)
    assert "grid" not in info
    assert peer.ask("session.list").result["sessions"][-1]["elements"] > 0


def test_wheels_and_contacts_step_in_one_message(peer, wheel, session):
    wheel_step = {"session": wheel, "step": 1, "wheelrail": {"state": ROLLING}}
    steps = [wheel_step, {"session": session, "step": 1}, {"session": session, "step": 2, "wheelrail": {"state": {}}}]
    answers = peer.ask("session.step_many", {"steps": steps}).result["steps"]
    assert [answer["status"]["code"] for answer in answers] == [OK, OK, INVALID_ARGUMENT]
    assert answers[2]["status"]["details"]["violations"][0]["field"] == "wheelrail"
