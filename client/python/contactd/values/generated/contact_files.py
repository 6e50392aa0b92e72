"""Files of the CONTACT program: answers of `Client.read_contact_file`, `Client.run_contact_file`,
`Client.convert_contact_file` and `Client.read_contact_slices`.

Written by ./dev generate from proto/schema: edit it there.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any, Literal

from ..arrays import Array
from ..contact_file_methods import ContactFileMethods
from ..solution import ContactSolution
from .grid import Grid
from .wheel_rail.result import WheelRailSolution

__all__ = [
    "CaseStatus",
    "ComputedCase",
    "ComputedCases",
    "ComputedPatch",
    "ContactCase",
    "ContactFile",
    "ContactSlice",
    "ContactSlices",
    "ConvertedCase",
    "ConvertedCases",
]

CaseStatus = Literal["solved", "not converged", "read", "refused", "failed", "follows", "wrong"]


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


@dataclass(frozen=True, eq=False)
class ComputedPatch:
    """A contact. Forces act on body 1.

    Attributes:
        grid: Its elements.
        numbers: Numbers by CONTACT's names, those of its .out files. SPINXO and SPINYO are the centre of spin. On rails
            YCP(R), ZCP(R), XCP(W), YCP(W) and ZCP(W) are the reference in the axes of the profiles.
        mu: Coefficients of friction at rest: one, or one for each row of a curved contact. Those of rows that have
            their own (V = 3) are 1.
        friction_bound: Coefficient at rest times the normal force (N).
        arrays: Arrays of shape [ny, nx] by CONTACT's names: IGS (0 exterior, 1 adhesion, 2 slip, 3 plastic), H, MU, PN,
            PX, PY, UX, UY, UN, SX, SY, rigid slip WX, WY; TAUCRT, UPLSX, UPLSY of a layer that yields; TEMP1, TEMP2
            with heat.
        blocks: Blocks of subsurface points, z >= 0 in body 1.
        previous: Numbers, from 1, of the patches of the last step that share rows of elements with this one. None if
            the step does not continue another one.
    """

    grid: Grid
    numbers: Mapping[str, float]
    mu: tuple[float, ...]
    friction_bound: float
    arrays: Mapping[str, Array] | None = None
    blocks: tuple[Mapping[str, Array], ...] = ()
    previous: tuple[int, ...] | None = None


@dataclass(frozen=True, eq=False)
class ComputedCase:
    """A case with its forces, patches and arrays. Units are CONTACT's: mm, N, rad, N/mm^2, J and W.

    Attributes:
        number: Case number as CONTACT prints it.
        line: Line of its first control word.
        module: 1: a wheel on its rail or roller; 3: basic contact.
        status: The outcome. With results: solved, or not converged. Without: read (not to be computed, R = 2, 3),
            refused (it requires something that contactd does not support, or numbers that it does not accept), failed
            (the solve ended with an error), follows (it continues a case that was not computed), wrong (the case, or a
            file that it names, has an error).
        sentence: The reason if there are no results, or their limitation; empty for a solved case.
        warnings: Warnings of the solution.
        seconds: Time of the solve (s).
        numbers: Numbers of the whole case by CONTACT's names: of module 3 those of its contact, of module 1 FX(TR),
            FY(TR), FZ(TR), FX(WS), FY(WS), FZ(WS), and Z_WS and VPITCH_WS if they were searched for.
        patches: The contacts: one of module 3; of module 1 from the field side to the gauge side.
        reid: Result element of the case, if the file names one.
        cpid: Contact problem of the case, if the file names a result element for module 3.
        contact: The solution of module 3, as in contact.solve.
        wheelrail: The solution of module 1, as in wheelrail.solve.
    """

    number: int
    line: int
    module: int
    status: CaseStatus
    sentence: str
    warnings: tuple[str, ...]
    seconds: float
    numbers: Mapping[str, float]
    patches: tuple[ComputedPatch, ...]
    reid: int | None = None
    cpid: int | None = None
    contact: ContactSolution | None = None
    wheelrail: WheelRailSolution | None = None


@dataclass(frozen=True, eq=False)
class ComputedCases:
    """Outcomes of the cases of an input file of the CONTACT program.

    Attributes:
        cases: The cases that are complete, in the order of the file.
        warnings: Sentences on the file that are about no case, after its last case.
        errors: Errors in the text between cases, after its last case.
        run: Name of the run, if cases are left.
    """

    cases: tuple[ComputedCase, ...]
    warnings: tuple[str, ...]
    errors: tuple[str, ...]
    run: str | None = None


@dataclass(frozen=True, eq=False)
class ConvertedCase:
    """A case. Without parameters, the sentence contains the reason.

    Attributes:
        number: Case number as CONTACT prints it.
        line: Line of its first control word.
        module: 1: a wheel on its rail or roller; 3: basic contact.
        status: read for a case that can be solved; otherwise refused, failed or wrong as in contact_file.run.
        sentence: The reason if there are no parameters.
        continues: Whether the case starts from the end of an earlier one, which the parameters lack.
        reid: Result element of the case, if the file names one.
        cpid: Contact problem of the case, if the file names a result element for module 3.
        contact: Parameters of contact.solve, for module 3.
        wheelrail: Parameters of wheelrail.solve, for module 1.
    """

    number: int
    line: int
    module: int
    status: CaseStatus
    sentence: str
    continues: bool
    reid: int | None = None
    cpid: int | None = None
    contact: Mapping[str, Any] | None = None
    wheelrail: Mapping[str, Any] | None = None


@dataclass(frozen=True, eq=False)
class ConvertedCases:
    """Cases of an input file of the CONTACT program as parameters of contact.solve and wheelrail.solve.

    Attributes:
        cases: The requested cases in the order of the file.
    """

    cases: tuple[ConvertedCase, ...]


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
