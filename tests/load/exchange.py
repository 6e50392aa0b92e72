"""Sends random messages and receives their answers: exactly one status for each, with its id, and no sign of a
defect."""

from __future__ import annotations

import collections
import json
import math
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass, field
from typing import Any

import zmq

from contactd import LocalDaemon
from load.messages import SESSION, Message

TIMEOUT_MS = 60_000


class Wrong(AssertionError):
    """Reports a violation by a message, and names the message."""


@dataclass
class Outcome:
    statuses: collections.Counter[str] = field(default_factory=collections.Counter)
    memory: list[int] = field(default_factory=list)
    slowest: float = 0.0


@contextmanager
def connected(daemon: LocalDaemon, kind: int) -> Iterator[zmq.Socket[bytes]]:
    with zmq.Context() as context, context.socket(kind) as socket:
        socket.linger = 0
        socket.connect(daemon.endpoint)
        yield socket


def reply(socket: zmq.Socket[bytes], about: object) -> dict[str, Any]:
    """Returns the next reply; progress is ignored."""
    while True:
        if not socket.poll(TIMEOUT_MS):
            raise Wrong(f"no answer within {TIMEOUT_MS / 1000:g} s to {about}")
        parts = socket.recv_multipart()
        # A DEALER whose envelope was empty, with frames after it, looks like a REQ and is answered like one.
        envelope = json.loads(parts[0] or parts[1])
        if "progress" not in envelope:
            return envelope


def finite(number: str) -> float:
    """Refuses numbers beyond a double, like the daemon, including NaN and Infinity."""
    if not math.isfinite(value := float(number)):
        raise ValueError(number)
    return value


def readable_id(message: Message) -> str | None:
    """Returns the id that every JSON parser would find, or None if they may differ."""
    try:
        envelope = json.loads(message.text.decode(), parse_float=finite, parse_int=finite, parse_constant=finite)
    except (ValueError, RecursionError):
        return None
    found = envelope.get("id") if isinstance(envelope, dict) else None
    return found if isinstance(found, str) and 0 < len(found) <= 128 and found.isascii() else None


def take(envelope: dict[str, Any], outcome: Outcome) -> str | None:
    status = envelope["status"]
    reason = status.get("details", {}).get("reason", "")
    outcome.statuses[f"{status['name']} {reason}".strip()] += 1
    if reason == "UNEXPECTED":
        raise Wrong(f"a defect shows: {status['message']}")
    if status["code"] != 0 and not (reason and status["message"]):
        raise Wrong(f"a status without reason or message: {status}")
    return envelope["id"]


def by_dealer(socket: zmq.Socket[bytes], batch: list[Message], outcome: Outcome) -> None:
    """Sends all at once; there must be as many replies as messages, and every readable id must occur as often as it
    was sent."""
    for message in batch:
        socket.send_multipart([message.text, *message.frames])
    names = [readable_id(message) for message in batch]
    ids: collections.Counter[str | None] = collections.Counter()
    for _ in batch:
        missing = [str(message) for name, message in zip(names, batch, strict=True) if not ids[name]]
        ids[take(reply(socket, "\n".join(missing)), outcome)] += 1
    sent = collections.Counter(names)  # damage may make two messages equal
    for name, message in zip(names, batch, strict=True):
        if name is not None and ids[name] != sent[name]:
            raise Wrong(f"{ids[name]} replies to {message}")


def by_req(socket: zmq.Socket[bytes], message: Message, outcome: Outcome) -> None:
    socket.send_multipart([message.text, *message.frames])
    name, expected = take(reply(socket, message), outcome), readable_id(message)
    if expected is not None and name != expected:
        raise Wrong(f"id {name!r} in the reply to {message}")


def expect_silence(socket: zmq.Socket[bytes]) -> None:
    """Messages of one client are answered in any order, but a health request at the end shows that no others are
    open."""
    socket.send(json.dumps({"contactd": 1, "id": "last", "method": "server.health"}).encode())
    if (name := reply(socket, "server.health")["id"]) != "last":
        raise Wrong(f"a second reply to {name!r}")


def describe(socket: zmq.Socket[bytes]) -> dict[str, Any]:
    """What server.describe returns."""
    socket.send(json.dumps({"contactd": 1, "id": "d", "method": "server.describe"}).encode())
    found: dict[str, Any] = reply(socket, "server.describe")["result"]
    return found


def open_session(socket: zmq.Socket[bytes]) -> str:
    """Returns its name; empty if the daemon has no room for it."""
    socket.send(json.dumps({"contactd": 1, "id": "s", "method": "session.open", "params": SESSION}).encode())
    return str(reply(socket, "session.open").get("result", {"session": ""})["session"])
