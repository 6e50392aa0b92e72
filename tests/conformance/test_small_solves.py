"""Solves that take no longer than waking a thread, and a daemon that looks for work before it sleeps."""

import pytest

from conformance.requests import ENDLESS, SOLVE
from conformance.wire import INVALID_ARGUMENT, OK

QUICK = {**SOLVE, "model": "hertz"}
del QUICK["ics"]


@pytest.fixture(params=[0, 300], ids=["sleeping", "spinning"])
def peer(request, start):
    daemon = start(workers=1, spin_microseconds=request.param)
    with daemon.peer() as peer:
        yield peer


def test_a_small_solve_is_answered_alone_and_beside_others_alike(peer):
    alone = peer.ask("contact.solve", QUICK).result
    names = [peer.send("contact.solve", QUICK) for _ in range(20)]
    replies = {reply.id: reply.result for reply in (peer.reply() for _ in names)}
    assert replies.keys() == set(names)
    assert {reply["forces"]["Fn"] for reply in replies.values()} == {alone["forces"]["Fn"]}


def test_a_small_step_takes_its_turn(peer):
    session = peer.ask("session.open", QUICK).result["session"]
    for number in (1, 2):
        assert peer.ask("session.step", {"session": session, "step": number}).result["step"] == number
    names = [peer.send("session.step", {"session": session, "step": number}) for number in range(3, 30)]
    assert [peer.reply().id for _ in names] == names
    assert peer.ask("session.close", {"session": session}).result["step"] == 29


def test_a_small_solve_that_makes_no_sense_is_refused(peer):
    for grid in ({"nx": -1, "ny": 5, "dx": 1, "dy": 1}, {"nx": 5, "dx": 1, "dy": 1}, [], None):
        assert peer.ask("contact.solve", {**QUICK, "grid": grid}).code == INVALID_ARGUMENT
    assert peer.ask("contact.solve", {**QUICK, "model": 3}).code == INVALID_ARGUMENT
    assert peer.ask("session.step", {"session": 7, "step": 1}).code == INVALID_ARGUMENT


def test_a_small_solve_waits_for_no_worker_only_when_it_is_alone(peer):
    """While the worker is busy, it takes its turn like all others; meanwhile the daemon answers fast requests."""
    endless = peer.send("contact.solve", ENDLESS)
    assert peer.message().progress["stage"]
    waiting = peer.send("contact.solve", QUICK)
    peer.send("server.health")
    reply = peer.reply()
    while reply.id is None:
        reply = peer.reply()
    assert reply.result["state"] == "serving"
    peer.send("request.cancel", {"id": endless})
    ends = {reply.id: reply.code for reply in (peer.reply() for _ in range(3))}
    assert ends[waiting] == OK
