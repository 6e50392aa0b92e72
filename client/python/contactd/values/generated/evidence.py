"""Models and settings of solvers for contact problems, and evidence of the accuracy of solutions and of tables of
influence coefficients.

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
    "ForceAccuracy",
    "GridForces",
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
    """Reduction of the initial slope by contaminated surfaces (Spiryagin, Polach and Cole 2013), for fastsim and
    fastrip: flexibilities are divided by k = k0 (alpha + (1 - alpha)/(1 + beta eps)), where eps = G pi a b k0 C11 w/(4
    mu Fn) and w is the size of the creepage including spin. If None, k = 1, Kalker's slope.

    Attributes:
        k0: Share of Kalker's slope for small creepages, usually up to 1. Default 1.
        alpha: Fraction of k0 that remains for large creepages, usually at most 1. Default 1.
        beta: Rate at which k falls from k0 to alpha k0. Default 0.
    """

    k0: float | None = None
    alpha: float | None = None
    beta: float | None = None


@dataclass(frozen=True)
class SimplifiedSettings:
    """Options of the simplified models of rolling. A model refuses an option that it does not use unless the option has
    its default.

    Attributes:
        slope: Reduction of the initial slope by contaminated surfaces (Spiryagin, Polach and Cole 2013), for fastsim
            and fastrip: flexibilities are divided by k = k0 (alpha + (1 - alpha)/(1 + beta eps)), where eps = G pi a b
            k0 C11 w/(4 mu Fn) and w is the size of the creepage including spin. If None, k = 1, Kalker's slope.
        bound: Bound of tractions in an ellipse, for fastsim. parabolic: the usual bound, a third higher in the middle.
            elliptic: mu times Hertz's pressure. Default "parabolic".
        on_elements: True if fastsim uses whole steps of the grid's elements, with spin evaluated
            friction.rolling.spin_offset steps ahead, and sums over elements as forces. Otherwise the ellipse has its
            own slices, which converge to the limit of small elements. Kinetic friction, a slope, an elliptic bound,
            blended flexibilities and pressures of a normal_model require elements and select them automatically.
            Default False.
        blended: Blends the three flexibilities of fastsim and fastrip as slip increases: where the creepage is three
            times that of full slip, they equal their mean weighted by the shares of creepages and spin. Default False.
        coefficients: Kalker's creepage coefficients, for fastsim on elements, fastrip and polach. computed: to 1e-3.
            printed: interpolated in the three-digit table of his book, 1 % off, which other programs read. Default
            "computed".
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
    """Stopping criterion and iteration limit of an iterative solver.

    Attributes:
        tolerance: Bound of the paper's stopping criterion (sections 4.1 and 4.2). Default 1e-06.
        max_iterations: Bound of the iterations. Default 1000.
    """

    tolerance: float | None = None
    max_iterations: int | None = None


@dataclass(frozen=True)
class TangentialSettings(SolverSettings):
    """Stopping criterion for the tractions under friction, and the solver that computes them.

    Attributes:
        tolerance: Bound of the paper's stopping criterion (sections 4.1 and 4.2). Default 1e-06.
        max_iterations: Bound of the iterations. Default 1000.
        solver: newton: Newton's method on the friction law, with TangCG as a fallback. tangcg: TangCG alone,
            bound-constrained conjugate gradients, for shifts and transient rolling. Default "newton".
    """

    tolerance: float | None = None
    max_iterations: int | None = None
    solver: TangentialSolver | None = None


@dataclass(frozen=True)
class SolverEvidence:
    """Convergence of a solver.

    Attributes:
        iterations: Number of iterations.
        residual: Value that the stopping criterion compares with the tolerance.
        converged: True if the tolerance was reached.
        seconds: Duration (s).
    """

    iterations: int
    residual: float
    converged: bool
    seconds: float


@dataclass(frozen=True)
class LoadCase:
    """A solve of the finite-element problem.

    Attributes:
        load: Axis of the load. One of "x", "y", "z".
        iterations: Conjugate-gradient iterations.
        residual: True relative residual.
        converged: True if the stopping criterion reached the tolerance.
        seconds: Duration of the solve (s).
        update: Relative update in the last iteration, if that is the stopping criterion.
    """

    load: str
    iterations: int
    residual: float
    converged: bool
    seconds: float
    update: float | None = None


@dataclass(frozen=True)
class ComponentError:
    """Relative error of a component.

    Attributes:
        origin: Signed error at the origin, the paper's measure (3.1).
        largest: Largest absolute error over the table.
    """

    origin: float
    largest: float


@dataclass(frozen=True)
class IcErrors:
    """Errors against the closed form, or estimated errors. xy and xz vanish on the axes, so their errors are scaled by
    2 pi G rho / (dx dy).

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
    """Finite-element computation of the transform of the coefficients of a longitudinally uniform body. Errors are
    relative to zz of the half-space under an element as long as a column is wide.

    Attributes:
        order: Polynomial order of the elements.
        wavenumbers: Number of wavenumbers at which the transform was computed.
        error: Error of any coefficient: the sum of the three below.
        mesh_error: Error of the mesh, from elements of the next order.
        wavenumber_error: Error of the interpolation between wavenumbers, estimated with every second one.
        end_error: Error due to wavenumbers beyond the last one.
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
    """Origin and errors of a table, and details of its build. A closed form, and a table in the request, have no build.

    Attributes:
        source: Closed form, finite elements, or a table that came with the request. One of "analytic", "fem", "table".
        version: Versions of contactd and of the libraries that made the table.
        elements: Number of finite elements.
        dofs: Number of degrees of freedom.
        processes: Number of processes of the build.
        seconds: Duration of the stages (s).
        load_cases: The solves, one per load; for a family those of all its tables.
        errors: Errors against the closed form if one exists; otherwise estimates, if an accuracy was requested.
        errors_estimated: True if errors are estimates because no closed form exists. For a block, they are half of the
            difference to a coarser mesh. For layers, they are three times the differences to a second computation;
            those of xx, yy and zz are relative to the larger of zz at the origin and 1e-3 times thickness over G of the
            first layer.
        warnings: Warnings about the table: for example, the mesh is outside the ranges recommended in the paper.
        solver: Solver of the linear systems. One of "amg_pcg", "direct", "tensor_pcg".
        mesh: The mesh chosen for a requested accuracy of the half-space, as fields of ics that select it.
        family_nu: Poisson's ratios of the tables of a family.
        interpolation_error: Estimate of the largest error added by interpolation between the tables of a family,
            measured like accuracy.
        section: Finite-element computation of the transform of the coefficients of a longitudinally uniform body.
            Errors are relative to zz of the half-space under an element as long as a column is wide.
        modelling_error: Modelling error of a block: the largest difference between its table, for a load in the middle,
            and a load in the corner of as many elements about the middle as the table has offsets. It is measured like
            accuracy and includes a margin of one tenth for loads between corner and middle.
        imported: True if the table was imported. All other values are then those of the importer.
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
    """The coefficients that a solve used for a body.

    Attributes:
        origin: Origin of a table. given: in the request; file: in the request that imports it. One of "closed_form",
            "memory", "disk", "built", "given", "file".
        key: Digest that identifies the table in the store.
        evidence: Evidence of the table.
    """

    origin: str
    key: str
    evidence: IcEvidence


@dataclass(frozen=True)
class Discretisation:
    """Resolution of the contact by the elements, and estimates of the relative errors of this grid against the limit of
    small elements. Only for model full with contact.

    Attributes:
        elements_across: Elements across the contact, in the direction with fewer. A direction in which the contact
            fills the grid is not counted.
        force_error: Error of the normal force for the given approach, whichever was prescribed.
        pmax_error: Error of the largest pressure under the prescribed load.
        source: Source of these two errors. hertz: Hertz's closed form (a paraboloid on half-spaces). estimate: from
            elements_across.
        rolling_error: Estimated error of the tangential force in rolling under a small creepage, from elements_across
            and dq. The error is smaller if most of the contact slips.
        compliance_ratio: For bodies with layers, the compliance that elements of this size represent, under pressures
            as wide as the contact, divided by the true compliance of the layers; 1 for fine elements. Both errors above
            include it.
    """

    elements_across: int
    force_error: float
    pmax_error: float
    source: ErrorSource
    rolling_error: float | None = None
    compliance_ratio: float | None = None


@dataclass(frozen=True)
class OperatorUse:
    """Operators larger than store.influence_budget_bytes, of which only the most recently used are kept. None for
    smaller ones.

    Attributes:
        made: True if the operators were made for this solve, which also causes a warning; false if they were kept from
            an earlier one.
        bytes: Approximate memory of the operators.
        budget_bytes: store.influence_budget_bytes.
    """

    made: bool
    bytes: int
    budget_bytes: int


@dataclass(frozen=True)
class GridForces:
    """Forces on the coarser of the last two grids around the contact ellipse.

    Attributes:
        nx: Number of elements along x.
        ny: Number of elements along y.
        Fx: Force on the upper body along x (N).
        Fy: Force on the upper body along y (N).
        Mz: Moment on the upper body about z (N mm).
    """

    nx: int
    ny: int
    Fx: float
    Fy: float
    Mz: float


@dataclass(frozen=True)
class ForceAccuracy:
    """Extrapolation of the tangential forces to elements of zero size, and its stated error. Only if accuracy was
    requested, and with contact and friction.

    Attributes:
        coarse: Forces on the coarser of the last two grids around the contact ellipse.
        fine: Forces on the finer one. The forces of the answer are twice these minus the coarse ones.
        force_error: Stated error of Fx and Fy over mu Fn.
        moment_error: Stated error of Mz over mu Fn sqrt(a b).
        converged: True if the stated errors are at most the requested accuracy, and the solvers converged on both
            grids. Otherwise the answer contains a warning.
    """

    coarse: GridForces
    fine: GridForces
    force_error: float
    moment_error: float
    converged: bool


@dataclass(frozen=True)
class ContactEvidence:
    """Convergence of the solvers, and the coefficients that they used. Solvers that did not run are None.

    Attributes:
        normal: NORM, which finds the pressures.
        ics: Coefficients of the bodies, upper and lower, or of the pair if the request contained a table of the pair.
            None for a rigid body and for models other than full. Steps use those of their session.
        tangential: The tractions; with friction only.
        outer: Outer (Panagiotopoulos) iterations between normal and tangential contact of dissimilar bodies, and
            between slip and kinetic friction, if needed. The residual is the relative change of the tractions expected
            from further iterations; with kinetic friction it is the last change.
        force: Search for the motion that produces a prescribed tangential force. The iterations are those of Newton's
            method on motion and tractions, plus the solves of a search if that failed. The residual is the last error
            of the force over the friction bound.
        discretisation: Resolution of the contact by the elements, and estimates of the relative errors of this grid
            against the limit of small elements. Only for model full with contact.
        derivatives: Linear equations of the derivatives, if these were requested and there is contact: the total number
            of iterations, and the largest relative residual. Simplified models have no such equations.
        operators: Operators larger than store.influence_budget_bytes, of which only the most recently used are kept.
            None for smaller ones.
        accuracy: Extrapolation of the tangential forces to elements of zero size, and its stated error. Only if
            accuracy was requested, and with contact and friction.
        tangential_solver: Solver that found the tractions: the solver named by settings.tangential, or TangCG if
            Newton's method stopped. Only for model full with friction.
    """

    normal: SolverEvidence
    ics: Mapping[str, IcUse] = field(default_factory=dict)
    tangential: SolverEvidence | None = None
    outer: SolverEvidence | None = None
    force: SolverEvidence | None = None
    discretisation: Discretisation | None = None
    derivatives: SolverEvidence | None = None
    operators: OperatorUse | None = None
    accuracy: ForceAccuracy | None = None
    tangential_solver: TangentialSolver | None = None
