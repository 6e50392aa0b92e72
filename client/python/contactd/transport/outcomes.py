"""What came of each part of a request: an answer, or the exception that it alone would have raised."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any, TypeVar

from ..errors import ProtocolError, StatusError
from .messages import status_error_of

__all__ = ["outcomes"]

T = TypeVar("T")


def outcomes(
    method: str, result: dict[str, Any], name: str, readers: Sequence[Callable[[Any, str], T]]
) -> list[T | StatusError]:
    """`result[name]`, the answer of each part to `method`, read by the reader of that part, which is told its path."""
    parts = result.get(name)
    if not isinstance(parts, list) or len(parts) != len(readers):
        raise ProtocolError(f"The answer to {method} lacks its {len(readers)} {name}.")
    return [_outcome(part, reader, f"result.{name}[{i}].result") for i, (part, reader) in enumerate(zip(parts, readers))]


def _outcome(part: Any, reader: Callable[[Any, str], T], path: str) -> T | StatusError:
    error = status_error_of(part.get("status") if isinstance(part, dict) else None)
    return reader(part.get("result"), path) if error is None else error
