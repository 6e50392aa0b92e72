"""JSON answers to the dataclasses of solution.py. What an answer lacks, or holds in the wrong type, is a ProtocolError;
fields this version does not know are ignored, so that a newer daemon can be asked."""

from __future__ import annotations

import collections.abc
import dataclasses
import functools
import operator
import types
from typing import Any, Literal, TypeVar, Union, cast, get_args, get_origin, get_type_hints

import numpy as np

from .errors import ProtocolError
from .friction import Motion, Rolling, Shift
from .problem import AnalyticIcs, FemIcs, Ics

__all__ = ["read"]

T = TypeVar("T")


@functools.cache
def _hints(kind: Any) -> dict[str, Any]:
    """The types of the fields; what a generic base leaves open is as the class says."""
    hints = get_type_hints(kind)
    for base in getattr(kind, "__orig_bases__", ()):
        meant = dict(zip(getattr(get_origin(base), "__parameters__", ()), get_args(base), strict=False))
        hints = {name: meant.get(hint, hint) for name, hint in hints.items()}
    return hints


def read(kind: type[T], value: Any, path: str = "result") -> T:
    """`value` (decoded JSON with its arrays in place) as the dataclass `kind`."""
    if not isinstance(value, dict):
        raise ProtocolError(f"The answer's {path} is a {type(value).__name__} instead of an object.")
    hints, arguments = _hints(cast(Any, kind)), {}
    for field in dataclasses.fields(kind):  # type: ignore[arg-type]
        if field.name in value:
            arguments[field.name] = _convert(hints[field.name], value[field.name], f"{path}.{field.name}")
        elif field.default is dataclasses.MISSING and field.default_factory is dataclasses.MISSING:
            if type(None) not in get_args(hints[field.name]):
                raise ProtocolError(f"The answer's {path} lacks {field.name}.")
            arguments[field.name] = None
    return kind(**arguments)


def _convert(hint: Any, value: Any, path: str) -> Any:
    if hint == Ics:
        return read(FemIcs if isinstance(value, dict) and value.get("source") == "fem" else AnalyticIcs, value, path)
    if dataclasses.is_dataclass(hint):
        return read(hint, value, path)  # type: ignore[arg-type]
    if hint == Motion:
        return read(Shift if isinstance(value, dict) and "rigid_shift" in value else Rolling, value, path)
    origin, inner = get_origin(hint), get_args(hint)
    if origin in (Union, types.UnionType):
        # A closed-form table says {} of its errors: it has none to speak of.
        if value is None or (isinstance(value, dict) and not value):
            return None
        return _convert(functools.reduce(operator.or_, (t for t in inner if t is not type(None))), value, path)
    if origin is tuple and isinstance(value, list):
        return tuple(_convert(inner[0], item, f"{path}[{i}]") for i, item in enumerate(value))
    if origin is collections.abc.Mapping and isinstance(value, dict):
        return {name: _convert(inner[1], item, f"{path}.{name}") for name, item in value.items()}
    if origin is np.ndarray and isinstance(value, np.ndarray):
        return value
    if hint is float and type(value) in (int, float):
        return float(value)
    if hint in (int, str, bool) and type(value) is hint:
        return value
    if origin is Literal and isinstance(value, str):
        return value  # a newer daemon may know more words
    raise ProtocolError(f"The answer's {path} is a {type(value).__name__}, which does not belong there.")
