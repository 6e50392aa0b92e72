"""Sends requests one by one through a connection."""

from __future__ import annotations

import json
import threading
import time
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass, field
from typing import Any

import numpy as np
import zmq

PATIENCE_SECONDS = 300
Json = Any


@dataclass
class Request:
    """`params` may contain numpy arrays, which are sent as frames, or as lists if `arrays` is "list"."""

    method: str
    params: Json
    envelope: dict[str, Any] = field(default_factory=dict)

    def parts(self, name: str) -> list[bytes]:
        frames: list[bytes] = []
        as_lists = self.envelope.get("arrays") == "list"
        params = _packed(self.params, None if as_lists else frames)
        fields = {"contactd": 1, "id": name, "method": self.method, "params": params, **self.envelope}
        return [json.dumps(fields).encode(), *frames]


@dataclass
class Raw:
    """Sends a request unchanged, even if it is invalid."""

    method: str
    sent: list[bytes]

    def parts(self, name: str) -> list[bytes]:
        return self.sent


@dataclass(frozen=True)
class Answer:
    """Returns the last reply to a request; earlier progress is ignored."""

    text: bytes
    frames: list[bytes]

    @property
    def envelope(self) -> Json:
        return json.loads(self.text)

    @property
    def ok(self) -> bool:
        return bool(self.envelope["status"]["code"] == 0)

    @property
    def result(self) -> Json:
        return self.envelope["result"]

    def array(self, *path: str) -> np.ndarray[Any, Any]:
        found = self.result
        for name in path:
            found = found[name]
        if isinstance(found, list):
            return np.array(found)
        reference = found["$array"]
        return np.frombuffer(self.frames[reference["frame"] - 1], reference["dtype"]).reshape(reference["shape"])


class Connection:
    """Sends requests to one daemon until `stop` is set by another thread. Waiting calls then raise
    InterruptedError."""

    def __init__(self, socket: zmq.Socket[bytes], stop: threading.Event) -> None:
        self._socket = socket
        self._stop = stop

    def ask(self, request: Request | Raw, name: str = "request") -> Answer:
        self._socket.send_multipart(request.parts(name))
        deadline = time.monotonic() + PATIENCE_SECONDS
        while True:
            while not self._socket.poll(200):
                if self._stop.is_set():
                    raise InterruptedError
                if time.monotonic() > deadline:
                    raise TimeoutError(f"no answer to {request.method} within {PATIENCE_SECONDS} s")
            text, *frames = self._socket.recv_multipart()
            if b'"progress"' not in text or "progress" not in json.loads(text):
                return Answer(text, frames)


@contextmanager
def connected(endpoint: str, stop: threading.Event) -> Iterator[Connection]:
    with zmq.Context() as context, context.socket(zmq.DEALER) as socket:
        socket.linger = 0
        socket.connect(endpoint)
        yield Connection(socket, stop)


def _packed(node: Json, frames: list[bytes] | None) -> Json:
    """Returns `node` with its arrays as lists, or as references to `frames`, to which they are added."""
    if isinstance(node, np.ndarray):
        if frames is None:
            return node.tolist()
        frames.append(np.ascontiguousarray(node, "<f8").tobytes())
        return {"$array": {"frame": len(frames), "dtype": "<f8", "shape": list(node.shape)}}
    if isinstance(node, dict):
        return {key: _packed(value, frames) for key, value in node.items()}
    if isinstance(node, list):
        return [_packed(value, frames) for value in node]
    return node
