"""Reports wear of a rail that varies along the track, such as a crossing: a map in a file, and a table."""

from __future__ import annotations

import json
import math
from pathlib import Path
from typing import Any

import click
import numpy as np

from contactd import __version__
from contactd.files.whole import write_whole
from contactd.refusals import did_you_mean
from contactd.wear.slices import DepthMap, depths_along

from ..common import connected, setting
from ..files import named_file, read_object
from ..output import emit, listing
from ..paths import copied, put_into_words
from .reading import states_of

__all__ = ["is_along", "wear_along"]

_FIELDS = {"setup", "states", "wears", "law", "until", "along", "energy"}
_MOST = 100_000  #: Largest number of cells on an axis.
_MOST_CELLS = 10_000_000  #: Largest number of cells of the map.


def is_along(file: str) -> bool:
    """Returns whether a study has `along`, and so a map instead of steps."""
    return file != "-" and "along" in read_object(file)


def wear_along(file: str, output: Path) -> None:
    """Solves all states, writes the map to an HDF5 file, and shows the pieces. Raises click.UsageError."""
    given = read_object(file)
    if unknown := given.keys() - _FIELDS:
        meant = did_you_mean(min(unknown), _FIELDS)
        raise click.UsageError(f"{file}: a study along the track has no {', '.join(sorted(unknown))}; it has {', '.join(sorted(_FIELDS))}.{meant}")
    if missing := [name for name in ("setup", "states", "law", "until") if name not in given]:
        raise click.UsageError(f"{file}: {', '.join(missing)} {'is' if len(missing) == 1 else 'are'} missing.")
    if given.get("wears", "rail") != "rail":
        raise click.UsageError(f"{file}: wears is {given['wears']!r}; along the track it must be rail.")
    law = given["law"]
    if not (isinstance(law, dict) and law.get("name") and law.get("source")):
        raise click.UsageError(f"{file}: law has no name or no source; give its name, and the source of its coefficients.")
    x, y = (_edges(file, given["along"], name) for name in ("x", "y"))
    until = given["until"]
    if isinstance(until, bool) or not isinstance(until, (int, float)) or not 0 < until < math.inf:
        raise click.UsageError(f"{file}: until is {until!r}; it must be a positive number of passages.")
    if not isinstance(given["setup"], dict):
        raise click.UsageError(f"{file}: setup is {given['setup']!r}; it must be an object, fields with their values.")
    if (len(x) - 1) * (len(y) - 1) > _MOST_CELLS:
        raise click.UsageError(f"{file}: along has {len(x) - 1} times {len(y) - 1} cells, but at most {_MOST_CELLS} are allowed.")
    setup = copied({"setup": given["setup"]})
    put_into_words(setup)
    states = states_of(named_file(str(given["states"]), file))
    with connected(local_unless_named=True) as client:
        found = depths_along(client, setup["setup"], states, law, x, y, energy=given.get("energy", "scaled"))
    _write(output, given, found, float(until))
    depths = found.after(float(until))
    columns = ["x from, mm", "to", "largest depth, mm", "at y, mm", "area, mm^2", "pmax, N/mm^2"]
    centres = 0.5 * (y[1:] + y[:-1])
    rows = [
        [x[i], x[i + 1], float(depths[i].max()), float(centres[depths[i].argmax()]), float((depths[i] * np.diff(y)).sum()), float(found.pmax[i])]
        for i in range(len(depths))
    ]
    names = ("x_from", "x_to", "depth", "y", "area", "pmax")
    emit(setting().json, {"pieces": [dict(zip(names, map(float, row))) for row in rows]}, listing(None, columns, rows))


def _edges(file: str, along: Any, name: str) -> np.ndarray[Any, np.dtype[np.float64]]:
    """Returns the edges from `from`, `to` and `step` in `along`."""
    value = along.get(name) if isinstance(along, dict) else None
    is_list = isinstance(value, list) and len(value) == 3 and all(_is_number(one) for one in value)
    if not is_list or value is None or not (value[2] > 0 and value[1] - value[0] >= value[2]):
        raise click.UsageError(f"{file}: along.{name} is {value!r}; it must be [from, to, step] in mm, as [0, 200, 10].")
    count = round((value[1] - value[0]) / value[2])
    if count > _MOST:
        raise click.UsageError(f"{file}: along.{name} has {count} pieces, but at most {_MOST} are allowed.")
    return np.asarray(np.linspace(float(value[0]), float(value[1]), count + 1), dtype=np.float64)


def _is_number(value: Any) -> bool:
    return isinstance(value, (int, float)) and not isinstance(value, bool) and math.isfinite(value)


def _write(path: Path, given: dict[str, Any], found: DepthMap, passages: float) -> None:
    import io

    import h5py

    content = io.BytesIO()
    with h5py.File(content, "w") as file:
        file.attrs.update(contactd=__version__, study=json.dumps(given, sort_keys=True, default=str), passages=passages)
        file.attrs["sources"] = json.dumps([f"{given['law']['name']}: {given['law']['source']}"])
        for name, values in vars(found).items():
            file.create_dataset(name, data=values)
    write_whole(path, lambda into: into.write(content.getvalue()))
