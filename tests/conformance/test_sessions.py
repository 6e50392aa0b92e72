"""Sessions: a number is answered once, what fails changes nothing, states are gone back to, and the end is the end."""

import pytest

from conformance.requests import SOLVE
from conformance.wire import INVALID_ARGUMENT, NOT_FOUND, OK

ABORTED, FAILED_PRECONDITION = 10, 9


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
