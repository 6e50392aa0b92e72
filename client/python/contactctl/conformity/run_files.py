"""Reads the forces of a run from a table."""

from __future__ import annotations

import re
from collections.abc import Callable, Mapping
from pathlib import Path

import click
import numpy as np

from contactd.files.number_text import number_in, table_of
from contactd.files.whole import read_whole
from contactd.values.arrays import Array

from .run_quantities import Run, WheelsetForces

__all__ = ["read_run"]

_MOST_BYTES = 1 << 26  #: Reading takes 19 times as much memory.
_UNITS = {
    "distance": {"mm": 1.0, "m": 1e3, "km": 1e6},
    "time": {"s": 1.0, "ms": 1e-3},
    "speed": {"mm/s": 1.0, "m/s": 1e3, "km/h": 1e6 / 3600},
    "force": {"N": 1.0, "kN": 1e3},
}  #: Factors to contactd's units; the first is assumed.
_LARGEST = {"distance": 1e12, "time": 1e9, "speed": 1e6, "force": 1e9}  #: in contactd's units
_LONGEST = 5e9  #: mm, ten million windows
_NAME = re.compile(r"(?P<name>[^()\[\]]+?)\s*(?:[(\[](?P<unit>[^()\[\]]*)[)\]])?")
_FORCE = re.compile(r"([YQ][rl])(.*)")


def read_run(file: Path, *, is_outwards: bool, on_progress: Callable[[float], None] = lambda _: None) -> Run:
    """Returns the run in a table with the columns `distance`, or `time` and `speed`, and Yr, Yl, Qr, Ql, followed by the
    name of a wheelset if there are several. A unit may follow in brackets. `is_outwards`: Y is positive towards the
    field side of both wheels. `on_progress` receives the fraction read. Raises click.UsageError.
    """
    columns = _columns(file, on_progress)
    distance = _distance(file, columns)
    wheelsets = {match.group(2): None for name in columns if (match := _FORCE.fullmatch(name)) is not None}
    if not wheelsets:
        raise click.UsageError(f"{file} has no forces; its columns must be Yr, Yl, Qr and Ql.")
    found = []
    for name in wheelsets:
        forces = {kind: _needed(file, columns, kind + name) for kind in ("Yr", "Yl", "Qr", "Ql")}
        for kind in ("Qr", "Ql"):
            if not np.all(forces[kind] > 0):
                row = int(np.argmax(~(forces[kind] > 0)))
                raise click.UsageError(f"{file}: {kind}{name} is {forces[kind][row]:g} N in row {row + 1}; a wheel without load has no Y/Q. Remove these rows.")
        left = -forces["Yl"] if is_outwards else forces["Yl"]
        found.append(WheelsetForces(name.strip(" _-"), forces["Yr"], left, forces["Qr"], forces["Ql"]))
    return Run(distance, found)


def _distance(file: Path, columns: Mapping[str, Array]) -> Array:
    if "distance" in columns:
        distance = columns["distance"]
    else:
        time, speed = _needed(file, columns, "time"), _needed(file, columns, "speed")
        distance = np.concatenate(([0.0], np.cumsum(np.diff(time) * (speed[1:] + speed[:-1]) / 2)))
    if len(distance) < 2:
        raise click.UsageError(f"{file} has {len(distance)} row; a run requires at least two.")
    if not np.all(np.diff(distance) > 0):
        row = int(np.argmax(~(np.diff(distance) > 0))) + 2
        raise click.UsageError(f"{file}: the distance does not increase at row {row}; remove stops and repeated rows.")
    if not distance[-1] - distance[0] <= _LONGEST:
        raise click.UsageError(f"{file}: the run is {(distance[-1] - distance[0]) / 1e6:g} km long; it may have up to {_LONGEST / 1e6:g} km. Check the unit.")
    return distance


def _needed(file: Path, columns: Mapping[str, Array], name: str) -> Array:
    if name not in columns:
        raise click.UsageError(f"{file} has no column {name}; it has {', '.join(columns)}.")
    return columns[name]


def _columns(file: Path, on_progress: Callable[[float], None]) -> dict[str, Array]:
    """Returns the columns of distance, time, speed and forces in contactd's units; others are ignored."""
    try:
        on_progress(0.0)
        names, rows = table_of(read_whole(file, _MOST_BYTES).decode("utf-8-sig"), lambda share: on_progress(share / 2))
    except OSError as error:
        raise click.UsageError(f"{file} cannot be read: {error.strerror or error}.") from None
    except UnicodeDecodeError:
        raise click.UsageError(f"{file} is not text in UTF-8.") from None
    except ValueError as error:
        raise click.UsageError(f"{file} contains no table: {error}.") from None
    found: dict[str, Array] = {}
    for index, heading in enumerate(names):
        on_progress(0.5 + index / len(names) / 2)
        name, factor = _named(file, heading)
        if factor is None:
            continue
        if name in found:
            raise click.UsageError(f"{file}: the column {name} is given twice.")
        values = [number_in(cells[index]) for _, cells in rows]
        if None in values:
            line, cells = rows[values.index(None)]
            raise click.UsageError(f"{file}: line {line} has {cells[index][:40]!r} in column {heading}; it must be a number.")
        found[name] = factor * np.array(values, dtype=float)
        if not np.all(np.abs(found[name]) <= (largest := _LARGEST[_kind(name)])):
            row = int(np.argmax(~(np.abs(found[name]) <= largest)))
            raise click.UsageError(f"{file}: line {rows[row][0]} has {values[row]:g} in column {heading}, which is too large; check its unit.")
    return found


def _kind(name: str) -> str:
    return "force" if _FORCE.fullmatch(name) else name


def _named(file: Path, heading: str) -> tuple[str, float | None]:
    """Returns the name of a column without its unit, and the factor of the unit; None for other columns."""
    match = _NAME.fullmatch(heading)
    name, unit = (match.group("name"), match.group("unit")) if match is not None else (heading, None)
    kind = _kind(name)
    if kind not in _UNITS:
        return name, None
    units = _UNITS[kind]
    if unit is None:
        return name, next(iter(units.values()))
    if unit not in units:
        raise click.UsageError(f"{file}: the unit of {heading!r} is not supported; use {', '.join(units)}.")
    return name, units[unit]
