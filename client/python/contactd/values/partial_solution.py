"""Solutions with requested arrays, and the steps of a session."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from typing import Any, TypeVar, get_args

from ..errors import ProtocolError
from .answers import read
from .generated.grid import Grid
from .representation import with_inherited_attributes
from .solution import ContactSolution, Field, PartialSolution, Solution

__all__ = [
    "ALL_FIELDS",
    "PartialSolution",
    "SavedState",
    "StepSolution",
    "check_arrays",
    "on_grid",
    "read_solution",
]

S = TypeVar("S", bound=Solution[Any, Any])
#: Optional arrays: slip requires friction, displacements and temperatures must be requested, and the state of friction
#: requires a law with one.
_MAY_LACK = (
    "slip_x", "slip_y", "displacement_x", "displacement_y", "displacement_z", "flow_x", "flow_y", "yield_stress",
    "friction_coefficient", "upper_temperature", "lower_temperature",
)  # fmt: skip
ALL_FIELDS: tuple[str, ...] = get_args(Field)


def check_arrays(solution: Solution[Any, Any], names: Iterable[str], grid: Grid) -> None:
    """Raises ProtocolError if an array is missing or does not have the shape of the grid."""
    for name in names:
        array = getattr(solution, name)
        if array is None and name in _MAY_LACK:
            continue
        if array is None:
            raise ProtocolError(f"The answer lacks the requested {name}.")
        if array.shape != grid.shape:
            raise ProtocolError(f"The answer's {name} has shape {list(array.shape)} instead of {list(grid.shape)}.")


def on_grid(solution: S, grid: Grid) -> S:
    """Returns the solution with its grid, which answers omit because the caller has it."""
    object.__setattr__(solution, "grid", grid)
    return solution


def read_solution(
    grid: Grid, names: list[str] | None, result: Any, path: str = "result"
) -> ContactSolution | PartialSolution:
    """Reads the solution of a problem with the requested arrays `names`; None means all."""
    solution = read(ContactSolution, result, path) if names is None else read(PartialSolution, result, path)
    check_arrays(solution, ALL_FIELDS if names is None else names, grid)
    return on_grid(solution, grid)


@with_inherited_attributes
@dataclass(frozen=True, eq=False, repr=False, kw_only=True)
class StepSolution(PartialSolution):
    """The solution of a step. Arrays are None unless `fields` names them. `converged` can be False only if the session
    accepts that.

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
