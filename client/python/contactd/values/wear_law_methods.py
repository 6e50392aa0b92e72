"""Implements the wire format of wear laws; `wear_laws` declares the fields."""

from __future__ import annotations

from typing import Any

__all__ = ["StatedWear"]

_OF_LAWS = ("source", "body", "range", "name")


class StatedWear:
    """A kind of wear that may also have the fields of a WearLaw; on the wire these are in the law."""

    @staticmethod
    def _completed(written: dict[str, Any]) -> dict[str, Any]:
        return {name: value for name, value in written.items() if name not in _OF_LAWS}
