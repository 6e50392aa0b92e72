"""The last solves of a daemon, as plain, immutable values."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
import numpy.typing as npt

from .grid import Array, Grid

__all__ = ["RecentPatch", "RecentSolve"]


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
