"""Tests the limits of server.info in both directions; exceeding them affects only the sender."""

import json

import pytest

from conformance.requests import SOLVE, TABLE
from conformance.wire import INVALID_ARGUMENT, OK

LIMITS = {"max_frame_bytes": 4096, "max_frames": 3, "max_message_bytes": 6000, "max_grid_elements": 100}


@pytest.fixture(scope="module")
def strict():
    from conformance.wire import Daemon

    daemon = Daemon({"limits": LIMITS})
    yield daemon
    daemon.finish()


@pytest.fixture
def guest(strict):
    with strict.peer() as peer:
        yield peer


def test_limits_are_published(guest):
    limits = guest.ask("server.info").result["limits"]
    assert {name: limits[name] for name in LIMITS} == LIMITS
    assert {"max_array_elements", "max_queue", "max_queue_per_client", "max_queue_bytes"} <= limits.keys()


@pytest.mark.parametrize(
    "frames", [[bytes(4097)], [b"", b"", b""], [bytes(4000), bytes(4000)]], ids=["frame", "frames", "message"]
)
def test_a_message_beyond_them_is_refused_in_words(guest, frames):
    reply = guest.ask("server.health", {}, *frames)
    assert (reply.code, reply.reason) == (INVALID_ARGUMENT, "LIMIT_EXCEEDED")
    assert guest.ask("server.health").code == OK


def test_an_envelope_beyond_them_is_refused(guest):
    reply = guest.ask_text(" " * 4097)
    assert (reply.code, reply.reason) == (INVALID_ARGUMENT, "LIMIT_EXCEEDED")


@pytest.mark.parametrize(
    ("method", "params", "field"),
    [
        ("ic.get", {**TABLE, "grid": {**TABLE["grid"], "nx": 31, "ny": 31}}, "grid.nx"),
        ("contact.solve", {**SOLVE, "grid": {**SOLVE["grid"], "nx": 31, "ny": 31}}, "grid.nx"),
        ("contact.solve_many", {"problems": [SOLVE] * 4}, "problems"),
    ],
    ids=lambda part: part if isinstance(part, str) else "",
)
def test_grids_are_bounded_before_anything_is_made_of_them(guest, method, params, field):
    reply = guest.ask(method, params)
    assert (reply.code, reply.reason, reply.fields) == (INVALID_ARGUMENT, "LIMIT_EXCEEDED", [field])


def test_a_frame_beyond_all_measure_costs_its_sender_only(strict, guest):
    with strict.peer() as careless:
        careless.send("server.health", {}, bytes(100_000))
    assert guest.ask("server.health").code == OK


@pytest.mark.parametrize("method", ["server.info", "server.describe", "server.metrics"])
def test_the_server_answers_for_itself_whatever_the_limits(guest, method):
    reply = guest.ask(method)
    assert reply.code == OK
    assert method == "server.info" or len(json.dumps(reply.envelope)) > LIMITS["max_message_bytes"]
