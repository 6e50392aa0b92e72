"""Tests steps of several sessions in one message, and repeated steps."""

import numpy as np
import pytest

from conformance.requests import ENDLESS, SOLVE
from conformance.wire import (
    CANCELLED,
    DEADLINE_EXCEEDED,
    FAILED_PRECONDITION,
    INVALID_ARGUMENT,
    NOT_FOUND,
    OK,
)


@pytest.fixture
def sessions(peer):
    """Provides the names of three sessions."""
    names = [peer.ask("session.open", SOLVE).result["session"] for _ in range(3)]
    yield names
    for name in names:
        assert peer.ask("session.close", {"session": name}).code == OK


def ask(peer, *steps, **options):
    return peer.ask("session.step_many", {"steps": list(steps)}, **options)


def step(session, number=1, **changes):
    return {"session": session, "step": number, **changes}


def codes(reply):
    return [one["status"]["code"] for one in reply.result["steps"]]


def test_each_step_is_answered_as_if_it_had_come_alone(peer, sessions):
    loads = (0.01, 0.015, 0.02)
    alone = [peer.ask("contact.solve", {**SOLVE, "approach": load}).result for load in loads]
    reply = ask(peer, *(step(name, approach=load) for name, load in zip(sessions, loads, strict=True)))
    assert codes(reply) == [OK, OK, OK]
    assert [one["result"]["step"] for one in reply.result["steps"]] == [1, 1, 1]
    assert [one["result"]["forces"] for one in reply.result["steps"]] == [one["forces"] for one in alone]


def test_arrays_stand_in_the_order_of_the_steps(peer, sessions):
    steps = [step(name, approach=0.01 + 0.002 * i, fields=["pressure"]) for i, name in enumerate(sessions)]
    many = ask(peer, *steps)
    assert len(many.frames) == 3
    frames = [one["result"]["pressure"]["$array"]["frame"] for one in many.result["steps"]]
    assert frames == [1, 2, 3]
    again = [peer.ask("session.step", one) for one in steps]  # each session still has its own answer
    assert [one.frames[0] for one in again] == many.frames


def test_one_that_fails_does_not_fail_the_others(peer, sessions):
    reply = ask(peer, step(sessions[0]), step(sessions[1], friction={"rotation": 0}), step("0" * 32), step(sessions[2], 7))
    assert codes(reply) == [OK, INVALID_ARGUMENT, NOT_FOUND, FAILED_PRECONDITION]
    assert reply.result["steps"][1]["status"]["details"]["violations"][0]["field"] == "friction.mu"
    steps_taken = [peer.ask("session.info", {"session": name}).result["step"] for name in sessions]
    assert steps_taken == [1, 0, 0]


def test_steps_of_one_session_are_taken_in_their_order(peer, sessions):
    name = sessions[0]
    reply = ask(peer, *(step(name, number) for number in (1, 2, 3)))
    assert [one["result"]["step"] for one in reply.result["steps"]] == [1, 2, 3]


def test_the_same_steps_asked_for_twice_are_answered_twice(peer, sessions):
    steps = [step(name, fields=["pressure"]) for name in sessions]
    first, second = ask(peer, *steps), ask(peer, *steps)
    assert (second.result, second.frames) == (first.result, first.frames)


def test_steps_are_tried_again_together(peer, sessions):
    first = ask(peer, *(step(name, approach=0.02) for name in sessions[:2]), step(sessions[2], friction={"rotation": 0}))
    assert codes(first) == [OK, OK, INVALID_ARGUMENT]
    tried = ask(peer, *(step(name, approach=0.01, again=True) for name in sessions))
    assert codes(tried) == [OK, OK, OK]
    alone = peer.ask("contact.solve", {**SOLVE, "approach": 0.01}).result["forces"]
    assert [one["result"]["forces"] for one in tried.result["steps"]] == [alone] * 3
    assert {peer.ask("session.info", {"session": name}).result["step"] for name in sessions} == {1}


def test_a_step_solved_anew_starts_where_the_first_one_started(peer, sessions):
    name, other, _ = sessions
    history = [{"friction": {"mu": 0.3, "rigid_shift": [shift, 0]}} for shift in (0.002, -0.001, 0.0005)]
    peer.ask("session.step", step(name, 1, **history[0]))
    peer.ask("session.step", step(name, 2, **history[1]))
    anew = peer.ask("session.step", step(name, 2, again=True, **history[2]))
    peer.ask("session.step", step(other, 1, **history[0]))
    straight = peer.ask("session.step", step(other, 2, **history[2]))
    assert anew.result["forces"] == straight.result["forces"]


def test_without_again_another_step_in_place_of_the_last_one_is_refused(peer, sessions):
    ask(peer, step(sessions[0]))
    reply = ask(peer, step(sessions[0], approach=0.01))
    assert reply.result["steps"][0]["status"]["details"]["reason"] == "STEP_DIFFERS"


def test_a_restored_state_can_be_taken_back_once_more(peer, sessions):
    name = sessions[0]
    peer.ask("session.step", step(name, 1))
    state = peer.ask("session.save", {"session": name}).result["state"]
    peer.ask("session.step", step(name, 2))
    peer.ask("session.restore", {"session": name, "state": state})
    assert peer.ask("session.step", step(name, 1, again=True, approach=0.01)).result["step"] == 1


@pytest.mark.parametrize(
    ("params", "field"),
    [
        ({}, "steps"),
        ({"steps": []}, "steps"),
        ({"steps": 3}, "steps"),
        ({"steps": [3]}, "steps[0]"),
        ({"steps": [{"session": "0" * 32}]}, "steps[0].step"),
        ({"steps": [{"session": 7, "step": 1}]}, "steps[0].session"),
        ({"steps": [{"session": "0" * 32, "step": 1, "again": "yes"}]}, "steps[0].again"),
    ],
)
def test_what_is_no_list_of_steps_is_refused_whole(peer, params, field):
    reply = peer.ask("session.step_many", params)
    assert reply.code == INVALID_ARGUMENT
    assert reply.fields == [field]


def test_a_message_with_one_wrong_step_moves_no_session(peer, sessions):
    reply = peer.ask("session.step_many", {"steps": [step(sessions[0]), {"session": sessions[1]}]})
    assert reply.code == INVALID_ARGUMENT
    assert peer.ask("session.info", {"session": sessions[0]}).result["step"] == 0


def test_a_frame_that_no_step_uses_is_refused(peer, sessions):
    reply = peer.ask("session.step_many", {"steps": [step(sessions[0])]}, b"\0" * 8)
    assert reply.code == INVALID_ARGUMENT
    assert peer.ask("session.info", {"session": sessions[0]}).result["step"] == 0


def test_many_steps_can_be_given_up(peer, sessions):
    endless = peer.ask("session.open", ENDLESS).result["session"]
    reply = ask(peer, step(endless), step(sessions[0]), timeout_ms=200)
    assert reply.code == DEADLINE_EXCEEDED
    name = peer.send("session.step_many", {"steps": [step(endless)]})
    peer.send("request.cancel", {"id": name})
    assert sorted([peer.reply().code, peer.reply().code]) == [OK, CANCELLED]
    assert peer.ask("session.close", {"session": endless}).result == {"step": 0}


def test_a_solve_sends_the_arrays_that_it_is_asked_for(peer):
    everything = peer.ask("contact.solve", SOLVE)
    forces = peer.ask("contact.solve", {**SOLVE, "fields": []})
    pressure = peer.ask("contact.solve", {**SOLVE, "fields": ["pressure"]})
    assert (len(forces.frames), len(pressure.frames)) == (0, 1)
    assert forces.result["forces"] == everything.result["forces"]
    assert "pressure" not in forces.result
    frame = everything.result["pressure"]["$array"]["frame"]
    assert pressure.frames[0] == everything.frames[frame - 1]


def test_each_of_many_problems_names_its_arrays(peer):
    problems = [{**SOLVE, "fields": []}, {**SOLVE, "fields": ["traction_x"]}, SOLVE]
    solutions = peer.ask("contact.solve_many", {"problems": problems}).result["solutions"]
    arrays = {"element_division", "pressure", "traction_x", "traction_y", "slip_x", "slip_y"}
    assert [len(arrays & one["result"].keys()) for one in solutions] == [0, 1, 4]


def test_a_step_is_told_by_its_own_arrays_alone(peer, sessions):
    def gapped(session, frame):
        return step(session, gap={"array": {"$array": {"frame": frame, "dtype": "<f8", "shape": [5, 6]}}})

    flat, raised = np.zeros((5, 6)).tobytes(), np.full((5, 6), 0.001).tobytes()
    many = peer.ask("session.step_many", {"steps": [gapped(sessions[0], 1), gapped(sessions[1], 2)]}, flat, raised)
    assert codes(many) == [OK, OK]
    alone = peer.ask("session.step", gapped(sessions[0], 1), flat)
    assert alone.result == many.result["steps"][0]["result"]
    assert peer.ask("session.step", gapped(sessions[0], 1), raised).reason == "STEP_DIFFERS"
