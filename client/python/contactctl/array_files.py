"""Arrays in files of their own: numpy's .npy, or text with a row a line."""

from __future__ import annotations

import io
from pathlib import Path
from typing import Any

import click
import numpy as np

from contactd.files.whole import check_npy, read_whole

__all__ = ["read_array"]

_MOST_BYTES = 1 << 29  #: 67 million numbers; a daemon takes no such grid
_MOST_TEXT = 1 << 26
_COMMENTS = ("#", "%")


def read_array(file: Path, named_by: str) -> np.ndarray[Any, Any]:
    """The array of `file`. Raises click.UsageError with the file that names it, and the line."""
    try:
        if file.suffix == ".npy":
            return _npy(read_whole(file, _MOST_BYTES))
        return _text(read_whole(file, _MOST_TEXT).decode("utf-8-sig"))
    except OSError as error:
        raise click.UsageError(f"{named_by} names {file}, which cannot be read: {error.strerror or error}.") from None
    except UnicodeDecodeError:
        raise click.UsageError(f"{named_by} names {file}, which is no text in UTF-8; arrays are in .npy or in text.") from None
    except (ValueError, EOFError, MemoryError) as error:
        raise click.UsageError(f"{named_by} names {file}, which holds no array of numbers: {error}.") from None


def _npy(content: bytes) -> np.ndarray[Any, Any]:
    if content[:2] == b"PK":
        raise ValueError("it is an archive of arrays, as .npz is")
    file = io.BytesIO(content)
    check_npy(file, len(content))
    file.seek(0)
    loaded: np.ndarray[Any, Any] = np.load(file, allow_pickle=False)
    return loaded


def _text(text: str) -> np.ndarray[Any, Any]:
    """Between numbers are blanks, commas, or semicolons, beside which a comma is that of a decimal fraction. What follows # or
    % is a comment, and a first line of words a heading."""
    between = ";" if ";" in text else "," if "," in text else None
    rows: list[list[float]] = []
    is_first = True
    for number, line in enumerate(text.splitlines(), 1):
        for sign in _COMMENTS:
            line = line.partition(sign)[0]
        if not line.strip():
            continue
        words = [word.strip() for word in line.split(between)]
        if between == ";":
            words = [word.replace(",", ".") for word in words]
        if is_first and not any(_is_number(word) for word in words):
            is_first = False
            continue
        is_first = False
        rows.append([_number(word, number) for word in words])
        if len(rows[-1]) != len(rows[0]):
            raise ValueError(f"line {number} has {len(rows[-1])} numbers, and the first {len(rows[0])}")
    if not rows:
        raise ValueError("it has none")
    return np.array(rows)


def _is_number(word: str) -> bool:
    try:
        float(word)
    except ValueError:
        return False
    return True


def _number(word: str, line: int) -> float:
    try:
        return float(word)
    except ValueError:
        raise ValueError(f"line {line} has {word[:40]!r} in the place of a number") from None
