"""Fields by their paths, as refusals name them: ``friction.rolling.xi``, ``ics.layers[0].G``."""

from __future__ import annotations

import json
from collections.abc import Iterable
from typing import Any

import click

from contactd.values import field_paths
from contactd.values.field_paths import copied

__all__ = ["changed", "copied", "get", "parts", "put"]


def parts(path: str) -> list[str | int]:
    """Names and indices. Raises click.UsageError."""
    try:
        return field_paths.parts(path)
    except ValueError as error:
        raise click.UsageError(str(error)) from None


def put(document: Any, path: str, value: Any) -> None:
    """Changes `document`; objects on the way are made where they are missing or null. Raises click.UsageError."""
    try:
        field_paths.put(document, path, value)
    except ValueError as error:
        raise click.UsageError(str(error)) from None


def get(document: Any, path: str) -> Any:
    """The value there; None where there is none. Raises click.UsageError for what is no path."""
    try:
        return field_paths.get(document, path)
    except ValueError as error:
        raise click.UsageError(str(error)) from None


def changed(document: dict[str, Any], settings: Iterable[str]) -> dict[str, Any]:
    """A copy with each PATH=VALUE of the command line in place; a value is JSON, or else a text."""
    found: dict[str, Any] = copied(document)
    for setting in settings:
        path, sign, text = setting.partition("=")
        if not sign:
            raise click.UsageError(f"--set {setting}: it must be PATH=VALUE, such as friction.mu=0.3.")
        put(found, path, _value(text))
    return found


def _value(text: str) -> Any:
    try:
        return json.loads(text)
    except ValueError:
        return text
