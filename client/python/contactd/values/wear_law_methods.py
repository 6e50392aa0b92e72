"""How kinds of wear are written, whose fields are in `wear_laws`."""

from __future__ import annotations

from typing import Any

__all__ = ["StatedWear"]

_OF_LAWS = ("source", "body", "range", "name")


class StatedWear:
    """A kind of wear that may have what a WearLaw says of it; on the wire that stands in the law."""

    @staticmethod
    def _completed(written: dict[str, Any]) -> dict[str, Any]:
        return {name: value for name, value in written.items() if name not in _OF_LAWS}
