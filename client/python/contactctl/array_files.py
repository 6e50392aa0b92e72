"""Arrays in separate files: numpy's .npy, or text with one row per line."""

from __future__ import annotations

import io
from pathlib import Path
from typing import Any

import click
import numpy as np

from contactd.files.heading_units import unit_factor
from contactd.files.number_text import rows_of
from contactd.files.whole import check_npy, read_whole

__all__ = ["read_array"]

_MOST_BYTES = 1 << 29  #: 67 million numbers, more than the grid of any daemon.
_MOST_TEXT = 1 << 26


def read_array(file: Path, named_by: str) -> np.ndarray[Any, Any]:
    """Returns the array of `file`. Text is converted from the unit in its heading to mm or N/mm^2. Raises
    click.UsageError naming the file that refers to it, and the line.
    """
    try:
        if file.suffix == ".npy":
            return _npy(read_whole(file, _MOST_BYTES))
        text = read_whole(file, _MOST_TEXT).decode("utf-8-sig")
        values = np.array(rows_of(text))
        factor = unit_factor(text)
        return values if factor == 1 else values * factor
    except OSError as error:
        raise click.UsageError(f"{named_by} names {file}, which cannot be read: {error.strerror or error}.") from None
    except UnicodeDecodeError:
        raise click.UsageError(f"{named_by} names {file}, which is not text in UTF-8; give arrays as .npy or as text.") from None
    except (ValueError, EOFError, MemoryError) as error:
        raise click.UsageError(f"{named_by} names {file}, which contains no array of numbers: {error}.") from None


def _npy(content: bytes) -> np.ndarray[Any, Any]:
    if content[:2] == b"PK":
        raise ValueError("it is an archive of arrays, such as .npz")
    file = io.BytesIO(content)
    check_npy(file, len(content))
    file.seek(0)
    loaded: np.ndarray[Any, Any] = np.load(file, allow_pickle=False)
    return loaded
