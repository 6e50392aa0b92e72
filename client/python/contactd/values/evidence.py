"""How a contact problem was solved, and what that is worth."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field

from .tables import IcEvidence, IcSpec

__all__ = ["ContactEvidence", "Discretisation", "IcUse", "ImportedIc", "OperatorUse", "SolverEvidence"]


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
