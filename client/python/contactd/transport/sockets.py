"""Creates ZeroMQ sockets to a daemon, and handles their events and their end."""

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
#: Events of handshakes that a socket reports.
_HANDSHAKE_EVENTS = (
    zmq.EVENT_HANDSHAKE_FAILED_AUTH | zmq.EVENT_HANDSHAKE_FAILED_PROTOCOL | zmq.EVENT_HANDSHAKE_FAILED_NO_DETAIL
)
_EVENTS = zmq.EVENT_DISCONNECTED | zmq.EVENT_HANDSHAKE_SUCCEEDED | _HANDSHAKE_EVENTS

#: A daemon that cannot decrypt a client's messages closes the connection silently. A stopping daemon does so once.
_SILENT_ENDS = 3


class Event(NamedTuple):
    """Represents an event of a socket's connection: a number zmq.EVENT_..., and its value."""

    kind: int
    value: int

    @property
    def is_of_connection(self) -> bool:
        """True if a connection was made or lost; otherwise a handshake has failed."""
        return self.kind in (zmq.EVENT_DISCONNECTED, zmq.EVENT_HANDSHAKE_SUCCEEDED)


def connected_socket(context: ZmqContext, endpoint: str, curve: CurveKeys | None) -> tuple[ZmqSocket, ZmqSocket]:
    """Returns a DEALER that connects to the endpoint, and its monitor. Raises ConnectionFailed."""
    socket = context.socket(zmq.DEALER)
    socket.setsockopt(zmq.LINGER, 0)
    # Without a listener, sending fails instead of queueing and waiting forever.
    socket.setsockopt(zmq.IMMEDIATE, 1)
    # Detects a machine that disappeared silently; the other side's libzmq answers automatically.
    socket.setsockopt(zmq.HEARTBEAT_IVL, 10_000)
    socket.setsockopt(zmq.HEARTBEAT_TIMEOUT, 30_000)
    # Not for host names, which would be resolved to IPv6 addresses first.
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
            f"{endpoint!r} is not a valid endpoint ({zmq.strerror(error.errno or 0)}); " "it must have the form tcp://127.0.0.1:5555 or ipc:///path."
        ) from None
    return socket, monitor


def next_event(monitor: ZmqSocket) -> Event | None:
    """Returns the next event; None if there is none. (zmq.utils.monitor would import asyncio.)"""
    if not monitor.poll(0):
        return None
    return Event(*struct.unpack("=hi", monitor.recv_multipart()[0]))


def received(socket: ZmqSocket, flags: int = 0) -> list[Buffer]:
    """Returns the parts of a message: the envelope, and frames, which are not copied because a table may have a hundred
    megabytes. Raises zmq.Again.
    """
    parts: list[Buffer] = [socket.recv(flags)]
    while socket.getsockopt(zmq.RCVMORE):
        parts.append(socket.recv(copy=False).buffer.toreadonly())
    return parts


def give_up(socket: ZmqSocket, request: str) -> None:
    """Tells the daemon that this request is abandoned. Later answers to it are dropped."""
    try:
        # The socket may be closed immediately; this message may still be sent.
        socket.setsockopt(zmq.LINGER, _CANCEL_LINGER_MS)
        socket.send(cancellation(request), flags=zmq.DONTWAIT)
    except zmq.ZMQError:
        pass  # The daemon has stopped, and the request has ended with it.


def close(socket: ZmqSocket, monitor: ZmqSocket) -> None:
    """Drops pending messages. May be called twice."""
    if not socket.closed:
        socket.disable_monitor()
        monitor.close()
        socket.close()


def no_daemon(endpoint: str) -> ConnectionFailed:
    """Returns the exception for an endpoint without a daemon."""
    return ConnectionFailed(f"No daemon answers at {endpoint}. Start the program contactd, or use contactd.local() or contactctl --local, which need no daemon.")


def went_away(endpoint: str, method: str) -> ConnectionFailed:
    """Returns the exception for a lost connection."""
    return ConnectionFailed(f"The daemon at {endpoint} disconnected during {method}.")


def too_late(endpoint: str, method: str) -> TimeoutExpired:
    """Returns the exception for a timeout."""
    return TimeoutExpired(f"{method} was not answered in time by {endpoint}.")


class Handshakes:
    """Determines why a socket gets no connection, from the events of its monitor."""

    def __init__(self, endpoint: str, encrypted: bool) -> None:
        self._endpoint, self._encrypted, self._silent_ends = endpoint, encrypted, 0

    def judge(self, event: Event) -> Unauthenticated | ConnectionFailed | None:
        """Returns the exception for an event, or None while a connection is still possible."""
        if event.kind == zmq.EVENT_HANDSHAKE_FAILED_AUTH:
            return self._refused("the daemon does not accept this client's key; ask its administrator to allow own_key")
        if event.kind == zmq.EVENT_HANDSHAKE_FAILED_PROTOCOL:
            if event.value != zmq.PROTOCOL_ERROR_ZMTP_MECHANISM_MISMATCH:
                return ConnectionFailed(f"The program that listens at {self._endpoint} is not a contactd daemon.")
            if self._encrypted:
                return self._refused("the daemon does not use encryption; remove server_key and own_key")
            return self._refused("the daemon accepts encrypted connections only; give server_key and own_key")
        self._silent_ends += 1
        if self._silent_ends < _SILENT_ENDS:
            return None
        if self._encrypted:
            return self._refused(
                "it cannot read this client's messages; either server_key is not the daemon's key, or the daemon does " "not use encryption"
            )
        return self._refused("it closes the connection; if it accepts encrypted connections only, give server_key and own_key")

    def _refused(self, why: str) -> Unauthenticated:
        return Unauthenticated(f"No connection to {self._endpoint}: {why}.", reason="HANDSHAKE_FAILED")
