"""What a daemon keeps, as plain, immutable values: tables in its store, and its last solves."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
import numpy.typing as npt

from .evidence import IcEvidence, IcUse
from .grid import Array, Grid
from .tables import IcSpec

__all__ = ["ImportedIc", "QuarantinedIc", "RecentPatch", "RecentSolve", "StoredIc"]


@dataclass(frozen=True)
class RecentSolve:
    """One of the last solves that the user who asks had the daemon do, by whatever connection.

    Attributes:
        number: What recent_pressures takes; counted by the daemon, of all users.
        method: By which it was asked for, e.g. "contact.solve".
        id: Of the request.
        at: When it ended (s since 1970).
        seconds: Time from the start of the solve to its answer (s).
        elements: Of its grid; of wheels on rails those of all patches.
        patches: How many grids there are: one, and of wheels on rails as many as there are places of contact.
        converged: Whether every solver reached its tolerance.
        iterations: Of the normal and the tangential solvers together.
        residual: The largest figure that one of them compared with its tolerance.
        forces: Fx, Fy, Fn on the upper body; of wheels on rails Fx, Fy, Fz on the rail or rails, in track coordinates (N).
        pmax: Largest pressure (N/mm^2).
        has_pressures: Whether recent_pressures has them.
        grid: That of the contact; None of wheels on rails.
    """

    number: int
    method: str
    id: str
    at: float
    seconds: float
    elements: int
    patches: int
    converged: bool
    iterations: int
    residual: float
    forces: tuple[float, ...]
    pmax: float
    has_pressures: bool
    grid: Grid | None = None


@dataclass(frozen=True)
class RecentPatch:
    """The pressures of one grid of a solve.

    Attributes:
        grid: Its elements; of a wheel on its rail in contact coordinates (mm).
        pressure: In single precision's digits (N/mm^2), shape [ny, nx].
        element_division: Shape [ny, nx]: 0 exterior, 1 adhesion, 2 slip.
    """

    grid: Grid
    pressure: Array
    element_division: npt.NDArray[np.uint8]


@dataclass(frozen=True)
class ImportedIc:
    """What import_ic has put into the daemon's store.

    Attributes:
        spec: What the file is a table of; of a prism dx and nx mean nothing, any are served.
        ics: The table that you are served now: its origin is "file", or "disk" where there was one already.
        new: Whether the table of the file was kept; one that you were served already stays.
    """

    spec: IcSpec
    ics: IcUse
    new: bool


@dataclass(frozen=True)
class StoredIc:
    """A table in the daemon's store.

    Attributes:
        key: What delete_ic takes.
        nx: Offsets along x.
        ny: Offsets along y.
        bytes: Size of its file.
        evidence: How it was made, where that was asked for and its file can be read; else None.
    """

    key: str
    nx: int
    ny: int
    bytes: int
    evidence: IcEvidence | None = None


@dataclass(frozen=True)
class QuarantinedIc:
    """A table whose builds failed too often; it and larger ones with its key are not tried again for now.

    Attributes:
        key: What delete_ic takes, which ends the quarantine.
        nx: Offsets along x.
        ny: Offsets along y.
        failures: How many builds failed.
        message: How the last build failed.
        seconds: Until it may be tried again.
    """

    key: str
    nx: int
    ny: int
    failures: int
    message: str
    seconds: float
