"""Weights of computed contacts: of a contact problem, and of a wheel on its rail with all its patches."""

from __future__ import annotations

import math
import warnings
from typing import TYPE_CHECKING

import numpy as np

from ..calls.answer_warnings import ContactWarning
from ..errors import invalid
from ..materials import steel
from ..values.arrays import Array
from ..values.generated.problem import ContactProblem
from ..values.generated.wheel_rail.setup import WheelRailSetup
from ..values.solution import ContactSolution
from ..values.wheel_rail.solution import WheelRailPatch, WheelRailSolution
from .weights import ContactWeights

if TYPE_CHECKING:
    from ..client import Client

__all__ = ["contact_weights", "normal_problem", "patch_problem", "wheel_rail_weights"]

_APART = 1e3  #: Gap outside the contact (mm), which no deformation closes.


def contact_weights(client: Client, problem: ContactProblem, solution: ContactSolution | None = None) -> ContactWeights:
    """Returns the weights of a contact problem, by one more solve: the flat punch with the outline of its contact.

    `solution` is that of the problem with the field pressure; without it, the problem is solved first. Bodies can be
    any that contactd supports on a plane. Use at least 32 elements across the contact. Raises InvalidArgument without
    contact, and for a contact that reaches the border of the grid.
    """
    if problem.columns is not None:
        raise invalid("problem.columns", "= a curved contact: only weights of plane contacts are supported. Omit columns.")
    if solution is None:
        solution = client.solve(problem, fields=["pressure"])
    return _weights_by_punch(client, problem, solution)


def wheel_rail_weights(client: Client, setup: WheelRailSetup, solution: WheelRailSolution) -> ContactWeights:
    """Returns the weights of all patches of a wheel by their common vertical approach: their values are in proportion to
    the vertical stiffness of each, and refer to vertical heights.

    `solution` is the answer of Client.wheel_rail for the set-up with the field pressure. Places are those of the track:
    x forwards, y to the right (mm). The stiffness is dFz/dz of the wheel (N/mm). Profiles may be worn. Raises
    InvalidArgument without contact, and for conformal contact.
    """
    if not solution.patches:
        raise invalid("solution", "= a wheel without contact: there are no weights. Lower the wheel or prescribe Fz.")
    if any(patch.place.rows for patch in solution.patches):
        raise invalid("setup.conformal", f"= {setup.conformal}: only weights of patches on a plane are supported. Set conformal to off.")
    if any(len(patch.place.regions) > 1 for patch in solution.patches):
        warnings.warn(ContactWarning("solution: a patch has several regions, whose weights are computed as if they interacted fully."), stacklevel=2)
    parts = []
    for patch in solution.patches:
        found = _weights_by_punch(client, patch_problem(setup, patch), patch.solution)
        place, angle = patch.place.reference, patch.place.reference.angle
        stiffness = float(found.stiffness or 0) * math.cos(angle) ** 2
        parts.append((place.x + found.x, place.y + found.y * math.cos(angle), found.values * stiffness, found.size))
    x, y, values = (np.concatenate([part[i] for part in parts]) for i in range(3))
    return ContactWeights(x, y, values, parts[0][3], float(values.sum()))


def patch_problem(setup: WheelRailSetup, patch: WheelRailPatch) -> ContactProblem:
    """Returns the frictionless contact problem of a patch on half-spaces, with its gap if the solution has it."""
    upper = steel if setup.upper is None else setup.upper
    gap = np.zeros(patch.place.grid.shape) if patch.gap is None else patch.gap
    return ContactProblem(
        patch.place.grid, upper, gap, lower=setup.lower, Fn=patch.solution.Fn, sheet_flexibility=setup.sheet_flexibility
    )


def normal_problem(problem: ContactProblem, gap: Array, Fn: float) -> ContactProblem:
    """Returns the frictionless problem of the same bodies with another gap (mm) and force (N)."""
    return ContactProblem(
        problem.grid, problem.upper, gap, lower=problem.lower, ics=problem.ics, upper_ics=problem.upper_ics, lower_ics=problem.lower_ics,
        sheet_flexibility=problem.sheet_flexibility, regions=problem.regions, normal=problem.normal, Fn=Fn,
    )  # fmt: skip


def _weights_by_punch(client: Client, problem: ContactProblem, solution: ContactSolution) -> ContactWeights:
    if (pressure := getattr(solution, "pressure", None)) is None:
        raise invalid("solution", "= no pressures: the outline of the contact is unknown. Request fields=['pressure'].")
    touching = np.asarray(pressure) > 0
    if not touching.any():
        raise invalid("solution", "= no contact: there are no weights. Increase the approach or the force.")
    if touching[[0, -1]].any() or touching[:, [0, -1]].any():
        raise invalid("problem.grid", "= a contact that reaches its border: the outline is cut off. Use a larger grid.")
    solved = client.solve(normal_problem(problem, np.where(touching, 0.0, _APART), 1.0), fields=["pressure"])
    grid = problem.grid
    x, y = np.meshgrid(grid.x, grid.y)
    return ContactWeights(x[touching], y[touching], solved.pressure[touching], (grid.dx, grid.dy), solved.Fn / solved.approach)
