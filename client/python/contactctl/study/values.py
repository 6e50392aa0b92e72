"""Parses the values of a field of a study: a list, or a range."""

from __future__ import annotations

import json
import math
from typing import Any

import click
import numpy as np

from ..paths import parts

__all__ = ["MOST", "values_of"]

MOST = 1_000_000  #: Largest number of rows in a study.


def values_of(path: str, name: str, given: Any) -> list[Any]:
    """Returns the values of the field `name` in the study `path` as a list. Raises click.UsageError."""
    parts(name)
    right = "a list, or {from: 0, to: 1, count: 11}, or with step in place of count, or with scale: log"
    if isinstance(given, list) and given:
        try:
            json.dumps(given, allow_nan=False)
        except (TypeError, ValueError):
            raise click.UsageError(f"{path}: the values of {name} must be valid in JSON; every number must be finite.") from None
        return given
    if not isinstance(given, dict) or not given.keys() <= {"from", "to", "count", "step", "scale"}:
        raise click.UsageError(f"{path}: the values of {name} must be {right}.")
    start, end = (given.get(name, "") for name in ("from", "to"))
    numbers = [start, end, given.get("step", 1), given.get("count", 1)]
    if not all(map(_is_finite, numbers)):
        raise click.UsageError(f"{path}: the values of {name} must be {right}, and all must be finite numbers.")
    return _range(path, name, float(start), float(end), given)


def _is_finite(value: Any) -> bool:
    try:
        return isinstance(value, (int, float)) and not isinstance(value, bool) and math.isfinite(value)
    except OverflowError:  # an integer beyond the range of doubles
        return False


def _range(path: str, name: str, start: float, end: float, given: dict[str, Any]) -> list[Any]:
    scale = given.get("scale", "linear")
    if scale not in ("linear", "log") or (scale == "log" and not (start > 0 and end > 0)):
        raise click.UsageError(f"{path}: scale of {name} must be linear, or log between positive numbers.")
    if ("step" in given) == ("count" in given) or ("step" in given and scale == "log"):
        raise click.UsageError(f"{path}: {name} must have either count or, for a linear scale, step.")
    if "step" in given:
        count = (end - start) / given["step"] if given["step"] else -1
        if count < 0 or count > MOST:
            raise click.UsageError(f"{path}: step of {name} does not lead from {start:g} to {end:g} in {MOST} steps.")
        return [start + index * given["step"] for index in range(math.floor(count * (1 + 1e-12)) + 1)]
    if not isinstance(given["count"], int) or not 1 <= given["count"] <= MOST:
        raise click.UsageError(f"{path}: count of {name} must be a whole number, 1 to {MOST}.")
    space = np.geomspace if scale == "log" else np.linspace
    with np.errstate(all="ignore"):
        found = [float(value) for value in space(start, end, given["count"])]
    if not all(map(math.isfinite, found)):
        raise click.UsageError(f"{path}: {name} goes from {start:g} to {end:g}, which is too large a range.")
    return found
