"""From a file to a study of wear."""

from __future__ import annotations

import math
from pathlib import Path
from typing import Any

import click

from contactd import InvalidArgument
from contactd.wear import WearStudy, read_states

from ..files import read_object

__all__ = ["FIELDS", "read_study"]

FIELDS = {
    "setup", "states", "wears", "law", "rail_law", "passages_per_km", "symmetric", "fatigue", "until", "step", "smoothing", "energy",
    "spacing",
}  # fmt: skip
_NAMED = ("rail_law", "passages_per_km", "symmetric", "fatigue", "smoothing", "energy", "spacing")


def read_study(file: str) -> WearStudy:
    """The study that a file of JSON or YAML describes. Raises click.UsageError naming the file and what is wrong."""
    given = read_object(file)
    if unknown := given.keys() - FIELDS:
        raise click.UsageError(f"{file}: a study of wear has no {', '.join(sorted(unknown))}; it has {', '.join(sorted(FIELDS))}.")
    if missing := [name for name in ("states", "wears", "law", "until") if name not in given]:
        raise click.UsageError(f"{file}: {', '.join(missing)} {'is' if len(missing) == 1 else 'are'} missing.")
    step = _object(file, given, "step")
    if unknown := step.keys() - {"depth", "distance"}:
        raise click.UsageError(f"{file}: step has no {', '.join(sorted(unknown))}; it has depth and distance.")
    for name in ("law", "rail_law"):
        law = _object(file, given, name) if name in given else None
        if law is not None and not (law.get("source") and law.get("name")):
            raise click.UsageError(f"{file}: {name} has no name or no source; say what it is called, and where its coefficients come from.")
    named = {name: given[name] for name in _NAMED if name in given}
    if "fatigue" in named:
        _object(file, given, "fatigue")
    if not isinstance(named.get("symmetric", False), bool):
        raise click.UsageError(f"{file}: symmetric is {named['symmetric']!r}; it must be true or false.")
    path = given["states"]
    if not isinstance(path, str):
        raise click.UsageError(f"{file}: states is the name of a file: CSV, HDF5 or Parquet.")
    place = Path(path) if file == "-" else Path(file).parent / path
    for name in ("until", "spacing", "passages_per_km"):
        _number(file, name, given.get(name))
    for name in ("depth", "distance"):
        _number(file, f"step.{name}", step.get(name))
    try:
        return WearStudy(_object(file, given, "setup"), read_states(place), given["wears"], given["law"], given["until"], **step, **named)
    except InvalidArgument as error:
        raise click.UsageError(f"{file}: {error}") from None
    except (OSError, UnicodeDecodeError) as error:
        raise click.UsageError(f"{place}: {getattr(error, 'strerror', None) or 'it is no text'}") from None


def _object(file: str, given: dict[str, Any], name: str) -> dict[str, Any]:
    value = given.get(name, {})
    if not isinstance(value, dict):
        raise click.UsageError(f"{file}: {name} is {value!r}; it must be an object, fields with their values.")
    return value


def _number(file: str, name: str, value: Any) -> None:
    is_number = isinstance(value, (int, float)) and not isinstance(value, bool) and math.isfinite(value)
    if value is not None and not is_number:
        raise click.UsageError(f"{file}: {name} is {value!r}; it must be a number.")
