"""A ROUTER with scripted answers, to test a client with messages that a real daemon never sends."""

from __future__ import annotations

import json
import threading
from collections.abc import Callable, Iterable
from pathlib import Path
from typing import Any

import zmq

Frames = list[bytes]
Script = Callable[["Request"], Iterable[Frames]]


class Request:
    """The messages of the client, and answers to it as lists of frames."""

    def __init__(self, parts: Frames) -> None:
        self.envelope: dict[str, Any] = json.loads(parts[0])
        self.frames = parts[1:]
        self.id = self.envelope["id"]
        self.method = self.envelope["method"]
        self.params = self.envelope["params"]

    def message(self, **fields: Any) -> bytes:
        return json.dumps({"contactd": 1, "id": self.id, **fields}).encode()

    def result(self, result: Any, *frames: bytes) -> Frames:
        return [self.message(status={"code": 0, "name": "OK", "message": ""}, result=result), *frames]

    def failure(self, code: int, message: str, **details: Any) -> Frames:
        return [self.message(status={"code": code, "name": "", "message": message, "details": details})]

    def progress(self, **fields: Any) -> Frames:
        return [self.message(progress={"job": "build-1", "stage": "pcg", "fraction": 0.5, **fields})]


class FakeServer:
    """Runs `script` for every request in a separate thread; `requests` collects the requests."""

    def __init__(self, folder: Path, script: Script) -> None:
        self.script = script
        self.requests: list[Request] = []
        self._context = zmq.Context()
        self._socket = self._context.socket(zmq.ROUTER)
        self._socket.setsockopt(zmq.LINGER, 0)
        self.endpoint = f"ipc://{folder}/fake"
        self._socket.bind(self.endpoint)
        self._ending = threading.Event()
        self._thread = threading.Thread(target=self._serve)
        self._thread.start()

    def __enter__(self) -> FakeServer:
        return self

    def __exit__(self, *exception: object) -> None:
        self._ending.set()
        self._thread.join()
        self._context.destroy(linger=0)

    def _serve(self) -> None:
        while not self._ending.is_set():
            if not self._socket.poll(20):
                continue
            identity, *parts = self._socket.recv_multipart()
            request = Request(parts)
            self.requests.append(request)
            for answer in self.script(request):
                self._socket.send_multipart([identity, *answer])
