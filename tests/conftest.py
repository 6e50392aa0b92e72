"""Provides settings for every Python test: more time if programs are slow, a separate process, and a check that no
threads remain."""

from __future__ import annotations

import signal
import sys
import threading
from collections.abc import Iterator

import pytest

from support.daemons import BIN
from support.slowness import SLOWER

# contactd_local is built beside the programs.
sys.path.insert(0, str(BIN.parent / "lib" / "python"))

# A run started in the background of a script ignores SIGINT, and so would every program it starts. Tests of
# interruptions need the default behaviour in any case.
signal.signal(signal.SIGINT, signal.default_int_handler)


pytest_plugins = ["support.scheduling"]


@pytest.hookimpl(tryfirst=True)
def pytest_collection_modifyitems(config: pytest.Config, items: list[pytest.Item]) -> None:
    """Time limits are increased if the programs are SLOWER."""
    for item in items:
        limit = item.get_closest_marker("timeout")
        seconds = limit.args[0] if limit else float(config.getini("timeout"))
        item.add_marker(pytest.mark.timeout(SLOWER * seconds), append=False)


@pytest.fixture(autouse=True)
def no_thread_left() -> Iterator[None]:
    before = set(threading.enumerate())
    yield
    left = [thread.name for thread in threading.enumerate() if thread not in before]
    assert not left, f"threads left behind: {left}"
