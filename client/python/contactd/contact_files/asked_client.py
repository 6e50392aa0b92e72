"""The calls of a client that reading and computing files needs."""

from __future__ import annotations

from typing import Any, Protocol

__all__ = ["AskedClient"]


class AskedClient(Protocol):
    """Describes a Client, or any object with these calls."""

    @property
    def info(self) -> Any: ...
    @property
    def read_contact_file(self) -> Any: ...
    @property
    def read_contact_slices(self) -> Any: ...
    @property
    def run_contact_file(self) -> Any: ...
    @property
    def convert_contact_file(self) -> Any: ...
