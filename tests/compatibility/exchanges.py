"""Exchanges with a daemon as bytes: what a version's clients sent, and what it answered. A file of them is never changed."""

from __future__ import annotations

import base64
import gzip
import json
from collections.abc import Iterator
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np

from support.raw import RawClient

RECORDED = Path(__file__).parent / "recorded"
#: Relative to the largest number of an array or object: what solvers may find otherwise, within their tolerances.
BOUND = 1e-4
#: What tells of the run, of the version or of a way to the solution, and not of the solution.
PASSING = {"seconds", "version", "evidence", "warnings", "sessions", "session", "state", "uptime_seconds", "recent", "lease_seconds"}
#: Ends of paths whose values have changed on purpose, with the reason.
CHANGED = {"place.on_rail.across": "lengths are counted from y = 0 of the profile, no longer from its first point beyond"}


class Exchange(NamedTuple):
    """A request, and its answer: each an envelope and its frames."""

    request: dict[str, Any]
    sent: list[bytes]
    answer: dict[str, Any]
    received: list[bytes]


def written(exchanges: list[Exchange]) -> bytes:
    lines = [
        json.dumps({
            "request": one.request, "sent": [base64.b64encode(frame).decode() for frame in one.sent],
            "answer": one.answer, "received": [base64.b64encode(frame).decode() for frame in one.received],
        })
        for one in exchanges
    ]  # fmt: skip
    return gzip.compress("\n".join(lines).encode(), mtime=0)


def read(path: Path) -> Iterator[Exchange]:
    for line in gzip.decompress(path.read_bytes()).decode().splitlines():
        told = json.loads(line)
        frames = {name: [base64.b64decode(frame) for frame in told[name]] for name in ("sent", "received")}
        yield Exchange(told["request"], frames["sent"], told["answer"], frames["received"])


def asked(raw: RawClient, request: dict[str, Any], frames: list[bytes]) -> Exchange:
    """Sends the bytes, and waits for the answer."""
    raw._methods[request["id"]] = request["method"]
    raw.send_bytes(json.dumps(request).encode(), *frames)
    answer = raw.receive()
    return Exchange(request, frames, answer.envelope, answer.frames)


def whole(value: Any, frames: list[bytes]) -> Any:
    """With arrays in place of what refers to frames."""
    if isinstance(value, dict):
        if (reference := value.get("$array")) is not None:
            return np.frombuffer(frames[reference["frame"] - 1], reference["dtype"]).reshape(reference["shape"])
        return {name: whole(item, frames) for name, item in value.items()}
    return [whole(item, frames) for item in value] if isinstance(value, list) else value


def differences(old: Any, new: Any, path: str = "result", scale: float = 0.0) -> Iterator[str]:
    """What an old client would miss or find otherwise. What is new is none: clients pass over fields that they do not know."""
    if isinstance(old, dict):
        numbers = [abs(value) for value in old.values() if isinstance(value, (int, float)) and not isinstance(value, bool)]
        for name, value in old.items():
            if name in PASSING or f"{path}.{name}".endswith(tuple(CHANGED)):
                continue
            if not isinstance(new, dict) or name not in new:
                yield f"{path}.{name} is gone"
            else:
                yield from differences(value, new[name], f"{path}.{name}", max(numbers, default=0.0))
    elif isinstance(old, np.ndarray):
        if old.dtype != new.dtype or old.shape != new.shape:
            yield f"{path} was {old.dtype}{old.shape}, and is {new.dtype}{new.shape}"
        elif old.dtype.kind == "f" and not np.abs(old - new).max(initial=0) <= BOUND * np.abs(old).max(initial=0):
            yield f"{path} differs by {np.abs(old - new).max():.2g} of {np.abs(old).max():.2g}"
    elif isinstance(old, list):
        if len(old) != len(new):
            yield f"{path} had {len(old)} entries, and has {len(new)}"
        for number, (one, other) in enumerate(zip(old, new)):
            yield from differences(one, other, f"{path}[{number}]", scale)
    elif isinstance(old, float) and isinstance(new, (int, float)):
        if not abs(old - new) <= BOUND * max(abs(old), scale, 1e-300):
            yield f"{path} was {old}, and is {new}"
    elif old != new:
        yield f"{path} was {old!r}, and is {new!r}"
