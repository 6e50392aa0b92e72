"""Values of this package as dictionaries, and back: each with its kind, as ``{"type": "Paraboloid", "Rx": 50.0, ...}``."""

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

#: How modules are named whose values can be made from dictionaries. Who imports contactd has them all.
_VALUES = f"{__package__}."


def to_dict(value: Any) -> Any:
    """Dataclasses of this package as dictionaries with their "type"; tuples as lists; arrays and numbers as they are.

    What is None by default is left out then. Raises TypeError for what is no value.
    """
    if is_dataclass(value) and not isinstance(value, type):
        items = ((field, getattr(value, field.name)) for field in fields(value))
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
    raise TypeError(f"{value!r:.80} is a {type(value).__name__}, which is no value of contactd")


@public
def from_dict(told: Any, path: str = "") -> Any:
    """The value that `told`, made by to_dict, stands for. Raises ValueError naming what it cannot be made of."""
    return _value_of(told, path)


def _value_of(told: Any, path: str) -> Any:
    if isinstance(told, Mapping):
        parts = {name: _value_of(item, f"{path}.{name}" if path else name) for name, item in told.items() if name != "type"}
        if "type" not in told:
            return parts
        kind = _kinds().get(told["type"])
        if kind is None:
            raise ValueError(f"{path or 'the value'} is of the type {told['type']!r}, which this version does not know")
        if unknown := parts.keys() - {field.name for field in fields(kind)}:
            raise ValueError(f"{path or 'the value'} has {', '.join(sorted(unknown))}, which {told['type']} does not know")
        try:
            return kind(**parts)
        except TypeError as error:
            raise ValueError(f"{path or 'the value'} is no {told['type']}: {error}") from None
    if isinstance(told, list):
        return tuple(_value_of(item, f"{path}[{i}]") for i, item in enumerate(told))
    return told


@cache
def _kinds() -> dict[str, Any]:
    modules = [module for name, module in sys.modules.items() if name.startswith(_VALUES)]
    found = [kind for module in modules for kind in vars(module).values() if isinstance(kind, type) and is_dataclass(kind)]
    return {kind.__name__: kind for kind in found}


class HasDict:
    """A value that tells itself as a dictionary."""

    def to_dict(self) -> dict[str, Any]:
        """All but what is None by default, by name, with "type", the name of the class; values in it alike. Arrays stay arrays.

        `contactd.from_dict` makes the value again.
        """
        told: dict[str, Any] = to_dict(self)
        return told


V = TypeVar("V", bound="Saved")


class Saved(HasDict):
    """A value that is kept in files."""

    @public
    def save(self, path: str | os.PathLike[str]) -> None:
        """Writes this to a file of HDF5 (needs h5py), which `load` reads; whole or not at all."""
        extra("Saved.save")(path, self)

    @classmethod
    @public
    def load(cls: type[V], path: str | os.PathLike[str]) -> V:
        """The value of this class that `save` has written. Raises SavedFileError, also where it is another one."""
        value = extra("Saved.load")(path)
        if not isinstance(value, cls):
            raise SavedFileError(f"{os.fspath(path)} holds a {type(value).__name__}, not a {cls.__name__}")
        return value
