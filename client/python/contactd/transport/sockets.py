"""The sockets of ZeroMQ that speak with a daemon: how they are made, what they tell of their connection, how they end."""

from __future__ import annotations

import struct
from typing import NamedTuple

import zmq

from ..errors import ConnectionFailed, TimeoutExpired, Unauthenticated
from .curve import CurveKeys
from .messages import Buffer, cancellation

__all__ = [
    "Event",
    "Handshakes",
    "ZmqContext",
    "ZmqSocket",
    "close",
    "connected_socket",
    "give_up",
    "next_event",
    "no_daemon",
    "received",
    "too_late",
    "went_away",
]

ZmqSocket = zmq.Socket[bytes]
ZmqContext = zmq.Context[ZmqSocket]
_CANCEL_LINGER_MS = 200
#: A socket reports these of the handshakes of its connection.
_HANDSHAKE_EVENTS = (
    zmq.EVENT_HANDSHAKE_FAILED_AUTH | zmq.EVENT_HANDSHAKE_FAILED_PROTOCOL | zmq.EVENT_HANDSHAKE_FAILED_NO_DETAIL
)
_EVENTS = zmq.EVENT_DISCONNECTED | zmq.EVENT_HANDSHAKE_SUCCEEDED | _HANDSHAKE_EVENTS

#: A daemon that cannot read what a client says hangs up without a word, and so does one that is ending, once.
_SILENT_ENDS = 3


class Event(NamedTuple):
    """Event of the connection of a socket: a number zmq.EVENT_..., and what that says besides."""

    kind: int
    value: int

    @property
    def is_of_connection(self) -> bool:
        """Whether it was made or lost; else a handshake has failed."""
        return self.kind in (zmq.EVENT_DISCONNECTED, zmq.EVENT_HANDSHAKE_SUCCEEDED)


def connected_socket(context: ZmqContext, endpoint: str, curve: CurveKeys | None) -> tuple[ZmqSocket, ZmqSocket]:
    """A DEALER that connects to the endpoint, and its monitor. Raises ConnectionFailed."""
    socket = context.socket(zmq.DEALER)
    socket.setsockopt(zmq.LINGER, 0)
    # Without a listener nothing is queued: sending fails instead of waiting for ever.
    socket.setsockopt(zmq.IMMEDIATE, 1)
    # Notices a machine that went away without a word; the other side's libzmq answers by itself.
    socket.setsockopt(zmq.HEARTBEAT_IVL, 10_000)
    socket.setsockopt(zmq.HEARTBEAT_TIMEOUT, 30_000)
    # Not for names: what they stand for would be looked for among IPv6 addresses first.
    socket.setsockopt(zmq.IPV6, endpoint.startswith("tcp://["))
    if curve is not None:
        curve.apply(socket)
    monitor: ZmqSocket = socket.get_monitor_socket(_EVENTS)
    monitor.setsockopt(zmq.LINGER, 0)
    try:
        socket.connect(endpoint)
    except zmq.ZMQError as error:
        close(socket, monitor)
        raise ConnectionFailed(
            f"{endpoint!r} is no endpoint one can connect to ({zmq.strerror(error.errno or 0)}); "
            "it must read like tcp://127.0.0.1:5555 or ipc:///path."
        ) from None
    return socket, monitor


def next_event(monitor: ZmqSocket) -> Event | None:
    """Returns what happened, in order; None when all is read. (zmq.utils.monitor would take asyncio along.)"""
    if not monitor.poll(0):
        return None
    return Event(*struct.unpack("=hi", monitor.recv_multipart()[0]))


def received(socket: ZmqSocket, flags: int = 0) -> list[Buffer]:
    """The parts of a message: the envelope, and frames, which stay where ZeroMQ has put them: a table may have a hundred
    megabytes. Raises zmq.Again."""
    parts: list[Buffer] = [socket.recv(flags)]
    while socket.getsockopt(zmq.RCVMORE):
        parts.append(socket.recv(copy=False).buffer.toreadonly())
    return parts


def give_up(socket: ZmqSocket, request: str) -> None:
    """Tells the daemon that this request is abandoned. Its answers are dropped as they come."""
    try:
        # Who gives up closes the socket perhaps at once: this may still go out.
        socket.setsockopt(zmq.LINGER, _CANCEL_LINGER_MS)
        socket.send(cancellation(request), flags=zmq.DONTWAIT)
    except zmq.ZMQError:
        pass  # the daemon has gone, and the request with it


def close(socket: ZmqSocket, monitor: ZmqSocket) -> None:
    """Drops what is under way. May be called twice."""
    if not socket.closed:
        socket.disable_monitor()
        monitor.close()
        socket.close()


def no_daemon(endpoint: str) -> ConnectionFailed:
    """Nobody listens."""
    return ConnectionFailed(f"No daemon answers at {endpoint}. The program contactd is one; contactd.local() and contactctl --local need none.")


def went_away(endpoint: str, method: str) -> ConnectionFailed:
    """The connection broke."""
    return ConnectionFailed(f"The daemon at {endpoint} went away while it worked on {method}.")


def too_late(endpoint: str, method: str) -> TimeoutExpired:
    """The time of a call is over."""
    return TimeoutExpired(f"{method} was not answered in time by {endpoint}.")


class Handshakes:
    """Judges why a socket gets no connection, from the events of its monitor."""

    def __init__(self, endpoint: str, encrypted: bool) -> None:
        self._endpoint, self._encrypted, self._silent_ends = endpoint, encrypted, 0

    def judge(self, event: Event) -> Unauthenticated | ConnectionFailed | None:
        """The exception that an event amounts to, or None while there is hope."""
        if event.kind == zmq.EVENT_HANDSHAKE_FAILED_AUTH:
            return self._refused("the daemon does not know this client's key; ask who runs it to allow own_key")
        if event.kind == zmq.EVENT_HANDSHAKE_FAILED_PROTOCOL:
            if event.value != zmq.PROTOCOL_ERROR_ZMTP_MECHANISM_MISMATCH:
                return ConnectionFailed(f"What listens at {self._endpoint} is no contactd daemon.")
            if self._encrypted:
                return self._refused("the daemon does not use encryption; leave server_key and own_key out")
            return self._refused("the daemon takes encrypted connections only; give server_key and own_key")
        self._silent_ends += 1
        if self._silent_ends < _SILENT_ENDS:
            return None
        if self._encrypted:
            return self._refused(
                "it cannot read what this client says; either server_key is not the daemon's key, or the daemon does "
                "not use encryption"
            )
        return self._refused("it hangs up; if it takes encrypted connections only, give server_key and own_key")

    def _refused(self, why: str) -> Unauthenticated:
        return Unauthenticated(f"No connection to {self._endpoint}: {why}.", reason="HANDSHAKE_FAILED")
