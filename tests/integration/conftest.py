"""Fixtures with real daemons."""

from __future__ import annotations

from collections.abc import Iterator
from concurrent.futures import Future, ThreadPoolExecutor
from typing import Any, Protocol

import pytest

from contactd import Client
from support.daemons import BIN, Daemons, TestDaemon
from support.raw import RawClient
from support.sessions import OPEN


@pytest.fixture(scope="session", autouse=True)
def _built() -> None:
    missing = [name for name in ("contactd", "contactd-ic") if not (BIN / name).exists()]
    if missing:
        pytest.exit(f"{', '.join(missing)} not found in {BIN}; build first, or set CONTACTD_BIN", returncode=2)


@pytest.fixture
def daemons() -> Iterator[Daemons]:
    """Starts daemons for one test and checks that they leave nothing behind."""
    started = Daemons()
    yield started
    started.finish()


@pytest.fixture
def daemon(daemons: Daemons) -> TestDaemon:
    return daemons.start()


@pytest.fixture
def client(daemon: TestDaemon) -> Iterator[Client]:
    with daemon.client() as connected:
        yield connected


@pytest.fixture(scope="module")
def shared_daemon() -> Iterator[TestDaemon]:
    """Provides one daemon for a module whose tests do not affect each other."""
    started = Daemons()
    try:
        yield started.start()
    finally:
        started.finish()


@pytest.fixture
def shared(shared_daemon: TestDaemon) -> Iterator[Client]:
    with shared_daemon.client() as connected:
        yield connected


@pytest.fixture
def raw(shared_daemon: TestDaemon) -> Iterator[RawClient]:
    with shared_daemon.raw() as connected:
        yield connected


@pytest.fixture
def session(raw: RawClient) -> Iterator[str]:
    """Provides the name of a session of `raw`, which is closed afterwards."""
    name = raw.ask("session.open", OPEN).result["session"]
    yield name
    raw.ask("session.close", {"session": name})


class Background(Protocol):
    def __call__(self, function: Any, *arguments: Any, **options: Any) -> Future[Any]: ...


@pytest.fixture
def background() -> Iterator[Background]:
    """background(function, ...) runs a call in a separate thread and returns its future."""
    with ThreadPoolExecutor(max_workers=16) as pool:
        yield pool.submit
