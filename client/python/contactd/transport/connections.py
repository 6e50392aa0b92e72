"""The sockets of a client: one for each call that runs, kept for the next one."""

from __future__ import annotations

import os
import threading
import weakref
from typing import Any, Protocol

import zmq

from ..errors import ConnectionFailed
from .connection import Connection
from .curve import CurveKeys
from .messages import Reply, Request
from .sockets import ZmqContext

__all__ = ["Connections", "Exchanging", "Lender"]


class Exchanging(Protocol):
    """What takes one request to where it is answered."""

    def exchange(self, request: Request) -> Reply:
        """Raises StatusError, TimeoutExpired, ConnectionFailed or ProtocolError."""


class Lender(Protocol):
    """What lends a client one for each call. Thread-safe."""

    is_closed: bool

    def take(self) -> Exchanging:
        """Raises ConnectionFailed."""

    def give_back(self, connection: Any, usable: bool = True) -> None:
        """`usable`: whether the next call may have it."""

    def close(self) -> None:
        """May be called twice."""


class Connections:
    """Lends each call a Connection of its own. Thread-safe.

    A process that was forked starts over with sockets of its own: those it inherited share descriptors with its parent,
    and the threads of ZeroMQ that serve them are in the parent only.
    """

    def __init__(self, endpoint: str, curve: CurveKeys | None, spin: float = 0.0) -> None:
        self._endpoint, self._curve, self._spin = endpoint, curve, spin
        self._inherited: list[Any] = []  # never used, and never freed either, which would wait for the parent's threads
        self.is_closed = False
        self._begin()
        _ALL.add(self)

    def _begin(self) -> None:
        self._context: ZmqContext = zmq.Context()
        self._lock = threading.Lock()  # guards the two below, and is_closed
        self._idle: list[Connection] = []
        self._busy = 0

    def start_over(self) -> None:
        """In a process that was just forked, before anything else runs there."""
        self._inherited.append((self._context, self._idle))
        self._begin()

    def take(self) -> Connection:
        """Raises ConnectionFailed."""
        with self._lock:
            if self.is_closed:
                raise ConnectionFailed("The client is closed.")
            connection = self._idle.pop() if self._idle else self._made()
            self._busy += 1
            return connection

    def _made(self) -> Connection:
        return Connection(self._context, self._endpoint, self._curve, self._spin)

    def give_back(self, connection: Connection, usable: bool = True) -> None:
        """`usable`: whether the next call may have it."""
        if not connection.is_of_this_process:
            self._inherited.append(connection)
            return
        with self._lock:
            self._busy -= 1
            if usable and not self.is_closed:
                self._idle.append(connection)
                return
            connection.close()
            if self.is_closed and self._busy == 0:
                self._context.term()

    def close(self) -> None:
        """May be called twice. What is lent stays usable until it is given back."""
        with self._lock:
            self.is_closed = True
            while self._idle:
                self._idle.pop().close()
            if self._busy == 0:
                self._context.term()


_ALL: weakref.WeakSet[Connections] = weakref.WeakSet()


def _start_all_over() -> None:
    for connections in list(_ALL):
        connections.start_over()


if hasattr(os, "register_at_fork"):  # not where nothing forks
    os.register_at_fork(after_in_child=_start_all_over)
