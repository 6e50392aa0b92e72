"""Gets and sets fields by their paths, as in error messages: ``friction.rolling.xi``, ``ics.layers[0].G``. Also
converts notations of files that the wire does not have: Young's modulus, and lists instead of the objects of laws.
"""

from __future__ import annotations

import json
from collections.abc import Iterable
from typing import Any

import click

from contactd import FatigueRequest, InvalidArgument, WearRequest
from contactd.values import field_paths
from contactd.values.field_paths import copied
from contactd.values.params import with_objects

__all__ = ["changed", "copied", "get", "parts", "put", "put_into_words"]


_LAWS: dict[str, type] = {"wear": WearRequest, "fatigue": FatigueRequest}


def parts(path: str) -> list[str | int]:
    """Returns names and indices. Raises click.UsageError."""
    try:
        return field_paths.parts(path)
    except ValueError as error:
        raise click.UsageError(str(error)) from None


def put(document: Any, path: str, value: Any) -> None:
    """Sets a value in `document`; creates missing or null objects on the path. Raises click.UsageError."""
    try:
        field_paths.put(document, path, value)
    except ValueError as error:
        raise click.UsageError(str(error)) from None


def get(document: Any, path: str) -> Any:
    """Returns the value, or None. Raises click.UsageError for an invalid path."""
    try:
        return field_paths.get(document, path)
    except ValueError as error:
        raise click.UsageError(str(error)) from None


def changed(document: dict[str, Any], settings: Iterable[str]) -> dict[str, Any]:
    """Returns a copy with each PATH=VALUE of the command line; a value is JSON, or otherwise a text. The copy has the
    form of the wire (put_into_words).
    """
    found: dict[str, Any] = copied(document)
    for setting in settings:
        path, sign, text = setting.partition("=")
        if not sign:
            raise click.UsageError(f"--set {setting}: it must be PATH=VALUE, such as friction.mu=0.3.")
        put(found, path, _value(text))
    put_into_words(found)
    return found


def put_into_words(document: dict[str, Any]) -> None:
    """Converts `document` to the form of the wire: G = E / (2 (1 + nu)) replaces E in objects with E and nu, and
    objects replace lists in laws of wear and fatigue requests, as in Python.

    Raises click.UsageError for E together with G, for an E that is not positive, and for lists of another length.
    """
    _with_shear_moduli(document)
    _with_laws(document)


def _with_laws(document: dict[str, Any], path: str = "") -> None:
    """Converts laws in all parameters of a contact or a set-up."""
    for name, item in document.items():
        place = f"{path}.{name}" if path else name
        if (kind := _LAWS.get(name)) is not None:
            try:
                document[name] = with_objects(kind, item, place)
            except InvalidArgument as error:
                raise click.UsageError(str(error)) from None
        elif isinstance(item, dict):
            _with_laws(item, place)


def _with_shear_moduli(document: Any, path: str = "") -> None:
    if isinstance(document, list):
        for i, item in enumerate(document):
            _with_shear_moduli(item, f"{path}[{i}]")
    if not isinstance(document, dict):
        return
    if "E" in document and isinstance(nu := document.get("nu"), (int, float)) and nu > -1:
        E = document.pop("E")
        where = f"{path}.E" if path else "E"
        if "G" in document:
            raise click.UsageError(f"{where} cannot be combined with G; give a material by one of them, and nu.")
        if isinstance(E, bool) or not isinstance(E, (int, float)) or not E > 0:
            raise click.UsageError(f"{where} is {E!r:.60}; Young's modulus must be a positive number.")
        document["G"] = E / (2 * (1 + nu))
    for name, item in document.items():
        _with_shear_moduli(item, f"{path}.{name}" if path else name)


def _value(text: str) -> Any:
    try:
        return json.loads(text)
    except ValueError:
        return text
