"""Reads the benchmark of EN 15302 from files with profiles and values."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

import click
import numpy as np

from contactd.files.number_text import rows_of
from contactd.files.whole import read_whole
from contactd.values.arrays import Array
from contactd.wheel_rail import ProfilePoints

from .benchmark import COMBINATIONS, Benchmark

__all__ = ["read_benchmark"]

_MOST_BYTES = 1 << 24
_RAIL = "SUIC519A.dat"


def read_benchmark(folders: Sequence[Path]) -> Benchmark:
    """Returns the profiles RUIC519A.dat, B, H, I and SUIC519A.dat, and the values ben_E1.dat to ben_E9.dat, of folders.

    Profiles have two columns, y and z in mm. Values have the amplitude (mm) and the conicity in their first two
    columns. Raises click.UsageError naming the missing or invalid file.
    """
    values = {name: _values(file) for name in COMBINATIONS if (file := _found(folders, f"ben_{name}.dat")) is not None}
    if not values:
        raise click.UsageError(f"{_named(folders)}: there are no values; the files must be called ben_E1.dat to ben_E9.dat.")
    letters = sorted({letter for name in values for letter in (COMBINATIONS[name].right, COMBINATIONS[name].left)})
    wheels = {letter: _profile(_needed(folders, f"RUIC519{letter}.dat")) for letter in letters}
    return Benchmark(wheels, _profile(_needed(folders, _RAIL)), values)


def _named(folders: Sequence[Path]) -> str:
    return ", ".join(map(str, folders))


def _found(folders: Sequence[Path], name: str) -> Path | None:
    for folder in folders:
        if not folder.is_dir():
            raise click.UsageError(f"{folder} is not a folder.")
        if (file := folder / name).exists():
            return file
    return None


def _needed(folders: Sequence[Path], name: str) -> Path:
    if (file := _found(folders, name)) is None:
        raise click.UsageError(f"{_named(folders)}: the profile {name} is missing.")
    return file


def _values(file: Path) -> list[tuple[float, float]]:
    values = [(float(amplitude), float(conicity)) for amplitude, conicity in _columns(file)]
    if wrong := next((row for row in values if not (row[0] > 0 and row[1] >= 0)), None):
        raise click.UsageError(f"{file}: amplitude {wrong[0]:g} with conicity {wrong[1]:g}: give amplitudes above 0 and conicities of at least 0.")
    return values


def _profile(file: Path) -> ProfilePoints:
    points = _columns(file)
    # The flange of a wheel and the gauge face of a rail are the places with the largest z.
    is_upwards = bool(points[np.argmax(np.abs(points[:, 1])), 1] < 0)
    return ProfilePoints(points, mirror_z=is_upwards)


def _columns(file: Path) -> Array:
    try:
        rows = np.array(rows_of(read_whole(file, _MOST_BYTES).decode("utf-8-sig")))
    except OSError as error:
        raise click.UsageError(f"{file} cannot be read: {error.strerror or error}.") from None
    except UnicodeDecodeError:
        raise click.UsageError(f"{file} is not text in UTF-8.") from None
    except ValueError as error:
        raise click.UsageError(f"{file} contains no table of numbers: {error}.") from None
    if rows.shape[1] < 2:
        raise click.UsageError(f"{file} has one column; it must have two or more.")
    found: Array = rows[:, :2]
    return found
