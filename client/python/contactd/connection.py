"""One DEALER socket and the exchange of one request for its answer."""

from __future__ import annotations

import json
import os
import time
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Any

import zmq
from zmq.utils.monitor import recv_monitor_message

from ._version import __version__
from .curve import HANDSHAKE_EVENTS, CurveKeys, Handshakes
from .errors import ConnectionFailed, ProtocolError, StatusError, TimeoutExpired, Violation, status_error

__all__ = ["CLIENT", "PROTOCOL_VERSION", "Connection", "Reply", "parsed", "reply_of", "status_error_of"]

PROTOCOL_VERSION = 1
CLIENT = f"contactd-python {__version__}"  #: as the daemon's log names this client
_CANCEL_LINGER_MS = 200
_EVENTS = zmq.EVENT_DISCONNECTED | zmq.EVENT_HANDSHAKE_SUCCEEDED | HANDSHAKE_EVENTS


@dataclass(frozen=True)
class Reply:
    """The answer to one request: the JSON of its `result` and the array frames behind it.

    Attributes:
        result: JSON, in which arrays are references to frames.
        frames: The arrays, as bytes.
    """

    result: dict[str, Any]
    frames: Sequence[bytes]


class Connection:
    """A socket of its own, for one exchange at a time; belongs to one thread while that lasts.

    An exchange that timed out leaves the socket usable: its late answer is recognised by its id and dropped. What the
    exchange gives up, it cancels.
    """

    def __init__(
        self,
        context: zmq.Context[zmq.Socket[bytes]],
        endpoint: str,
        curve: CurveKeys | None = None,
        spin: float = 0.0,
    ) -> None:
        self.endpoint = endpoint
        self._spin = spin
        self._process = os.getpid()
        self._encrypted = curve is not None
        self._socket = context.socket(zmq.DEALER)
        self._socket.setsockopt(zmq.LINGER, 0)
        # Without a listener nothing is queued: sending fails instead of waiting for ever.
        self._socket.setsockopt(zmq.IMMEDIATE, 1)
        # Notices a machine that went away without a word; the other side's libzmq answers by itself.
        self._socket.setsockopt(zmq.HEARTBEAT_IVL, 10_000)
        self._socket.setsockopt(zmq.HEARTBEAT_TIMEOUT, 30_000)
        # Not for names: what they stand for would be looked for among IPv6 addresses first.
        self._socket.setsockopt(zmq.IPV6, endpoint.startswith("tcp://["))
        if curve is not None:
            curve.apply(self._socket)
        self._monitor: zmq.Socket[bytes] = self._socket.get_monitor_socket(_EVENTS)
        self._lost = False  # the connection, and no handshake has made a new one since
        self._monitor.setsockopt(zmq.LINGER, 0)
        try:
            self._socket.connect(endpoint)
        except zmq.ZMQError as error:
            self.close()
            raise ConnectionFailed(
                f"{endpoint!r} is no endpoint one can connect to ({zmq.strerror(error.errno or 0)}); "
                "it must read like tcp://127.0.0.1:5555 or ipc:///path."
            ) from None

    @property
    def is_of_this_process(self) -> bool:
        """False in a process that was forked from the one it belongs to, and must leave it alone."""
        return self._process == os.getpid()

    def close(self) -> None:
        """Drops what is under way. May be called twice."""
        if not self._socket.closed:
            self._socket.disable_monitor()
            self._monitor.close()
            self._socket.close()

    def exchange(
        self,
        envelope: dict[str, Any],
        frames: Sequence[bytes],
        deadline: float,
        connect_timeout: float,
        on_progress: Callable[[dict[str, Any]], None] | None,
    ) -> Reply:
        """Sends the request and returns its answer. `deadline` is a time of time.monotonic().

        Raises StatusError, TimeoutExpired, ConnectionFailed or ProtocolError.
        """
        self._send([json.dumps(envelope, allow_nan=False).encode(), *frames], deadline, connect_timeout)
        try:
            answer, arrays = self._await(envelope, deadline, on_progress)
        except BaseException as error:
            if not isinstance(error, (ConnectionFailed, ProtocolError)):
                self._cancel(envelope["id"])
            raise
        return reply_of(answer, arrays)

    def _await(
        self, envelope: dict[str, Any], deadline: float, on_progress: Callable[[dict[str, Any]], None] | None
    ) -> tuple[dict[str, Any], Sequence[bytes]]:
        while True:
            message = self._receive(deadline, envelope["method"])
            answer = parsed(message[0])
            if "status" in answer and answer.get("id") in (envelope["id"], None):
                return answer, message[1:]
            if "progress" in answer and answer.get("id") == envelope["id"] and on_progress is not None:
                on_progress(answer["progress"])
            # Anything else belongs to an exchange that was given up.

    def _cancel(self, name: str) -> None:
        """Tells the daemon that nobody waits for this request any more. Its answers are dropped as they come."""
        if not self.is_of_this_process:
            return
        params = {"id": name}
        request = {"contactd": PROTOCOL_VERSION, "id": f"{name}-cancel", "method": "request.cancel", "params": params}
        try:
            # Who gives up closes the socket perhaps at once: this may still go out.
            self._socket.setsockopt(zmq.LINGER, _CANCEL_LINGER_MS)
            self._socket.send(json.dumps(request).encode(), flags=zmq.DONTWAIT)
        except zmq.ZMQError:
            pass  # the daemon has gone, and the request with it

    def _send(self, message: list[bytes], deadline: float, connect_timeout: float) -> None:
        self._wait_until_connected(min(deadline, time.monotonic() + connect_timeout))
        try:
            self._socket.send_multipart(message, flags=zmq.DONTWAIT)
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
                if connected or event["event"] in (zmq.EVENT_DISCONNECTED, zmq.EVENT_HANDSHAKE_SUCCEEDED):
                    continue
                if (failure := handshakes.judge(event["event"], event["value"])) is not None:
                    raise failure
            if connected and not news:
                return
            remaining = deadline - time.monotonic()
            if remaining <= 0:
                raise ConnectionFailed(f"No daemon answers at {self.endpoint}.")
            if self._lost:
                self._monitor.poll(max(1, round(remaining * 1000)))
            elif not news:
                poller.poll(max(1, round(remaining * 1000)))

    def _next_event(self) -> dict[str, Any] | None:
        """What happened to the connection, in order; None when all is read."""
        if not self._monitor.poll(0):
            return None
        event = recv_monitor_message(self._monitor)
        # The socket itself may take a message for a connection that is being taken down a little longer.
        if event["event"] in (zmq.EVENT_DISCONNECTED, zmq.EVENT_HANDSHAKE_SUCCEEDED):
            self._lost = event["event"] == zmq.EVENT_DISCONNECTED
        return dict(event)

    def _receive(self, deadline: float, method: str) -> list[bytes]:
        poller = zmq.Poller()
        poller.register(self._socket, zmq.POLLIN)
        poller.register(self._monitor, zmq.POLLIN)
        awake = min(deadline, time.monotonic() + self._spin)
        while time.monotonic() < awake:
            if self._socket.poll(0):
                return self._socket.recv_multipart()
        while True:
            remaining = deadline - time.monotonic()
            if remaining <= 0:
                raise TimeoutExpired(f"{method} was not answered in time by {self.endpoint}.")
            if not self.is_of_this_process:  # a progress callback has forked, and has returned here, too
                raise ConnectionFailed(f"This process was forked from the one that gets the answer to {method}.")
            poller.poll(max(1, round(remaining * 1000)))
            # The answer first: a daemon that is ending answers and then hangs up.
            event = self._next_event()
            if self._socket.poll(0):
                return self._socket.recv_multipart()
            if event is not None and event["event"] != zmq.EVENT_HANDSHAKE_SUCCEEDED:
                raise ConnectionFailed(f"The daemon at {self.endpoint} went away while it worked on {method}.")


def parsed(text: bytes) -> dict[str, Any]:
    """The envelope of an answer. Raises ProtocolError."""
    try:
        answer = json.loads(text)
    except (ValueError, RecursionError):
        raise ProtocolError(f"The answer is no JSON: {text[:80]!r}") from None
    version = answer.get("contactd") if isinstance(answer, dict) else None
    if type(version) is not int:
        raise ProtocolError(f"The answer is no message of contactd's protocol: {text[:80]!r}")
    if version != PROTOCOL_VERSION:
        side = "client (the Python package contactd)" if version > PROTOCOL_VERSION else "daemon"
        raise ProtocolError(
            f"The daemon answers in version {version} of the protocol; this client speaks {PROTOCOL_VERSION}: "
            f"upgrade the {side}."
        )
    return dict(answer)


def reply_of(answer: dict[str, Any], frames: Sequence[bytes]) -> Reply:
    """What an envelope with a status and its frames say. Raises StatusError or ProtocolError."""
    if (error := status_error_of(answer["status"])) is not None:
        raise error
    if not isinstance(answer.get("result"), dict):
        raise _unreadable(answer)
    return Reply(answer["result"], frames)


def status_error_of(status: Any) -> StatusError | None:
    """The exception that a status stands for; None when it is OK. Raises ProtocolError when it is no status."""
    try:
        if status["code"] == 0:
            return None
        details = status.get("details", {})
        violations = [Violation(str(v["field"]), str(v["description"])) for v in details.get("violations", [])]
        reason, delay = str(details.get("reason", "")), float(details.get("retry_delay_ms", 0)) / 1000
        return status_error(status["code"], status["message"], reason=reason, violations=violations, retry_delay=delay)
    except (KeyError, TypeError, AttributeError, ValueError):
        raise _unreadable(status) from None


def _unreadable(part: Any) -> ProtocolError:
    return ProtocolError(f"The answer's status or result cannot be read: {part!r:.200}")
