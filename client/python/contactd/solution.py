"""What is answered: tables, contact solutions and the evidence for both, as plain, immutable values.

Arrays are read-only; copy one to change it.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field

import numpy as np
import numpy.typing as npt

from .friction import Motion
from .problem import Array, FemIcs, Grid, Ics, Material

__all__ = [
    "Areas",
    "ComponentError",
    "ContactEvidence",
    "ContactSolution",
    "Counts",
    "Forces",
    "IcErrors",
    "IcEvidence",
    "IcSpec",
    "IcTable",
    "IcUse",
    "Job",
    "Limits",
    "LoadCase",
    "Progress",
    "QuarantinedIc",
    "ServerInfo",
    "SolverEvidence",
    "StoredIc",
]


@dataclass(frozen=True)
class Progress:
    """A sign of life of the job that a call waits for."""

    stage: str  #: what is being done, e.g. "assembly"
    fraction: float  #: 0 to 1, of the whole job
    job: str = ""  #: what cancel_job takes
    iteration: int = 0  #: within the stage
    residual: float = 0.0  #: the figure that the stage's stop test compares
    state: str = ""  #: of health.watch


@dataclass(frozen=True)
class LoadCase:
    """One solve of the finite-element problem."""

    load: str  #: direction of the load: "x", "y" or "z"
    iterations: int
    residual: float  #: true relative residual ||b - A u|| / ||b||
    converged: bool
    seconds: float
    update: float | None = None  #: relative update of the last iteration, where that is the stop test


@dataclass(frozen=True)
class ComponentError:
    """Relative error: signed at the origin (paper, (3.1)), and the largest size over the table."""

    origin: float
    largest: float


@dataclass(frozen=True)
class IcErrors:
    """Errors against the closed form, or estimated ones (IcEvidence.errors_estimated).

    xy and xz vanish on the axes, so theirs are scaled by 2 pi G rho / (dx dy).
    """

    xx: ComponentError
    yy: ComponentError
    zz: ComponentError
    scaled_xy: float
    scaled_xz: float


@dataclass(frozen=True)
class IcEvidence:
    """How a table was made. A closed-form one has no elements, no solves and no errors.

    Read `warnings` first. `errors` is None where nothing is known of them: of a block on a mesh that was named.
    """

    source: str
    version: str = ""
    elements: int = 0
    dofs: int = 0
    processes: int = 0
    seconds: Mapping[str, float] = field(default_factory=dict)  #: "assembly", "setup", "solve", "total"
    load_cases: tuple[LoadCase, ...] = ()
    errors: IcErrors | None = None
    errors_estimated: bool = False  #: of a block, by the difference to the next lower order
    warnings: tuple[str, ...] = ()  #: sentences, e.g. that the mesh is outside of the ranges the paper recommends
    solver: str | None = None  #: "amg_pcg" or "direct"
    mesh: FemIcs | None = None  #: what was chosen for an accuracy; not of a block
    family_nu: tuple[float, ...] = ()  #: of a family: Poisson's ratios of its tables
    interpolation_error: float | None = None  #: of a family: what interpolation between them adds at most, estimated


@dataclass(frozen=True)
class IcSpec:
    """A request for a table with its defaults filled in."""

    material: Material
    grid: Grid
    ics: Ics


_AXES = "xyz"


@dataclass(frozen=True, eq=False)
class IcTable:
    """Influence coefficients of one body.

    `array[i, j, l, k]` (mm^3/N) is the displacement along axis i at an element whose offset from the loaded element is
    (k dx, l dy), for a unit traction along axis j; axes are x, y, z, and z is the outward normal. Negative offsets
    follow from symmetry: xx, yy, zz are even in both, xy, yx odd in both, xz, zx odd in x, yz, zy odd in y.
    """

    key: str  #: equal for every shear modulus, element size and extent of the same dimensionless problem; "" of a file .h5
    origin: str  #: "closed_form", "memory", "disk" or "built"; "file" when load_table read it
    spec: IcSpec
    array: Array  #: shape [3, 3, ny, nx] (mm^3/N)
    evidence: IcEvidence

    def __getitem__(self, component: str) -> Array:
        """One component, shape [ny, nx]: ``table["xz"]`` is the displacement along x for a load along z."""
        if len(component) != 2 or not set(component) <= set(_AXES):
            raise KeyError(f"{component!r} is no component; one is two of the letters x, y and z.")
        part: Array = self.array[_AXES.index(component[0]), _AXES.index(component[1])]
        return part


@dataclass(frozen=True)
class SolverEvidence:
    """How one iterative solver ended; `residual` is the figure compared with its tolerance."""

    iterations: int
    residual: float
    converged: bool
    seconds: float


@dataclass(frozen=True)
class IcUse:
    """Where the influence coefficients of one body came from."""

    origin: str
    key: str
    evidence: IcEvidence


@dataclass(frozen=True)
class ContactEvidence:
    """How a contact problem was solved; `tangential` is None without friction, `outer` and `force` where they did not run.

    `ics` has "upper" and "lower" (not of a rigid body), or "pair" when the problem brought its coefficients along
    (TableIcs). It is empty for models other than "full".
    """

    normal: SolverEvidence
    ics: Mapping[str, IcUse]
    tangential: SolverEvidence | None = None
    #: the loop that bodies that differ and kinetic friction need; its residual is the last relative change of tractions
    outer: SolverEvidence | None = None
    #: the search for the motion of a prescribed force; its residual is the error of the force over the friction bound
    force: SolverEvidence | None = None


@dataclass(frozen=True)
class Areas:
    """Areas (mm^2): contact = adhesion + slip; without friction all contact counts as slip."""

    contact: float
    adhesion: float
    slip: float


@dataclass(frozen=True)
class Counts:
    """Numbers of elements: contact = adhesion + slip; without friction all contact counts as slip."""

    contact: int
    adhesion: int
    slip: int
    border: int  #: in contact at the border of the potential contact area, which should not be; see `warnings`


@dataclass(frozen=True)
class Forces:
    """Total force on the upper body (N), and its moment about z."""

    Fn: float
    Fx: float
    Fy: float
    Mz: float  #: at the origin: sum of x p_y - y p_x over the elements (N mm)


class WithForces:
    """What has forces, with short names for them."""

    forces: Forces

    @property
    def Fn(self) -> float:
        """Normal force (N), > 0 in compression."""
        return self.forces.Fn

    @property
    def Fx(self) -> float:
        """Tangential force along x on the upper body (N)."""
        return self.forces.Fx

    @property
    def Fy(self) -> float:
        """Tangential force along y on the upper body (N)."""
        return self.forces.Fy

    @property
    def Mz(self) -> float:
        """Moment of the tractions on the upper body about z at the origin (N mm)."""
        return self.forces.Mz


@dataclass(frozen=True, eq=False)
class ContactSolution(WithForces):
    """The solution of a ContactProblem. Arrays have shape [ny, nx]; tractions and forces act on the upper body.

    A solve that did not converge is a solution too: ask `converged`. Read `warnings`. A solution may be `previous` or
    `initial` of the next problem.
    """

    approach: float  #: delta (mm), prescribed or found
    forces: Forces
    pmax: float  #: largest pressure (N/mm^2)
    area: Areas
    elements: Counts
    element_division: npt.NDArray[np.uint8]  #: 0 exterior, 1 adhesion, 2 slip
    pressure: Array  #: N/mm^2, >= 0
    traction_x: Array  #: N/mm^2
    traction_y: Array  #: N/mm^2
    converged: bool
    evidence: ContactEvidence
    warnings: tuple[str, ...] = ()  #: sentences, e.g. that the contact touches the border of the potential contact area
    # The following are None without friction.
    #: slip of the upper body over the lower, zero outside contact: of a shift the distance over the step (mm), of rolling
    #: the relative slip, per distance rolled
    slip_x: Array | None = None
    slip_y: Array | None = None
    frictional_work: float | None = None  #: of a shift: what friction dissipates in the step (N mm)
    frictional_power: float | None = None  #: of rolling: what friction dissipates (N mm/s)
    motion: Motion | None = None  #: as asked for, with what a prescribed force made of it


@dataclass(frozen=True)
class Limits:
    """What one message may cost."""

    max_frame_bytes: int
    max_frames: int  #: the envelope included
    max_message_bytes: int
    max_array_elements: int
    max_queue: int


@dataclass(frozen=True)
class ServerInfo:
    """The daemon, its libraries, and what it has done since it started."""

    version: str
    commit: str  #: of the sources it was built from
    protocol: int
    libraries: Mapping[str, str]
    limits: Limits
    counters: Mapping[str, int]
    cache: Mapping[str, int]
    queue: Mapping[str, int]
    uptime_seconds: float


@dataclass(frozen=True)
class StoredIc:
    """A table in the daemon's store."""

    key: str  #: what delete_ic takes
    nx: int
    ny: int
    bytes: int


@dataclass(frozen=True)
class QuarantinedIc:
    """A table whose builds failed too often; it and larger ones with its key are not tried again for now."""

    key: str
    nx: int
    ny: int
    failures: int
    message: str  #: how the last build failed
    seconds: float  #: until it may be tried again


@dataclass(frozen=True)
class Job:
    """A build, a solve or stresses that wait or run."""

    job: str  #: what cancel_job takes
    kind: str  #: "build", "solve", "subsurface" or "step"
    state: str  #: "queued" or "running"
    stage: str
    fraction: float
    callers: int  #: how many calls wait for it
    seconds: float
