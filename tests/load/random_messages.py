"""Random messages at a running daemon: each gets exactly one status with its id, and nothing of them stays in memory.

    ./dev load random [--count 100000] [--seed 1]               at the daemon as it is installed
    ./dev load random --preset sanitize [--count ...]           at one that is built with ASan and UBSan (several times slower)

Requests are made from the schemas of server.describe and damaged (messages.py); half of them go through DEALER, half
through REQ. The daemon's grids are limited, so that none of them takes long, and its builder is /bin/false.
"""

from __future__ import annotations

import argparse
import collections
import json
import math
import sys
import time
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import zmq

from contactd.daemon import LocalDaemon
from load.messages import SESSION, Message, Messages
from load.process import resident_bytes

LIMITS = {"max_grid_elements": 64, "max_array_elements": 2000, "max_frame_bytes": 65536, "max_message_bytes": 262144, "max_frames": 32}
CONFIG = {"limits": LIMITS, "sessions": {"max_sessions": 4096, "lease_seconds": 5, "max_lease_seconds": 10}, "builds": {"program": "/bin/false"}, "log": {"level": "warn"}}
PATIENCE_MS = 60_000
BATCH = 32


class Wrong(AssertionError):
    """What a message did that it must not; names the message."""


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
    """The next reply; progress is passed over."""
    while True:
        if not socket.poll(PATIENCE_MS):
            raise Wrong(f"no answer within {PATIENCE_MS / 1000:g} s to {about}")
        parts = socket.recv_multipart()
        # A DEALER whose envelope was empty, with frames behind it, looks like a REQ and is answered like one.
        envelope = json.loads(parts[0] or parts[1])
        if "progress" not in envelope:
            return envelope


def finite(number: str) -> float:
    """Refuses what no double holds, as the daemon does; NaN and Infinity, too."""
    if not math.isfinite(value := float(number)):
        raise ValueError(number)
    return value


def readable_id(message: Message) -> str | None:
    """The id that every JSON parser would find; None where they may differ."""
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
    """All at once; as many replies as messages, and every readable id as often as it was sent."""
    for message in batch:
        socket.send_multipart([message.text, *message.frames])
    ids: collections.Counter[str | None] = collections.Counter()
    for _ in batch:
        missing = [str(message) for message in batch if not ids[readable_id(message)]]
        ids[take(reply(socket, "\n".join(missing)), outcome)] += 1
    sent = collections.Counter(map(readable_id, batch))  # damage may give two messages the same
    for message in batch:
        name = readable_id(message)
        if name is not None and ids[name] != sent[name]:
            raise Wrong(f"{ids[name]} replies to {message}")


def by_req(socket: zmq.Socket[bytes], message: Message, outcome: Outcome) -> None:
    socket.send_multipart([message.text, *message.frames])
    name, wanted = take(reply(socket, message), outcome), readable_id(message)
    if wanted is not None and name != wanted:
        raise Wrong(f"id {name!r} in the reply to {message}")


def expect_silence(socket: zmq.Socket[bytes]) -> None:
    """Messages of one client are answered in any order, but health asked last shows that nothing else is on its way."""
    socket.send(json.dumps({"contactd": 1, "id": "last", "method": "server.health"}).encode())
    if (name := reply(socket, "server.health")["id"]) != "last":
        raise Wrong(f"a second reply to {name!r}")


def open_session(socket: zmq.Socket[bytes]) -> str:
    socket.send(json.dumps({"contactd": 1, "id": "s", "method": "session.open", "params": SESSION}).encode())
    return str(reply(socket, "session.open")["result"]["session"])


def run(daemon: LocalDaemon, count: int, seed: int) -> Outcome:
    """Sends `count` messages. Memory is looked at twenty times, first when a twentieth has been sent."""
    outcome = Outcome()
    with connected(daemon, zmq.DEALER) as dealer, connected(daemon, zmq.REQ) as req:
        dealer.send(json.dumps({"contactd": 1, "id": "d", "method": "server.describe"}).encode())
        messages = Messages(reply(dealer, "server.describe")["result"], seed)
        sent = 0
        while sent < count:
            start = time.monotonic()
            messages.sessions = [*messages.sessions[-2:], open_session(dealer)]
            batch = [messages.next(f"{sent + n}") for n in range(min(BATCH, count - sent))]
            half = len(batch) // 2
            by_dealer(dealer, batch[:half], outcome)
            for message in batch[half:]:
                by_req(req, message, outcome)
            sent += len(batch)
            outcome.slowest = max(outcome.slowest, time.monotonic() - start)
            if sent >= count * (len(outcome.memory) + 1) / 20:
                outcome.memory.append(resident_bytes(daemon.pid))
        expect_silence(dealer)
    if daemon.process.poll() is not None:
        raise Wrong("the daemon has ended")
    return outcome


def main(arguments: list[str]) -> int:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--bin", type=Path, required=True, help="folder with the programs")
    parser.add_argument("--count", type=int, default=100_000)
    parser.add_argument("--seed", type=int, default=1)
    options = parser.parse_args(arguments)
    start = time.monotonic()
    with LocalDaemon(options.bin / "contactd", config=CONFIG) as daemon:
        try:
            outcome = run(daemon, options.count, options.seed)
        finally:
            # A sanitizer ends the daemon with its report in the log, of leaks when it ends in order.
            if (status := daemon.stop()) != 0:
                print(f"the daemon ended with status {status}; the end of its log:\n{daemon.log[-5000:]}")
        if status != 0:
            return 1
    for status, count in outcome.statuses.most_common():
        print(f"{count:8} {status}")
    mib = [bytes_ / 2**20 for bytes_ in outcome.memory]
    print(f"resident memory (MiB), each twentieth: {' '.join(f'{value:.1f}' for value in mib)}")
    print(f"slowest batch of {BATCH}: {outcome.slowest:.2f} s; all in {time.monotonic() - start:.0f} s")
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
