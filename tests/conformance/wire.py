"""Implements contactd's wire with ZeroMQ and JSON only, based on docs/protocol.md alone.

RECORD stores every message that a Peer receives. When the suite ends, they are checked against the daemon's own
OpenRPC document.
"""

from __future__ import annotations

import itertools
import json
import os
import select
import shutil
import signal
import subprocess
import tempfile
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import numpy as np
import zmq

BIN = Path(os.environ.get("CONTACTD_BIN", Path(__file__).parents[2] / "build" / "development" / "bin"))
TIMEOUT_MS = 30_000

OK, CANCELLED, INVALID_ARGUMENT, DEADLINE_EXCEEDED, NOT_FOUND = 0, 1, 3, 4, 5
RESOURCE_EXHAUSTED, FAILED_PRECONDITION, ABORTED, UNIMPLEMENTED = 8, 9, 10, 12
INTERNAL, UNAVAILABLE, UNAUTHENTICATED = 13, 14, 16

#: Holds received messages: the method of the request ("" if unknown), and the envelope.
RECORD: list[tuple[str, dict[str, Any]]] = []


@dataclass(frozen=True)
class Message:
    envelope: dict[str, Any]
    frames: list[bytes]

    @property
    def id(self) -> str | None:
        return self.envelope["id"]

    @property
    def is_progress(self) -> bool:
        return "progress" in self.envelope

    @property
    def progress(self) -> dict[str, Any]:
        return self.envelope["progress"]

    @property
    def code(self) -> int:
        return self.envelope["status"]["code"]

    @property
    def text(self) -> str:
        return self.envelope["status"]["message"]

    @property
    def details(self) -> dict[str, Any]:
        return self.envelope["status"].get("details", {})

    @property
    def reason(self) -> str:
        return self.details.get("reason", "")

    @property
    def fields(self) -> list[str]:
        return [violation["field"] for violation in self.details.get("violations", [])]

    @property
    def result(self) -> dict[str, Any]:
        assert self.code == OK, self.envelope["status"]
        return self.envelope["result"]

    def array(self, value: Any) -> np.ndarray[Any, Any]:
        """Returns the array that `value` of this message represents: a list, or a reference to a frame."""
        if isinstance(value, list):
            return np.array(value)
        reference = value["$array"]
        frame = self.frames[reference["frame"] - 1]
        return np.frombuffer(frame, reference["dtype"]).reshape(reference["shape"])


@dataclass(frozen=True)
class Keys:
    """Holds keys for CURVE, in Z85: the daemon's public key, and the client's own pair."""

    server: bytes
    own: tuple[bytes, bytes]


class Peer:
    """Represents one socket, with its own ids; received messages are recorded."""

    def __init__(self, endpoint: str, kind: int = zmq.DEALER, keys: Keys | None = None) -> None:
        self._context = zmq.Context()
        self.socket = self._context.socket(kind)
        self.socket.setsockopt(zmq.LINGER, 0)
        if keys is not None:
            self.socket.curve_serverkey = keys.server
            self.socket.curve_publickey, self.socket.curve_secretkey = keys.own
        self.socket.connect(endpoint)
        self._ids = (f"{n}" for n in itertools.count(1))
        self._methods: dict[str | None, str] = {}

    def __enter__(self) -> Peer:
        return self

    def __exit__(self, *exception: object) -> None:
        self._context.destroy(linger=0)

    def send(self, method: str, params: Any = None, *frames: bytes, **envelope: Any) -> str:
        """Sends a request and returns its id."""
        fields = {"contactd": 1, "id": next(self._ids), "method": method, **envelope}
        if params is not None:
            fields["params"] = params
        self._methods[fields["id"]] = method
        self.send_bytes(json.dumps(fields).encode(), *frames)
        return fields["id"]

    def send_bytes(self, *parts: bytes) -> None:
        self.socket.send_multipart(parts)

    def message(self) -> Message:
        """Returns the next message, progress or reply."""
        assert self.socket.poll(TIMEOUT_MS), "no message within half a minute"
        text, *frames = self.socket.recv_multipart()
        message = Message(json.loads(text), frames)
        RECORD.append((self._methods.get(message.id, ""), message.envelope))
        return message

    def reply(self) -> Message:
        """Returns the next reply, after any progress."""
        while (message := self.message()).is_progress:
            pass
        return message

    def ask(self, method: str, params: Any = None, *frames: bytes, **envelope: Any) -> Message:
        name = self.send(method, params, *frames, **envelope)
        reply = self.reply()
        assert reply.id == name
        return reply

    def ask_text(self, text: str | bytes, *frames: bytes) -> Message:
        """Sends frame 0 unchanged; if it has an id, it is "x"."""
        try:
            self._methods["x"] = json.loads(text)["method"]
        except (ValueError, KeyError, TypeError, RecursionError):
            pass  # an unreadable reply, or one without it, has no result either
        self.send_bytes(text.encode() if isinstance(text, str) else text, *frames)
        return self.reply()

    def cancel(self, name: str) -> None:
        """Ends one of this peer's requests, whose reply comes first."""
        self.send("request.cancel", {"id": name})
        assert (self.reply().code, self.reply().code) == (CANCELLED, OK)

    def is_silent(self) -> bool:
        """Checks that no work is running: an answer requested now must be the next message."""
        name = self.send("server.health")
        return self.message().id == name


@dataclass
class Daemon:
    """Runs a daemon in its own folder."""

    config: dict[str, Any]
    folder: Path = field(default_factory=lambda: Path(tempfile.mkdtemp(prefix="contactd-wire-")))

    def __post_init__(self) -> None:
        config = {
            "endpoint": f"ipc://{self.folder}/socket",
            "store": {"folder": str(self.folder / "store")},
            "log": {"file": str(self.folder / "log")},
            **self.config,
        }
        (self.folder / "config.json").write_text(json.dumps(config))
        self.process = subprocess.Popen(
            [BIN / "contactd", "--config", self.folder / "config.json"],
            stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True,
        )  # fmt: skip
        assert select.select([self.process.stdout], [], [], 30)[0], "the daemon was not ready within half a minute"
        self.endpoint = json.loads(self.process.stdout.readline())["endpoint"]

    def peer(self, kind: int = zmq.DEALER, keys: Keys | None = None) -> Peer:
        return Peer(self.endpoint, kind, keys)

    @property
    def log(self) -> str:
        return (self.folder / "log").read_text()

    def terminate(self) -> None:
        self.process.send_signal(signal.SIGTERM)

    def finish(self) -> None:
        """Ends the daemon in order; only its log, configuration and tables may remain."""
        try:
            self.process.terminate()
            try:
                assert self.process.wait(30) == 0
            except subprocess.TimeoutExpired:
                self.process.kill()
                self.process.wait()
                raise
            finally:
                self.process.stdout.close()
            left = [path for path in self.folder.rglob("*") if not path.is_dir() and path.suffix != ".h5"]
            assert {path.name for path in left} <= {"log", "config.json"}, left
        finally:
            shutil.rmtree(self.folder)
