"""The sockets of a client: one for each call that runs, kept for the next one."""

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
    """Takes one request to where it is answered."""

    def exchange(self, request: Request) -> Reply:
        """Raises StatusError, TimeoutExpired, ConnectionFailed or ProtocolError."""


class ConnectionPool(Protocol):
    """Lends a client a connection for each call. Thread-safe."""

    is_closed: bool

    def take(self) -> Exchanging:
        """Raises ConnectionFailed."""

    def give_back(self, connection: Any, usable: bool = True) -> None:
        """`usable`: whether the next call may have it."""

    def close(self) -> None:
        """May be called twice."""


#: Lets another thread have the processor; Windows knows it as a sleep of no time.
yield_processor: Callable[[], None] = getattr(os, "sched_yield", partial(time.sleep, 0))

#: The longest wait for a socket, in seconds. A signal that comes after Python has looked for one and before the system waits
#: does not end that wait, so that an interrupt may be late by this much, and is never lost.
LONGEST_WAIT = 0.2


def milliseconds(remaining: float) -> int:
    """How long the next wait for a socket lasts, with so many seconds to go."""
    return max(1, round(min(remaining, LONGEST_WAIT) * 1000))


class Connection:
    """A socket of its own, for one exchange at a time; belongs to one thread while that lasts.

    An exchange that timed out leaves the socket usable: its late answer is recognised by its id and dropped. What the
    exchange gives up, it cancels.
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
        self._lost = False  # the connection, and no handshake has made a new one since
        self._socket, self._monitor = connected_socket(context, endpoint, curve)

    @property
    def is_of_this_process(self) -> bool:
        """False in a process that was forked from the one it belongs to, and must leave it alone."""
        return self._process == os.getpid()

    def close(self) -> None:
        """Drops what is under way. May be called twice."""
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
            # Anything else belongs to an exchange that was given up.

    def _send(self, request: Request) -> None:
        self._wait_until_connected(min(request.deadline, time.monotonic() + request.connect_timeout))
        try:
            self._socket.send_multipart(request.message(), flags=zmq.DONTWAIT)
        except zmq.Again:
            raise ConnectionFailed(f"The daemon at {self.endpoint} went away.") from None

    def _wait_until_connected(self, deadline: float) -> None:
        """Forgets what happened to earlier connections; raises why there is none."""
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
        """Returns what happened to the connection, in order; None when all is read."""
        event = next_event(self._monitor)
        # The socket itself may take a message for a connection that is being taken down a little longer.
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
            yield_processor()  # to the daemon, where it shares this processor
        while True:
            remaining = deadline - time.monotonic()
            if remaining <= 0:
                raise too_late(self.endpoint, method)
            if not self.is_of_this_process:  # a progress callback has forked, and has returned here, too
                raise ConnectionFailed(f"This process was forked from the one that gets the answer to {method}.")
            poller.poll(milliseconds(remaining))
            # The answer first: a daemon that is ending answers and then hangs up.
            event = self._next_event()
            if self._socket.poll(0):
                return received(self._socket)
            if event is not None and event.kind != zmq.EVENT_HANDSHAKE_SUCCEEDED:
                raise went_away(self.endpoint, method)


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
