"""The calls of a client that reading and computing files needs."""

from __future__ import annotations

from typing import Any, Protocol

__all__ = ["AskedClient"]


class AskedClient(Protocol):
    """A Client, or any object with these calls."""

    @property
    def info(self) -> Any: ...
    @property
    def solve(self) -> Any: ...
    @property
    def subsurface(self) -> Any: ...
    @property
    def wheel_rail(self) -> Any: ...
    @property
    def wheel_rail_session(self) -> Any: ...
    @property
    def placed_profiles(self) -> Any: ...
    @property
    def read_contact_file(self) -> Any: ...
    @property
    def read_contact_slices(self) -> Any: ...
