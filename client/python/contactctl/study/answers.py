"""Valid answers of a study: an optional answer may be missing, an unknown one is an error."""

from __future__ import annotations

import types
from collections.abc import Iterator
from dataclasses import is_dataclass
from functools import cache
from typing import Any, TypeVar, Union, get_args, get_origin

from contactd import ContactSolution
from contactd.values.type_hints import hints_of
from contactd.wheel_rail import WheelRailSolution

from ..paths import parts

__all__ = ["may_answer"]

_KINDS = {"contact.solve": ContactSolution, "wheelrail.solve": WheelRailSolution}


@cache
def may_answer(method: str, path: str) -> bool:
    """Returns whether an answer of the method can have this path."""
    found: list[Any] = [_KINDS[method]]
    for part in parts(path):
        found = [inner for hint in found for kind in _alternatives(hint) for inner in _inside(kind, part)]
    return bool(found)


def _alternatives(hint: Any) -> tuple[Any, ...]:
    return get_args(hint) if get_origin(hint) in (Union, types.UnionType) else (hint,)


def _inside(kind: Any, part: str | int) -> Iterator[Any]:
    """Returns the types of the member of this type. Members of open types may exist."""
    origin = get_origin(kind) or kind
    if kind is Any or isinstance(kind, TypeVar) or origin is dict or getattr(origin, "__name__", "") == "Mapping":
        yield Any
    elif isinstance(part, int):
        if origin in (tuple, list):
            yield from (item for item in get_args(kind) if item is not Ellipsis)
    elif is_dataclass(origin) and part in (hints := hints_of(origin)):
        yield hints[part]
