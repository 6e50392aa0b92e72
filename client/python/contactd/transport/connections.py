"""Manages the sockets of a client: one for each running call, reused by later calls."""

from __future__ import annotations

import os
import threading
import time
import weakref
from collections.abc import Callable, Sequence
from functools import partial
from typing import Any, Protocol

import zmq

from ..errors import ConnectionFailed, ProtocolError
from .curve import CurveKeys
from .messages import Buffer, Reply, Request, parsed, reply_of
from .sockets import (
    Event,
    Handshakes,
    ZmqContext,
    close,
    connected_socket,
    give_up,
    next_event,
    no_daemon,
    received,
    too_late,
    went_away,
)

__all__ = ["Connection", "ConnectionPool", "Connections", "Exchanging"]


class Exchanging(Protocol):
    """Sends one request and returns its answer."""

    def exchange(self, request: Request) -> Reply:
        """Raises StatusError, TimeoutExpired, ConnectionFailed or ProtocolError."""


class ConnectionPool(Protocol):
    """Lends each call a connection. Thread-safe."""

    is_closed: bool

    def take(self) -> Exchanging:
        """Lends a connection. Raises ConnectionFailed."""

    def give_back(self, connection: Any, usable: bool = True) -> None:
        """Takes a connection back; `usable` means that the next call may use it."""

    def close(self) -> None:
        """Closes the connections. A second call has no effect."""


#: Yields the processor to another thread; on Windows, a sleep of zero time.
yield_processor: Callable[[], None] = getattr(os, "sched_yield", partial(time.sleep, 0))

#: The longest wait for a socket (s). A signal between Python's check and the wait of the system does not end the wait,
#: so an interrupt may be delayed by this time, but is never lost.
LONGEST_WAIT = 0.2


def milliseconds(remaining: float) -> int:
    """Returns the duration of the next wait for a socket, for the remaining time in seconds."""
    return max(1, round(min(remaining, LONGEST_WAIT) * 1000))


class Connection:
    """Represents a socket for one exchange at a time; during the exchange it belongs to one thread.

    The socket stays usable after a timeout: a late answer is recognised by its ID and dropped. An abandoned request is
    cancelled in the daemon.
    """

    def __init__(
        self,
        context: ZmqContext,
        endpoint: str,
        curve: CurveKeys | None = None,
        spin: float = 0.0,
    ) -> None:
        self.endpoint = endpoint
        self._spin = spin
        self._process = os.getpid()
        self._encrypted = curve is not None
        self._lost = False  # The connection was lost, and there is no new handshake since.
        self._socket, self._monitor = connected_socket(context, endpoint, curve)

    @property
    def is_of_this_process(self) -> bool:
        """False in a forked process, which must not use the connection."""
        return self._process == os.getpid()

    def close(self) -> None:
        """Drops pending messages. A second call has no effect."""
        close(self._socket, self._monitor)

    def exchange(self, request: Request) -> Reply:
        """Sends the request and returns its answer.

        Raises StatusError, TimeoutExpired, ConnectionFailed or ProtocolError.
        """
        self._send(request)
        try:
            answer, arrays = self._await(request)
        except BaseException as error:
            if self.is_of_this_process and not isinstance(error, (ConnectionFailed, ProtocolError)):
                give_up(self._socket, request.id)
            raise
        return reply_of(answer, arrays)

    def _await(self, request: Request) -> tuple[dict[str, Any], Sequence[Buffer]]:
        while True:
            message = self._receive(request.deadline, request.method)
            answer = parsed(message[0])
            if "status" in answer and answer.get("id") in (request.id, None):
                return answer, message[1:]
            if "progress" in answer and answer.get("id") == request.id and request.on_progress is not None:
                request.on_progress(answer["progress"])
            # All other messages belong to abandoned exchanges.

    def _send(self, request: Request) -> None:
        self._wait_until_connected(min(request.deadline, time.monotonic() + request.connect_timeout))
        try:
            self._socket.send_multipart(request.message(), flags=zmq.DONTWAIT)
        except zmq.Again:
            raise ConnectionFailed(f"The daemon at {self.endpoint} disconnected.") from None

    def _wait_until_connected(self, deadline: float) -> None:
        """Ignores events of earlier connections; raises an exception with the reason if there is no connection."""
        handshakes = Handshakes(self.endpoint, self._encrypted)
        poller = zmq.Poller()
        poller.register(self._socket, zmq.POLLOUT)
        poller.register(self._monitor, zmq.POLLIN)
        while True:
            connected = bool(self._socket.poll(0, zmq.POLLOUT)) and not self._lost
            news = bool(self._monitor.poll(0))
            while (event := self._next_event()) is not None:
                if connected or event.is_of_connection:
                    continue
                if (failure := handshakes.judge(event)) is not None:
                    raise failure
            if connected and not news:
                return
            remaining = deadline - time.monotonic()
            if remaining <= 0:
                raise no_daemon(self.endpoint)
            if self._lost:
                self._monitor.poll(milliseconds(remaining))
            elif not news:
                poller.poll(milliseconds(remaining))

    def _next_event(self) -> Event | None:
        """Returns the next event of the connection; None if there is none."""
        event = next_event(self._monitor)
        # The socket may still accept messages while its connection is being closed.
        if event is not None and event.is_of_connection:
            self._lost = event.kind == zmq.EVENT_DISCONNECTED
        return event

    def _receive(self, deadline: float, method: str) -> list[Buffer]:
        poller = zmq.Poller()
        poller.register(self._socket, zmq.POLLIN)
        poller.register(self._monitor, zmq.POLLIN)
        awake = min(deadline, time.monotonic() + self._spin)
        while time.monotonic() < awake:
            if self._socket.poll(0):
                return received(self._socket)
            yield_processor()  # Yields to the daemon if it shares this processor.
        while True:
            remaining = deadline - time.monotonic()
            if remaining <= 0:
                raise too_late(self.endpoint, method)
            if not self.is_of_this_process:  # A progress callback has forked; this is the child process.
                raise ConnectionFailed(f"This process was forked from the one that receives the answer to {method}.")
            poller.poll(milliseconds(remaining))
            # Read the answer first: a stopping daemon answers before it closes the connection.
            event = self._next_event()
            if self._socket.poll(0):
                return received(self._socket)
            if event is not None and event.kind != zmq.EVENT_HANDSHAKE_SUCCEEDED:
                raise went_away(self.endpoint, method)


class Connections:
    """Lends each call its own Connection. Thread-safe.

    A forked process opens its own sockets: inherited ones share descriptors with the parent, and the ZeroMQ threads
    that serve them only exist in the parent.
    """

    def __init__(self, endpoint: str, curve: CurveKeys | None, spin: float = 0.0) -> None:
        self._endpoint, self._curve, self._spin = endpoint, curve, spin
        self._inherited: list[Any] = []  # Neither used nor freed: freeing would wait for the parent's threads.
        self.is_closed = False
        self._begin()
        _ALL.add(self)

    def _begin(self) -> None:
        self._context: ZmqContext = zmq.Context()
        self._lock = threading.Lock()  # protects the two attributes below, and is_closed
        self._idle: list[Connection] = []
        self._busy = 0

    def start_over(self) -> None:
        """Resets the state of a process that was just forked, before other code runs there."""
        self._inherited.append((self._context, self._idle))
        self._begin()

    def take(self) -> Connection:
        """Lends a connection. Raises ConnectionFailed."""
        with self._lock:
            if self.is_closed:
                raise ConnectionFailed("The client is closed.")
            connection = self._idle.pop() if self._idle else self._made()
            self._busy += 1
            return connection

    def _made(self) -> Connection:
        return Connection(self._context, self._endpoint, self._curve, self._spin)

    def give_back(self, connection: Connection, usable: bool = True) -> None:
        """Takes a connection back; `usable` means that the next call may use it."""
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
        """Closes the connections. A second call has no effect. Lent connections stay usable until they are returned."""
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


if hasattr(os, "register_at_fork"):  # not available on systems without fork
    os.register_at_fork(after_in_child=_start_all_over)
