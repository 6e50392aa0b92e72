"""Solves contact problems, and computes stresses inside the bodies and temperatures of their surfaces."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import replace
from functools import partial
from typing import TYPE_CHECKING, Literal

import numpy.typing as npt

from ..errors import StatusError
from ..refusals import check_type
from ..transport.messages import results
from ..values.answers import read
from ..values.contact_params import problem_params, shear_modulus_of, subsurface_params
from ..values.generated.problem import ContactProblem, Estimate
from ..values.generated.subsurface import StressBlock, SubsurfaceStress
from ..values.generated.temperature import SurfaceTemperatures
from ..values.generated.thermal import ThermalBodies
from ..values.solution import ContactSolution, Fields, names_of
from ..values.step_solution import read_solution
from ..values.subsurface_methods import INVARIANTS
from ..values.temperature_params import temperature_params
from .call import Answering, asks
from .caller import Caller, ProgressCallback, check_shapes
from .stated_problems import Body, Gap, on_chosen_grid, stated_problem

if TYPE_CHECKING:
    from ..values.generated.problem import ProblemFields

__all__ = ["ContactCalls", "solved", "solved_many"]


class ContactCalls(Caller):
    """Calls the methods contact.* of the daemon whose answers have one type."""

    @asks
    def subsurface(
        self,
        problem: ContactProblem,
        solution: ContactSolution | Estimate,
        *,
        body: Literal["lower", "upper"] = "lower",
        points: npt.ArrayLike | None = None,
        block: StressBlock | None = None,
        nu: float | None = None,
        invariants: bool = False,
        displacements: bool = False,
        timeout: float | None = None,
        on_progress: ProgressCallback | None = None,
        progress: bool = False,
    ) -> Answering[SubsurfaceStress]:
        """Stresses inside a body, a half-space or layers, under the tractions of the `solution` of a `problem`.

        Give either `points`, shape [n, 3] (x, y, z in mm), or a `block`::

            stress = client.subsurface(problem, solution, block=StressBlock(x=grid.x, y=0, z=-np.linspace(0, 5, 51)))
            print(stress.largest.von_mises, stress.largest.depth)

        Points and stresses are in the frame of `body`, where z <= 0 is inside, also for the upper body: see
        SubsurfaceStress. `nu` replaces Poisson's ratio of the problem; a LayeredBody has its own. `invariants` adds
        hydrostatic, principal and Tresca stresses; `displacements` adds the displacements, for half-spaces only. Below
        a line contact, y has no effect. At depths below one element size, the results show the piecewise constant
        tractions. Below curved columns, y is the arc length as in the grid, and stresses are in the axes of the column
        above: each column acts on the others as on a half-space, rotated by the angle between them. Bodies that are
        not, or may not be, half-spaces are refused (InvalidArgument): blocks, longitudinally uniform bodies without
        columns, and TableIcs.
        """
        params, shape = subsurface_params(problem, solution, body, points, block, nu)
        if invariants:
            params["invariants"] = True
        if displacements:
            params["G"] = shear_modulus_of(problem, body)
        result = yield from self.asked("contact.subsurface", params, timeout=timeout, on_progress=on_progress, progress=progress)
        components = result.pop("stress", None)
        stress = read(SubsurfaceStress, {**result, **components} if isinstance(components, dict) else result)
        check_shapes(stress, ["xx", "yy", "zz", "xy", "xz", "yz", "von_mises"], shape)
        if invariants:
            check_shapes(stress, INVARIANTS, shape)
        if displacements:
            check_shapes(stress, ["displacement_x", "displacement_y", "displacement_z"], shape)
        return replace(stress, block=block, points=params.get("points"))

    @asks
    def temperature(
        self,
        solution: ContactSolution,
        bodies: ThermalBodies | None = None,
        *,
        velocity: float | None = None,
        timeout: float | None = None,
        on_progress: ProgressCallback | None = None,
        progress: bool = False,
    ) -> Answering[SurfaceTemperatures]:
        """Computes the temperatures of both surfaces, in and behind the contact, for a `solution` of steady rolling
        along x.

        Frictional heat is shared so that both surfaces have equal temperatures. `bodies` are their thermal properties;
        if None, steel at 0 degrees. You can also use a patch of a wheel on its rail::

            found = client.temperature(solution, ThermalBodies(upper=ThermalBody(bulk_temperature=120), lower=ThermalBody()))
            print(found.temperature.largest, found.lower_temperature.max())

        `velocity` is the rolling velocity (mm/s), if it differs from that of the solution. The result is the same as
        that of a problem with `temperature`. Shifts, transient rolling, and rolling across the rows are refused
        (InvalidArgument).
        """
        params = temperature_params(solution, bodies, velocity)
        result = yield from self.asked("contact.temperature", params, timeout=timeout, on_progress=on_progress, progress=progress)
        found = read(SurfaceTemperatures, result)
        assert solution.grid is not None  # temperature_params has checked it.
        check_shapes(found, ["upper_temperature", "lower_temperature"], solution.grid.shape)
        return replace(found, grid=solution.grid)


def solved(
    caller: Caller,
    problem: ContactProblem | Gap | None,
    upper: Body | None,
    lower: Body | None,
    problem_fields: ProblemFields,
    fields: Fields | None,
    timeout: float | None,
    on_progress: ProgressCallback | None,
    progress: bool,
) -> Answering[ContactSolution]:
    """The steps of `solve`."""
    stated = stated_problem(problem, upper, lower, problem_fields)

    def solve(one: ContactProblem) -> Answering[ContactSolution]:
        names = None if fields is None else names_of(fields)
        params = problem_params(one, names)
        result = yield from caller.asked(
            "contact.solve", params, timeout=timeout, on_progress=on_progress, progress=progress
        )
        return read_solution(one.grid, names, result)

    return (yield from on_chosen_grid(stated, solve, lambda solution: [solution]))


def solved_many(
    caller: Caller,
    problems: Iterable[ContactProblem],
    fields: Fields | None,
    timeout: float | None,
    on_progress: ProgressCallback | None,
    progress: bool,
) -> Answering[list[ContactSolution | StatusError]]:
    """The steps of `solve_many`."""
    problems = list(problems)
    if not problems:
        return []
    for index, problem in enumerate(problems):
        check_type(f"problems[{index}]", problem, ContactProblem)
    names = None if fields is None else names_of(fields)
    params = {"problems": [problem_params(problem, names) for problem in problems]}
    result = yield from caller.asked(
        "contact.solve_many", params, timeout=timeout, on_progress=on_progress, progress=progress
    )
    readers = [partial(read_solution, problem.grid, names) for problem in problems]
    return results("contact.solve_many", result, "solutions", readers)
