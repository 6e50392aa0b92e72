"""The client that functions of the package share, such as `contactd.solve`: opened with the first call, one for a process."""

from __future__ import annotations

import atexit
import os
import threading
from collections.abc import Callable
from typing import Any

__all__ = ["open_by", "shared_client"]


class _Holder:
    """Keeps the client of this process."""

    def __init__(self) -> None:
        self.lock = threading.Lock()
        self.client: Any = None


_holder = _Holder()
#: Holders of the processes that this one was forked from. Their clients must not end here what those still use.
_inherited: list[_Holder] = []
_openers: list[Callable[[], Any]] = []


def open_by(opener: Callable[[], Any]) -> None:
    """Names the function that opens the client; contactd.local does, which knows how."""
    _openers[:] = [opener]


def shared_client() -> Any:
    """Returns the client of this process; opens it where there is none, or the last one was closed."""
    holder = _holder
    with holder.lock:
        if holder.client is None or holder.client.is_closed:
            holder.client = _openers[0]()
        return holder.client


def _start_anew() -> None:
    """In a forked process: the lock may be held by a thread that does not exist here."""
    global _holder
    _inherited.append(_holder)
    _holder = _Holder()


@atexit.register
def _close() -> None:
    if _holder.client is not None:
        _holder.client.close()


if hasattr(os, "register_at_fork"):
    os.register_at_fork(after_in_child=_start_anew)
