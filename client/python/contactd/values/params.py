"""What values have in common on their way to the wire."""

from __future__ import annotations

import functools
import types
from collections.abc import Callable
from dataclasses import Field, fields, is_dataclass
from typing import Any, NamedTuple, Union, get_args, get_origin, get_type_hints

import numpy as np

from ..errors import invalid
from ..refusals import check_type

__all__ = ["array_of", "params_of", "plain", "whole"]

Convert = Callable[[Any, str], Any]


class _Member(NamedTuple):
    """How a field of a dataclass is written."""

    name: str
    within: str | None  # the object of the wire that it stands in, where that is no class here
    may_be_null: bool  # None is a value of it, as it is not what is left out
    convert: Convert | None


def params_of(value: Any, field: str = "") -> Any:
    """A value as the wire has it: its fields that are not None, by name, and values in it alike. `field` is where it stands.

    Raises TypeError where a value in it is of a wrong class. A class that looks otherwise on the wire says by a method
    ``_on_wire(field)`` how. Fields that do are known by their metadata: "within" is the object that they are in, "keys"
    are the names that the parts of a tuple have.
    """
    if hasattr(value, "_on_wire"):
        return value._on_wire(field)
    if (members := _members(value.__class__)) is None:
        return plain(value)
    written: dict[str, Any] = {}
    for name, within, may_be_null, convert in members:
        item = getattr(value, name)
        if item is None and not may_be_null:
            continue
        if convert is not None and item is not None:
            item = convert(item, f"{field}.{name}" if field else name)
        (written if within is None else written.setdefault(within, {}))[name] = item
    return written


@functools.cache
def _members(kind: type) -> tuple[_Member, ...] | None:
    """How the fields of a dataclass are written, looked at once; None where all of them are as the wire has them."""
    hints = get_type_hints(kind)
    members = tuple(_member(one, hints[one.name]) for one in fields(kind))
    return members if any(member[1:] != (None, False, None) for member in members) else None


def _member(one: Field[Any], hint: Any) -> _Member:
    keys = one.metadata.get("keys")
    convert = _writer(hint) if keys is None else _writer_of_tuples(hint, keys)
    may_be_null = one.default is not None and type(None) in get_args(hint)
    return _Member(one.name, one.metadata.get("within"), may_be_null, convert)


def _writer(hint: Any) -> Convert | None:
    """What writes values of the dataclasses that a type names; None where they are as the wire has them."""
    kinds: list[Any] = [kind for kind in _alternatives(hint) if is_dataclass(kind)]
    if not kinds:
        return None

    def write(value: Any, field: str) -> Any:
        if value.__class__ not in kinds:
            check_type(field, value, *kinds)
        return params_of(value, field)

    return write


def _writer_of_tuples(hint: Any, keys: tuple[str, ...]) -> Convert:
    """What writes a tuple, or a sequence of tuples, in place of which the type may allow a number."""
    kinds = _alternatives(hint)
    (kind,) = [kind for kind in kinds if get_origin(kind) is not None]
    is_one, may_be_number = get_origin(kind) is tuple, float in kinds
    parts = get_args(kind if is_one else get_args(kind)[0])
    writers = [(key, _writer(part)) for key, part in zip(keys, parts, strict=True)]

    def write(values: Any, field: str) -> dict[str, Any]:
        pairs = zip(values, writers, strict=True)
        return {key: item if convert is None else convert(item, f"{field}.{key}") for item, (key, convert) in pairs}

    def write_all(items: Any, field: str) -> Any:
        if may_be_number and np.ndim(items) == 0:
            return items
        return [write(values, f"{field}[{i}]") for i, values in enumerate(items)]

    return write if is_one else write_all


def _alternatives(hint: Any) -> tuple[Any, ...]:
    return get_args(hint) if get_origin(hint) in (Union, types.UnionType) else (hint,)


def plain(value: Any) -> dict[str, Any]:
    """The fields of a dataclass that are not None, as the wire names them."""
    return {name: item for name in _names(value.__class__) if (item := getattr(value, name)) is not None}


@functools.cache
def _names(kind: type) -> tuple[str, ...]:
    """Of the fields of a dataclass, looked at once: steps are told thousands of times a second."""
    return tuple(field.name for field in fields(kind))


def array_of(value: Any) -> np.ndarray[Any, Any]:
    """`value` as an array that still has its mask, should it have one, for `encode` to refuse."""
    if isinstance(value, (list, tuple)) and any(isinstance(row, np.ma.MaskedArray) for row in value):
        masked: np.ndarray[Any, Any] = np.ma.array(value)
        return masked
    return np.asanyarray(value)


def whole(array: np.ndarray[Any, Any], field: str) -> np.ndarray[Any, Any]:
    """`array`; raises InvalidArgument where elements are masked, since contact has no word for what is not there."""
    if np.ma.is_masked(array):
        problem = f"has {np.count_nonzero(np.ma.getmaskarray(array))} masked values; every value must be there, as in array.filled(...)"
        raise invalid(field, problem, "ARRAY_INVALID")
    return array
