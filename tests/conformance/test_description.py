"""Tests that the daemon conforms to its own description."""

import pytest
from jsonschema import Draft7Validator
from referencing import Registry
from referencing.jsonschema import DRAFT7

from conformance.requests import HEAT, SOLVE, STRESS, TABLE
from conformance.wire import NOT_FOUND, OK


@pytest.fixture(scope="module")
def document(shared):
    with shared.peer() as peer:
        return peer.ask("server.describe").result


def test_every_method_that_is_described_exists_and_no_other(document, peer):
    described = {method["name"] for method in document["methods"]}
    listed = peer.ask("no.such.method").text.split("there are ")[1].rstrip(".").split(", ")
    assert described == set(listed)


def test_every_message_is_described_with_examples_that_conform(document):
    registry = Registry().with_resource("urn:contactd", DRAFT7.create_resource(document))
    schemas = document["components"]["schemas"]
    for name, schema in schemas.items():
        Draft7Validator.check_schema(schema)
        assert schema["description"], name
        assert schema["examples"], name
        validator = Draft7Validator({"$ref": f"urn:contactd#/components/schemas/{name}"}, registry=registry)
        for example in schema["examples"]:
            assert [error.message for error in validator.iter_errors(example)] == [], name


def test_every_parameter_is_described(document):
    for method in document["methods"]:
        properties = document["components"]["schemas"][f"{method['name']}.params"]["properties"]
        assert {param["name"] for param in method["params"]} == properties.keys()
        assert all(param["description"] for param in method["params"])


@pytest.mark.parametrize("arrays", ["frame", "list"])
@pytest.mark.parametrize(
    ("method", "params"),
    [
        ("ic.get", TABLE),
        ("ic.get", {**TABLE, "components": ["zz"]}),
        ("ic.export", {**TABLE, "format": "hdf5"}),
        ("ic.export", {**TABLE, "format": "contact"}),
        ("contact.solve", SOLVE),
        ("contact.solve", {**SOLVE, "friction": {"mu": 0.3, "rigid_shift": [0.001, 0]}}),
        ("contact.solve", {**SOLVE, "friction": {"mu": 0.3, "rolling": {"xi": 0.001}}}),
        ("contact.solve", {**SOLVE, "model": "hertz"}),
        ("contact.solve_many", {"problems": [SOLVE, {**SOLVE, "gap": {"array": [[1]]}}]}),
        ("contact.subsurface", STRESS),
        ("contact.temperature", HEAT),
        ("wheelrail.solve", {"setup": {"friction": {"mu": 0.3}, "dx": 1, "dy": 1}, "state": {"Fz": 10000}}),
        ("wheelrail.wheelset", {"setup": {"dx": 1, "dy": 1}, "state": {"Fz_left": 1e4, "Fz_right": 9e3}}),
        ("wheelrail.geometry", {"contacts": {"shifts": [1]}, "conicity": {"amplitudes": [2]}, "profiles": True}),
        ("wheelrail.geometry", {"states": [{"position": {"y": 3}, "Fz": 10000}]}),
    ],
    ids=lambda part: part if isinstance(part, str) else "",
)
def test_every_answer_is_as_described(peer, method, params, arrays):
    # At its end, the suite checks every received message against the description.
    assert peer.ask(method, params, arrays=arrays).code == OK


def test_answers_of_methods_without_parameters_are_as_described(document, peer):
    for method in document["methods"]:
        if not method["params"] and method["name"] != "health.watch":  # which ends with the daemon
            assert peer.ask(method["name"]).code == OK


@pytest.mark.parametrize("arrays", ["frame", "list"])
def test_the_last_solve_and_its_pressures_are_as_described(peer, arrays):
    solved = peer.ask("contact.solve", SOLVE)
    last = peer.ask("solves.recent").result["solves"][0]
    assert (last["method"], last["id"]) == ("contact.solve", solved.id)
    assert last["pmax"] == solved.result["pmax"]
    reply = peer.ask("solves.pressures", {"number": last["number"]}, arrays=arrays)
    assert reply.code == OK
    assert len(reply.result["patches"]) == 1


def test_tables_of_the_store_come_with_evidence(peer):
    assert peer.ask("ic.list", {"evidence": True}).code == OK


def test_a_solve_that_is_not_kept_is_not_found(peer):
    reply = peer.ask("solves.pressures", {"number": 999_999})
    assert (reply.code, reply.reason) == (NOT_FOUND, "SOLVE_UNKNOWN")


def test_a_job_that_does_not_exist_is_not_found(peer):
    reply = peer.ask("job.cancel", {"job": "build-999"})
    assert (reply.code, reply.reason) == (NOT_FOUND, "JOB_UNKNOWN")
