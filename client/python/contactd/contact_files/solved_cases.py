"""The cases of a file after a run: forces, patches and arrays of each, and a comparison with printed results."""

from __future__ import annotations

import os
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from typing import Any, overload

from ..errors import invalid
from ..files.case_text import text_of
from ..refusals import public
from ..values.generated.wheel_rail.forces import WheelRailForces
from ..values.generated.wheel_rail.result import WheelRailSolution
from ..values.representation import Rows, Shown
from ..values.solution import ContactSolution, Forces, Solution
from .case import Case
from .comparison import case_differences, matched
from .out_reader import printed_cases

__all__ = ["CaseComparison", "ComparedCase", "SolvedCase", "SolvedCases"]


@dataclass(frozen=True, eq=False, repr=False)
class SolvedCase(Shown):
    """A case of an input file with its results. Units are those of CONTACT: mm, N, rad, N/mm^2.

    Attributes:
        outcome: The outcome of the runner: the case, its problem and its answers.
    """

    outcome: Any

    @property
    def case(self) -> Case:
        """The case as read from the file."""
        case: Case = self.outcome.case
        return case

    @property
    def number(self) -> int:
        """Its number, as printed by CONTACT."""
        return self.case.number

    @property
    def status(self) -> str:
        """The outcome. With results: ``solved`` or ``not converged``. Without: ``read``, ``refused``, ``failed``,
        ``follows`` (it continues a case that was not computed) or ``wrong``.
        """
        return str(self.outcome.status)

    @property
    def sentence(self) -> str:
        """The reason why there are no results, or their limitations; empty for a solved case."""
        return str(self.outcome.sentence)

    @property
    def warnings(self) -> tuple[str, ...]:
        """Warnings in the answers of this case."""
        return tuple(self.outcome.warnings)

    @property
    def solution(self) -> ContactSolution | WheelRailSolution | None:
        """The solution: of a contact for module 3, of a wheel on its rail for module 1; or None."""
        result = self.outcome.result
        solution: ContactSolution | WheelRailSolution | None = None if result is None else result.solution
        return solution

    @property
    def forces(self) -> Forces | WheelRailForces | None:
        """The forces of the solution (N): on body 1, or on the rail."""
        return None if self.solution is None else self.solution.forces

    @property
    def patches(self) -> tuple[Solution[Any, Any], ...]:
        """The contacts with their forces and their element arrays, shape [ny, nx]. Module 3 has one; module 1 has all
        patches in CONTACT's order, from the field side to the gauge side.
        """
        result = self.outcome.result
        if result is None:
            return ()
        return (result.solution,) if self.case.module == 3 else tuple(one.solution for one in result.patches)

    @property
    def numbers(self) -> dict[str, float]:
        """The numbers of the whole case by CONTACT's labels, such as "FN" and "PMAX", or "FX(TR)"."""
        return {} if self.outcome.result is None else dict(self.outcome.result.compared.numbers)

    def _title(self) -> str:
        return f"SolvedCase {self.number}"

    def _rows(self) -> Rows:
        rows: Rows = [("status", self.status), ("patches", len(self.patches))]
        rows += [(name, value) for name, value in self.numbers.items() if name.startswith(("FN", "FX", "FY", "FZ(TR)"))]
        return [*rows, *([("why", self.sentence)] if self.sentence else [])]

    def _remarks(self) -> Sequence[str]:
        return self.warnings


@dataclass(frozen=True, eq=False)
class ComparedCase:
    """A case and the printed one.

    Attributes:
        case: The case.
        is_printed: Whether the printed file contains the case.
        differences: A sentence for each number that exceeds its tolerance.
    """

    case: SolvedCase
    is_printed: bool
    differences: tuple[str, ...]

    @property
    def agrees(self) -> bool:
        """True if both sides have numbers that agree within the tolerances."""
        return self.is_printed and self.case.solution is not None and not self.differences

    def __str__(self) -> str:
        if not self.is_printed:
            return f"case {self.case.number}: not printed in this file"
        if self.case.solution is None:
            return f"case {self.case.number}: {self.case.status}. {self.case.sentence}"
        return f"case {self.case.number}: {'; '.join(self.differences) or 'agrees'}"


@dataclass(frozen=True, eq=False)
class CaseComparison(Sequence[ComparedCase]):
    """All cases and the printed ones, in the order of the input file. As text, it has a line for each difference.

    Attributes:
        cases: The cases.
    """

    cases: tuple[ComparedCase, ...]

    @overload
    def __getitem__(self, index: int) -> ComparedCase: ...
    @overload
    def __getitem__(self, index: slice) -> tuple[ComparedCase, ...]: ...
    def __getitem__(self, index: Any) -> Any:
        return self.cases[index]

    def __len__(self) -> int:
        return len(self.cases)

    @property
    def agrees(self) -> bool:
        """True if every case agrees."""
        return all(one.agrees for one in self.cases)

    def __str__(self) -> str:
        agreeing = sum(one.agrees for one in self.cases)
        lines = [str(one) for one in self.cases if not one.agrees]
        return "\n".join([f"{agreeing} of {len(self.cases)} cases agree", *lines])


@dataclass(frozen=True, eq=False, repr=False)
class SolvedCases(Sequence[SolvedCase], Shown):
    """The cases of a file after a run, in the order of the file.

    Attributes:
        cases: The cases.
        errors: Sentences about invalid text between cases.
    """

    cases: tuple[SolvedCase, ...]
    errors: tuple[str, ...] = ()

    @overload
    def __getitem__(self, index: int) -> SolvedCase: ...
    @overload
    def __getitem__(self, index: slice) -> tuple[SolvedCase, ...]: ...
    def __getitem__(self, index: Any) -> Any:
        return self.cases[index]

    def __len__(self) -> int:
        return len(self.cases)

    def __iter__(self) -> Iterator[SolvedCase]:
        return iter(self.cases)

    @public
    def compare(self, path: str | os.PathLike[str]) -> CaseComparison:
        """Compares the numbers of all cases with those that CONTACT printed in a file (.out).

        docs/contact-files.md lists the tolerances. Raises OSError for a file that cannot be read, and InvalidArgument
        for one without printed cases.
        """
        printed = printed_cases(text_of(path))
        if not printed:
            raise invalid(os.fspath(path), "has no printed case; give an .out file of CONTACT")
        theirs = matched(((one.case.number, one.case.reid, one.case.cpid) for one in self.cases), printed)
        compared = []
        for case, other in zip(self.cases, theirs):
            result = case.outcome.result
            apart = () if other is None or result is None else tuple(case_differences(result.compared, other))
            compared.append(ComparedCase(case, other is not None, apart))
        return CaseComparison(tuple(compared))

    def _title(self) -> str:
        return f"SolvedCases of {len(self.cases)} cases"

    def _rows(self) -> Rows:
        statuses = [case.status for case in self.cases]
        return [(status, statuses.count(status)) for status in dict.fromkeys(statuses)]

    def _remarks(self) -> Sequence[str]:
        return self.errors
