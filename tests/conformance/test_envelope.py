"""Tests frame 0: requirements on a request, and answers to invalid ones."""

import json

import pytest
import zmq

from conformance.requests import QUICK_BUILD, SOLVE, STRESS
from conformance.wire import INVALID_ARGUMENT, OK, UNIMPLEMENTED
from support.daemons import eventually


def request(**fields):
    return json.dumps({"contactd": 1, "id": "x", "method": "server.health", **fields})


def test_a_reply_repeats_version_and_id(peer):
    reply = peer.ask("server.health", id="wheel 3 / \u00e9")
    assert reply.envelope["contactd"] == 1
    assert reply.id == "wheel 3 / \u00e9"
    assert reply.result["state"] == "serving"


def test_params_may_be_left_out(peer):
    assert peer.ask_text('{"contactd": 1, "id": "x", "method": "job.list"}').code == OK


@pytest.mark.parametrize("text", ["", "hello", "{", "{'a': 1}", b"\xff\xfe", "{} {}", "GET / HTTP/1.1\r\n\r\n"])
def test_what_is_no_json_is_refused_without_an_id(peer, text):
    reply = peer.ask_text(text)
    assert (reply.code, reply.reason, reply.id) == (INVALID_ARGUMENT, "NOT_JSON", None)


@pytest.mark.parametrize("text", ["[]", "null", "7", '"text"'])
def test_what_is_no_object_is_refused(peer, text):
    reply = peer.ask_text(text)
    assert (reply.code, reply.reason) == (INVALID_ARGUMENT, "NOT_AN_OBJECT")


@pytest.mark.parametrize("number", ["NaN", "Infinity", "-Infinity", "1e999"])
def test_a_number_that_is_not_finite_is_named(peer, number):
    text = request(params={"grid": {"dx": 17}}).replace("17", number)
    reply = peer.ask_text(text)
    assert (reply.reason, reply.fields, reply.id) == ("NOT_JSON", ["grid.dx"], "x")


@pytest.mark.parametrize(
    ("text", "field"),
    [
        ('{"contactd": 1, "id": "x", "method": "server.health", "method": "job.list"}', "method"),
        ('{"contactd": 1, "id": "x", "method": "ic.get", "params": {"grid": {"nx": 1, "ny": 1, "nx": 2}}}', "grid.nx"),
        ('{"contactd": 1, "id": "x", "method": "contact.solve_many", "params": {"problems": [{}, {"a": 1, "a": 1}]}}', "problems[1].a"),
    ],
)
def test_a_key_that_stands_twice_is_refused_and_named(peer, text, field):
    reply = peer.ask_text(text)
    assert (reply.code, reply.reason, reply.fields, reply.id) == (INVALID_ARGUMENT, "NOT_JSON", [field], "x")


def test_nesting_is_bounded(peer):
    reply = peer.ask_text(request(params={}).replace("{}", '{"a":' * 10_000 + "1" + "}" * 10_000))
    assert (reply.code, reply.reason, reply.id) == (INVALID_ARGUMENT, "NOT_JSON", "x")


@pytest.mark.parametrize(
    ("fields", "named"),
    [
        ({"id": ""}, "id"),
        ({"id": 7}, "id"),
        ({"id": "x" * 129}, "id"),
        ({"method": ""}, "method"),
        ({"method": 1}, "method"),
        ({"params": []}, "params"),
        ({"timeout_ms": 0}, "timeout_ms"),
        ({"timeout_ms": 86_400_001}, "timeout_ms"),
        ({"timeout_ms": 1.5}, "timeout_ms"),
        ({"arrays": "base64"}, "arrays"),
        ({"priority": "urgent"}, "priority"),
        ({"metadata": []}, "metadata"),
        ({"metadata": {"a": [1]}}, "metadata.a"),
        ({"metadata": {"a": None}}, "metadata.a"),
        ({"metadata": {"a": "x" * 257}}, "metadata.a"),
        ({"metadata": {"client": 1}}, "metadata.client"),
        ({"metadata": {str(n): n for n in range(17)}}, "metadata"),
        ({"metadata": {"x" * 65: 1}}, "metadata"),
        ({"contactd": "1"}, "contactd"),
        ({"extra": 1}, "extra"),
    ],
)
def test_an_envelope_that_breaks_its_schema_is_refused_by_field(peer, fields, named):
    reply = peer.ask_text(request(**fields))
    assert (reply.code, reply.reason) == (INVALID_ARGUMENT, "ENVELOPE_INVALID")
    assert named in reply.fields


@pytest.mark.parametrize("missing", ["contactd", "id", "method"])
def test_a_required_field_of_the_envelope_is_missed_by_name(peer, missing):
    envelope = json.loads(request())
    del envelope[missing]
    reply = peer.ask_text(json.dumps(envelope))
    assert (reply.reason, reply.fields) == ("ENVELOPE_INVALID", [missing])
    assert reply.id == (None if missing == "id" else "x")


@pytest.mark.parametrize(("version", "side"), [(0, "client"), (2, "daemon"), (-1, "client"), (10**9, "daemon")])
def test_another_version_is_told_which_side_to_upgrade(peer, version, side):
    reply = peer.ask_text(request(contactd=version, what="another version may ask in other fields"))
    assert (reply.code, reply.reason, reply.id) == (UNIMPLEMENTED, "PROTOCOL_VERSION", "x")
    assert reply.details["versions"] == peer.ask("server.info").result["protocol_versions"] == [1]
    assert f"upgrade the {side}" in reply.text


def test_an_unknown_method_is_unimplemented_and_the_known_ones_are_named(peer):
    reply = peer.ask("contact.solv", SOLVE)
    assert (reply.code, reply.reason) == (UNIMPLEMENTED, "UNKNOWN_METHOD")
    assert "contact.solve" in reply.text


@pytest.mark.parametrize("method", ["server.info", "server.describe", "job.list", "health.watch"])
def test_an_unknown_parameter_is_refused_by_name(peer, method):
    reply = peer.ask(method, {"what": 1})
    assert (reply.code, reply.reason, reply.fields) == (INVALID_ARGUMENT, "FIELD_INVALID", ["what"])


def test_every_wrong_field_of_a_request_is_named_at_once(peer):
    params = {**SOLVE, "grid": {**SOLVE["grid"], "nx": 0, "what": 1}, "approach": "deep"}
    reply = peer.ask("contact.solve", params)
    assert reply.reason == "FIELD_INVALID"
    assert {"grid.nx", "grid.what", "approach"} <= set(reply.fields)


def test_a_socket_serves_many_requests_at_once_each_with_one_reply(peer):
    names = {peer.send("contact.solve", SOLVE) for _ in range(20)}
    assert {peer.reply().id for _ in names} == names
    assert peer.is_silent()


def test_a_req_socket_gets_its_reply_and_no_progress(shared):
    with shared.peer(zmq.REQ) as peer:
        peer.send("ic.get", {**QUICK_BUILD, "grid": {"nx": 3, "ny": 3, "dx": 1, "dy": 1}})
        assert peer.message().result["origin"] == "built"
        assert peer.ask("contact.subsurface", STRESS).code == OK


def test_metadata_client_stands_in_the_log(shared, peer):
    peer.ask("server.health", metadata={"client": "sled 9.1", "wheel": 3, "left": True})
    eventually(lambda: "sled 9.1" in shared.log)  # the reply does not wait for the log
