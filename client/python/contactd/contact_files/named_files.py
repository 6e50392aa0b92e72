"""Reads files named in cases: profiles, lists of slices and influence coefficients. Their contents are sent to the
service."""

from __future__ import annotations

import os
import posixpath
import re
from collections.abc import Iterable, Iterator
from pathlib import Path
from threading import Lock

from ..files.case_text import text_of
from ..files.reach import check_within
from ..files.whole import digest_of
from .case import Case

__all__ = ["NamedFiles"]

_DRIVE = re.compile(r"[A-Za-z]:")
_LISTS = (".slcs", ".slcw")
_OF_FILE = 9  #: C
_LONGEST_NAME, _LONGEST_REASON = 4096, 1000  #: Limits in proto/schema.


class NamedFiles:
    """Reads each file once. Names are relative to `folder`, with either path separator. Files outside the `allowed`
    folders are refused; None allows all.
    """

    def __init__(self, folder: str | os.PathLike[str], allowed: Iterable[Path] | None = None) -> None:
        self._folder = Path(folder)
        self._allowed = None if allowed is None else tuple(allowed)
        self._read: dict[str, dict[str, str]] = {}
        self._lock = Lock()

    def contents(self, cases: Iterable[Case]) -> list[dict[str, str]]:
        """Returns the files that these cases need, as for Client.run_contact_file."""
        with self._lock:
            return [self._content(name) for name in self._names_of(cases) if 0 < len(name) <= _LONGEST_NAME]

    def digests(self, cases: Iterable[Case]) -> dict[str, str]:
        """Returns a digest of each file that these cases need; empty for a file that cannot be read."""
        paths = {self._place(name) for name in self._names_of(cases)}
        return {os.fspath(path): digest_of(path) if self._is_allowed(path) else "" for path in paths}

    def _names_of(self, cases: Iterable[Case]) -> list[str]:
        named = {str(case.values[name]).replace("\\", "/") for case in cases for name in _names_in(case)}
        slices = {slice for name in named if name.lower().endswith(_LISTS) for slice in self._slices(name)}
        return sorted(named | slices)

    def _slices(self, name: str) -> Iterator[str]:
        """Returns the profiles in a list of slices, in quotation marks in its lines; none if it cannot be read."""
        for line in self._content(name).get("text", "").splitlines():
            for profile in filter(None, line.split("'")[1:-1:2]):
                yield posixpath.join(posixpath.dirname(name), profile.replace("\\", "/"))

    def _content(self, name: str) -> dict[str, str]:
        if name not in self._read:
            try:
                path = self._place(name)
                self._check(path)
                self._read[name] = {"name": name, "text": text_of(path)}
            except OSError as error:
                reason = (error.strerror or str(error)).removesuffix(".")
                self._read[name] = {"name": name, "failure": reason[:_LONGEST_REASON]}
        return self._read[name]

    def _check(self, path: Path) -> None:
        if self._allowed is not None:
            check_within(path, self._allowed)

    def _is_allowed(self, path: Path) -> bool:
        try:
            self._check(path)
        except OSError:
            return False
        return True

    def _place(self, name: str) -> Path:
        path = Path(name)
        return path if path.is_absolute() or _DRIVE.match(name) else self._folder / path


def _names_in(case: Case) -> tuple[str, ...]:
    """Returns the names of the values that name files. A case with errors may lack some."""
    names = ("RFNAME", "WFNAME") if case.module == 1 else ("CFNAME",) if case.values.get("INFLCF") == _OF_FILE else ()
    return tuple(name for name in names if name in case.values)
