"""Provides the client shared by functions such as `contactd.solve`: one per process, opened by the first call."""

from __future__ import annotations

import atexit
import os
import threading
from collections.abc import Callable
from typing import Any

__all__ = ["open_by", "shared_client"]


class _Holder:
    """Holds the client of this process."""

    def __init__(self) -> None:
        self.lock = threading.Lock()
        self.client: Any = None


_holder = _Holder()
#: Holders of parent processes. Their clients must not be freed here, because the parents still use them.
_inherited: list[_Holder] = []
_openers: list[Callable[[], Any]] = []


def open_by(opener: Callable[[], Any]) -> None:
    """Registers the function that opens the client; contactd.local calls it."""
    _openers[:] = [opener]


def shared_client() -> Any:
    """Returns the client of this process. Opens one if there is none, or the last one was closed."""
    holder = _holder
    with holder.lock:
        if holder.client is None or holder.client.is_closed:
            holder.client = _openers[0]()
        return holder.client


def _start_anew() -> None:
    """Resets a forked process: the lock may be held by a thread that does not exist there."""
    global _holder
    _inherited.append(_holder)
    _holder = _Holder()


@atexit.register
def _close() -> None:
    if _holder.client is not None:
        _holder.client.close()


if hasattr(os, "register_at_fork"):
    os.register_at_fork(after_in_child=_start_anew)
