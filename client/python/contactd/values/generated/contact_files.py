"""Files of the CONTACT program: answers of `Client.read_contact_file` and `Client.read_contact_slices`.

Written by ./dev generate from proto/schema: edit it there.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

from ..contact_file_methods import ContactFileMethods

__all__ = ["ContactCase", "ContactFile", "ContactSlice", "ContactSlices"]


@dataclass(frozen=True)
class ContactCase:
    """A case of the CONTACT program: its digits, and all values in its memory.

    Attributes:
        number: Case number as CONTACT prints it. Each result element has its own numbering.
        line: Line of its first control word.
        module: 1: a wheel on its rail or roller; 3: basic contact.
        digits: Control digits by their names: C1 (module 1) P B T N F S V L D C M Z E M2 W2 X H G I A O W R.
        values: All values in memory by CONTACT's names, read in this case or kept: numbers, file names, lists of
            numbers. The digits determine whether a value has an effect. Angles in rad.
        read: Names of the values that this case reads, including friction and subsurface. All other values are kept.
        warnings: Warnings of probable mistakes.
        errors: Errors that prevent the case from being computed: an unexpected word, incompatible digits, data of a
            case with errors. Part of the case may have been read.
        reid: Result element of the case, if the file names one.
        cpid: Contact problem of the case, if the file names a result element for module 3.
        friction: Parameter sets of the friction law in force, with ALPHVF, SVF or IY where friction varies.
        subsurface: Blocks of subsurface points in force: ISUBS, and lists of IX, IY, Z or X, Y, Z.
    """

    number: int
    line: int
    module: int
    digits: Mapping[str, int]
    values: Mapping[str, Any]
    read: tuple[str, ...]
    warnings: tuple[str, ...]
    errors: tuple[str, ...]
    reid: int | None = None
    cpid: int | None = None
    friction: tuple[Mapping[str, float], ...] = ()
    subsurface: tuple[Mapping[str, Any], ...] = ()


@dataclass(frozen=True)
class ContactFile(ContactFileMethods[ContactCase]):
    """Cases of an input file of the CONTACT program in their order, and the errors in the file.

    Attributes:
        cases: The cases in the order of the file.
        warnings: Warnings about the file that concern no single case.
        errors: Errors: text between cases that does not belong there.
    """

    cases: tuple[ContactCase, ...]
    warnings: tuple[str, ...]
    errors: tuple[str, ...]


@dataclass(frozen=True)
class ContactSlice:
    """A slice, with the name of its profile.

    Attributes:
        u: Position of the slice along the track (mm) or around the wheel (rad), with the list's offset and scale.
        file: Name of the profile file as written, relative to the folder of the list.
        features: Lengths along the profile from its first point to the features (mm), as in rail_slices. Empty if the
            profile has one part.
    """

    u: float
    file: str
    features: tuple[float, ...]


@dataclass(frozen=True)
class ContactSlices:
    """A list of slices of the CONTACT program.

    Attributes:
        slices: Slices in rising order of u.
        is_approximated: True if the surface approximates the slices (U_INTPOL = 2), false if it interpolates them.
        kinks: Numbers of the parts that begin with a kink.
        accelerations: Numbers of the parts that begin with a jump of curvature.
    """

    slices: tuple[ContactSlice, ...]
    is_approximated: bool
    kinks: tuple[int, ...]
    accelerations: tuple[int, ...]
