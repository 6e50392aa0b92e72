"""Accepts problems as arguments of calls: as a whole, by gap and bodies, or by their fields, with or without a
grid."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, TypeVar

import numpy.typing as npt

from ..refusals import check_type
from ..values.generated.grid import Grid, HalfEllipses, Paraboloid, SemiAxes
from ..values.generated.materials import LayeredBody, Material, RigidBody, ViscoelasticBody
from ..values.generated.problem import ContactProblem
from ..values.hertz_grid import corrected_grid, grid_of
from ..values.problem_methods import check_field_types
from ..values.solution import ContactSolution
from .call import Answering, Noted

if TYPE_CHECKING:
    from ..values.generated.problem import ProblemFields

__all__ = ["Body", "Gap", "Stated", "on_chosen_grid", "stated_problem", "without_warnings"]

Body = Material | RigidBody | LayeredBody | ViscoelasticBody
Gap = Paraboloid | SemiAxes | HalfEllipses | npt.ArrayLike
T = TypeVar("T")


@dataclass(frozen=True)
class Stated:
    """Holds a problem, and whether its grid was chosen here."""

    problem: ContactProblem
    is_grid_chosen: bool


def stated_problem(
    problem: ContactProblem | Gap | None, upper: Body | None, lower: Body | None, fields: ProblemFields, call: str = "solve"
) -> Stated:
    """Returns the problem described by the arguments. Raises TypeError if there is none, or more than one."""
    if isinstance(problem, ContactProblem):
        names = [*(name for name, body in (("upper", upper), ("lower", lower)) if body is not None), *fields]
        if names:
            raise TypeError(f"{call}() accepts a ContactProblem or its fields, not both: {', '.join(names)}")
        return Stated(problem, False)
    by_place = {"gap": problem, "upper": upper, "lower": lower}
    given: dict[str, Any] = dict(fields)
    for name, value in by_place.items():
        if value is None:
            continue
        if name in given:
            raise TypeError(f"{call}() got {name} twice, by position and by keyword")
        given[name] = value
    if given.get("grid") is not None:
        return Stated(ContactProblem(**given), False)
    if "gap" not in given:
        raise TypeError(f"{call}() lacks gap: give a ContactProblem, or its fields")
    if problem is not None and not isinstance(problem, Paraboloid | SemiAxes | HalfEllipses) and "upper" not in given:
        check_type("problem", problem, ContactProblem, Paraboloid, SemiAxes)
    check_field_types(ContactProblem, {**given, "grid": _ANY_GRID})
    return Stated(ContactProblem(**{**given, "grid": grid_of(given)}), True)


_ANY_GRID = Grid(1, 1, 1.0, 1.0)


def on_chosen_grid(
    stated: Stated, solve: Callable[[ContactProblem], Answering[T]], solutions: Callable[[T], Iterable[ContactSolution]]
) -> Answering[T]:
    """Solves a problem. If its grid was chosen here and does not fit the solution, solves it again on a better one.
    Warnings of the first answer are then dropped.
    """
    if not stated.is_grid_chosen:
        return (yield from solve(stated.problem))
    noted: list[str] = []
    answer = yield from without_warnings(solve(stated.problem), noted)
    fitting = (corrected_grid(stated.problem.grid, solution) for solution in solutions(answer))
    grids = [grid for grid in fitting if grid is not None]
    if grids:
        largest = max(grids, key=lambda grid: grid.nx * grid.dx)
        return (yield from solve(stated.problem.replace(grid=largest)))
    if noted:
        yield Noted(tuple(noted))
    return answer


def without_warnings(steps: Answering[T], noted: list[str]) -> Answering[T]:
    """Runs the steps, and adds the warnings of answers to `noted` instead of giving them."""
    try:
        asked = next(steps)
        while True:
            if isinstance(asked, Noted):
                noted.extend(asked.sentences)
                asked = next(steps)
                continue
            try:
                reply = yield asked
            except BaseException as error:
                asked = steps.throw(error)
            else:
                asked = steps.send(reply)
    except StopIteration as end:
        answer: T = end.value
    return answer
