"""Reads lists of slices of the CONTACT program with their profiles."""

from __future__ import annotations

import os
from collections.abc import Callable
from pathlib import Path

from ..files.case_text import text_of
from ..values.generated.profile_shapes import Profile, ProfileFile
from .asked_client import AskedClient

__all__ = ["read_slices"]

#: A feature at the end of every profile: lists without features have one part.
_WHOLE = (0.0, 1e5)


def read_slices(
    path: str | os.PathLike[str],
    client: AskedClient,
    *,
    profile: Callable[[Path], Profile] = ProfileFile,
) -> list[tuple[float, Profile, tuple[float, ...]]]:
    """Reads the `rail_slices` of a list of rails (.slcs): position, profile and features of each::

        setup = WheelRailSetup(rail_slices=read_slices("nose.slcs", client), rail_spline="cubic", ...)

    The `client` parses the list. `profile` reads profiles from their paths, which are relative to the folder of the
    list: ``profile=lambda path: ProfileFile(path, unit=1000)`` for files in metres. For a list of wheels (.slcw), the
    first two parts of each slice are the `wheel_slices`.

    Raises OSError for a file that cannot be read, and InvalidArgument with line and column of an error.
    """
    path = Path(path)
    slices = client.read_contact_slices(text_of(path), name=path.name).slices
    return [(one.u, profile(path.parent / one.file.replace("\\", "/")), one.features or _WHOLE) for one in slices]
