"""Compares the answers to one request bit by bit, except for values that differ between any two runs."""

from __future__ import annotations

import re
from dataclasses import dataclass
from typing import Any

import numpy as np

from .contents import Array, Contents, Number

#: Fields with durations and versions, which are not compared.
VOLATILE = re.compile(r"(^|[./_])(seconds|version)(\.|$)")


@dataclass(frozen=True)
class Explained:
    """Describes an intended difference: the kind of cases, the fields, and the reason."""

    kind: str
    field: str
    why: str

    def holds(self, kind: str, field: str) -> bool:
        return re.fullmatch(self.kind, kind) is not None and re.fullmatch(self.field, field) is not None


#: Kind and field are regular expressions for the whole name. Remove an entry when both commits contain the change.
EXPLAINED: list[Explained] = [
    Explained(
        "impossible table",
        r"status\.(message|details\.violations\[\d+\]\.description)",
        "a refused word is answered with the word that was meant",
    ),
    Explained(
        "session",
        r"result\.warnings\[\d+\]",
        "a contact that is a small part of its area gets a warning of units, too",
    ),
]


@dataclass(frozen=True)
class Difference:
    field: str
    before: str
    after: str

    def __str__(self) -> str:
        return f"{self.field}\n        before {self.before}\n        after  {self.after}"


def differences(before: Contents, after: Contents) -> list[Difference]:
    found = []
    for field in [*before, *(field for field in after if field not in before)]:
        if VOLATILE.search(field):
            continue
        one, other = before.get(field, "(nothing)"), after.get(field, "(nothing)")
        if type(one) is not type(other) or one != other:
            found.append(Difference(field, *_texts(one, other)))
    return found


def _texts(one: Any, other: Any) -> tuple[str, str]:
    if isinstance(one, Array) and isinstance(other, Array) and (one.dtype, one.shape) == (other.dtype, other.shape):
        return _array_texts(one, other)
    if isinstance(one, str) and isinstance(other, str) and not isinstance(one, Number):
        return _long_texts(one, other)
    return _text(one), _text(other)


def _text(value: Any) -> str:
    if isinstance(value, Array):
        return f"array of {value.dtype}, shape {list(value.shape)}"
    return str(value) if isinstance(value, Number) else repr(value)


def _array_texts(one: Array, other: Array) -> tuple[str, str]:
    """Returns the element that differs most, and the number of differing ones."""
    a, b = one.numpy(), other.numpy()
    unlike = np.frombuffer(one.data, np.uint8) != np.frombuffer(other.data, np.uint8)
    count = int(unlike.reshape(a.size, -1).any(axis=1).sum())
    if not np.issubdtype(a.dtype, np.number):
        return repr(a.tolist()), repr(b.tolist())
    change = np.abs(b.astype(float) - a.astype(float))
    at = tuple(int(i) for i in np.unravel_index(int(np.argmax(change)), a.shape)) if a.shape else ()
    largest = float(np.max(np.abs(a))) if a.size else 0
    share = f", {change[at] / largest:.1e} of the largest" if largest else ""
    return f"{a[at].item()!r} at {list(at)}", f"{b[at].item()!r}{share}; {count} of {a.size} elements differ"


def _long_texts(one: str, other: str) -> tuple[str, str]:
    """Returns the position in both at which they begin to differ."""
    at = next((n for n, (a, b) in enumerate(zip(one, other, strict=False)) if a != b), min(len(one), len(other)))
    start = max(0, at - 60)
    return repr(one[start : at + 120]), repr(other[start : at + 120])
