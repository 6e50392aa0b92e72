"""Gets and sets fields of parameters by their paths, as in error messages: ``friction.rolling.xi``,
``ics.layers[0].G``."""

from __future__ import annotations

import re
from typing import Any

__all__ = ["copied", "get", "parts", "put"]

_PART = re.compile(r"([A-Za-z_$][\w$]*)((?:\[[0-9]{1,9}\])*)")

_MOST_SHOWN = 100  #: Largest length of a path in a message.


def parts(path: str) -> list[str | int]:
    """Returns names and indices. Raises ValueError."""
    found: list[str | int] = []
    for piece in path.strip().split("."):
        matched = _PART.fullmatch(piece)
        if matched is None:
            shown = path if len(path) < _MOST_SHOWN else f"{path[:_MOST_SHOWN]}..."
            raise ValueError(f"{shown!r} is not the path of a field, such as friction.rolling.xi or ics.layers[0].G.")
        found.append(matched[1])
        found.extend(int(index) for index in re.findall(r"\d+", matched[2]))
    return found


def put(document: Any, path: str, value: Any) -> None:
    """Sets a value in `document`; creates missing or null objects on the path. Raises ValueError."""
    *way, last = parts(path)
    at = document
    for part in way:
        if isinstance(part, str) and isinstance(at, dict):
            if at.get(part) is None:
                at[part] = {}
            at = at[part]
        else:
            at = _member(at, part, path)
    if isinstance(last, str) and isinstance(at, dict):
        at[last] = value
    else:
        _member(at, last, path)
        at[last] = value


def get(document: Any, path: str) -> Any:
    """Returns the value, or None."""
    at = document
    for part in parts(path):
        try:
            at = at[part]
        except (KeyError, IndexError, TypeError):
            return None
    return at


def copied(document: Any) -> Any:
    """Copies objects and lists, but not arrays."""
    if isinstance(document, dict):
        return {name: copied(member) for name, member in document.items()}
    if isinstance(document, list):
        return [copied(member) for member in document]
    return document


def _member(at: Any, part: str | int, path: str) -> Any:
    try:
        return at[part]
    except (KeyError, IndexError, TypeError):
        what = f"entry [{part}]" if isinstance(part, int) else f"object with {part}"
        raise ValueError(f"{path} cannot be set: there is no {what} on its path.") from None
