"""Runs many clients in one process: each sends a request, waits for its answer, checks it, and sends the next."""

from __future__ import annotations

import json
import random
import time
from dataclasses import dataclass, field
from typing import Any

import numpy as np
import zmq

from load.workload import KINDS, draw, is_right, request

TIMEOUT = 60.0  # seconds for one answer


@dataclass
class Tally:
    """Holds the results of clients. Latencies are in milliseconds, by phase and kind."""

    sent: int = 0
    answered: int = 0
    refused: int = 0  # with a delay for the next attempt
    problems: list[str] = field(default_factory=list)
    latencies: dict[str, dict[str, list[float]]] = field(default_factory=dict)

    def problem(self, sentence: str) -> None:
        if len(self.problems) < 20:
            self.problems.append(sentence)


@dataclass
class Client:
    """Represents one DEALER with at most one open request."""

    socket: zmq.Socket[bytes]
    name: str
    count: int = 0
    waiting: str = ""
    kind: int = 0
    factor: float = 1.0
    since: float = 0.0
    resume: float = 0.0  # earliest time of the next request, after a refusal

    def ask(self, choose: random.Random, tally: Tally) -> None:
        self.count += 1
        self.kind, self.factor = draw(choose)
        self.waiting = f"{self.name}-{self.count}"
        self.socket.send_multipart(request(KINDS[self.kind], self.waiting, self.factor))
        self.since = time.monotonic()
        tally.sent += 1

    def take(self, parts: list[bytes], references: list[Any], phase: str, tally: Tally) -> None:
        envelope = json.loads(parts[0])
        if "progress" in envelope:
            return
        if envelope["id"] != self.waiting:
            return tally.problem(f"{self.name} waits for {self.waiting!r} and gets {envelope['id']!r}")
        now = time.monotonic()
        self.waiting = ""
        tally.answered += 1
        kind, status = KINDS[self.kind], envelope["status"]
        details = status.get("details", {})
        if status["name"] == "RESOURCE_EXHAUSTED" and "retry_delay_ms" in details:
            tally.refused += 1
            self.resume = now + details["retry_delay_ms"] / 1000
            return
        if status["code"] != 0:
            return tally.problem(f"{kind.name}: {status}")
        if not is_right(kind, self.factor, envelope["result"], parts[1:], np.array(references[self.kind])):
            tally.problem(f"{kind.name}: the answer to {envelope['id']} is not its own")
        tally.latencies.setdefault(phase, {}).setdefault(kind.name, []).append((now - self.since) * 1000)


def references(socket: zmq.Socket[bytes]) -> list[list[float]]:
    """Returns the answers of every kind to the factor 1, computed by a single client."""
    found = []
    for kind in KINDS:
        socket.send_multipart(request(kind, "reference", 1.0))
        while True:
            if not socket.poll(TIMEOUT * 1000):
                raise TimeoutError(f"no answer to {kind.name}")
            text, *frames = socket.recv_multipart()
            envelope = json.loads(text)
            if "progress" not in envelope:
                break
        if envelope["status"]["code"] != 0:
            raise RuntimeError(f"{kind.name}: {envelope['status']}")
        found.append(kind.numbers(envelope["result"], frames).tolist())
    return found


def run(endpoint: str, name: str, number: int, seed: int, references_: list[Any], phases: list[tuple[str, float]]) -> Tally:
    """Runs `number` clients until the last phase ends; `phases` are names and ends (time.monotonic, the same in every
    process)."""
    tally = Tally()
    choose = random.Random(seed)
    with zmq.Context() as context:
        poller = zmq.Poller()
        clients: dict[zmq.Socket[bytes], Client] = {}
        for n in range(number):
            socket = context.socket(zmq.DEALER)
            socket.linger = 0
            socket.connect(endpoint)
            poller.register(socket, zmq.POLLIN)
            clients[socket] = Client(socket, f"{name}.{n}")
        for phase, end in phases:
            while (now := time.monotonic()) < end:
                for client in clients.values():
                    if not client.waiting and client.resume <= now:
                        client.ask(choose, tally)
                _receive(poller, clients, references_, phase, tally, 100)
        _finish(poller, clients, references_, tally)
        for socket in clients:
            socket.close()
    return tally


def _receive(poller: zmq.Poller, clients: Any, references_: Any, phase: str, tally: Tally, milliseconds: int) -> None:
    for socket, _ in poller.poll(milliseconds):
        clients[socket].take(socket.recv_multipart(), references_, phase, tally)


def _finish(poller: zmq.Poller, clients: Any, references_: Any, tally: Tally) -> None:
    """Waits for open requests, then requests the health, whose answer must be the only one to arrive."""
    deadline = time.monotonic() + TIMEOUT
    while any(client.waiting for client in clients.values()) and time.monotonic() < deadline:
        _receive(poller, clients, references_, "end", tally, 100)
    for client in clients.values():
        if client.waiting:
            tally.problem(f"no answer to {client.waiting} within {TIMEOUT:g} s")
    for socket, client in clients.items():
        client.waiting, client.kind = f"{client.name}-last", len(KINDS) - 1
        socket.send_multipart(request(KINDS[client.kind], client.waiting, 1.0))
        tally.sent += 1
    deadline = time.monotonic() + TIMEOUT
    while any(client.waiting for client in clients.values()) and time.monotonic() < deadline:
        _receive(poller, clients, references_, "end", tally, 100)
