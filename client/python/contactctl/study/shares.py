"""Shares of a study for independent processes: the tasks of a job array, or two terminals."""

from __future__ import annotations

import fcntl
import re
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any, TypeVar

import click

from contactd.files.whole import read_whole

from ..codes import Code, Ended
from .journal import MOST_BYTES, rows_in

__all__ = ["Rows", "Share", "best", "check_ended", "rows_beside", "share_of"]

Case = TypeVar("Case")
Rows = dict[str, dict[str, Any]]  #: Rows by their keys.


@dataclass(frozen=True)
class Share:
    """Selects every `count`-th case from the `index`-th on, so that shares have similar amounts of work."""

    index: int
    count: int

    def cases(self, cases: Sequence[Case]) -> Sequence[Case]:
        return cases[self.index :: self.count]

    def numbers(self, count: int) -> Sequence[int]:
        """Returns the numbers of its cases in the study, which begin with 1."""
        return range(1, count + 1)[self.index :: self.count]

    def file(self, rows: Path) -> Path:
        """Returns the file of its rows; `rows` is that of the study."""
        return Path(f"{rows}.{self.index}-of-{self.count}")


def share_of(text: str) -> Share:
    """Returns the share described by a text such as 0/16. Raises click.UsageError."""
    found = re.fullmatch(r"(\d{1,6})/(\d{1,6})", text)
    if not found or not int(found[1]) < int(found[2]):
        raise click.UsageError(f"--share is {text!r}; it must be INDEX/COUNT with INDEX below COUNT, such as 0/16 to 15/16.")
    return Share(int(found[1]), int(found[2]))


def rows_beside(rows: Path, own: Path) -> Rows:
    """Returns the rows of the study's file and of all its shares, for any number of shares, except the `own` file.
    Other processes may be writing: incomplete lines are ignored.
    """
    files = [path for path in (rows, *_files(rows)) if path != own and path.is_file()]
    return best(*(rows_in(path, read_whole(path, MOST_BYTES)) for path in files))


def best(*sources: Rows) -> Rows:
    """Returns each row once: that of the first source, or a later successful one if it failed."""
    found: Rows = {}
    for rows in sources:
        found.update({key: row for key, row in rows.items() if key not in found or (found[key]["code"] and not row["code"])})
    return found


def check_ended(rows: Path) -> None:
    """Raises Ended while a share is running."""
    for path in _files(rows):
        with path.open("rb") as file:
            try:
                fcntl.flock(file, fcntl.LOCK_SH | fcntl.LOCK_NB)
            except OSError:
                raise Ended(Code.USAGE, f"{path} belongs to a running share; wait for it, or solve another --share.") from None


def _files(rows: Path) -> list[Path]:
    """Lists the files of the shares that have rows."""
    pattern = re.compile(re.escape(rows.name) + r"\.\d+-of-\d+")
    return sorted(path for path in rows.parent.iterdir() if pattern.fullmatch(path.name)) if rows.parent.is_dir() else []
