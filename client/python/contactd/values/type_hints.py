"""Determines the types of the fields of a class."""

from __future__ import annotations

from typing import Any, get_type_hints

__all__ = ["hints_of"]


def hints_of(kind: Any) -> dict[str, Any]:
    """Returns the result of get_type_hints. KW_ONLY, a marker in front of keyword-only fields, is replaced by a type
    here, because Python 3.10 refuses it.
    """
    return get_type_hints(kind, localns={"KW_ONLY": object})
