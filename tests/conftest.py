"""What every Python test gets: a time limit, and a check that it leaves no thread behind."""

from __future__ import annotations

import signal
import threading
from collections.abc import Iterator

import pytest

from support.patience import SLOWER

# A run started in the background of a script ignores SIGINT, and so would every program it starts; the tests that
# interrupt something need the usual behaviour whoever starts them.
signal.signal(signal.SIGINT, signal.default_int_handler)


@pytest.fixture(autouse=True)
def time_limit(request: pytest.FixtureRequest) -> Iterator[None]:
    """Fails a test that hangs; @pytest.mark.time_limit(seconds) changes the sixty seconds."""
    marker = request.node.get_closest_marker("time_limit")
    seconds = SLOWER * (marker.args[0] if marker else 60)

    def expire(signum: int, frame: object) -> None:
        pytest.fail(f"took longer than {seconds} s", pytrace=True)

    before = signal.signal(signal.SIGALRM, expire)
    signal.alarm(seconds)
    yield
    signal.alarm(0)
    signal.signal(signal.SIGALRM, before)


@pytest.fixture(autouse=True)
def no_thread_left() -> Iterator[None]:
    before = set(threading.enumerate())
    yield
    left = [thread.name for thread in threading.enumerate() if thread not in before]
    assert not left, f"threads left behind: {left}"
