"""What is answered: tables, contact solutions and the evidence for both, as plain, immutable values.

Arrays are read-only; copy one to change it.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any, Generic, TypeVar

import numpy as np
import numpy.typing as npt

from .friction import Motion
from .plain_values import HasDict
from .problem import Array, FemIcs, Grid, Ics, LayeredBody, Material
from .saving import Saved
from .showing import Rows, Shown, number, with_inherited_attributes

if TYPE_CHECKING:
    import xarray
    from matplotlib.axes import Axes

__all__ = [
    "Areas",
    "ComponentError",
    "ContactEvidence",
    "ContactSolution",
    "Counts",
    "Derivatives",
    "DerivativesOfAnswer",
    "Discretisation",
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
    "Solution",
    "SolverEvidence",
    "StoredIc",
]


@dataclass(frozen=True)
class Progress:
    """A sign of life of the job that a call waits for.

    Attributes:
        stage: What is being done, e.g. "assembly".
        fraction: 0 to 1, of the whole job.
        job: What cancel_job takes.
        iteration: Within the stage.
        residual: The figure that the stage's stop test compares.
        state: Of health.watch.
        seconds_left: Time to go for the whole job (s), an estimate; None where there is none.
    """

    stage: str
    fraction: float
    job: str = ""
    iteration: int = 0
    residual: float = 0.0
    state: str = ""
    seconds_left: float | None = None

    def __str__(self) -> str:
        if self.state:
            return f"the daemon is {self.state}"
        parts = [f"{self.stage} {100 * self.fraction:.0f} %"]
        if self.iteration:
            parts.append(f"iteration {self.iteration}, residual {self.residual:.1e}")
        if self.seconds_left is not None:
            parts.append(f"about {_duration(self.seconds_left)} to go")
        return ", ".join(parts)


def _duration(seconds: float) -> str:
    whole = round(seconds)
    if whole < 120:
        return f"{whole} s"
    return f"{whole // 60} min" if whole < 7200 else f"{whole / 3600:.1f} h"


@dataclass(frozen=True)
class LoadCase:
    """One solve of the finite-element problem.

    Attributes:
        load: Direction of the load: "x", "y" or "z".
        iterations: Of the linear solver.
        residual: True relative residual ||b - A u|| / ||b||.
        converged: Whether the stop test was met.
        seconds: Time spent (s).
        update: Relative update of the last iteration, where that is the stop test.
    """

    load: str
    iterations: int
    residual: float
    converged: bool
    seconds: float
    update: float | None = None


@dataclass(frozen=True)
class ComponentError:
    """Relative error: signed at the origin (paper, (3.1)), and the largest size over the table.

    Attributes:
        origin: Signed, at the origin.
        largest: Largest size over the table.
    """

    origin: float
    largest: float


@dataclass(frozen=True)
class IcErrors:
    """Errors against the closed form, or estimated ones (IcEvidence.errors_estimated).

    xy and xz vanish on the axes, so theirs are scaled by 2 pi G rho / (dx dy).

    Attributes:
        xx: Relative errors of xx.
        yy: Relative errors of yy.
        zz: Relative errors of zz.
        scaled_xy: Largest scaled error of xy over the table.
        scaled_xz: Largest scaled error of xz over the table.
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

    Attributes:
        source: "analytic" or "fem".
        version: Of the contactd that made it.
        elements: Of the mesh.
        dofs: Unknowns of the finite-element problem.
        processes: MPI processes that built it.
        seconds: Time spent (s) on "assembly", "setup", "solve" and "total".
        load_cases: The solves, by direction of the load.
        errors: Of its components, where known.
        errors_estimated: Of a block, by a third of the difference to the next lower order.
        warnings: Sentences, e.g. that the mesh is outside of the ranges the paper recommends.
        solver: "amg_pcg" or "direct".
        mesh: What was chosen for an accuracy; not of a block.
        family_nu: Of a family: Poisson's ratios of its tables.
        interpolation_error: Of a family: what interpolation between them adds at most, estimated.
    """

    source: str
    version: str = ""
    elements: int = 0
    dofs: int = 0
    processes: int = 0
    seconds: Mapping[str, float] = field(default_factory=dict)
    load_cases: tuple[LoadCase, ...] = ()
    errors: IcErrors | None = None
    errors_estimated: bool = False
    warnings: tuple[str, ...] = ()
    solver: str | None = None
    mesh: FemIcs | None = None
    family_nu: tuple[float, ...] = ()
    interpolation_error: float | None = None


@dataclass(frozen=True)
class IcSpec:
    """A request for a table with its defaults filled in.

    Attributes:
        material: The body.
        grid: Offsets and element size; where it lies does not matter.
        ics: Closed form or finite elements, with every option.
    """

    material: Material | LayeredBody
    grid: Grid
    ics: Ics

    @staticmethod
    def of_wire(spec: dict[str, Any]) -> dict[str, Any]:
        """With the layers, which stand in `ics` there, in place of the material."""
        ics = spec.get("ics")
        if not isinstance(ics, dict) or "layers" not in ics:
            return spec
        return {**spec, "material": {name: ics[name] for name in ("layers", "base") if name in ics}}


_AXES = "xyz"


@dataclass(frozen=True, eq=False, repr=False)
class IcTable(HasDict, Shown):
    """Influence coefficients of one body.

    `array[i, j, l, k]` (mm^3/N) is the displacement along axis i at an element whose offset from the loaded element is
    (k dx, l dy), for a unit traction along axis j; axes are x, y, z, and z is the outward normal. Negative offsets
    follow from symmetry: xx, yy, zz are even in both, xy, yx odd in both, xz, zx odd in x, yz, zy odd in y.

    Attributes:
        key: Equal for every shear modulus, element size and extent of the same dimensionless problem; "" of a file .h5.
        origin: "closed_form", "memory", "disk" or "built"; "file" when load_table read it.
        spec: What was asked for, defaults filled in.
        array: Shape [3, 3, ny, nx] (mm^3/N).
        evidence: How it was made, and how good it is.
    """

    key: str
    origin: str
    spec: IcSpec
    array: Array
    evidence: IcEvidence

    def _title(self) -> str:
        return f"IcTable of {self.spec.grid.nx} x {self.spec.grid.ny} offsets"

    def _rows(self) -> Rows:
        material, grid, ics = self.spec.material, self.spec.grid, self.spec.ics
        if isinstance(material, LayeredBody):
            rows: Rows = [("layers", len(material.layers))]
        else:
            rows = [("G", material.G), ("nu", material.nu)]
        rows += [("dx", grid.dx), ("dy", grid.dy)]
        rows.append(("source", _recipe(ics)))
        rows += [("origin", self.origin), ("zz at the origin", float(self["zz"][0, 0]))]
        if (errors := self.evidence.errors) is not None:
            name = "largest error of zz, estimated" if self.evidence.errors_estimated else "largest error of zz"
            rows.append((name, f"{errors.zz.largest:.2g}"))
        return rows

    def _remarks(self) -> tuple[str, ...]:
        return self.evidence.warnings

    def plot(self, components: Iterable[str] = ("xx", "yy", "zz", "xz"), axes: Axes | None = None) -> Axes:
        """Draws sizes of the components over the distance from the load, along x and along y, on a logarithmic scale.

        Into `axes`, or a figure of its own; returns the axes. Needs matplotlib ("contactd[pictures]").
        """
        from .pictures.tables import draw_table

        return draw_table(self, components, axes)

    def to_xarray(self) -> xarray.DataArray:
        """The table over displacement, load and offsets (mm), as ``table.to_xarray().sel(displacement="x", load="z")``.

        Needs xarray ("contactd[xarray]").
        """
        from .labelled import labelled_table

        return labelled_table(self)

    def __getitem__(self, component: str) -> Array:
        """One component, shape [ny, nx]: ``table["xz"]`` is the displacement along x for a load along z."""
        if len(component) != 2 or not set(component) <= set(_AXES):
            raise KeyError(f"{component!r} is no component; one is two of the letters x, y and z.")
        part: Array = self.array[_AXES.index(component[0]), _AXES.index(component[1])]
        return part


def _recipe(ics: Ics) -> str:
    """Finite elements by their most telling options."""
    if not isinstance(ics, FemIcs):
        return "closed form"
    names = ("preset", "accuracy", "body", "mesh", "order", "L_over_h")
    given = [f"{name} {number(value)}" for name in names if (value := getattr(ics, name)) is not None]
    return " ".join(["finite elements,", *given]) if given else "finite elements"


@dataclass(frozen=True)
class SolverEvidence:
    """How one iterative solver ended; `residual` is the figure compared with its tolerance.

    Attributes:
        iterations: How many there were.
        residual: The figure compared with the tolerance.
        converged: Whether it reached the tolerance.
        seconds: Time spent (s).
    """

    iterations: int
    residual: float
    converged: bool
    seconds: float


@dataclass(frozen=True)
class Discretisation:
    """How finely the elements divide the contact, and what that costs: sizes of relative errors against the limit of
    small elements.

    Attributes:
        elements_across: In the direction with fewer; one in which the contact fills the grid does not count.
        force_error: Of the normal force for the approach, whichever of them was prescribed.
        pmax_error: Of the largest pressure under the prescribed load.
        source: Of these two: "hertz", Hertz's closed form (a paraboloid on half-spaces), or "estimate", from
            elements_across.
        rolling_error: Of rolling, an estimate: of the tangential force under a small creepage, from elements_across and
            dq. Where most of the contact slips the force errs by less.
    """

    elements_across: int
    force_error: float
    pmax_error: float
    source: str
    rolling_error: float | None = None


@dataclass(frozen=True)
class IcUse:
    """Where the influence coefficients of one body came from.

    Attributes:
        origin: "closed_form", "memory", "disk", "built", or "given" where the problem brought them along.
        key: That of the table, as IcTable.key.
        evidence: How the table was made.
    """

    origin: str
    key: str
    evidence: IcEvidence


@dataclass(frozen=True)
class ContactEvidence:
    """How a contact problem was solved; `tangential` is None without friction, `outer` and `force` where they did not run.

    `ics` has "upper" and "lower" (not of a rigid body), or "pair" when the problem brought its coefficients along
    (TableIcs). It is empty for models other than "full", and of a step, whose coefficients are those of its session
    (Session.ics).

    Attributes:
        normal: NORM, which finds the pressures.
        ics: Where the coefficients came from, by "upper", "lower" or "pair".
        tangential: Newton's method on the friction law, and TangCG where that stopped, which find the tractions.
        outer: The loop that bodies that differ and kinetic friction need; its residual is what further turns
            would change of the tractions, relative; of kinetic friction the last change.
        force: How the motion of a prescribed force was found: iterations of Newton's method on motion and tractions, and
            solves of a search where that failed; its residual is the error of the force over the friction bound.
        discretisation: What the size of the elements costs; of model "full", where there is contact.
        derivatives: The linear equations of the derivatives, where these were asked for and there is contact: iterations
            of all together, the largest residual.
    """

    normal: SolverEvidence
    ics: Mapping[str, IcUse] = field(default_factory=dict)
    tangential: SolverEvidence | None = None
    outer: SolverEvidence | None = None
    force: SolverEvidence | None = None
    discretisation: Discretisation | None = None
    derivatives: SolverEvidence | None = None


@dataclass(frozen=True)
class DerivativesOfAnswer:
    """Of one answer, by each input: units are those of the answer over those of the input. None is what the problem does
    not have, or its model does not know.

    Attributes:
        xi: Of rolling: by the longitudinal creepage.
        eta: Of rolling: by the lateral creepage.
        phi: Of rolling: by the spin creepage.
        rigid_shift: Of a shift: by that along x, and along y.
        rotation: Of a shift: by its rotation.
        approach: By the approach, where that is prescribed.
        Fn: By the normal force, where that is prescribed.
        mu: By the coefficient of friction: the same change in every element.
    """

    xi: float | None = None
    eta: float | None = None
    phi: float | None = None
    rigid_shift: tuple[float, float] | None = None
    rotation: float | None = None
    approach: float | None = None
    Fn: float | None = None
    mu: float | None = None


@dataclass(frozen=True)
class Derivatives:
    """How the answers follow the inputs, to first order: ``solution.derivatives.Fx.xi`` is dFx/d(xi).

    Held are the undeformed distance (also where semi-axes and the load made it), the tractions before the step,
    rigid_slip, and the division of the elements, at whose next change the derivatives are one-sided. Motion is an input
    also where forces found it: as if it had been given.

    Attributes:
        Fx: Of Fx (N), with friction.
        Fy: Of Fy (N), with friction.
        Mz: Of Mz (N mm), with friction.
        Fn: Of the normal force (N), where the approach is prescribed.
        approach: Of the approach (mm), where the normal force is prescribed.
    """

    Fx: DerivativesOfAnswer | None = None
    Fy: DerivativesOfAnswer | None = None
    Mz: DerivativesOfAnswer | None = None
    Fn: DerivativesOfAnswer | None = None
    approach: DerivativesOfAnswer | None = None


@dataclass(frozen=True)
class Areas:
    """Areas (mm^2): contact = adhesion + slip; without friction all contact counts as slip.

    Attributes:
        contact: Of all elements in contact (mm^2).
        adhesion: Of those in adhesion (mm^2).
        slip: Of those in slip (mm^2).
    """

    contact: float
    adhesion: float
    slip: float


@dataclass(frozen=True)
class Counts:
    """Numbers of elements: contact = adhesion + slip; without friction all contact counts as slip.

    Attributes:
        contact: Of elements in contact.
        adhesion: Of elements in adhesion.
        slip: Of elements in slip.
        border: Of elements in contact at the border of the potential contact area, which should not be; see `warnings`.
    """

    contact: int
    adhesion: int
    slip: int
    border: int


@dataclass(frozen=True)
class Forces:
    """Total force on the upper body (N), and its moment about z.

    Attributes:
        Fn: Normal force (N), > 0 in compression.
        Fx: Tangential force along x (N).
        Fy: Tangential force along y (N).
        Mz: At the origin: sum of x p_y - y p_x over the elements (N mm).
    """

    Fn: float
    Fx: float
    Fy: float
    Mz: float


# What the arrays of a solution are: of a step each may be left out.
Floats = TypeVar("Floats", bound="Array | None")
Bytes = TypeVar("Bytes", bound="npt.NDArray[np.uint8] | None")


@dataclass(frozen=True, eq=False, repr=False, kw_only=True)
class Solution(Saved, Shown, Generic[Floats, Bytes]):
    """What is answered of one contact. Arrays have shape [ny, nx]; tractions and forces act on the upper body.

    Attributes:
        approach: delta (mm), prescribed or found.
        forces: Total force on the upper body; also as Fn, Fx, Fy (N) and Mz (N mm) of the solution.
        pmax: Largest pressure (N/mm^2).
        area: Areas (mm^2) of contact, adhesion and slip.
        elements: Numbers of elements in contact, adhesion and slip.
        element_division: Shape [ny, nx]: 0 exterior, 1 adhesion, 2 slip.
        pressure: Shape [ny, nx] (N/mm^2), >= 0.
        traction_x: Along x on the upper body, shape [ny, nx] (N/mm^2).
        traction_y: Along y on the upper body, shape [ny, nx] (N/mm^2).
        converged: Whether every solver reached its tolerance.
        evidence: How the solvers ended, and where the coefficients came from.
        warnings: Sentences, e.g. that the contact touches the border of the potential contact area, or that elements or
            dq are too large for it.
        slip_x: Along x, slip of the upper body over the lower, zero outside contact: of a shift the distance over the
            step (mm), of rolling the relative slip, per distance rolled. None without friction, like all that follow.
        slip_y: The same along y.
        frictional_work: Of a shift: what friction dissipates in the step (N mm).
        frictional_power: Of rolling: what friction dissipates (N mm/s).
        motion: As asked for, with what a prescribed force made of it.
        derivatives: How forces follow the inputs, where the problem asked for that, and the solution has converged and has
            contact.
        grid: That of the problem, which the client adds.
    """

    approach: float
    forces: Forces
    pmax: float
    area: Areas
    elements: Counts
    element_division: Bytes
    pressure: Floats
    traction_x: Floats
    traction_y: Floats
    converged: bool
    evidence: ContactEvidence
    warnings: tuple[str, ...] = ()
    slip_x: Array | None = None
    slip_y: Array | None = None
    frictional_work: float | None = None
    frictional_power: float | None = None
    motion: Motion | None = None
    derivatives: Derivatives | None = None
    grid: Grid | None = None

    def plot(self, axes: Axes | None = None) -> Axes:
        """Draws pressures over the grid, the edges of contact and adhesion, and arrows of the tractions on the upper body.

        Into `axes`, or a figure of its own; returns the axes. Needs matplotlib ("contactd[pictures]").
        """
        from .pictures.contact import draw_contact

        return draw_contact(self, axes)

    def plot_section(self, y: float = 0.0, axes: Axes | None = None) -> Axes:
        """Draws pressure and tractions along x, in the row of elements nearest to `y` (mm); else as `plot`."""
        from .pictures.contact import draw_section

        return draw_section(self, y, axes)

    def to_xarray(self) -> xarray.Dataset:
        """Arrays over x and y, forces, pmax and the approach, with their units. Needs xarray ("contactd[xarray]")."""
        from .labelled import labelled_solution

        return labelled_solution(self)

    def _rows(self) -> Rows:
        division = f"{self.elements.contact} elements: {self.elements.adhesion} in adhesion, {self.elements.slip} in slip"
        forces: Rows = [(name, getattr(self, name)) for name in ("Fn", "Fx", "Fy", "Mz")]
        rows: Rows = [*forces, ("pmax", self.pmax), ("approach", self.approach), ("contact", division)]
        if self.motion is not None:
            rows.append(("motion", self.motion))
        return [*rows, ("converged", "yes" if self.converged else "NO")]

    def _remarks(self) -> tuple[str, ...]:
        return self.warnings

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


@with_inherited_attributes
@dataclass(frozen=True, eq=False, repr=False, kw_only=True)
class ContactSolution(Solution[Array, npt.NDArray[np.uint8]]):
    """The solution of a ContactProblem. Arrays have shape [ny, nx]; tractions and forces act on the upper body.

    A solve that did not converge is a solution too: ask `converged`. Read `warnings`. A solution may be `previous` or
    `initial` of the next problem.
    """

    def _title(self) -> str:
        ny, nx = self.pressure.shape
        return f"ContactSolution on {nx} x {ny} elements"


@dataclass(frozen=True)
class Limits:
    """What one message may cost.

    Attributes:
        max_frame_bytes: Bytes of one frame.
        max_frames: The envelope included.
        max_message_bytes: Bytes of one message.
        max_array_elements: Numbers of one array.
        max_grid_elements: Elements of one grid, offsets of one table.
        max_queue: Requests that may wait for an answer.
        max_queue_per_client: Of these, requests that came through one socket.
        max_queue_bytes: Bytes of the messages whose requests wait for an answer.
        max_sessions: Sessions that may be open.
        max_session_bytes: Bytes of all sessions and their saved states together.
        max_session_states: Saved states of one session.
        max_lease_seconds: Longest lease of a session (s).
    """

    max_frame_bytes: int
    max_frames: int
    max_message_bytes: int
    max_array_elements: int
    max_grid_elements: int
    max_queue: int
    max_queue_per_client: int
    max_queue_bytes: int
    max_sessions: int
    max_session_bytes: int
    max_session_states: int
    max_lease_seconds: float


@dataclass(frozen=True)
class ServerInfo:
    """The daemon, its libraries, and what it has done since it started.

    Attributes:
        version: Version of contactd.
        commit: Of the sources it was built from.
        protocol: Version of the protocol that it answers in.
        libraries: Their versions, by name.
        limits: What one message may cost, and how much may wait.
        counters: What was done since it started, by name (docs/protocol.md).
        cache: Tables in memory, and their bytes.
        queue: What waits and runs.
        uptime_seconds: Since it started (s).
        protocol_versions: Versions that it understands.
    """

    version: str
    commit: str
    protocol: int
    libraries: Mapping[str, str]
    limits: Limits
    counters: Mapping[str, int]
    cache: Mapping[str, int]
    queue: Mapping[str, int]
    uptime_seconds: float
    protocol_versions: tuple[int, ...] = ()


@dataclass(frozen=True)
class StoredIc:
    """A table in the daemon's store.

    Attributes:
        key: What delete_ic takes.
        nx: Offsets along x.
        ny: Offsets along y.
        bytes: Size of its file.
    """

    key: str
    nx: int
    ny: int
    bytes: int


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


@dataclass(frozen=True)
class Job:
    """A build, a solve or stresses that wait or run.

    Attributes:
        job: What cancel_job takes.
        kind: "build", "solve", "subsurface" or "step".
        state: "queued" or "running".
        stage: What is being done; empty while queued.
        fraction: 0 to 1, of the whole job, an estimate.
        callers: How many calls wait for it.
        seconds: Since it was queued (s).
        seconds_left: Time to go as last reported (s), of builds; None where there is no estimate.
    """

    job: str
    kind: str
    state: str
    stage: str
    fraction: float
    callers: int
    seconds: float
    seconds_left: float | None = None
