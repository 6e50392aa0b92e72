"""Requests and answers as messages (docs/protocol.md), whole or in parts, for any transport."""

from __future__ import annotations

import json
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Any, TypeVar

from .._version import __version__
from ..errors import ProtocolError, StatusError, Violation, status_error

__all__ = [
    "CLIENT",
    "PROTOCOL_VERSION",
    "Buffer",
    "Reply",
    "Request",
    "cancellation",
    "parsed",
    "reply_of",
    "results",
    "status_error_of",
]


PROTOCOL_VERSION = 1
CLIENT = f"contactd-python {__version__}"  #: Name of this client in the daemon's log.


Buffer = bytes | memoryview  #: Types of received arrays and envelopes.


def _refuse(word: str) -> Any:
    raise ValueError(f"{word} is not a number in JSON")


_READER = json.JSONDecoder(parse_constant=_refuse)
_WRITER = json.JSONEncoder(allow_nan=False, separators=(",", ":"))


@dataclass(frozen=True)
class Request:
    """Holds a request to the daemon, and the time to wait for its answer.

    Attributes:
        envelope: JSON, in which arrays are references to frames.
        frames: The arrays, as bytes.
        deadline: End of the wait, by time.monotonic().
        connect_timeout: Time to wait for a connection (s).
        on_progress: Called with reports of progress before the answer, as JSON.
    """

    envelope: dict[str, Any]
    frames: Sequence[bytes]
    deadline: float
    connect_timeout: float
    on_progress: Callable[[dict[str, Any]], None] | None = None

    @property
    def id(self) -> str:
        """Identifies its answers."""
        return str(self.envelope["id"])

    @property
    def method(self) -> str:
        """The method of the daemon."""
        return str(self.envelope["method"])

    def message(self) -> list[bytes]:
        """All frames."""
        return [_WRITER.encode(self.envelope).encode(), *self.frames]


@dataclass(frozen=True)
class Reply:
    """Holds the answer to one request: the JSON of its `result` and the array frames after it.

    Attributes:
        result: JSON, in which arrays are references to frames.
        frames: The arrays, as bytes.
    """

    result: dict[str, Any]
    frames: Sequence[Buffer]


def cancellation(name: str) -> bytes:
    """Returns a message that cancels the request with this ID."""
    params = {"id": name}
    request = {"contactd": PROTOCOL_VERSION, "id": f"{name}-cancel", "method": "request.cancel", "params": params}
    return json.dumps(request).encode()


def parsed(text: Buffer) -> dict[str, Any]:
    """Returns the envelope of an answer. Raises ProtocolError."""
    try:
        answer = _READER.decode(str(text, "utf-8"))
    except (ValueError, RecursionError):
        raise ProtocolError(f"The answer is not JSON: {bytes(text[:80])!r}") from None
    version = answer.get("contactd") if isinstance(answer, dict) else None
    if type(version) is not int:
        raise ProtocolError(f"The answer is not a message of contactd's protocol: {bytes(text[:80])!r}")
    if version != PROTOCOL_VERSION:
        side = "client (the Python package contactd)" if version > PROTOCOL_VERSION else "daemon"
        raise ProtocolError(
            f"The daemon answers in version {version} of the protocol; this client speaks {PROTOCOL_VERSION}: "
            f"upgrade the {side}."
        )
    return dict(answer)


def reply_of(answer: dict[str, Any], frames: Sequence[Buffer]) -> Reply:
    """Reads an envelope with a status, and its frames. Raises StatusError or ProtocolError."""
    if (error := status_error_of(answer["status"])) is not None:
        raise error
    if not isinstance(answer.get("result"), dict):
        raise _unreadable(answer)
    return Reply(answer["result"], frames)


def status_error_of(status: Any) -> StatusError | None:
    """Returns the exception of a status; None if it is OK. Raises ProtocolError for an invalid status."""
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


T = TypeVar("T")


def results(
    method: str, result: dict[str, Any], name: str, readers: Sequence[Callable[[Any, str], T]]
) -> list[T | StatusError]:
    """Returns `result[name]`, the answer of each part to `method`. The reader of each part receives its path."""
    parts = result.get(name)
    if not isinstance(parts, list) or len(parts) != len(readers):
        raise ProtocolError(f"The answer to {method} lacks its {len(readers)} {name}.")
    return [_outcome(part, reader, f"result.{name}[{i}].result") for i, (part, reader) in enumerate(zip(parts, readers))]


def _outcome(part: Any, reader: Callable[[Any, str], T], path: str) -> T | StatusError:
    error = status_error_of(part.get("status") if isinstance(part, dict) else None)
    return reader(part.get("result"), path) if error is None else error
