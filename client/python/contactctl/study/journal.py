"""Stores rows of a study in a file that only grows: one line each, with its checksum, written at once.

If the process is killed, the file contains each finished row once, and possibly the beginning of another, which the
next run removes. Damaged lines are ignored, and their rows are solved again.
"""

from __future__ import annotations

import fcntl
import json
import os
import secrets
import time
import zlib
from pathlib import Path
from types import TracebackType
from typing import Any

from contactd.files.whole import read_whole

from ..codes import Code, Ended
from ..output import note

__all__ = ["MOST_BYTES", "Journal", "rows_in"]

MOST_BYTES = 1 << 32  #: Largest size of a file with rows.
_CHECKSUM = 8  #: Number of digits.
_SYNC = 1.0  # largest loss at a power failure, in seconds of work


class Journal:
    """Holds the finished rows by their keys. Only one thread of one process may use it at a time.

    Attributes:
        rows: Rows in the order of completion; each has a `key`.
    """

    def __init__(self, path: Path) -> None:
        self.path = path
        if path.is_symlink() and not path.exists():
            raise Ended(Code.USAGE, f"{path} is a broken link; give another file with --rows.")
        self.rows: dict[str, dict[str, Any]] = {}
        self._file = os.open(path, os.O_RDWR | os.O_CREAT | os.O_APPEND | os.O_CLOEXEC, 0o644)
        try:
            fcntl.flock(self._file, fcntl.LOCK_EX | fcntl.LOCK_NB)
        except OSError:
            os.close(self._file)
            raise Ended(Code.USAGE, f"{path} belongs to a running study; wait for it, or give another file with --rows.") from None
        self._read()
        self._synced = time.monotonic()

    def __enter__(self) -> Journal:
        return self

    def __exit__(
        self, kind: type[BaseException] | None, value: BaseException | None, traceback: TracebackType | None
    ) -> None:
        os.fsync(self._file)
        os.close(self._file)

    def add(self, row: dict[str, Any]) -> None:
        """Writes a new row. If it cannot be written, raises OSError and leaves no part of it."""
        if row["key"] in self.rows:
            return
        line = _line(row)
        before = os.fstat(self._file).st_size
        written = 0
        try:
            while written < len(line):  # on a full disk, a part may be written
                written += os.write(self._file, line[written:])
        except BaseException:
            os.ftruncate(self._file, before)
            raise
        self.rows[row["key"]] = row
        if time.monotonic() - self._synced > _SYNC:
            os.fsync(self._file)
            self._synced = time.monotonic()

    def forget(self, keys: set[str]) -> None:
        """Removes rows so that they are solved again: rewrites the file without them."""
        kept = [row for key, row in self.rows.items() if key not in keys]
        part = Path(f"{os.path.realpath(self.path)}.{secrets.token_hex(4)}.part")
        with part.open("xb") as file:
            file.writelines(_line(row) for row in kept)
            file.flush()
            os.fsync(file.fileno())
        renewed = os.open(part, os.O_RDWR | os.O_APPEND | os.O_CLOEXEC)
        fcntl.flock(renewed, fcntl.LOCK_EX | fcntl.LOCK_NB)
        part.replace(os.path.realpath(self.path))
        os.close(self._file)
        self._file = renewed
        self.rows = {row["key"]: row for row in kept}

    def _read(self) -> None:
        try:
            content = read_whole(self.path, MOST_BYTES)
            self.rows = rows_in(self.path, content)
        except BaseException:
            os.close(self._file)
            raise
        whole = content.rfind(b"\n") + 1
        if whole < len(content):  # The process was killed while it wrote a line.
            os.ftruncate(self._file, whole)


def rows_in(path: Path, content: bytes) -> dict[str, dict[str, Any]]:
    """Returns the complete lines of a file with this content. Raises Ended if none is a row."""
    rows: dict[str, dict[str, Any]] = {}
    damaged = 0
    for line in content[: content.rfind(b"\n") + 1].splitlines():
        row = _row(line)
        if row is None:
            damaged += 1
        else:
            rows.setdefault(row["key"], row)
    rest = content[content.rfind(b"\n") + 1 :]
    if not rows and (damaged or not _can_begin_a_line(rest)):
        raise Ended(Code.USAGE, f"{path} is not a file with rows of a study; give another one with --rows.")
    if damaged:
        note(f"warning: {damaged} damaged lines of {path} are ignored, and their rows are solved again.")
    return rows


def _can_begin_a_line(content: bytes) -> bool:
    """Returns whether a row can begin like this, or the content is empty."""
    checksum, blank, text = content[:_CHECKSUM], content[_CHECKSUM : _CHECKSUM + 1], content[_CHECKSUM + 1 :]
    is_hexadecimal = all(sign in b"0123456789abcdef" for sign in checksum)
    return is_hexadecimal and blank in (b"", b" ") and text[:1] in (b"", b"{")


def _line(row: dict[str, Any]) -> bytes:
    text = json.dumps(row, allow_nan=False).encode()
    return b"%08x %s\n" % (zlib.crc32(text), text)


def _row(line: bytes) -> dict[str, Any] | None:
    """Returns the row; None for a damaged line."""
    checksum, _, text = line.partition(b" ")
    if checksum != b"%08x" % zlib.crc32(text):
        return None
    try:
        row = json.loads(text)
    except (ValueError, RecursionError):  # a line with a valid checksum, but not a row
        return None
    kinds = {"key": str, "code": int, "values": dict}
    if not isinstance(row, dict) or not all(isinstance(row.get(name), kind) for name, kind in kinds.items()):
        return None
    is_whole = isinstance(row.get("answers", {}), dict) and isinstance(row.get("warnings", []), list)
    return row if is_whole else None
