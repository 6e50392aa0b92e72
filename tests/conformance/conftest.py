"""The suite holds the daemon to docs/protocol.md. It never uses the client library."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from typing import Any

import pytest
from jsonschema import Draft7Validator
from referencing import Registry
from referencing.jsonschema import DRAFT7

from conformance.wire import RECORD, Daemon, Peer

Start = Callable[..., Daemon]


@pytest.fixture(scope="session", autouse=True)
def every_message_is_as_described() -> Iterator[None]:
    """Holds all that was received against the schemas of the OpenRPC document that the daemon itself hands out."""
    yield
    daemon = Daemon({})
    try:
        with daemon.peer() as peer:
            document = peer.ask("server.describe").result
    finally:
        daemon.finish()
    registry: Registry[Any] = Registry().with_resource("urn:contactd", DRAFT7.create_resource(document))
    found = document["components"]["schemas"]
    validators = {
        name: Draft7Validator({"$ref": f"urn:contactd#/components/schemas/{name}"}, registry=registry)
        for name in ["reply", "progress", *(method["name"] + ".result" for method in document["methods"])]
    }
    assert validators.keys() <= found.keys()
    wrong = []
    for method, envelope in RECORD:
        checks = [("progress" if "progress" in envelope else "reply", envelope)]
        if "result" in envelope:
            checks.append((f"{method}.result", envelope["result"]))
        wrong += [
            f"{method} {error.json_path}: {error.message[:200]}"
            for name, part in checks
            for error in validators[name].iter_errors(part)
        ]
    assert len(RECORD) > 1
    assert not wrong, f"{len(wrong)} of {len(RECORD)} messages are not as described:\n" + "\n".join(wrong[:20])


@pytest.fixture(scope="module")
def shared() -> Iterator[Daemon]:
    """One daemon for a module whose scenarios do not disturb each other."""
    daemon = Daemon({})
    yield daemon
    daemon.finish()


@pytest.fixture
def peer(shared: Daemon) -> Iterator[Peer]:
    with shared.peer() as connected:
        yield connected


@pytest.fixture
def start() -> Iterator[Start]:
    """start(section={...}) starts a daemon with that configuration for one scenario."""
    daemons: list[Daemon] = []

    def begin(**config: Any) -> Daemon:
        daemons.append(Daemon(config))
        return daemons[-1]

    yield begin
    for daemon in daemons:
        daemon.finish()
