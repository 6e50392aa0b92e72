"""The values of one field of a study: a list, or a range."""

from __future__ import annotations

import json
import math
from typing import Any

import click
import numpy as np

from ..paths import parts

__all__ = ["MOST", "values_of"]

MOST = 1_000_000  #: rows of a study


def values_of(path: str, name: str, said: Any) -> list[Any]:
    """What the study in `path` says of the field `name`, as a list. Raises click.UsageError."""
    parts(name)
    right = "a list, or {from: 0, to: 1, count: 11}, or with step in place of count, or with scale: log"
    if isinstance(said, list) and said:
        try:
            json.dumps(said, allow_nan=False)
        except (TypeError, ValueError):
            raise click.UsageError(f"{path}: the values of {name} must be what JSON has; every number must be finite.") from None
        return said
    if not isinstance(said, dict) or not said.keys() <= {"from", "to", "count", "step", "scale"}:
        raise click.UsageError(f"{path}: the values of {name} must be {right}.")
    start, end = (said.get(name, "") for name in ("from", "to"))
    numbers = [start, end, said.get("step", 1), said.get("count", 1)]
    if not all(map(_is_finite, numbers)):
        raise click.UsageError(f"{path}: the values of {name} must be {right}; all are finite numbers.")
    return _range(path, name, float(start), float(end), said)


def _is_finite(value: Any) -> bool:
    try:
        return isinstance(value, (int, float)) and not isinstance(value, bool) and math.isfinite(value)
    except OverflowError:  # an integer beyond all doubles
        return False


def _range(path: str, name: str, start: float, end: float, said: dict[str, Any]) -> list[Any]:
    scale = said.get("scale", "linear")
    if scale not in ("linear", "log") or (scale == "log" and not (start > 0 and end > 0)):
        raise click.UsageError(f"{path}: scale of {name} must be linear, or log between positive numbers.")
    if ("step" in said) == ("count" in said) or ("step" in said and scale == "log"):
        raise click.UsageError(f"{path}: {name} must have either count or, of a linear scale, step.")
    if "step" in said:
        count = (end - start) / said["step"] if said["step"] else -1
        if count < 0 or count > MOST:
            raise click.UsageError(f"{path}: step of {name} does not lead from {start:g} to {end:g} in {MOST} steps.")
        return [start + index * said["step"] for index in range(math.floor(count * (1 + 1e-12)) + 1)]
    if not isinstance(said["count"], int) or not 1 <= said["count"] <= MOST:
        raise click.UsageError(f"{path}: count of {name} must be a whole number, 1 to {MOST}.")
    space = np.geomspace if scale == "log" else np.linspace
    with np.errstate(all="ignore"):
        found = [float(value) for value in space(start, end, said["count"])]
    if not all(map(math.isfinite, found)):
        raise click.UsageError(f"{path}: {name} goes from {start:g} to {end:g}, which is too far.")
    return found
