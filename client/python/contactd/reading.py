"""JSON answers to the dataclasses of solution.py. What an answer lacks, or holds in the wrong type, is a ProtocolError;
fields this version does not know are ignored, so that a newer daemon can be asked."""

from __future__ import annotations

import collections.abc
import dataclasses
import functools
import operator
import types
from collections.abc import Callable
from typing import Any, Literal, NamedTuple, TypeVar, Union, cast, get_args, get_origin, get_type_hints

import numpy as np

from .errors import ProtocolError
from .friction import Motion, Rolling, Shift
from .ics import AnalyticIcs, FemIcs, Ics
from .materials import LayeredBody, Material, RigidBody

__all__ = ["read"]

T = TypeVar("T")
Convert = Callable[[Any, str], Any]  #: a value and its path


@functools.cache
def _hints(kind: Any) -> dict[str, Any]:
    """The types of the fields; what a generic base leaves open is as the class says."""
    hints = get_type_hints(kind)
    for base in getattr(kind, "__orig_bases__", ()):
        meant = dict(zip(getattr(get_origin(base), "__parameters__", ()), get_args(base), strict=False))
        hints = {name: meant.get(hint, hint) for name, hint in hints.items()}
    return hints


class _Field(NamedTuple):
    """How a field of a dataclass is read."""

    name: str
    convert: Convert
    has_default: bool
    may_be_none: bool


@functools.cache
def _fields(kind: Any) -> tuple[_Field, ...]:
    missing = dataclasses.MISSING
    return tuple(
        _Field(
            field.name,
            _converter(hint := _hints(kind)[field.name]),
            field.default is not missing or field.default_factory is not missing,
            type(None) in get_args(hint),
        )
        for field in dataclasses.fields(kind)
    )


def read(kind: type[T], value: Any, path: str = "result") -> T:
    """`value` (decoded JSON with its arrays in place) as the dataclass `kind`."""
    if not isinstance(value, dict):
        raise ProtocolError(f"The answer's {path} is a {type(value).__name__} instead of an object.")
    of_wire = getattr(kind, "of_wire", None)
    if of_wire is not None:
        value = of_wire(value)
    arguments = {}
    for name, convert, has_default, may_be_none in _fields(cast(Any, kind)):
        if name in value:
            arguments[name] = convert(value[name], f"{path}.{name}")
        elif not has_default:
            if not may_be_none:
                raise ProtocolError(f"The answer's {path} lacks {name}.")
            arguments[name] = None
    return kind(**arguments)


def _misplaced(value: Any, path: str) -> ProtocolError:
    return ProtocolError(f"The answer's {path} is a {type(value).__name__}, which does not belong there.")


@functools.cache
def _converter(hint: Any) -> Convert:
    """What reads a value of this type: looked at once, as answers are read again and again."""
    hint = getattr(hint, "__value__", hint)  # what the name of a type stands for, such as numpy's NDArray where it is one
    if hint == Ics:
        return _read_ics
    if hint in (Material | LayeredBody, Material | LayeredBody | RigidBody, Material | RigidBody):
        return _read_body
    if hint == Motion:
        return _read_motion
    if hint is Any:
        return _as_it_is
    if dataclasses.is_dataclass(hint):
        return functools.partial(read, cast(Any, hint))
    origin, inner = get_origin(hint), get_args(hint)
    if origin in (Union, types.UnionType):
        return _optional(_converter(functools.reduce(operator.or_, (t for t in inner if t is not type(None)))))
    if origin is tuple:
        return _tuple_of(_converter(inner[0]))
    if origin is collections.abc.Mapping:
        return _mapping_to(_converter(inner[1]))
    if origin is np.ndarray:
        return _instance_of(np.ndarray)
    if origin is Literal:
        return _instance_of(str)  # a newer daemon may know more words
    return _read_float if hint is float else _exactly(hint)


def _read_ics(value: Any, path: str) -> Any:
    return read(FemIcs if isinstance(value, dict) and value.get("source") == "fem" else AnalyticIcs, value, path)


def _read_body(value: Any, path: str) -> Any:
    if isinstance(value, dict) and "rigid" in value:
        return RigidBody()
    return read(LayeredBody if isinstance(value, dict) and "layers" in value else Material, value, path)


def _read_motion(value: Any, path: str) -> Any:
    return read(Shift if isinstance(value, dict) and "rigid_shift" in value else Rolling, value, path)


def _read_float(value: Any, path: str) -> float:
    if type(value) not in (int, float):
        raise _misplaced(value, path)
    return float(value)


def _as_it_is(value: Any, path: str) -> Any:
    return value


def _optional(convert: Convert) -> Convert:
    def read_optional(value: Any, path: str) -> Any:
        # A closed-form table says {} of its errors: it has none to speak of.
        if value is None or (isinstance(value, dict) and not value):
            return None
        return convert(value, path)

    return read_optional


def _tuple_of(convert: Convert) -> Convert:
    def read_tuple(value: Any, path: str) -> Any:
        if not isinstance(value, list):
            raise _misplaced(value, path)
        return tuple(convert(item, f"{path}[{i}]") for i, item in enumerate(value))

    return read_tuple


def _mapping_to(convert: Convert) -> Convert:
    def read_mapping(value: Any, path: str) -> Any:
        if not isinstance(value, dict):
            raise _misplaced(value, path)
        return {name: convert(item, f"{path}.{name}") for name, item in value.items()}

    return read_mapping


def _instance_of(kind: type) -> Convert:
    def read_instance(value: Any, path: str) -> Any:
        if not isinstance(value, kind):
            raise _misplaced(value, path)
        return value

    return read_instance


def _exactly(kind: Any) -> Convert:
    def read_exactly(value: Any, path: str) -> Any:
        if kind not in (int, str, bool) or type(value) is not kind:
            raise _misplaced(value, path)
        return value

    return read_exactly
