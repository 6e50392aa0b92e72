"""Reads input files of the CONTACT program for commands. Warnings name the case by its number in the file."""

from __future__ import annotations

from pathlib import Path

from contactd import Client
from contactd.calls.answer_warnings import collected
from contactd.contact_files import read
from contactd.contact_files.case import ContactFile

from ..output import warn, warn_of
from .rows import case_name

__all__ = ["read_cases"]


def read_cases(file: Path, client: Client) -> ContactFile:
    """Reads a file, and shows its warnings and those of its cases."""
    with collected():  # These sentences name cases by their indices.
        found = read(file, client)
    warn(found.warnings)
    warn_of("case", ((case_name(vars(case)), sentence) for case in found.cases for sentence in case.warnings))
    return found
