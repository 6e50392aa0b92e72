"""Sends requests as bytes, including those that a client would never send. Validates every answer against its schema."""

from __future__ import annotations

import itertools
import json
from dataclasses import dataclass
from typing import Any

import numpy as np
import zmq

from . import schemas
from .slowness import SLOWER

TIMEOUT_MS = 30_000 * SLOWER


@dataclass(frozen=True)
class Answer:
    envelope: dict[str, Any]
    frames: list[bytes]

    @property
    def result(self) -> dict[str, Any]:
        assert self.envelope["status"]["code"] == 0, self.envelope["status"]
        return self.envelope["result"]

    @property
    def status(self) -> str:
        return self.envelope["status"]["name"]

    @property
    def message(self) -> str:
        return self.envelope["status"]["message"]

    @property
    def reason(self) -> str:
        return self.envelope["status"]["details"]["reason"]

    @property
    def fields(self) -> list[str]:
        return [violation["field"] for violation in self.envelope["status"]["details"].get("violations", [])]

    def array(self, name: str) -> np.ndarray[Any, Any]:
        reference = self.result[name]["$array"]
        return np.frombuffer(self.frames[reference["frame"] - 1], reference["dtype"]).reshape(reference["shape"])


class RawClient:
    """One DEALER (or `kind`) socket."""

    def __init__(self, endpoint: str, kind: int = zmq.DEALER) -> None:
        self._context = zmq.Context()
        self.socket = self._context.socket(kind)
        self.socket.setsockopt(zmq.LINGER, 0)
        self.socket.connect(endpoint)
        self._ids = itertools.count(1)
        self._methods: dict[str, str] = {}

    def __enter__(self) -> RawClient:
        return self

    def __exit__(self, *exception: object) -> None:
        self._context.destroy(linger=0)

    def ask(self, method: str, params: Any = None, *frames: bytes, **envelope: Any) -> Answer:
        self.send(method, params, *frames, **envelope)
        return self.receive()

    def send(self, method: str, params: Any = None, *frames: bytes, **envelope: Any) -> str:
        """Sends a request and returns its id."""
        name = str(envelope.get("id", next(self._ids)))
        self._methods[name] = method
        fields = {"contactd": 1, "id": name, "method": method, "params": {} if params is None else params, **envelope}
        self.send_bytes(json.dumps(fields).encode(), *frames)
        return name

    def send_bytes(self, *parts: bytes) -> None:
        self.socket.send_multipart(parts)

    def receive(self, timeout: float = TIMEOUT_MS / 1000 / SLOWER) -> Answer:
        """Returns the next reply within `seconds`. Progress messages before it are validated and skipped."""
        while True:
            assert self.socket.poll(int(1000 * timeout * SLOWER)), "no answer"
            text, *frames = self.socket.recv_multipart()
            envelope = json.loads(text)
            if "progress" in envelope:
                schemas.check("progress", envelope)
                continue
            schemas.check_reply(self._methods.get(envelope["id"] or "", "?"), envelope)
            return Answer(envelope, frames)
