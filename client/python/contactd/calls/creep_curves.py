"""Computes creep curves: forces of a contact for many creepages."""

from __future__ import annotations

import math
import re
from collections.abc import Iterator
from dataclasses import replace
from functools import partial
from typing import TYPE_CHECKING, Any

import numpy as np
import numpy.typing as npt

from ..errors import StatusError, invalid
from ..transport.messages import results
from ..values.arrays import array_of
from ..values.contact_params import problem_params
from ..values.creep_curves import CreepCurve
from ..values.generated.friction import Friction
from ..values.generated.motion import Rolling
from ..values.generated.problem import ContactProblem
from ..values.step_solution import read_solution
from .call import Answering, Noted, asks
from .caller import Caller, ProgressCallback
from .stated_problems import Body, Gap, on_chosen_grid, stated_problem, without_warnings

if TYPE_CHECKING:
    from typing_extensions import Unpack

    from ..values.generated.problem import ProblemFields

__all__ = ["CreepCurveCalls"]

_MOST_POINTS = 1000  #: Maximum number of points in a message.
_MOST_ELEMENTS = 2_000_000  #: Maximum number of elements of all grids in a message.
_FARTHEST = 1e12  #: Largest creepage that the schema allows.
_FORCES = ("Fn", "Fx", "Fy", "Mz", "pmax")
_MOST_SHOWN = 3


class CreepCurveCalls(Caller):
    """Calls that solve one contact at many creepages."""

    @asks
    def creep_curve(
        self,
        contact: ContactProblem | Gap | None = None,
        upper: Body | None = None,
        lower: Body | None = None,
        /,
        *,
        xi: npt.ArrayLike = 0.0,
        eta: npt.ArrayLike = 0.0,
        phi: npt.ArrayLike = 0.0,
        timeout: float | None = None,
        on_progress: ProgressCallback | None = None,
        progress: bool = False,
        **problem_fields: Unpack[ProblemFields],
    ) -> Answering[CreepCurve]:
        """Computes the forces of steady rolling for many creepages. Describe the contact as for `solve`; the grid is
        optional::

            friction = Friction(0.3)
            curve = client.creep_curve(Paraboloid(460, 300), steel, Fn=80e3, friction=friction, xi=np.linspace(0, 0.01, 21))
            print(curve.Fx / curve.Fn)

        `xi`, `eta` and `phi` (rad/mm) are numbers or arrays that are broadcast together; arrays of the answer have the
        resulting shape. They are the creepages of the upper body relative to the lower one. Other values of the motion,
        such as the rolling direction and velocity, are those of ``friction.rolling``. `timeout` applies to each
        message.

        If a point fails, its values are NaN, `errors` contains the exception, and a ContactWarning names the point.
        Points that did not converge keep their values; a ContactWarning states their number. Raises the exception if
        all points fail, and TypeError if the friction has no coefficient, prescribes a force, or is that of a shift.
        """
        stated = stated_problem(contact, upper, lower, problem_fields, "creep_curve")
        friction = _friction_of(stated.problem)
        points = _broadcast(xi=xi, eta=eta, phi=phi)

        def solve(problem: ContactProblem) -> Answering[list[Any]]:
            indices, motions = zip(*_points(points))
            answers: list[Any] = [_refused(index, point) for index, point in zip(indices, motions)]
            there = [number for number, error in enumerate(answers) if error is None]
            for chunk in _chunks(there, problem):
                problems = [problem.replace(friction=_rolling(friction, motions[number])) for number in chunk]
                noted: list[str] = []
                params = {"problems": [problem_params(one, []) for one in problems]}
                steps = self.asked("contact.solve_many", params, timeout=timeout, on_progress=on_progress, progress=progress)
                result = yield from without_warnings(steps, noted)
                readers = [partial(read_solution, one.grid, []) for one in problems]
                found = results("contact.solve_many", result, "solutions", readers)
                yield Noted(tuple(_of_points(sentence, [indices[number] for number in chunk]) for sentence in noted))
                for number, answer in zip(chunk, found):
                    answers[number] = answer
            return [(problem, answer) for answer in answers]

        answered = yield from on_chosen_grid(
            stated, solve, lambda found: [answer for _, answer in found if not isinstance(answer, StatusError)]
        )
        curve = _curve(points, answered, stated.problem)
        if sentences := _sentences(curve):
            yield Noted(tuple(sentences))
        return curve


def _friction_of(problem: ContactProblem) -> Friction:
    friction = problem.friction
    if friction is None:
        raise TypeError("friction is None; a creep curve needs a coefficient of friction. Give friction=Friction(0.3).")
    if friction.rolling is not None and friction.rolling.force is not None:
        raise TypeError("friction.rolling.force is given; a creep curve prescribes creepages. Remove the force.")
    for name in ("rigid_shift", "force", "rotation"):
        if getattr(friction, name) is not None:
            raise TypeError(f"friction.{name} is that of a shift; a creep curve rolls. Remove it.")
    return friction


def _rolling(friction: Friction, motion: dict[str, Any]) -> Friction:
    return replace(friction, rolling=replace(friction.rolling or Rolling(), **motion))


def _broadcast(**creepages: npt.ArrayLike) -> dict[str, Any]:
    """Broadcasts the creepages to one shape. Raises InvalidArgument if that is impossible."""
    arrays = {}
    for name, values in creepages.items():
        try:
            arrays[name] = np.ma.filled(np.ma.asarray(array_of(values), dtype=np.float64), np.nan)
        except (TypeError, ValueError):
            raise invalid(name, f"is {values!r:.60}; it must be a number or an array of numbers", "ARRAY_INVALID") from None
    try:
        shaped = np.broadcast_arrays(*arrays.values())
    except ValueError:
        shapes = ", ".join(f"{name} {list(array.shape)}" for name, array in arrays.items())
        raise invalid("xi, eta and phi", f"do not broadcast together; their shapes are {shapes}", "ARRAY_INVALID") from None
    if not shaped[0].size:
        raise invalid("xi, eta and phi", "have no points", "ARRAY_INVALID")
    return {name: np.array(array) for name, array in zip(arrays, shaped)}


def _points(points: dict[str, Any]) -> Iterator[tuple[tuple[int, ...], dict[str, float]]]:
    for index in np.ndindex(points["xi"].shape):
        yield index, {name: float(array[index]) for name, array in points.items()}


def _refused(index: tuple[int, ...], point: dict[str, float]) -> StatusError | None:
    """Returns the reason why a point is invalid; the daemon would refuse the whole message."""
    for name, value in point.items():
        if not math.isfinite(value) or abs(value) > _FARTHEST:
            return invalid(f"{name}[{', '.join(map(str, index))}]", f"is {value}; it must be a finite number")
    return None


def _chunks(numbers: list[int], problem: ContactProblem) -> Iterator[list[int]]:
    size = max(1, min(_MOST_POINTS, _MOST_ELEMENTS // max(1, problem.grid.nx * problem.grid.ny)))
    for first in range(0, len(numbers), size):
        yield numbers[first : first + size]


def _curve(points: dict[str, Any], answered: list[Any], problem: ContactProblem) -> CreepCurve:
    shape = points["xi"].shape
    grid = answered[0][0].grid if answered else problem.grid
    found = {name: np.full(shape, np.nan) for name in _FORCES}
    converged = np.zeros(shape, dtype=np.bool_)
    errors: dict[tuple[int, ...], StatusError] = {}
    for (index, _), (_, answer) in zip(_points(points), answered):
        if isinstance(answer, StatusError):
            errors[index] = answer
            continue
        converged[index] = answer.converged
        for name, array in found.items():
            array[index] = getattr(answer, name)
    if len(errors) == len(answered):
        raise next(iter(errors.values()))
    for array in (*points.values(), *found.values(), converged):
        array.flags.writeable = False
    return CreepCurve(grid=grid, converged=converged, errors=errors, **points, **found)


def _sentences(curve: CreepCurve) -> list[str]:
    sentences = []
    if curve.errors:
        named = [f"{_name(index)}: {error.message}" for index, error in list(curve.errors.items())[:_MOST_SHOWN]]
        more = f"; and {len(curve.errors) - _MOST_SHOWN} more" if len(curve.errors) > _MOST_SHOWN else ""
        sentences.append(f"{len(curve.errors)} of {curve.xi.size} points failed and are NaN: {'; '.join(named)}{more}.")
    if missed := int(np.count_nonzero(~curve.converged)) - len(curve.errors):
        sentences.append(f"{missed} of {curve.xi.size} points did not converge; see `converged`.")
    return sentences


def _of_points(sentence: str, indices: list[tuple[int, ...]]) -> str:
    """Replaces the problems of a message by the indices of points."""
    return re.sub(r"\bproblems\[(\d+)\]", lambda found: _name(indices[int(found[1])]), sentence)


def _name(index: tuple[int, ...]) -> str:
    return f"point [{', '.join(map(str, index))}]"
