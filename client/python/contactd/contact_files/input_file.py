"""Input files of the CONTACT program, from disk to the service that reads their text."""

from __future__ import annotations

import os

from ..files.case_text import text_of
from ..values.contact_files import ContactFile
from .asked_client import AskedClient

__all__ = ["read"]


def read(path_or_text: str | os.PathLike[str], client: AskedClient) -> ContactFile:
    """The cases of an input file (.inp), or of its text: a string with an end of line in it is a text.

    The `client` reads the text, ``contactd.local()`` as well as one of a daemon, and opens no file. What is wrong with a
    case is in its `errors`, what stands between cases in those of the file.

    Raises OSError for a file that cannot be read or has more than 16 MiB.
    """
    if isinstance(path_or_text, str) and "\n" in path_or_text:
        file: ContactFile = client.read_contact_file(path_or_text)
    else:
        file = client.read_contact_file(text_of(path_or_text), name=os.path.basename(os.fspath(path_or_text)))
    return file
