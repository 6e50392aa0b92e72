"""The types of the fields of a class."""

from __future__ import annotations

from typing import Any, get_type_hints

__all__ = ["hints_of"]


def hints_of(kind: Any) -> dict[str, Any]:
    """Returns what get_type_hints does. KW_ONLY, which stands before fields that are given by name, is a type here: Python 3.10
    refuses classes that have it otherwise."""
    return get_type_hints(kind, localns={"KW_ONLY": object})
