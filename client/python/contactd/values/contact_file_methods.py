"""Implements methods of the cases of a file; `contact_files` declares the fields."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any, Generic, TypeVar, overload

__all__ = ["ContactFileMethods"]

C = TypeVar("C")


class ContactFileMethods(Generic[C]):
    """Implements methods of a ContactFile: a sequence of its cases."""

    def __iter__(self: Any) -> Iterator[C]:
        return iter(self.cases)

    def __len__(self: Any) -> int:
        return len(self.cases)

    @overload
    def __getitem__(self, index: int) -> C: ...
    @overload
    def __getitem__(self, index: slice) -> tuple[C, ...]: ...
    def __getitem__(self: Any, index: Any) -> Any:
        return self.cases[index]
