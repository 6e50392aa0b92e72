"""Uses one DEALER socket in an event loop, which carries the exchanges of many requests."""

from __future__ import annotations

import asyncio
import os
import time
from collections import deque
from collections.abc import Callable, Iterable
from copy import copy

import zmq

from ..errors import ConnectionFailed, ContactdError, ProtocolError, StatusError
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

__all__ = ["Exchanges"]

#: Methods that are answered immediately or need no worker; they are sent before waiting requests.
_AT_ONCE = ("server.", "health.", "job.", "session.list", "session.close")


class _Open:
    """Represents a request that waits for its answer, or for the reason why there is none."""

    def __init__(self, request: Request) -> None:
        self.request = request
        self.is_queued = not request.method.startswith(_AT_ONCE)
        self.is_sent = False
        self.arrived: asyncio.Queue[list[Buffer] | ContactdError] = asyncio.Queue()


class Exchanges:
    """Carries the requests of one event loop. At most `most` are sent at a time; others wait.

    The loop watches the descriptors of the socket and of its monitor; there is no polling. An abandoned exchange (a
    timeout, a cancelled task) is also cancelled in the daemon, and its late answer is dropped.
    """

    def __init__(self, endpoint: str, curve: CurveKeys | None, most: int) -> None:
        self._endpoint, self._encrypted = endpoint, curve is not None
        self._process, self._loop = os.getpid(), asyncio.get_running_loop()
        self._open: dict[str, _Open] = {}
        self._unsent: deque[_Open] = deque()  # sent immediately
        self._queued: deque[_Open] = deque()  # sent later, in order
        self._free_places = most
        self._is_connected = False
        self._timer: asyncio.TimerHandle | None = None  # while the daemon does not listen
        self._context: ZmqContext = zmq.Context()
        try:
            self._socket, self._monitor = connected_socket(self._context, endpoint, curve)
        except BaseException:
            self._context.term()
            raise
        self._handshakes = Handshakes(endpoint, self._encrypted)
        self._descriptors = [int(socket.FD) for socket in (self._socket, self._monitor)]
        for descriptor in self._descriptors:
            self._loop.add_reader(descriptor, self._look)
        self.is_closed = False

    @property
    def is_of_this_process(self) -> bool:
        """False in a forked process, which must not use it."""
        return self._process == os.getpid()

    @property
    def is_of_this_loop(self) -> bool:
        """True if the running event loop watches it."""
        return self._loop is asyncio.get_running_loop()

    @property
    def loop_has_ended(self) -> bool:
        """True if its event loop has ended."""
        return self._loop.is_closed()

    def close(self) -> None:
        """Ends all exchanges. A second call, or a call in a forked process, has no effect."""
        if self.is_closed or not self.is_of_this_process:
            return
        self.is_closed = True
        if not self._loop.is_closed():
            for descriptor in self._descriptors:
                self._loop.remove_reader(descriptor)
            self._end(self._open.values(), lambda one: ConnectionFailed("The client was closed."))
        self._stop_timer()
        close(self._socket, self._monitor)
        self._context.term()

    async def exchange(self, request: Request) -> Reply:
        """Sends the request and returns its answer.

        Raises StatusError, TimeoutExpired, ConnectionFailed or ProtocolError.
        """
        one = _Open(request)
        timer = self._loop.call_later(max(0.0, request.deadline - time.monotonic()), self._too_late, one)
        self._open[request.id] = one
        (self._queued if one.is_queued else self._unsent).append(one)
        answered = False
        try:
            self._look()
            while True:
                message = await one.arrived.get()
                if isinstance(message, ContactdError):
                    answered = isinstance(message, (ConnectionFailed, ProtocolError, StatusError))
                    raise message
                answer = parsed(message[0])
                if "status" in answer:
                    answered = True
                    return reply_of(answer, message[1:])
                if request.on_progress is not None:
                    request.on_progress(answer["progress"])
        finally:
            timer.cancel()
            self._open.pop(request.id, None)
            self._forget(one, cancel=not answered)

    def _forget(self, one: _Open, cancel: bool) -> None:
        if self.is_closed or not self.is_of_this_process:
            return
        if not one.is_sent:
            (self._queued if one.is_queued else self._unsent).remove(one)
            if not self._unsent and not self._queued:
                self._stop_timer()
            return
        if cancel:
            give_up(self._socket, one.request.id)
        self._free_places += one.is_queued
        self._look()  # the next waiting request can be sent

    def _too_late(self, one: _Open) -> None:
        connecting = not (one.is_sent or self._is_connected)
        one.arrived.put_nowait(no_daemon(self._endpoint) if connecting else too_late(self._endpoint, one.request.method))

    # --- events

    def _look(self) -> None:
        """Receives all messages and sends waiting ones. ZeroMQ only signals changes, so everything must be checked."""
        if self.is_closed or not self.is_of_this_process:
            return
        events = self._events()
        self._receive()  # Read answers first: a stopping daemon answers before it closes the connection.
        for event in events:
            self._note(event)
        if self._is_connected:
            self._send()
        elif self._timer is None and (first := [*self._unsent, *self._queued][:1]):
            wait = first[0].request.connect_timeout
            self._timer = self._loop.call_later(wait, self._time_out)
        self._receive()  # sending may have cleared the signal of new answers

    def _events(self) -> list[Event]:
        events = []
        while (event := next_event(self._monitor)) is not None:
            events.append(event)
        return events

    def _note(self, event: Event) -> None:
        if event.kind == zmq.EVENT_HANDSHAKE_SUCCEEDED:
            self._is_connected = True
            self._handshakes = Handshakes(self._endpoint, self._encrypted)
            self._stop_timer()
        elif event.is_of_connection:  # lost; also reported after each failed handshake
            self._is_connected = False
            sent = [one for one in self._open.values() if one.is_sent]
            self._end(sent, lambda one: went_away(self._endpoint, one.request.method))
        elif (failure := self._handshakes.judge(event)) is not None:
            # A socket never connects again after its handshake was refused.
            self._end(self._open.values(), lambda one: copy(failure))
            self.close()

    def _receive(self) -> None:
        while not self.is_closed:
            try:
                message = received(self._socket, zmq.DONTWAIT)
            except zmq.Again:
                return
            try:
                name = parsed(message[0]).get("id")
            except ProtocolError as error:  # its request is unknown
                self._end(self._open.values(), lambda one, error=error: copy(error))  # type: ignore[misc]
                continue
            if name is None:
                self._end([*self._open.values()][:1], lambda one, message=message: message)  # type: ignore[misc]
            elif (one := self._open.get(name)) is not None:
                one.arrived.put_nowait(message)
            # All other messages belong to abandoned exchanges.

    def _send(self) -> None:
        while self._unsent and self._sent(self._unsent[0]):
            self._unsent.popleft()
        while self._queued and self._free_places > 0 and self._sent(self._queued[0]):
            self._queued.popleft()
            self._free_places -= 1

    def _sent(self, one: _Open) -> bool:
        try:
            self._socket.send_multipart(one.request.message(), flags=zmq.DONTWAIT)
        except zmq.Again:  # the socket is full; it signals when it accepts more
            return False
        one.is_sent = True
        return True

    def _time_out(self) -> None:
        self._timer = None
        self._end([*self._unsent, *self._queued], lambda one: no_daemon(self._endpoint))

    def _stop_timer(self) -> None:
        if self._timer is not None:
            self._timer.cancel()
            self._timer = None

    def _end(self, exchanges: Iterable[_Open], why: Callable[[_Open], list[Buffer] | ContactdError]) -> None:
        for one in [*exchanges]:
            one.arrived.put_nowait(why(one))
