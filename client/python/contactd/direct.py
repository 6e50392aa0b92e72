"""Provides functions that use `contactd.default_client` instead of a client of your own."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy.typing as npt

from .calls.caller import ProgressCallback
from .calls.stated_problems import Body, Gap
from .refusals import public
from .transport.shared_client import shared_client
from .values.creep_curves import CreepCurve
from .values.generated.problem import ContactProblem
from .values.solution import ContactSolution, Fields

if TYPE_CHECKING:
    from typing_extensions import Unpack

    from .values.generated.problem import ProblemFields

__all__ = ["creep_curve", "solve"]


@public
def solve(
    problem: ContactProblem | Gap | None = None,
    upper: Body | None = None,
    lower: Body | None = None,
    /,
    *,
    fields: Fields | None = None,
    timeout: float | None = None,
    on_progress: ProgressCallback | None = None,
    progress: bool = False,
    **problem_fields: Unpack[ProblemFields],
) -> ContactSolution:
    """Solves a contact problem with the default client. Arguments, answer and errors are those of Client.solve::

        solution = contactd.solve(Paraboloid(50, 50), steel, Fn=100)  # radii (mm), both bodies of steel, force (N)
        print(solution.pmax, solution.approach, solution.grid)

    See `default_client` for the client. Lengths are in mm, forces in N, pressures in N/mm^2.
    """
    solution: ContactSolution = shared_client().solve(
        problem, upper, lower, fields=fields, timeout=timeout, on_progress=on_progress, progress=progress, **problem_fields
    )
    return solution


@public
def creep_curve(
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
) -> CreepCurve:
    """Computes the forces of steady rolling for many creepages with the default client. Arguments, answer and errors
    are those of Client.creep_curve::

        curve = contactd.creep_curve(Paraboloid(460, 300), steel, Fn=80e3, friction=Friction(0.3), xi=np.linspace(0, 0.01, 21))
        curve.plot()
    """
    curve: CreepCurve = shared_client().creep_curve(
        contact, upper, lower, xi=xi, eta=eta, phi=phi, timeout=timeout, on_progress=on_progress, progress=progress,
        **problem_fields,
    )  # fmt: skip
    return curve
