"""Solutions with requested arrays, and the steps of a session."""

from __future__ import annotations

from collections.abc import Collection
from dataclasses import dataclass
from typing import Any, TypeVar

from ..errors import ProtocolError
from .answers import read
from .generated.grid import Grid
from .representation import with_inherited_attributes
from .solution import ALL_FIELDS, OPTIONAL_ARRAYS, ContactSolution, without_other_arrays

__all__ = ["SavedState", "StepSolution", "checked", "read_solution"]

S = TypeVar("S", bound=ContactSolution)


def checked(solution: S, names: Collection[str], grid: Grid) -> S:
    """Returns the solution with the arrays `names` and its grid, which answers omit because the caller has it. Raises
    ProtocolError if an array is missing or does not have the shape of the grid.
    """
    for name in names:
        array = getattr(solution, name, None)
        if array is None and name in OPTIONAL_ARRAYS:
            continue
        if array is None:
            raise ProtocolError(f"The answer lacks the requested {name}.")
        if array.shape != grid.shape:
            raise ProtocolError(f"The answer's {name} has shape {list(array.shape)} instead of {list(grid.shape)}.")
    object.__setattr__(solution, "grid", grid)
    return without_other_arrays(solution, names)


def read_solution(grid: Grid, names: list[str] | None, result: Any, path: str = "result") -> ContactSolution:
    """Reads the solution of a problem with the requested arrays `names`; None means all."""
    return checked(read(ContactSolution, result, path), ALL_FIELDS if names is None else names, grid)


@with_inherited_attributes
@dataclass(frozen=True, eq=False, repr=False, kw_only=True)
class StepSolution(ContactSolution):
    """The solution of a step, with the arrays named by `fields`. `converged` can be False only if the session accepts
    that.

    Attributes:
        step: Number of the step.
    """

    step: int

    def _title(self) -> str:
        return f"StepSolution {self.step}"


@dataclass(frozen=True)
class SavedState:
    """A state that save() returns and restore() accepts.

    Attributes:
        name: Its name in the daemon.
        step: Number of the last step when it was saved.
    """

    name: str
    step: int
