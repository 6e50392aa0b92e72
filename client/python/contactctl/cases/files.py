"""The files that are written of cases, and those that they are compared with."""

from __future__ import annotations

from pathlib import Path

import click

from contactd.contact_files.case import Case
from contactd.contact_files.prints.mat_file import mat_texts
from contactd.contact_files.prints.out_text import IS_OURS
from contactd.contact_files.prints.subs_file import subs_texts
from contactd.contact_files.runner import Outcome
from contactd.files.whole import read_whole

from ..files import write_text

__all__ = ["CaseFiles", "check_own", "read_printed"]

_MOST_BYTES = 1 << 29  #: of an .out file
_HEAD = 1000


def read_printed(path: Path) -> str:
    """The text of an .out file. Raises click.UsageError."""
    try:
        return read_whole(path, _MOST_BYTES).decode("utf-8", errors="replace")
    except OSError as error:
        raise click.UsageError(f"--compare {path} cannot be read: {error.strerror}.") from None


def check_own(path: Path) -> None:
    """Raises click.UsageError for a file that another program has written: it may be what to compare with."""
    if not path.is_file():
        return
    with path.open("rb") as file:
        head = file.read(_HEAD).decode("utf-8", errors="replace")
    if IS_OURS not in head:
        raise click.UsageError(f"{path} is there, and contactd has not written it: name another file by --output.")


class CaseFiles:
    """Files beside the .out file, each written whole when its case is there."""

    def __init__(self, place: Path) -> None:
        self._place = place

    def keep(self, outcome: Outcome) -> None:
        """Writes what a case asks for."""
        if outcome.result is None:
            return
        for letter, text in mat_texts(outcome.result):
            write_text(self._named(outcome.case, f"{outcome.case.number:04d}{letter}.mat"), text)
        for letter, text in subs_texts(outcome.result):
            write_text(self._named(outcome.case, f"{outcome.case.number:04d}{letter}.subs"), text)

    def _named(self, case: Case, ending: str) -> Path:
        """Result elements count their cases each by itself."""
        element = "" if case.reid is None else f".r{case.reid}" + ("" if case.cpid is None else f"c{case.cpid}")
        return self._place.with_name(f"{self._place.stem}{element}.{ending}")
