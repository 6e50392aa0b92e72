"""Finds the files of given cases: inputs of the CONTACT program with its printed results."""

from __future__ import annotations

import json
import re
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

from contactd.contact_files.out_reader import PrintedCase, printed_cases

__all__ = ["LIST", "FilesMissing", "GivenFile", "families", "given_files", "printed_seconds"]

LIST = "cases_given.json"
_TOTAL = re.compile(r"^\|Total +\| +\d+ \| +([\d.]+) \|[^|]*\| +([\d.]+) \|", re.MULTILINE)


class FilesMissing(Exception):
    """Raised when files are not in their place; the message names the missing ones."""


@dataclass(frozen=True)
class GivenFile:
    """A file of cases.

    Attributes:
        name: Path of the input file below the common folder.
        path: The input file.
        reference: The printed results of the CONTACT program.
    """

    name: str
    path: Path
    reference: Path

    @property
    def family(self) -> str:
        """Returns the folder of the file; the Manchester benchmark is a separate family among the examples."""
        folder = Path(self.name).parent.name
        if folder == "examples" and Path(self.name).name.startswith("mbench"):
            return "mbench"
        return folder.removeprefix("examples_")

    def printed(self) -> list[PrintedCase]:
        """Returns the printed cases, in their order."""
        return printed_cases(self._text())

    def printed_seconds(self) -> float | None:
        """Returns the printed time of all its cases, or None without one."""
        return printed_seconds(self._text())

    def _text(self) -> str:
        return self.reference.read_text(errors="replace")


def given_files(folder: Path) -> list[GivenFile]:
    """Returns the files in the folder's list that have printed numbers. Raises FilesMissing."""
    try:
        listed = json.loads((folder / LIST).read_text())["files"]
    except FileNotFoundError:
        raise FilesMissing(
            f"{folder / LIST} is missing: the cases of the CONTACT program are not part of this repository; "
            "give their folder by --cases"
        ) from None
    except (ValueError, KeyError, TypeError):
        raise FilesMissing(f"{folder / LIST} is not a list of cases") from None
    files = [
        GivenFile(one["file"], folder / one["file"], folder / one["reference"]) for one in listed if one["reference"]
    ]
    for path in (path for one in files for path in (one.path, one.reference)):
        if not path.is_file():
            raise FilesMissing(f"{path} is not there, which {folder / LIST} names")
    return files


def families(files: Sequence[GivenFile]) -> list[str]:
    """Returns the families of the files, in their order."""
    return list(dict.fromkeys(one.family for one in files))


def printed_seconds(text: str) -> float | None:
    """Returns the wall-clock time of the timers at the end of an .out file (s)."""
    found = _TOTAL.search(text)
    return float(found[2]) if found else None
