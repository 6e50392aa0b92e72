"""Represents a case of an input file with its results."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from typing import Any

from ..values.generated.contact_files import CaseStatus, ComputedCase
from ..values.generated.wheel_rail.forces import WheelRailForces
from ..values.generated.wheel_rail.result import WheelRailSolution
from ..values.representation import Rows, Shown
from ..values.solution import ContactSolution, Forces
from .case import Case
from .case_results import Elements, is_right
from .comparison import Compared

__all__ = ["SolvedCase"]


@dataclass(frozen=True, eq=False, repr=False)
class SolvedCase(Shown):
    """A case of an input file with its results. Units are those of CONTACT: mm, N, rad, N/mm^2.

    Attributes:
        case: The case as read from the file.
        answer: Its outcome, with the numbers and arrays of each contact by CONTACT's names.
    """

    case: Case
    answer: ComputedCase

    @property
    def number(self) -> int:
        """Its number, as printed by CONTACT."""
        return self.case.number

    @property
    def status(self) -> CaseStatus:
        """The outcome. With results: ``solved`` or ``not converged``. Without: ``read``, ``refused``, ``failed``,
        ``follows`` (it continues a case that was not computed) or ``wrong``.
        """
        return self.answer.status

    @property
    def sentence(self) -> str:
        """The reason why there are no results, or their limitations; empty for a solved case."""
        return self.answer.sentence

    @property
    def warnings(self) -> tuple[str, ...]:
        """Warnings in the answers of this case."""
        return self.answer.warnings

    @property
    def solution(self) -> ContactSolution | WheelRailSolution | None:
        """The solution: of a contact for module 3, of a wheel on its rail for module 1; or None."""
        return self.answer.contact if self.answer.wheelrail is None else self.answer.wheelrail

    @property
    def forces(self) -> Forces | WheelRailForces | None:
        """The forces of the solution (N): on body 1, or on the rail."""
        return None if self.solution is None else self.solution.forces

    @property
    def patches(self) -> tuple[ContactSolution, ...]:
        """The contacts with their forces and their element arrays, shape [ny, nx]. Module 3 has one; module 1 has all
        patches in CONTACT's order, from the field side to the gauge side.
        """
        if self.answer.contact is not None:
            return (self.answer.contact,)
        return tuple(elements.on_rail.solution for elements in self.elements if elements.on_rail is not None)

    @property
    def elements(self) -> Iterator[Elements]:
        """The contacts as output files print them, in CONTACT's order."""
        wheel = self.answer.wheelrail
        on_rail: Sequence[Any] = [None] if wheel is None else wheel.patches if is_right(self.case) else wheel.patches[::-1]
        return (Elements(self.case, patch, one) for patch, one in zip(self.answer.patches, on_rail))

    @property
    def numbers(self) -> dict[str, float]:
        """The numbers of the whole case by CONTACT's labels, such as "FN" and "PMAX", or "FX(TR)"."""
        return dict(self.answer.numbers)

    @property
    def compared(self) -> Compared | None:
        """The numbers for a comparison with printed ones; None without results."""
        if self.solution is None:
            return None
        bounds = [patch.friction_bound for patch in self.answer.patches]
        patches = [dict(patch.numbers) for patch in self.answer.patches]
        is_basic = self.answer.contact is not None
        return Compared(self.numbers, sum(bounds), [] if is_basic else patches, [] if is_basic else bounds)

    def _title(self) -> str:
        return f"SolvedCase {self.number}"

    def _rows(self) -> Rows:
        rows: Rows = [("status", self.status), ("patches", len(self.patches))]
        rows += [(name, value) for name, value in self.numbers.items() if name.startswith(("FN", "FX", "FY", "FZ(TR)"))]
        return [*rows, *([("why", self.sentence)] if self.sentence else [])]

    def _remarks(self) -> Sequence[str]:
        return self.warnings
