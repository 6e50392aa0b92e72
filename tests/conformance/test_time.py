"""Tests deadlines, cancellation and progress: any request ends when its client cancels it."""

import json

import pytest

from conformance.requests import ENDLESS, LONG_BUILD, QUICK_BUILD, SOLVE, TABLE
from conformance.wire import CANCELLED, DEADLINE_EXCEEDED, NOT_FOUND, OK

EXPORT = {**LONG_BUILD, "format": "contact"}
STRESSES = {
    "grid": {"nx": 160, "ny": 160, "dx": 1, "dy": 1},
    "nu": 0.3,
    "pressure": [[(k * k + 7 * l) % 5 for k in range(160)] for l in range(160)],
    # The points form no grid, so every point is a sum over all elements.
    "block": {"x": [n**0.5 for n in range(1000)], "y": [n**0.5 for n in range(1000)], "z": [-1, -2]},
}
MANY = {"problems": [ENDLESS, SOLVE]}
SLOW = pytest.mark.parametrize(
    ("method", "params"),
    [
        ("contact.solve", ENDLESS),
        ("contact.solve_many", MANY),
        ("contact.subsurface", STRESSES),
        ("ic.get", LONG_BUILD),
        ("ic.export", EXPORT),
        ("health.watch", {}),
    ],
    ids=lambda part: part if isinstance(part, str) else "",
)


def nothing_runs(peer):
    """Abandoned jobs end at their next iteration; builds continue for the cache."""
    return all(job["kind"] == "build" for job in peer.ask("job.list").result["jobs"])


def end_builds(peer):
    for job in peer.ask("job.list").result["jobs"]:
        peer.ask("job.cancel", {"job": job["job"]})


@SLOW
def test_a_deadline_is_kept(peer, method, params):
    reply = peer.ask(method, params, timeout_ms=60)
    assert (reply.code, reply.reason) == (DEADLINE_EXCEEDED, "DEADLINE_PASSED")
    assert "60 ms" in reply.text
    assert nothing_runs(peer)
    end_builds(peer)
    assert peer.is_silent()


@SLOW
def test_a_request_is_cancelled_by_its_id(peer, method, params):
    name = peer.send(method, params)
    peer.send("request.cancel", {"id": name})
    replies = [peer.reply(), peer.reply()]
    assert (replies[0].id, replies[0].code, replies[0].reason) == (name, CANCELLED, "REQUEST_CANCELLED")
    assert replies[1].result == {"id": name}
    assert nothing_runs(peer)
    end_builds(peer)
    assert peer.is_silent()


def test_a_running_solve_is_cancelled(peer):
    name = peer.send("contact.solve", ENDLESS)
    assert peer.message().progress["stage"]  # it runs
    peer.cancel(name)
    assert peer.ask("contact.solve", SOLVE).code == OK


def test_a_deadline_does_not_wait_for_a_worker(start):
    daemon = start(workers=1)
    with daemon.peer() as peer:
        running = peer.send("contact.solve", ENDLESS)
        assert peer.message().progress["stage"]
        waiting = peer.send("contact.solve", SOLVE, timeout_ms=50)
        assert [(m.id, m.reason) for m in [peer.reply()]] == [(waiting, "DEADLINE_PASSED")]
        # An envelope is too large for the I/O thread to read, but its deadline counts from its arrival.
        gap = [[0.0123456789] * 80] * 80
        large = peer.send("contact.solve", {**ENDLESS, "gap": {"array": gap}}, timeout_ms=50)
        assert [(m.id, m.reason) for m in [peer.reply()]] == [(large, "DEADLINE_PASSED")]
        peer.cancel(running)


@pytest.mark.parametrize("name", ["never sent", "\u00e9"])
def test_what_is_not_open_cannot_be_cancelled(peer, name):
    reply = peer.ask("request.cancel", {"id": name})
    assert (reply.code, reply.reason) == (NOT_FOUND, "REQUEST_UNKNOWN")


def test_what_has_been_answered_cannot_be_cancelled(peer):
    done = peer.ask("contact.solve", SOLVE)
    assert peer.ask("request.cancel", {"id": done.id}).reason == "REQUEST_UNKNOWN"


def test_a_request_is_its_clients_own(shared, peer):
    name = peer.send("contact.solve", ENDLESS, id="mine")
    assert peer.message().progress["stage"]
    with shared.peer() as stranger:
        assert stranger.ask("request.cancel", {"id": name}).reason == "REQUEST_UNKNOWN"
    peer.cancel(name)


def test_requests_under_one_id_are_cancelled_together(peer):
    for _ in range(2):
        peer.send("health.watch", id="twice")
    peer.send("request.cancel", {"id": "twice"})
    assert [peer.reply().code for _ in range(3)] == [CANCELLED, CANCELLED, OK]


def test_a_cancelled_request_leaves_the_build_to_others(shared, peer):
    with shared.peer() as other:
        first, second = peer.send("ic.get", LONG_BUILD), other.send("ic.get", LONG_BUILD)
        job = peer.message().progress["job"]
        assert other.message().progress["job"] == job
        peer.cancel(first)
        assert [entry["job"] for entry in peer.ask("job.list").result["jobs"]] == [job]
        assert peer.ask("job.cancel", {"job": job}).code == OK
        reply = other.reply()
        assert (reply.id, reply.code, reply.reason) == (second, CANCELLED, "JOB_CANCELLED")


def test_progress_comes_before_the_reply_under_the_same_id(peer):
    name = peer.send("ic.get", {**QUICK_BUILD, "grid": {"nx": 5, "ny": 5, "dx": 1, "dy": 1}})
    messages = [peer.message()]
    while messages[-1].is_progress:
        messages.append(peer.message())
    assert {message.id for message in messages} == {name}
    assert len(messages) > 1
    assert all(0 <= message.progress["fraction"] <= 1 for message in messages[:-1])
    assert messages[-1].code == OK
    assert peer.is_silent()


def test_quick_methods_take_a_deadline_too(peer):
    for method in ["server.info", "job.list"]:
        assert peer.ask(method, timeout_ms=86_400_000).code == OK
    assert peer.ask("ic.get", TABLE, timeout_ms=60_000).code == OK
    assert json.dumps(peer.ask("job.list").result) == '{"jobs": []}'
