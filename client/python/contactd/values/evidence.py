"""How a contact problem is solved, and what that is worth: models, settings of the solvers, and evidence of theirs and
of tables of influence coefficients.

Written by ./dev generate from proto/schema: edit it there.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Literal

from .fem_ics import FemIcs

__all__ = [
    "ComponentError",
    "ContactEvidence",
    "CreepageCoefficients",
    "Discretisation",
    "ErrorSource",
    "IcErrors",
    "IcEvidence",
    "IcUse",
    "LoadCase",
    "Model",
    "NormalModel",
    "OperatorUse",
    "SectionEvidence",
    "SimplifiedSettings",
    "SlopeReduction",
    "SolverEvidence",
    "SolverSettings",
    "TangentialSettings",
    "TangentialSolver",
    "TractionBound",
]

Model = Literal["full", "hertz", "fastsim", "fastrip", "polach"]
NormalModel = Literal["of_model", "kp", "kpec", "analyn", "elliptic", "parabolic"]
TractionBound = Literal["parabolic", "elliptic"]
CreepageCoefficients = Literal["computed", "printed"]
TangentialSolver = Literal["newton", "tangcg"]
ErrorSource = Literal["hertz", "estimate"]


@dataclass(frozen=True)
class SlopeReduction:
    """Reduction of the initial slope, of contaminated surfaces (Spiryagin, Polach and Cole 2013), of fastsim and
    fastrip: flexibilities over k = k0 (alpha + (1 - alpha)/(1 + beta eps)), where eps = G pi a b k0 C11 w/(4 mu Fn) and
    w is the size of the creepage with the spin's share.

    Attributes:
        k0: Share of Kalker's slope for small creepages, usually up to 1. Default 1.
        alpha: What is left of k0 for large creepages, usually up to 1. Default 1.
        beta: How fast k falls from k0 to alpha k0. Default 0.
    """

    k0: float | None = None
    alpha: float | None = None
    beta: float | None = None


@dataclass(frozen=True)
class SimplifiedSettings:
    """Options of the simplified models of rolling. Each model takes those that it names, and refuses others that are
    not left at their default.

    Attributes:
        slope: Reduction of the initial slope, of contaminated surfaces (Spiryagin, Polach and Cole 2013), of fastsim
            and fastrip: flexibilities over k = k0 (alpha + (1 - alpha)/(1 + beta eps)), where eps = G pi a b k0 C11
            w/(4 mu Fn) and w is the size of the creepage with the spin's share. None: k = 1, Kalker's slope.
        bound: Bound of tractions in an ellipse, of fastsim: parabolic, a third higher in the middle, as is usual;
            elliptic, mu times Hertz's pressure. Default "parabolic".
        on_elements: fastsim in whole steps of the grid's elements, with spin taken friction.rolling.spin_offset steps
            ahead, and forces that are sums over them. Otherwise the ellipse has slices of its own, which come to the
            limit of small elements. Kinetic friction, a slope, an elliptic bound, blended flexibilities and pressures
            of a normal_model need elements and take them by themselves. Default False.
        blended: The three flexibilities of fastsim and fastrip become one as slip grows: where the creepage is three
            times that of full slip, the mean of the three by the shares of creepages and spin. Default False.
        coefficients: Kalker's creepage coefficients, of fastsim on elements, fastrip and polach: computed, to 1e-3; or
            printed, the table of three digits of his book, between its lines, 1 % off, which other programs read.
            Default "computed".
        k_adhesion: Polach's reduction of the slope in the area of adhesion. Default 1.
        k_slip: Polach's reduction of the slope in the area of slip, at most k_adhesion. Default 1.
    """

    slope: SlopeReduction | None = None
    bound: TractionBound | None = None
    on_elements: bool | None = None
    blended: bool | None = None
    coefficients: CreepageCoefficients | None = None
    k_adhesion: float | None = None
    k_slip: float | None = None


@dataclass(frozen=True)
class SolverSettings:
    """Stopping criterion and bound of one iterative solver.

    Attributes:
        tolerance: Bound of the paper's stopping criterion (sections 4.1 and 4.2). Default 1e-06.
        max_iterations: Bound of the iterations. Default 1000.
    """

    tolerance: float | None = None
    max_iterations: int | None = None


@dataclass(frozen=True)
class TangentialSettings(SolverSettings):
    """Stopping criterion for the tractions under friction, and the solver that finds them.

    Attributes:
        tolerance: Bound of the paper's stopping criterion (sections 4.1 and 4.2). Default 1e-06.
        max_iterations: Bound of the iterations. Default 1000.
        solver: newton: Newton's method on the friction law, and where that does not get there, TangCG. tangcg: TangCG
            alone, bound-constrained conjugate gradients, of shifts and transient rolling. Default "newton".
    """

    tolerance: float | None = None
    max_iterations: int | None = None
    solver: TangentialSolver | None = None


@dataclass(frozen=True)
class SolverEvidence:
    """How a solver ended.

    Attributes:
        iterations: Number of iterations.
        residual: The figure that the stopping criterion compares with the tolerance.
        converged: Whether the tolerance was reached.
        seconds: Duration (s).
    """

    iterations: int
    residual: float
    converged: bool
    seconds: float


@dataclass(frozen=True)
class LoadCase:
    """One solve of the finite-element problem.

    Attributes:
        load: Axis of the load. One of "x", "y", "z".
        iterations: Conjugate-gradient iterations.
        residual: True relative residual.
        converged: Whether the stopping criterion reached the tolerance.
        seconds: Duration of the solve (s).
        update: Relative update of the last iteration, where that is the stopping criterion.
    """

    load: str
    iterations: int
    residual: float
    converged: bool
    seconds: float
    update: float | None = None


@dataclass(frozen=True)
class ComponentError:
    """Relative error of one component.

    Attributes:
        origin: Signed error at the origin, the paper's measure (3.1).
        largest: Largest absolute error over the table.
    """

    origin: float
    largest: float


@dataclass(frozen=True)
class IcErrors:
    """Errors against the closed form, or estimated ones. xy and xz vanish on the axes, so theirs are scaled by 2 pi G
    rho / (dx dy).

    Attributes:
        xx: Relative errors of xx.
        yy: Relative errors of yy.
        zz: Relative errors of zz.
        scaled_xy: Largest error of xy times 2 pi G rho / (dx dy).
        scaled_xz: Largest error of xz times 2 pi G rho / (dx dy).
    """

    xx: ComponentError
    yy: ComponentError
    zz: ComponentError
    scaled_xy: float
    scaled_xz: float


@dataclass(frozen=True)
class SectionEvidence:
    """How the transform of the coefficients of a longitudinally uniform body was computed by finite elements. Errors
    are over zz of the half-space under an element as long as a column is wide.

    Attributes:
        order: Polynomial order of the elements.
        wavenumbers: Number of wavenumbers that it was computed at.
        error: Error of any coefficient: the sum of the three below.
        mesh_error: Error of the mesh, from elements of the next order.
        wavenumber_error: Error of interpolation between wavenumbers, from every other one.
        end_error: Error of what lies beyond the last wavenumber.
        reciprocity_defect: Reciprocity defect of the coefficients before they were made symmetric.
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
    """How the numbers of a table were made, and how good they are. A closed form, and a table that came with the
    request, have no build.

    Attributes:
        source: Closed form, finite elements, or a table that came with the request. One of "analytic", "fem", "table".
        version: contactd and the libraries that made the table.
        elements: Number of finite elements.
        dofs: Number of degrees of freedom.
        processes: Number of processes of the build.
        seconds: Duration of the stages (s).
        load_cases: The solves, one per load; of a family those of all its tables.
        errors: Errors against the closed form where there is one, else estimated where an accuracy was asked for.
        errors_estimated: True when errors are an estimate, there being no closed form: for a block half of the
            difference to a coarser mesh; for layers three times the differences to a second computation, those of xx,
            yy and zz relative to the larger of zz at the origin and 1e-3 times thickness over G of the first layer.
        warnings: Sentences that a user of the table should know; for example that the mesh is outside of the ranges
            that the paper recommends.
        solver: Solver of the linear systems. One of "amg_pcg", "direct", "tensor_pcg".
        mesh: The mesh that was chosen, when an accuracy of the half-space was asked for: fields of ics that ask for it
            by name.
        family_nu: Poisson's ratios of the tables of a family.
        interpolation_error: Largest error that interpolation between the tables of a family adds, estimated; in the
            measures of accuracy.
        section: How the transform of the coefficients of a longitudinally uniform body was computed by finite elements.
            Errors are over zz of the half-space under an element as long as a column is wide.
        modelling_error: Largest difference of a block's table, which is that of a load in the middle, to a load in the
            corner of as many elements as the table has offsets, about the middle, in the measures of accuracy, and a
            tenth more for loads between corner and middle.
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


@dataclass(frozen=True)
class IcUse:
    """The coefficients that a solve used for one body.

    Attributes:
        origin: Where a table came from; given is: with the request, file: with the request that imports it. One of
            "closed_form", "memory", "disk", "built", "given", "file".
        key: Digest that identifies the table in the store.
        evidence: How the table was made.
    """

    origin: str
    key: str
    evidence: IcEvidence


@dataclass(frozen=True)
class Discretisation:
    """How finely the elements divide the contact, and what that costs: sizes of relative errors against the limit of
    small elements. It is there for model full, where there is contact.

    Attributes:
        elements_across: Elements across the contact, in the direction with fewer; one in which the contact fills the
            grid does not count.
        force_error: Error of the normal force for the approach, whichever of them was prescribed.
        pmax_error: Error of the largest pressure under the prescribed load.
        source: Source of these two errors: hertz: Hertz's closed form (a paraboloid on half-spaces); estimate: from
            elements_across.
        rolling_error: Estimated error of the tangential force in rolling under a small creepage, from elements_across
            and dq. Where most of the contact slips the force errs by less.
        compliance_ratio: Where a body has layers: how compliant elements of this size make them to pressures as wide as
            the contact, over how compliant they are; 1 where elements are fine. Both errors above have it in them.
    """

    elements_across: int
    force_error: float
    pmax_error: float
    source: ErrorSource
    rolling_error: float | None = None
    compliance_ratio: float | None = None


@dataclass(frozen=True)
class OperatorUse:
    """Operators that are larger than store.influence_budget_bytes, of which only those used last are kept.

    Attributes:
        made: Whether they were made for this solve, or kept from one before; made, there is a warning.
        bytes: About what they take in memory.
        budget_bytes: store.influence_budget_bytes.
    """

    made: bool
    bytes: int
    budget_bytes: int


@dataclass(frozen=True)
class ContactEvidence:
    """How the solvers ended, and which coefficients they used; what did not run is None.

    Attributes:
        normal: NORM, which finds the pressures.
        ics: The coefficients of the bodies, upper and lower, or of the pair where the request brought them. A rigid
            body has none, models other than full use none, and steps have those of their session.
        tangential: The tractions; with friction only.
        outer: Outer (Panagiotopoulos) iterations between normal and tangential contact of dissimilar bodies, and
            between slip and kinetic friction, where they ran; residual is the relative change of the tractions that
            further iterations would make, with kinetic friction the last change.
        force: How the motion that a prescribed tangential force needs was found, where there is one: iterations are
            those of Newton's method on motion and tractions, and the solves of a search where that failed; residual is
            the last error of the force over the friction bound.
        discretisation: How finely the elements divide the contact, and what that costs: sizes of relative errors
            against the limit of small elements. It is there for model full, where there is contact.
        derivatives: The linear equations of the derivatives, where these were asked for and there is contact:
            iterations of all together, the largest relative residual. Simplified models have none to solve.
        operators: Operators that are larger than store.influence_budget_bytes, of which only those used last are kept.
            None of others.
        tangential_solver: Solver that found the tractions: the one that settings.tangential asked for, or TangCG where
            Newton's method stopped. It is there for model full with friction only.
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
