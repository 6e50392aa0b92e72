"""Provides fixtures of tests of the Python client."""

from pathlib import Path

import pytest

import contactd
from integration.conftest import background, shared_daemon  # noqa: F401
from support.fake_server import FakeServer


@pytest.fixture(scope="module")
def client():
    """Provides a client that solves in process."""
    with contactd.local(in_process=True, config={"workers": 1}) as opened:
        yield opened


@pytest.fixture(scope="module")
def solving_here():
    """Calls without a client are solved in process."""
    with pytest.MonkeyPatch.context() as patch:
        patch.delenv("CONTACTD_ENDPOINT", raising=False)
        contactd.default_client().close()
        yield
        contactd.default_client().close()


@pytest.fixture
def fake(tmp_path: Path):
    """Starts a server with scripted answers, and its client."""
    started = []

    def start(script):
        server = FakeServer(tmp_path, script)
        client = contactd.Client(server.endpoint, timeout=5)
        started.extend([client, server])
        return server, client

    yield start
    for part in started:
        part.__exit__(None, None, None)
