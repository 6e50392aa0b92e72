"""Reads input files of the CONTACT program and sends their text to the service."""

from __future__ import annotations

import os

from ..files.case_text import text_of
from ..values.generated.contact_files import ContactFile
from .asked_client import AskedClient

__all__ = ["name_and_text", "read"]


def read(path_or_text: str | os.PathLike[str], client: AskedClient) -> ContactFile:
    """Reads the cases of an input file (.inp), or of its text: a string with a line break is a text.

    The `client` parses the text and opens no file; it may be ``contactd.local()`` or a client of a daemon. Errors of a
    case are in its `errors`. Errors between cases are in those of the file.

    Raises OSError for a file that cannot be read or is larger than 16 MiB.
    """
    name, text = name_and_text(path_or_text)
    file: ContactFile = client.read_contact_file(text, name=name)
    return file


def name_and_text(path_or_text: str | os.PathLike[str]) -> tuple[str, str]:
    """Returns the name of a file in error messages, and its text."""
    if isinstance(path_or_text, str) and "\n" in path_or_text:
        return "text", path_or_text
    return os.path.basename(os.fspath(path_or_text)), text_of(path_or_text)
