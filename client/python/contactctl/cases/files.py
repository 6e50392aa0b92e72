"""Writes output files of cases, and files for comparison."""

from __future__ import annotations

from collections.abc import Iterable
from pathlib import Path

import click

from contactd.contact_files.case import Case
from contactd.contact_files.prints.mat_file import mat_texts
from contactd.contact_files.prints.subs_file import subs_texts
from contactd.contact_files.solved_case import SolvedCase
from contactd.files.whole import read_whole

from ..files import check_own, write_text

__all__ = ["CaseFiles", "read_printed"]

_MOST_BYTES = 1 << 29  #: Largest size of an .out file.


def read_printed(path: Path) -> str:
    """Returns the text of an .out file. Raises click.UsageError."""
    try:
        return read_whole(path, _MOST_BYTES).decode("utf-8", errors="replace")
    except OSError as error:
        raise click.UsageError(f"--compare {path} cannot be read: {error.strerror}.") from None


class CaseFiles:
    """Writes files in addition to the .out file. Each is written when its case is complete."""

    def __init__(self, place: Path) -> None:
        self._place = place

    def check(self, cases: Iterable[Case]) -> None:
        """Raises click.UsageError if one of them exists and another program has written it. The letters of contacts are
        not yet known.
        """
        stems: dict[str, set[str]] = {".mat": set(), ".subs": set()}
        for case in cases:
            stem = self._named(case, f"{case.number:04d}").name
            if case.digits.get("A"):
                stems[".mat"].add(stem)
            if case.digits.get("S") and case.values.get("SUBS_A"):
                stems[".subs"].add(stem)
        for path in sorted(self._place.absolute().parent.iterdir()):
            if path.suffix in stems and not stems[path.suffix].isdisjoint({path.stem, path.stem[:-1]}):
                check_own("--output", path)

    def keep(self, solved: SolvedCase) -> None:
        """Writes the files of a case."""
        if solved.solution is None:
            return
        for ending, texts in ((".mat", mat_texts), (".subs", subs_texts)):
            for letter, text in texts(solved):
                write_text(self._named(solved.case, f"{solved.number:04d}{letter}{ending}"), text)

    def _named(self, case: Case, ending: str) -> Path:
        """Each result element counts its cases separately."""
        element = "" if case.reid is None else f".r{case.reid}" + ("" if case.cpid is None else f"c{case.cpid}")
        return self._place.with_name(f"{self._place.stem}{element}.{ending}")
