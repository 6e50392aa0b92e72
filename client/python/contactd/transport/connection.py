"""One DEALER socket and the exchange of one request for its answer."""

from __future__ import annotations

import os
import time
from collections.abc import Callable, Sequence
from functools import partial
from typing import Any

import zmq

from ..errors import ConnectionFailed, ProtocolError
from .curve import CurveKeys, Handshakes
from .messages import Buffer, Reply, Request, parsed, reply_of
from .sockets import (
    Event,
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

__all__ = ["Connection"]

#: Lets another thread have the processor; Windows knows it as a sleep of no time.
give_way: Callable[[], None] = getattr(os, "sched_yield", partial(time.sleep, 0))


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
                self._monitor.poll(max(1, round(remaining * 1000)))
            elif not news:
                poller.poll(max(1, round(remaining * 1000)))

    def _next_event(self) -> Event | None:
        """What happened to the connection, in order; None when all is read."""
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
            give_way()  # to the daemon, where it shares this processor
        while True:
            remaining = deadline - time.monotonic()
            if remaining <= 0:
                raise too_late(self.endpoint, method)
            if not self.is_of_this_process:  # a progress callback has forked, and has returned here, too
                raise ConnectionFailed(f"This process was forked from the one that gets the answer to {method}.")
            poller.poll(max(1, round(remaining * 1000)))
            # The answer first: a daemon that is ending answers and then hangs up.
            event = self._next_event()
            if self._socket.poll(0):
                return received(self._socket)
            if event is not None and event.kind != zmq.EVENT_HANDSHAKE_SUCCEEDED:
                raise went_away(self.endpoint, method)
