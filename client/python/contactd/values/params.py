"""Converts values to their form on the wire, and checks the types of their fields."""

from __future__ import annotations

import functools
import types
from collections.abc import Callable, Iterable, Mapping
from dataclasses import MISSING, Field, fields, is_dataclass
from typing import Any, NamedTuple, Union, get_args, get_origin

import numpy as np

from ..errors import invalid
from ..refusals import check_type, did_you_mean
from .arrays import array_of
from .type_hints import hints_of

__all__ = [
    "Checked", "HasParams", "array_of", "check_fields", "fields_of", "instead", "names_of_fields", "params_of", "whole", "with_objects",
]  # fmt: skip

Convert = Callable[[Any, str], Any]


class _Member(NamedTuple):
    """Returns the writer of a field of a dataclass."""

    within: str | None  # the enclosing object on the wire, if it is not a class here
    left_out: Any  # the value that is omitted
    convert: Convert | None


def params_of(value: Any, field: str = "") -> Any:
    """Returns a value as on the wire: its fields by name without None, with nested values converted. `field` is its
    path.

    Raises TypeError for a nested value of a wrong class. Differences between a value and the wire are defined

    * by the metadata of its field: "within" is the enclosing object, "keys" are the names of the parts of a tuple, and
      an "array" is anything that numpy can convert, in an object of this name unless that is empty;
    * by a method ``_write_NAME(value, field)`` of its class;
    * by a method ``_completed(written)``, which adds required fields;
    * by attributes of the class: ``_fixed`` is a name with a constant value, ``_key`` the name of all other fields.
    """
    kind: type = value.__class__
    written = fields_of(kind, vars(value), field)
    if (completed := getattr(kind, "_completed", None)) is not None:
        written = completed(written)
    if (fixed := getattr(kind, "_fixed", None)) is not None:
        written = {fixed[0]: fixed[1], **written}
    return written if (key := getattr(kind, "_key", None)) is None else {key: written}


def fields_of(kind: type, given: Mapping[str, Any], field: str = "") -> dict[str, Any]:
    """Returns some fields of a value of this class as on the wire."""
    written: dict[str, Any] = {}
    members = _members(kind)
    for name, item in given.items():
        within, left_out, convert = members[name]
        if item is left_out:
            continue
        if convert is not None and item is not None:
            item = convert(item, f"{field}.{name}" if field else name)
        (written if within is None else written.setdefault(within, {}))[name] = item
    return written


def with_objects(kind: type, given: Any, field: str = "") -> Any:
    """Returns parameters of a class as on the wire, with lists converted to objects as in Python: [0, 0, 5.3] is the
    piece of a function with from, value and slope. `field` is their path. Values that are not mappings are left to the
    daemon.

    Raises InvalidArgument for a list of another length.
    """
    if not isinstance(given, Mapping):
        return given
    found = dict(given)
    hints = hints_of(kind)
    for one in fields(kind):
        if (value := given.get(one.name)) is None:
            continue
        place = f"{field}.{one.name}" if field else one.name
        is_list = isinstance(value, (list, tuple, np.ndarray))
        keys, kinds = one.metadata.get("keys"), _kinds(hints[one.name])
        items: list[Any] = [kind for hint in _alternatives(hints[one.name]) for kind in get_args(hint)[:1] if is_dataclass(kind)]
        if keys is not None and is_list:
            found[one.name] = [_object_of(item, keys, f"{place}[{i}]") for i, item in enumerate(value)]
        elif kinds:
            found[one.name] = with_objects(kinds[0], value, place)
        elif items and is_list:
            found[one.name] = [with_objects(items[0], item, f"{place}[{i}]") for i, item in enumerate(value)]
    return found


def _object_of(item: Any, keys: tuple[str, ...], field: str) -> Any:
    if not isinstance(item, (list, tuple, np.ndarray)):
        return item
    if len(item) != len(keys):
        raise invalid(field, f"has {len(item)} numbers; it must have {len(keys)}: {', '.join(keys)}")
    return dict(zip(keys, item.tolist() if isinstance(item, np.ndarray) else item))


def names_of_fields(kind: type) -> frozenset[str]:
    return frozenset(field.name for field in fields(kind))


@functools.cache
def _members(kind: type) -> dict[str, _Member]:
    """Returns the writers of the fields of a dataclass. They are created once, because steps are written thousands of
    times a second.
    """
    hints = hints_of(kind)
    return {one.name: _member(kind, one, hints[one.name]) for one in fields(kind)}


def _member(kind: type, one: Field[Any], hint: Any) -> _Member:
    keys, array = one.metadata.get("keys"), one.metadata.get("array")
    if (convert := getattr(kind, f"_write_{one.name}", None)) is None:
        if array is not None:
            convert = _writer_of_arrays(hint, array)
        else:
            convert = _writer(hint) if keys is None else _writer_of_tuples(hint, keys)
    # None is omitted unless it differs from the default. A flag is written if it is set.
    left_out = False if one.default is False else MISSING if one.default is not None and type(None) in get_args(hint) else None
    return _Member(one.metadata.get("within"), left_out, convert)


def _kinds(hint: Any) -> list[Any]:
    return [kind for kind in _alternatives(hint) if is_dataclass(kind)]


def _writer(hint: Any) -> Convert | None:
    """Returns the writer of the dataclasses of a type, or of their sequences; None for values that are the same on the
    wire.
    """
    kinds = _kinds(hint)
    if kinds:

        def write(value: Any, field: str) -> Any:
            if value.__class__ not in kinds:
                check_type(field, value, *kinds)
            return params_of(value, field)

        return write
    inner = [get_args(one)[0] for one in _alternatives(hint) if get_origin(one) is tuple]
    return _writer_of_sequences(_writer(inner[0])) if inner else None


def _writer_of_sequences(convert: Convert | None) -> Convert:
    """Returns the writer of a list from any sequence; the daemon refuses other values by name."""

    def write(values: Any, field: str) -> Any:
        if not isinstance(values, Iterable):
            return values
        return [item if convert is None else convert(item, f"{field}[{i}]") for i, item in enumerate(values)]

    return write


def _writer_of_arrays(hint: Any, key: str) -> Convert:
    """Returns the writer of an array, or of dataclasses that may replace it."""
    kinds = tuple(_kinds(hint))

    def write(value: Any, field: str) -> Any:
        if isinstance(value, kinds):
            return params_of(value, field)
        return {key: array_of(value)} if key else array_of(value)

    return write


def _writer_of_tuples(hint: Any, keys: tuple[str, ...]) -> Convert:
    """Returns the writer of a tuple, or of a sequence of tuples, which the type may allow to be a number.

    If the type allows tuples of several lengths, the longest has a part for each key.
    """
    kinds = _alternatives(hint)
    (kind,) = [kind for kind in kinds if get_origin(kind) is not None]
    is_one, may_be_number = get_origin(kind) is tuple, float in kinds
    tuples = [get_args(one) for one in _alternatives(kind if is_one else get_args(kind)[0])]
    lengths = {len(parts) for parts in tuples}
    (longest,) = [parts for parts in tuples if len(parts) == max(lengths)]
    writers = [(key, _writer(part)) for key, part in zip(keys, longest, strict=True)]

    def write(values: Any, field: str) -> dict[str, Any]:
        if len(values) not in lengths:
            raise ValueError(f"{field} has {len(values)} parts; it must have {', '.join(keys)}")
        pairs = zip(values, writers, strict=False)
        return {key: plain(item) if convert is None else convert(item, f"{field}.{key}") for item, (key, convert) in pairs}

    def plain(item: Any) -> Any:
        return list(item) if isinstance(item, tuple) else item

    def write_all(items: Any, field: str) -> Any:
        if may_be_number and np.ndim(items) == 0:
            return items
        return [write(values, f"{field}[{i}]") for i, values in enumerate(items)]

    return write if is_one else write_all


def _alternatives(hint: Any) -> tuple[Any, ...]:
    return get_args(hint) if get_origin(hint) in (Union, types.UnionType) else (hint,)


def instead(changes: Mapping[str, Any], *either: str) -> dict[str, Any]:
    """Returns changes of alternative fields: the given one replaces the others."""
    given = [name for name in either if changes.get(name) is not None]
    return {**dict.fromkeys(either if given else ()), **changes}


class HasParams:
    """Represents a value that users can convert to its form on the wire."""

    def params(self) -> dict[str, Any]:
        """Returns the parameters of contact.solve for this value."""
        params: dict[str, Any] = params_of(self)
        return params


class Checked:
    """Represents a value that checks its fields on construction."""

    def __post_init__(self) -> None:
        check_fields(type(self), vars(self))


def check_fields(kind: type, given: Mapping[str, Any]) -> None:
    """Raises TypeError if a field of a value of this class has a wrong type, is required and missing, or has an unknown
    name. The daemon checks everything other than values of contactd and flags.
    """
    checked = _checked(kind)
    if unknown := given.keys() - names_of_fields(kind):
        meant = did_you_mean(min(unknown), names_of_fields(kind))
        raise TypeError(f"{kind.__name__} has no field {', '.join(sorted(unknown))}{meant and '.' + meant}")
    for name, kinds, is_optional, is_list, default in checked:
        value = given.get(name, default)
        if not is_list:
            check_type(name, value, *kinds, optional=is_optional)
            continue
        for i, item in enumerate(value):
            check_type(f"{name}[{i}]", item, *kinds)


@functools.cache
def _checked(kind: type) -> list[tuple[str, tuple[type, ...], bool, bool, Any]]:
    """Returns the fields that are values of contactd or flags: their types, whether they may be None, whether they are
    lists, and their defaults.
    """
    found = []
    for one in fields(kind):
        hint = hints_of(kind)[one.name]
        is_list = get_origin(hint) is tuple
        kinds = tuple(_kinds(get_args(hint)[0] if is_list else hint)) or ((bool,) if hint is bool else ())
        if kinds and "array" not in one.metadata:
            default = None if one.default is MISSING else one.default
            found.append((one.name, kinds, hint is bool or type(None) in get_args(hint), is_list, default))
    return found


def whole(array: np.ndarray[Any, Any], field: str) -> np.ndarray[Any, Any]:
    """Returns `array`. Raises InvalidArgument for masked elements, which contact problems do not support."""
    if np.ma.is_masked(array):
        problem = f"has {np.count_nonzero(np.ma.getmaskarray(array))} masked values; replace them, as in array.filled(...)"
        raise invalid(field, problem, "ARRAY_INVALID")
    return array
