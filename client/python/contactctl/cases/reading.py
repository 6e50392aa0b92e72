"""Reads input files of the CONTACT program for commands. Warnings name the case by its number in the file."""

from __future__ import annotations

from pathlib import Path
from typing import Any, NamedTuple

from contactd import Client
from contactd.calls.answer_warnings import collected
from contactd.contact_files.case import ContactFile
from contactd.contact_files.input_file import name_and_text
from contactd.contact_files.named_files import NamedFiles
from contactd.contact_files.runner import Runner

from ..files import allowed_folders
from ..output import note, warn, warn_of
from .rows import case_name

__all__ = ["ReadFile", "read_cases"]

_PART = 0.5  #: Time between rows of the journal (s).


class ReadFile(NamedTuple):
    """Holds an input file: its cases, its text, and the files that it names."""

    content: ContactFile
    text: str
    files: NamedFiles

    def runner(self, client: Client, name: str, wheel: Any = "exact") -> Runner:
        """Returns a runner of the cases, for prints and numbers by CONTACT's names."""
        return Runner(client, self.text, self.content.cases, self.files, wheel, name=name, fields=[], seconds=_PART)


def read_cases(file: Path, client: Client) -> ReadFile:
    """Reads a file, and shows its warnings and those of its cases, and its errors between cases."""
    with collected():  # These sentences name cases by their indices.
        name, text = name_and_text(file)
        found = client.read_contact_file(text, name=name)
    warn(found.warnings)
    warn_of("case", ((case_name(vars(case)), sentence) for case in found.cases for sentence in case.warnings))
    for sentence in found.errors:
        note(f"{file}: {sentence}")
    return ReadFile(found, text, NamedFiles(file.parent, allowed_folders(file.parent)))
