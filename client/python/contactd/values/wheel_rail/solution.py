"""The answers of `Client.wheel_rail` and `Client.wheelset`, and steps of a session. Lengths are in mm, angles in rad,
forces in N on the rail.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from typing import Any, TypeVar

from ...errors import ProtocolError
from ..answers import read
from ..generated.wheel_rail.result import RailDeflection, WheelRailPatch, WheelRailSolution, WheelsetSolution
from ..representation import with_inherited_attributes
from ..solution import ALL_FIELDS
from ..step_solution import checked

__all__ = [
    "RailDeflection",
    "WheelRailPatch",
    "WheelRailSolution",
    "WheelRailStepSolution",
    "WheelsetSolution",
    "read_wheel_rail",
    "read_wheel_rail_as",
    "read_wheel_rail_without_patches",
    "read_wheelset",
]

S = TypeVar("S", bound="WheelRailSolution")


def read_wheel_rail(names: Iterable[str] | None, gap: bool, result: dict[str, Any]) -> WheelRailSolution:
    """Reads the answer to a request for the arrays `names` (None: all), with undeformed distances if `gap` is set."""
    return read_wheel_rail_as(WheelRailSolution, names, gap, result)


def read_wheel_rail_as(
    kind: type[S], names: Iterable[str] | None, gap: bool, result: dict[str, Any], path: str = "result"
) -> S:
    """Reads the answer as a subclass with more fields."""
    return _checked(read(kind, result, path), names, gap)


def read_wheel_rail_without_patches(kind: type[S], result: dict[str, Any], path: str) -> S:
    """Reads an answer without patches."""
    if type(result.get("contacts")) is not int:
        raise ProtocolError(f"The answer's {path} lacks contacts.")
    solution = read(kind, {**result, "patches": []}, path)
    del vars(solution)["patches"]
    return solution


def read_wheelset(names: Iterable[str] | None, gap: bool, result: dict[str, Any]) -> WheelsetSolution:
    """Reads the answer of both wheels, as `read_wheel_rail` does."""
    solution = read(WheelsetSolution, result)
    for wheel in (solution.left, solution.right):
        _checked(wheel, names, gap)
    return solution


def _checked(solution: S, names: Iterable[str] | None, gap: bool) -> S:
    requested = list(ALL_FIELDS if names is None else names)
    for index, patch in enumerate(solution.patches):
        checked(patch.solution, requested, patch.place.grid)
        if gap and patch.gap is not None and patch.gap.shape != patch.place.grid.shape:
            raise ProtocolError(f"The answer's gap of patch {index} does not fit its grid.")
    return solution


@with_inherited_attributes
@dataclass(frozen=True, eq=False, repr=False, kw_only=True)
class WheelRailStepSolution(WheelRailSolution):
    """The solution of a step, whose patches have the arrays named by `fields`. `converged` can be False only if the
    session accepts that.

    Attributes:
        step: Number of the step.
    """

    step: int

    def _title(self) -> str:
        return f"WheelRailStepSolution {self.step}"
