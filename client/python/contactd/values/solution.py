"""Solutions of contacts as immutable values.

Arrays are read-only; copy one to change it.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass

import numpy as np
import numpy.typing as npt

from .arrays import Array
from .generated.result import Areas, Counts, Derivatives, DerivativesOfAnswer, Field, Forces, Resultant, Solution
from .representation import with_inherited_attributes

__all__ = [
    "Areas",
    "ContactSolution",
    "Counts",
    "Derivatives",
    "DerivativesOfAnswer",
    "Field",
    "Fields",
    "Forces",
    "PartialSolution",
    "Resultant",
    "Solution",
    "names_of",
]


@with_inherited_attributes
@dataclass(frozen=True, eq=False, repr=False, kw_only=True)
class ContactSolution(Solution[Array, npt.NDArray[np.uint8]]):
    """The solution of a ContactProblem. Arrays have shape [ny, nx]; tractions and forces act on the upper body.

    Check `converged`: a solve that did not converge also returns a solution. Read `warnings`. A solution may be
    `previous` or `initial` of the next problem.
    """

    def _title(self) -> str:
        ny, nx = self.pressure.shape
        return f"ContactSolution on {nx} x {ny} elements"


@with_inherited_attributes
@dataclass(frozen=True, eq=False, repr=False, kw_only=True)
class PartialSolution(Solution[Array | None, npt.NDArray[np.uint8] | None]):
    """A solution with the arrays named by `fields`; the others are None."""


Fields = Iterable[Field] | Field  #: Type of the argument `fields`: names, or a single name.


def names_of(fields: Fields) -> list[str]:
    """Returns names of arrays; the daemon refuses invalid ones."""
    return [fields] if isinstance(fields, str) else list(fields)
