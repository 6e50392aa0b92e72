"""Reads records of roughness from text, CSV and files of numpy. Units are read from headings or asked for, never guessed."""

from __future__ import annotations

import io
import os
import re
from collections.abc import Sequence
from pathlib import Path
from typing import Any

import numpy as np
import numpy.typing as npt

from ..errors import invalid
from ..files.heading_units import heading_of
from ..files.number_text import rows_of
from ..files.whole import arrays_of, check_npy, read_whole
from ..refusals import public
from .records import Record, factor_of, record_of

__all__ = ["read_record"]

_MOST_BYTES = 1 << 28  #: Largest size of a numpy file, 33 million heights.
_MOST_TEXT = 1 << 26
_UNIT = re.compile(r"[\[(]\s*([^\[\]()]{1,20}?)\s*[\])]|(?:/|\bin\b|_)\s*([a-zA-Zµμ]{1,7})\s*$")
_BETWEEN = re.compile(r"\s*[;,\t]\s*")
_NAMES = ("x", "spacing", "heights", "y", "x_unit", "height_unit")


@public
def read_record(
    path: str | os.PathLike[str],
    *,
    x_unit: str | None = None,
    height_unit: str | None = None,
    spacing: float | None = None,
    columns: Sequence[int] | None = None,
    y: npt.ArrayLike | None = None,
    upside_down: bool = False,
) -> Record:
    """Returns the record in a file: text or CSV, .npy with an array, or .npz with named arrays.

    The first column is x and each further one a line; with `spacing`, in `x_unit`, all columns are lines. `columns`
    selects and orders them, counted from 0. Arrays of .npy have the same columns, shape [samples, columns] or
    [samples]. Those of .npz are called x or spacing, heights [lines, samples], and optionally y (mm), x_unit and
    height_unit. Text may have semicolons and decimal commas, and comments after #, % or !.

    Units are read from headings such as "x (m)", "r [um]" or "height_um"; arguments state those that are missing: m, cm,
    mm, um or nm. `y` contains the lateral positions of several lines (mm). Heights are positive towards the other body;
    `upside_down` reverses their sign.

    Raises OSError if the file cannot be read, or is larger than 256 MiB, or 64 MiB as text. Raises InvalidArgument
    naming the field: for missing or contradictory units, and for the reasons of record_of.
    """
    name = Path(path).name
    suffix = Path(path).suffix.lower()
    stated: dict[str, str | None] = {"x_unit": None, "height_unit": None}
    if suffix == ".npz":
        found = _archive(path, name)
        stated.update({unit: str(found[unit]) for unit in stated if unit in found})
        x = found.get("x", found.get("spacing", spacing))
        heights, y = found["heights"], found.get("y", y)
    else:
        table, headings = (_npy(path, name), []) if suffix == ".npy" else _text(path, name)
        chosen = list(range(table.shape[1])) if columns is None else [int(column) for column in columns]
        if not chosen or not all(0 <= column < table.shape[1] for column in chosen):
            raise invalid("columns", f"= {chosen}: {name} has columns 0 to {table.shape[1] - 1}. Name some of them.")
        first = chosen[1:] if spacing is None else chosen
        if not first:
            raise invalid("spacing", f"= None: {name} has one column, which contains heights without places. Give the distance of the samples, with x_unit.")
        x, heights = (table[:, chosen[0]] if spacing is None else spacing), table[:, first].T
        units = [unit_in(heading) for heading in headings] or [None] * table.shape[1]
        stated = {"x_unit": units[chosen[0]] if spacing is None else None, "height_unit": _one({units[column] for column in first}, name)}
    if x is None:
        raise invalid("spacing", f"= None: {name} has neither x nor spacing. Give the distance of the samples, with x_unit.")
    given = {"x_unit": x_unit, "height_unit": height_unit}
    for field, unit in given.items():
        if unit is not None and stated[field] is not None and factor_of(field, unit) != factor_of(field, stated[field]):
            raise invalid(field, f"= {unit}: {name} states {stated[field]}. Omit {field}, or correct the heading.")
    return record_of(
        x, heights, x_unit=x_unit or stated["x_unit"], height_unit=height_unit or stated["height_unit"], y=y, upside_down=upside_down,
    )  # fmt: skip


def unit_in(heading: str) -> str | None:
    """Returns the unit that a heading states, such as m in "x (m)"; None without one."""
    found = _UNIT.search(heading.strip().strip('"'))
    return None if found is None else found.group(1) or found.group(2)


def _one(units: set[str | None], name: str) -> str | None:
    if len(units) > 1:
        raise invalid("height_unit", f"= {' and '.join(sorted(map(str, units)))}: the lines of {name} have different units. Select lines of one unit with columns.")
    return units.pop()


def _text(path: str | os.PathLike[str], name: str) -> tuple[np.ndarray[Any, Any], list[str]]:
    """Returns the numbers and, if a line of headings has as many cells, the headings of the columns."""
    try:
        text = read_whole(path, _MOST_TEXT).decode("utf-8-sig")
        heading = heading_of(text)
        # Headings may contain numbers, such as "dB re 1 um"; blank lines keep the numbers of the others.
        table = np.array(rows_of("\n".join([""] * len(heading) + text.splitlines()[len(heading) :])))
    except UnicodeDecodeError:
        raise invalid("path", f"= {name}: it is not text in UTF-8. Convert it, or use .npy or .npz.") from None
    except ValueError as error:
        raise invalid("path", f"= {name}: it contains no table of numbers: {error}. Correct this line.") from None
    for line in reversed(heading):
        words = line.strip().lstrip("#%! \t")
        for cells in (_BETWEEN.split(words), words.split()):
            if len(cells) == table.shape[1] and any(unit_in(cell) for cell in cells):
                return table, cells
    return table, []


def _npy(path: str | os.PathLike[str], name: str) -> np.ndarray[Any, Any]:
    content = read_whole(path, _MOST_BYTES)
    try:
        check_npy(io.BytesIO(content), len(content))
        found: np.ndarray[Any, Any] = np.load(io.BytesIO(content), allow_pickle=False)
    except (ValueError, EOFError, MemoryError) as error:
        raise invalid("path", f"= {name}: it contains no array of numbers: {error}. Save it with numpy.save.") from None
    if found.ndim not in (1, 2):
        raise invalid("path", f"= {name}: its array has the shape {list(found.shape)}. Give [samples, columns], or [samples].")
    return found.astype(float).reshape(len(found), -1)


def _archive(path: str | os.PathLike[str], name: str) -> dict[str, Any]:
    content = read_whole(path, _MOST_BYTES)
    try:
        found = arrays_of(io.BytesIO(content))
    except Exception as error:  # zipfile and numpy raise many kinds for damaged archives.
        raise invalid("path", f"= {name}: it is not an archive of arrays: {error}. Save it with numpy.savez.") from None
    if "heights" not in found:
        raise invalid("path", f"= {name}: it contains {', '.join(sorted(found)) or 'nothing'}. Its arrays must be called {', '.join(_NAMES)}.")
    return found
