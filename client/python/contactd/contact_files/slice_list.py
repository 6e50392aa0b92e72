"""Reads lists of slices of the CONTACT program with their profiles."""

from __future__ import annotations

import os
from collections.abc import Callable
from pathlib import Path
from typing import TYPE_CHECKING

from ..files.case_text import text_of
from ..values.generated.contact_files import ContactSlices
from ..values.generated.profile_shapes import Profile, ProfileFile

if TYPE_CHECKING:
    from .asked_client import AskedClient

__all__ = ["SPLINES", "placed_slices", "read_slices"]

#: Interpolation between slices (rail_spline, wheel_spline), by whether the list requests an approximation.
SPLINES = {False: "cubic", True: "approximating"}
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
    return placed_slices(client.read_contact_slices(text_of(path), name=path.name), path.parent, profile)


def placed_slices(
    read: ContactSlices, folder: Path, profile: Callable[[Path], Profile]
) -> list[tuple[float, Profile, tuple[float, ...]]]:
    """Returns the slices of a parsed list, whose profiles are in `folder`."""
    return [(one.u, profile(folder / one.file.replace("\\", "/")), one.features or _WHOLE) for one in read.slices]
