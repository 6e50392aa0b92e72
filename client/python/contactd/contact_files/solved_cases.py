"""Holds the cases of a file after a run: forces, patches and arrays of each, and a comparison with printed results."""

from __future__ import annotations

import os
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from typing import Any, overload

from ..errors import invalid
from ..files.case_text import text_of
from ..refusals import public
from ..values.representation import Rows, Shown
from .comparison import case_differences, matched
from .out_reader import printed_cases
from .solved_case import SolvedCase

__all__ = ["CaseComparison", "ComparedCase", "SolvedCase", "SolvedCases"]


@dataclass(frozen=True, eq=False)
class ComparedCase:
    """Holds a case and the printed one.

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
    """Compares all cases and the printed ones, in the order of the input file. As text, it has a line for each
    difference.

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
            found = case.compared
            apart = () if other is None or found is None else tuple(case_differences(found, other))
            compared.append(ComparedCase(case, other is not None, apart))
        return CaseComparison(tuple(compared))

    def _title(self) -> str:
        return f"SolvedCases of {len(self.cases)} cases"

    def _rows(self) -> Rows:
        statuses = [case.status for case in self.cases]
        return [(status, statuses.count(status)) for status in dict.fromkeys(statuses)]

    def _remarks(self) -> Sequence[str]:
        return self.errors
