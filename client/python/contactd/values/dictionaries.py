"""Converts values of this package to dictionaries with their type, such as ``{"type": "Paraboloid", "Rx": 50.0, ...}``,
and back.
"""

from __future__ import annotations

import os
import sys
from collections.abc import Mapping
from dataclasses import fields, is_dataclass
from functools import cache
from typing import Any, TypeVar

import numpy as np

from ..errors import SavedFileError
from ..refusals import public
from .registry import extra

__all__ = ["HasDict", "Saved", "from_dict", "to_dict"]

#: Prefix of modules whose values can be created from dictionaries. Importing contactd imports them all.
_VALUES = f"{__package__}."
_RENAMED = {"PartialSolution": "ContactSolution"}  #: Types in files of earlier versions.


def to_dict(value: Any) -> Any:
    """Converts dataclasses of this package to dictionaries with their "type", and tuples to lists. Arrays and numbers
    are unchanged.

    Omits fields with the default None, and absent arrays. Raises TypeError for other objects.
    """
    if is_dataclass(value) and not isinstance(value, type):
        absent: frozenset[str] = getattr(value, "_arrays", frozenset()).difference(vars(value))
        items = ((field, getattr(value, field.name)) for field in fields(value) if field.name not in absent)
        given = {field.name: to_dict(item) for field, item in items if item is not None or field.default is not None}
        return {"type": type(value).__name__, **given}
    if isinstance(value, Mapping):
        return {str(name): to_dict(item) for name, item in value.items()}
    if isinstance(value, (list, tuple)):
        return [to_dict(item) for item in value]
    if isinstance(value, np.generic):
        return value.item()
    if value is None or isinstance(value, (bool, int, float, str, np.ndarray)):
        return value
    raise TypeError(f"{value!r:.80} is a {type(value).__name__}, which is not a value of contactd")


@public
def from_dict(told: Any, path: str = "") -> Any:
    """Returns the value of a dictionary made by to_dict. Raises ValueError naming the invalid part."""
    return _value_of(told, path)


def _value_of(told: Any, path: str) -> Any:
    if isinstance(told, Mapping):
        parts = {name: _value_of(item, f"{path}.{name}" if path else name) for name, item in told.items() if name != "type"}
        if "type" not in told:
            return parts
        kind = _kinds().get(_RENAMED.get(told["type"], told["type"]))
        if kind is None:
            raise ValueError(f"{path or 'the value'} is of the type {told['type']!r}, which this version does not support")
        if unknown := parts.keys() - {field.name for field in fields(kind)}:
            raise ValueError(f"{path or 'the value'} has {', '.join(sorted(unknown))}, which {told['type']} does not have")
        try:
            return getattr(kind, "_of_parts", kind)(**parts)
        except TypeError as error:
            raise ValueError(f"{path or 'the value'} is not a valid {told['type']}: {error}") from None
    if isinstance(told, list):
        return tuple(_value_of(item, f"{path}[{i}]") for i, item in enumerate(told))
    return told


@cache
def _kinds() -> dict[str, Any]:
    modules = [module for name, module in sys.modules.items() if name.startswith(_VALUES)]
    found = [kind for module in modules for kind in vars(module).values() if isinstance(kind, type) and is_dataclass(kind)]
    return {kind.__name__: kind for kind in found}


class HasDict:
    """Represents a value that can be converted to a dictionary."""

    def to_dict(self) -> dict[str, Any]:
        """Returns the fields by name, with "type", the name of the class; nested values are converted, too. Omits
        fields with the default None. Arrays are unchanged.

        `contactd.from_dict` inverts the conversion.
        """
        told: dict[str, Any] = to_dict(self)
        return told


V = TypeVar("V", bound="Saved")


class Saved(HasDict):
    """Represents a value that can be saved in files."""

    @public
    def save(self, path: str | os.PathLike[str]) -> None:
        """Writes this value to an HDF5 file (needs h5py) for `load`. The file is never incomplete."""
        extra("Saved.save")(path, self)

    @classmethod
    @public
    def load(cls: type[V], path: str | os.PathLike[str]) -> V:
        """Returns the value of this class written by `save`. Raises SavedFileError, also for another class."""
        value = extra("Saved.load")(path)
        if not isinstance(value, cls):
            raise SavedFileError(f"{os.fspath(path)} contains a {type(value).__name__}, not a {cls.__name__}")
        return value
