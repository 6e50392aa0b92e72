"""Tests whether the daemon conforms to docs/protocol.md, without using the client library."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import pytest
from jsonschema import Draft7Validator
from referencing import Registry
from referencing.jsonschema import DRAFT7

from conformance.wire import RECORD, Daemon, Peer

Start = Callable[..., Daemon]


#: Lists reasons that only a defect of the daemon would cause, or that no client could receive.
UNREACHABLE = {"UNEXPECTED", "CLIENT_GONE"}


@pytest.hookimpl(tryfirst=True)
def pytest_collection_modifyitems(items: list[pytest.Item]) -> None:
    """The whole suite runs in one process (pytest-xdist), whose record is checked at the end."""
    for item in items:
        if item.path.parent == Path(__file__).parent:
            item.add_marker(pytest.mark.xdist_group("conformance"))


def _is_whole(session: pytest.Session) -> bool:
    """Returns whether the suite ran with every scenario, and none has failed."""
    folder = Path(__file__).parent
    modules = {item.path for item in session.items if item.path.parent == folder}
    chosen = session.config.option.keyword or any("::" in argument for argument in session.config.args)
    return not chosen and not session.testsfailed and modules == set(folder.glob("test_*.py"))


def _unseen(methods: set[str]) -> set[str]:
    """Returns methods that were never answered with OK, and reasons of the protocol page that never occurred."""
    page = (Path(__file__).parents[2] / "docs" / "protocol.md").read_text()
    rows = re.findall(r"^\| [A-Z_]+ \| ([A-Z_, ]+) \|", page, re.MULTILINE)
    reasons = {reason for row in rows for reason in row.split(", ")}
    assert len(reasons) > 30
    statuses = [envelope["status"] for _, envelope in RECORD if "status" in envelope]
    given = {status.get("details", {}).get("reason") for status in statuses}
    answered = {method for method, envelope in RECORD if "result" in envelope}
    return (reasons - given - UNREACHABLE) | (methods - answered)


@pytest.fixture(scope="session", autouse=True)
def every_message_is_as_described(request: pytest.FixtureRequest) -> Iterator[None]:
    """Checks after a complete run that every method was answered and every reason occurred.

    Of a whole run, also that every method was answered and every reason was given.
    """
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
    methods = {method["name"] for method in document["methods"]}
    unseen = _unseen(methods) if _is_whole(request.session) else set()
    assert not unseen, f"no scenario of the suite shows {', '.join(sorted(unseen))}"
    assert not wrong, f"{len(wrong)} of {len(RECORD)} messages are not as described:\n" + "\n".join(wrong[:20])


@pytest.fixture(scope="module")
def shared() -> Iterator[Daemon]:
    """Provides one daemon for a module whose scenarios do not affect each other."""
    daemon = Daemon({})
    yield daemon
    daemon.finish()


@pytest.fixture
def peer(shared: Daemon) -> Iterator[Peer]:
    with shared.peer() as connected:
        yield connected


@pytest.fixture
def start() -> Iterator[Start]:
    """start(section={...}) starts a daemon with this configuration for one scenario."""
    daemons: list[Daemon] = []

    def begin(**config: Any) -> Daemon:
        daemons.append(Daemon(config))
        return daemons[-1]

    yield begin
    for daemon in daemons:
        daemon.finish()
