"""Solutions of contacts as immutable values.

Arrays are read-only; copy one to change it.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from dataclasses import fields as dataclass_fields
from typing import Any, TypeVar, get_args

from .generated.result import Areas, Counts, Derivatives, DerivativesOfAnswer, Field, Forces, Resultant, Solution
from .representation import with_inherited_attributes

__all__ = [
    "ALL_FIELDS",
    "OPTIONAL_ARRAYS",
    "Areas",
    "ContactSolution",
    "Counts",
    "Derivatives",
    "DerivativesOfAnswer",
    "Field",
    "Fields",
    "Forces",
    "Resultant",
    "Solution",
    "names_of",
    "without_other_arrays",
]

ALL_FIELDS: tuple[str, ...] = get_args(Field)
#: Arrays that a solution may lack: slip requires friction, displacements, temperatures and derivatives must be requested,
#: and the state of friction requires a law with one.
OPTIONAL_ARRAYS = frozenset(one.name for one in dataclass_fields(Solution) if one.name in ALL_FIELDS and one.default is None)
S = TypeVar("S", bound="ContactSolution")


@with_inherited_attributes
@dataclass(frozen=True, eq=False, repr=False, kw_only=True)
class ContactSolution(Solution):
    """The solution of a ContactProblem. Arrays have shape [ny, nx]; tractions and forces act on the upper body.

    Check `converged`: a solve that did not converge also returns a solution. Read `warnings`. A solution may be
    `previous` or `initial` of the next problem.

    With `fields`, a solution has the arrays named there. Access to another array raises AttributeError, and
    ``hasattr(solution, "pressure")`` tests for one. A requested array is None if the problem has none, such as the slip
    without friction.
    """

    _arrays = frozenset(ALL_FIELDS)  # These may be absent.

    def _title(self) -> str:
        pressure = getattr(self, "pressure", None)
        shape = self.grid.shape if self.grid is not None else None if pressure is None else pressure.shape
        name = type(self).__name__
        return name if shape is None else f"{name} on {shape[1]} x {shape[0]} elements"

    @classmethod
    def _of_parts(cls: type[S], **parts: Any) -> S:
        """Returns a saved solution. If arrays that every problem has are absent, so are others without a value."""
        absent = [name for name in ALL_FIELDS if name not in OPTIONAL_ARRAYS and parts.get(name) is None]
        made = cls(**{**parts, **dict.fromkeys(absent)})
        return without_other_arrays(made, ()) if absent else made


class _AbsentArray:
    """Raises the error of an absent array. Arrays that a solution has take precedence."""

    def __init__(self, name: str) -> None:
        self._name = name

    def __get__(self, solution: object, kind: type | None = None) -> Any:
        if solution is None:
            return self
        raise AttributeError(f"This solution has no {self._name}: include it in `fields` when you request the solution.")


for _name in ALL_FIELDS:
    setattr(ContactSolution, _name, _AbsentArray(_name))


def without_other_arrays(solution: S, names: Iterable[str]) -> S:
    """Removes the arrays that were not requested, so that access to them raises AttributeError."""
    held = vars(solution)
    for name in ContactSolution._arrays.difference(names):
        if held.get(name) is None:
            held.pop(name, None)
    return solution


Fields = Iterable[Field] | Field  #: Type of the argument `fields`: names, or a single name.


def names_of(fields: Fields) -> list[str]:
    """Returns names of arrays; the daemon refuses invalid ones."""
    return [fields] if isinstance(fields, str) else list(fields)
