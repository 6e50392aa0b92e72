"""Records that a daemon keeps: tables in its store, and its last solves.

Written by ./dev generate from proto/schema: edit it there.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
import numpy.typing as npt

from ..arrays import Array
from ..tables import IcSpec
from .evidence import IcEvidence, IcUse
from .grid import Grid

__all__ = ["ImportedIc", "QuarantinedIc", "RecentPatch", "RecentSolve", "StoredIc"]


@dataclass(frozen=True)
class RecentSolve:
    """One of the last solves of the requesting user, on any connection.

    Attributes:
        number: Number of the solve among those of all users since the daemon started. It identifies the solve in
            solves.pressures.
        method: Requested method.
        id: Id of the request.
        at: Time at which the solve ended (s since 1970).
        seconds: Time from its start in a worker to its end (s).
        elements: Elements of the grid; for wheels on rails those of all patches.
        patches: Number of grids: one, or for wheels on rails the number of contact patches.
        converged: True if every solver reached its tolerance.
        iterations: Iterations of the normal and the tangential solvers together.
        residual: Largest of the values that the solvers compared with their tolerances.
        forces: Fx, Fy, Fn on the upper body; for wheels on rails Fx, Fy, Fz on the rail or both rails, in track
            coordinates (N).
        pmax: Largest pressure (N/mm^2).
        has_pressures: True if solves.pressures can return the pressures.
        grid: Grid of a contact. None for wheels on rails.
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
    """The pressures on a grid of a solve.

    Attributes:
        grid: Elements of the grid; for wheels on rails in contact coordinates (mm).
        pressure: Pressures (N/mm^2), shape [ny, nx].
        element_division: Shape [ny, nx], bytes: 0 exterior, 1 adhesion, 2 slip.
    """

    grid: Grid
    pressure: Array
    element_division: npt.NDArray[np.uint8]


@dataclass(frozen=True)
class ImportedIc:
    """Table that ic.import has added to the daemon's store.

    Attributes:
        spec: Specification of the table. For a longitudinally uniform body dx and nx are ignored: it serves any values.
        ics: The table that is served to this user now. Its origin is file, or disk if a table already existed.
        new: True if the table was stored. A table that already serves this user is kept.
    """

    spec: IcSpec
    ics: IcUse
    new: bool


@dataclass(frozen=True)
class StoredIc:
    """A table in the daemon's store.

    Attributes:
        key: Digest that identifies the table in the store.
        nx: Offsets along x.
        ny: Offsets along y.
        bytes: Size of the file.
        evidence: Evidence of the table, if requested and if its file can be read.
    """

    key: str
    nx: int
    ny: int
    bytes: int
    evidence: IcEvidence | None = None


@dataclass(frozen=True)
class QuarantinedIc:
    """A table whose builds failed too often. It and larger ones with its key are not built again for now.

    Attributes:
        key: Digest that identifies the table in the store.
        nx: Offsets along x.
        ny: Offsets along y.
        failures: Number of failed builds.
        message: Message of the last failure.
        seconds: Time until the next build is allowed (s).
    """

    key: str
    nx: int
    ny: int
    failures: int
    message: str
    seconds: float
