"""How a contact problem is solved, and what that is worth: models, settings of the solvers, and evidence of theirs and of
tables of influence coefficients."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Literal

from .ics import FemIcs

__all__ = [
    "ComponentError",
    "ContactEvidence",
    "Discretisation",
    "IcErrors",
    "IcEvidence",
    "IcUse",
    "LoadCase",
    "Model",
    "OperatorUse",
    "SectionEvidence",
    "SolverEvidence",
    "SolverSettings",
    "TangentialSettings",
]

Model = Literal["full", "hertz", "fastsim"]
TangentialSolver = Literal["newton", "tangcg"]


@dataclass(frozen=True)
class SolverSettings:
    """Stop test and bound of one iterative solver (paper, sections 4.1 and 4.2).

    Attributes:
        tolerance: Bound of the figure that the stop test compares; None: 1e-6, of `normal` 1e-8.
        max_iterations: Bound of the iterations; None: 1000, of `outer` 100.
    """

    tolerance: float | None = None
    max_iterations: int | None = None


@dataclass(frozen=True)
class TangentialSettings(SolverSettings):
    """Settings of the solver that finds tractions under friction, and which it is.

    Attributes:
        solver: "newton" (default): Newton's method on the friction law, and where that does not get there, TangCG;
            "tangcg": TangCG alone, of shifts and transient rolling.
    """

    solver: TangentialSolver | None = None


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
        compliance_ratio: Where a body has layers: how compliant elements of this size make them to pressures as wide as
            the contact, over how compliant they are; 1 where elements are fine. Both errors above have it in them.
    """

    elements_across: int
    force_error: float
    pmax_error: float
    source: str
    rolling_error: float | None = None
    compliance_ratio: float | None = None


@dataclass(frozen=True)
class OperatorUse:
    """Operators that are larger than store.influence_budget_bytes, of which only those used last are kept.

    Attributes:
        made: Whether they were made for this solve, or kept from one before.
        bytes: About what they take in memory.
        budget_bytes: store.influence_budget_bytes of the daemon.
    """

    made: bool
    bytes: int
    budget_bytes: int


@dataclass(frozen=True)
class IcUse:
    """Where the influence coefficients of one body came from.

    Attributes:
        origin: "closed_form", "memory", "disk", "built", "given" where the problem brought them along, or "file" where
            import_ic did.
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
        tangential: The solver that finds the tractions.
        tangential_solver: Which solver found them, "newton" or "tangcg": the one that `tangential` of the problem asks for,
            or TangCG where Newton's method stopped.
        outer: The loop that bodies that differ and kinetic friction need; its residual is what further turns
            would change of the tractions, relative; of kinetic friction the last change.
        force: How the motion of a prescribed force was found: iterations of Newton's method on motion and tractions, and
            solves of a search where that failed; its residual is the error of the force over the friction bound.
        discretisation: What the size of the elements costs; of model "full", where there is contact.
        derivatives: The linear equations of the derivatives, where these were asked for and there is contact: iterations
            of all together, the largest residual.
        operators: Of operators beyond the daemon's budget; None of others.
    """

    normal: SolverEvidence
    ics: Mapping[str, IcUse] = field(default_factory=dict)
    tangential: SolverEvidence | None = None
    outer: SolverEvidence | None = None
    force: SolverEvidence | None = None
    discretisation: Discretisation | None = None
    derivatives: SolverEvidence | None = None
    operators: OperatorUse | None = None
    tangential_solver: TangentialSolver | None = None


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
class SectionEvidence:
    """How the transform of a prism's coefficients was computed.

    Errors are over zz of the half-space under an element as long as a column is wide.

    Attributes:
        order: Of the elements.
        wavenumbers: How many it was computed at.
        error: Of any coefficient: the sum of the three below.
        mesh_error: Of the mesh, from elements of the next order.
        wavenumber_error: Of interpolation between wavenumbers.
        end_error: Of what lies beyond the last wavenumber.
        reciprocity_defect: Of coefficients before they were made symmetric.
    """

    order: int
    wavenumbers: int
    error: float
    mesh_error: float
    wavenumber_error: float
    end_error: float
    reciprocity_defect: float


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
        errors_estimated: Of a block, by half of the difference to a coarser mesh.
        warnings: Sentences, e.g. that the mesh is outside of the ranges the paper recommends.
        solver: "amg_pcg", "direct" or, of a block of an accuracy, "tensor_pcg".
        mesh: What was chosen for an accuracy; not of a block.
        family_nu: Of a family: Poisson's ratios of its tables.
        interpolation_error: Of a family: what interpolation between them adds at most, estimated.
        section: Of a prism by finite elements.
        modelling_error: Of a block: how far a load in the corner of the elements is from the table, which is that of one
            in the middle; in the measures of `FemIcs.accuracy`.
        imported: Somebody has imported the table: all of this is the importer's word.
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
    section: SectionEvidence | None = None
    modelling_error: float | None = None
    imported: bool = False
