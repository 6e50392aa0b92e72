"""Converts JSON answers to the dataclasses of solution.py. Missing fields and wrong types raise ProtocolError. Unknown
fields are ignored, so that answers of newer daemons can be read.
"""

from __future__ import annotations

import collections.abc
import dataclasses
import functools
import types
from collections.abc import Callable
from typing import Any, Literal, NamedTuple, TypeVar, Union, cast, get_args, get_origin

import numpy as np

from ..errors import ProtocolError
from .type_hints import hints_of

__all__ = ["read"]

T = TypeVar("T")
Convert = Callable[[Any], Any]


class _Unreadable(Exception):
    """Reports an error and its location. Enclosing readers add their part of the path, so that no paths are built
    without errors.
    """

    def __init__(self, problem: str, path: str = "") -> None:
        super().__init__(problem, path)
        self.problem, self.path = problem, path

    def within(self, part: str) -> _Unreadable:
        return _Unreadable(self.problem, part + self.path)


def read(kind: type[T], value: Any, path: str = "result") -> T:
    """Reads `value` (decoded JSON with its arrays) as the dataclass `kind`."""
    try:
        made: T = _reader(cast(Any, kind))(value)
    except _Unreadable as error:
        raise ProtocolError(f"The answer's {path}{error.path} {error.problem}.") from None
    return made


class _Field(NamedTuple):
    """Returns the reader of a field of a dataclass."""

    name: str
    convert: Convert
    has_default: bool
    may_be_none: bool
    may_be_absent: bool


@functools.cache
def _fields(kind: Any) -> tuple[_Field, ...]:
    missing, hints, arrays = dataclasses.MISSING, hints_of(kind), getattr(kind, "_arrays", ())
    return tuple(
        _Field(
            field.name,
            _converter(hint := hints[field.name]),
            field.default is not missing or field.default_factory is not missing,
            type(None) in get_args(hint),
            field.name in arrays,
        )
        for field in dataclasses.fields(kind)
    )


@functools.cache
def _reader(kind: Any) -> Convert:
    of_wire, make = getattr(kind, "of_wire", None), _maker(kind)

    def read_object(value: Any) -> Any:
        if not isinstance(value, dict):
            raise _Unreadable(f"is a {type(value).__name__} instead of an object")
        if of_wire is not None:
            value = of_wire(value)
        found: dict[str, Any] = {}
        for name, convert, has_default, may_be_none, may_be_absent in _fields(kind):  # on first use, not at import
            if name in value:
                reported = value[name]
                if type(reported) is float and convert is _read_float:  # the usual case
                    found[name] = reported
                    continue
                if reported is None and may_be_absent:
                    continue
                try:
                    found[name] = convert(reported)
                except _Unreadable as error:
                    raise error.within(f".{name}") from None
            elif not (has_default or may_be_absent):
                if not may_be_none:
                    raise _Unreadable(f"lacks {name}")
                found[name] = None
        return make(found)

    return read_object


def _maker(kind: Any) -> Callable[[dict[str, Any]], Any]:
    """Returns a function that creates a value from some of its fields, with defaults for the others. The __init__ of a
    frozen dataclass sets each field by a separate call. This function sets all at once where that is equivalent,
    because answers have hundreds of fields.
    """
    fields = dataclasses.fields(kind)
    if hasattr(kind, "__post_init__") or any(field.default_factory is not dataclasses.MISSING for field in fields):
        return lambda found: kind(**found)
    defaults = {field.name: field.default for field in fields if field.default is not dataclasses.MISSING}

    def make(found: dict[str, Any]) -> Any:
        made = object.__new__(kind)
        object.__setattr__(made, "__dict__", {**defaults, **found} if defaults else found)
        return made

    return make


def _misplaced(value: Any) -> _Unreadable:
    return _Unreadable(f"is a {type(value).__name__}, which is not allowed here")


@functools.cache
def _converter(hint: Any) -> Convert:
    """Returns the reader of values of this type. It is created once, because many answers are read."""
    hint = getattr(hint, "__value__", hint)  # resolves an alias of a type, such as numpy's NDArray
    if hint is Any:
        return _as_it_is
    if dataclasses.is_dataclass(hint):
        return _reader(cast(Any, hint))
    origin, inner = get_origin(hint), get_args(hint)
    if origin in (Union, types.UnionType):
        kinds = [kind for kind in inner if kind is not type(None)]
        found = _converter(kinds[0]) if len(kinds) == 1 else _one_of(kinds)
        return found if len(kinds) == len(inner) else _optional(found)
    if origin is tuple:
        return _tuple_of(_converter(inner[0]))
    if origin is collections.abc.Mapping:
        return _mapping_to(_converter(inner[1]))
    if origin is np.ndarray:
        return _instance_of(np.ndarray)
    if origin is Literal:
        return _instance_of(str)  # A newer daemon may have more keywords.
    return _read_float if hint is float else _exactly(hint)


def _one_of(kinds: list[Any]) -> Convert:
    """Reads the first dataclass whose constant and required fields are in `value`, otherwise the first one."""
    readers = [_reader(kind) for kind in kinds]
    marks = [getattr(kind, "_fixed", None) for kind in kinds]
    needs = [{one.name for one in _fields(kind) if not (one.has_default or one.may_be_absent)} for kind in kinds]

    def read_one(value: Any) -> Any:
        if isinstance(value, dict):
            for reader, mark, needed in zip(readers, marks, needs):
                if (mark is None or value.get(mark[0]) == mark[1]) and needed <= value.keys():
                    return reader(value)
        return readers[0](value)

    return read_one


def _read_float(value: Any) -> float:
    if type(value) not in (int, float):
        raise _misplaced(value)
    return float(value)


def _as_it_is(value: Any) -> Any:
    return value


def _optional(convert: Convert) -> Convert:
    def read_optional(value: Any) -> Any:
        # A closed-form table has no errors: {}.
        if value is None or (isinstance(value, dict) and not value):
            return None
        return convert(value)

    return read_optional


def _tuple_of(convert: Convert) -> Convert:
    def read_tuple(value: Any) -> Any:
        if not isinstance(value, list):
            raise _misplaced(value)
        found: list[Any] = []
        try:
            for item in value:
                found.append(convert(item))
        except _Unreadable as error:
            raise error.within(f"[{len(found)}]") from None
        return tuple(found)

    return read_tuple


def _mapping_to(convert: Convert) -> Convert:
    def read_mapping(value: Any) -> Any:
        if not isinstance(value, dict):
            raise _misplaced(value)
        found: dict[str, Any] = {}
        for name, item in value.items():
            try:
                found[name] = convert(item)
            except _Unreadable as error:
                raise error.within(f".{name}") from None
        return found

    return read_mapping


def _instance_of(kind: type) -> Convert:
    def read_instance(value: Any) -> Any:
        if not isinstance(value, kind):
            raise _misplaced(value)
        return value

    return read_instance


def _exactly(kind: Any) -> Convert:
    def read_exactly(value: Any) -> Any:
        if kind not in (int, str, bool) or type(value) is not kind:
            raise _misplaced(value)
        return value

    return read_exactly
