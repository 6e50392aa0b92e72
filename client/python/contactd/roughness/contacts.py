"""Weights of computed contacts: of a contact problem, and of a wheel on its rail with all its patches."""

from __future__ import annotations

import math
import warnings
from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

import numpy as np

from ..calls.answer_warnings import ContactWarning
from ..errors import invalid
from ..materials import steel
from ..values.answers import read
from ..values.contact_params import problem_params
from ..values.generated.grid import Grid
from ..values.generated.problem import ContactProblem
from ..values.generated.wheel_rail.setup import WheelRailSetup
from ..values.params import params_of
from ..values.solution import ContactSolution
from ..values.step_solution import read_solution
from ..values.wheel_rail.params import setup_params
from ..values.wheel_rail.solution import WheelRailSolution
from .weights import ContactWeights

if TYPE_CHECKING:
    from ..client import Client

__all__ = ["contact_weights", "wheel_rail_weights"]

_APART = 1e3  #: Gap outside the contact (mm), which no deformation closes.
_OF_BODIES = ("bodies", "ics", "sheet_flexibility", "regions")  #: Fields of a problem that determine the stiffness.


def contact_weights(client: Client, problem: ContactProblem | Mapping[str, Any], solution: ContactSolution | None = None) -> ContactWeights:
    """Returns the weights of a contact problem, or of its parameters as on the wire.

    `solution` is that of the problem; without it, the problem is solved first. With the field pressure_by_approach,
    which requires derivatives, it contains the weights. With the field pressure, one more solve computes them: the flat
    punch with the outline of the contact. Bodies can be any
    that contactd supports on a plane. Use at least 32 elements across the contact. Raises InvalidArgument without
    contact, and for a contact that reaches the border of the grid.
    """
    params = problem_params(problem) if isinstance(problem, ContactProblem) else dict(problem)
    if "columns" in params:
        raise invalid("problem.columns", "= a curved contact: only weights of plane contacts are supported. Omit columns.")
    grid = read(Grid, params.get("grid"), "problem.grid")
    if solution is None:
        solution = _solved(client, params, grid)
    return _weights(client, params, grid, solution)


def wheel_rail_weights(client: Client, setup: WheelRailSetup | Mapping[str, Any], solution: WheelRailSolution) -> ContactWeights:
    """Returns the weights of all patches of a wheel by their common vertical approach: their values are in proportion to
    the vertical stiffness of each, and refer to vertical heights.

    `solution` is the answer of Client.wheel_rail for the set-up with one of the fields that contact_weights names. x points
    forwards, and y to the right from the origin of the rail's profile (mm). The stiffness is dFz/dz of the wheel (N/mm). Profiles may be worn. Raises
    InvalidArgument without contact, and for conformal contact. Warns (ContactWarning) of patches with several regions.
    """
    params = setup_params(setup) if isinstance(setup, WheelRailSetup) else dict(setup)
    if not solution.patches:
        raise invalid("solution", "= a wheel without contact: there are no weights. Lower the wheel or prescribe Fz.")
    if any(patch.place.rows for patch in solution.patches):
        raise invalid("setup.conformal", f"= {params.get('conformal')}: only weights of patches on a plane are supported. Set conformal to off.")
    if any(len(patch.place.regions) > 1 for patch in solution.patches):
        warnings.warn(ContactWarning("solution: a patch has several regions, whose weights are computed as if they interacted fully."), stacklevel=2)
    bodies = {"bodies": {"upper": params_of(steel, "upper")}, "ics": {"source": "analytic"}, **params}
    parts, origin = [], solution.rail_frame.y
    for patch in solution.patches:
        found = _weights(client, bodies, patch.place.grid, patch.solution)
        place, angle = patch.place.reference, patch.place.reference.angle
        stiffness = float(found.stiffness or 0) * math.cos(angle) ** 2
        parts.append((place.x + found.x, place.y - origin + found.y * math.cos(angle), found.values * stiffness, found.size))
    x, y, values = (np.concatenate([part[i] for part in parts]) for i in range(3))
    return ContactWeights(x, y, values, parts[0][3], float(values.sum()))


def _weights(client: Client, params: Mapping[str, Any], grid: Grid, solution: ContactSolution) -> ContactWeights:
    gains = getattr(solution, "pressure_by_approach", None)
    if (outline := getattr(solution, "pressure", None) if gains is None else gains) is None:
        raise invalid("solution", "= no pressures: the outline of the contact is unknown. Request fields=['pressure'].")
    touching = np.asarray(outline) != 0
    if not touching.any():
        raise invalid("solution", "= no contact: there are no weights. Increase the approach or the force.")
    if touching[[0, -1]].any() or touching[:, [0, -1]].any():
        raise invalid("problem.grid", "= a contact that reaches its border: the outline is cut off. Use a larger grid.")
    if gains is None:
        bodies = {name: params[name] for name in _OF_BODIES if params.get(name) is not None}
        gap = np.where(touching, 0.0, _APART)
        punch = _solved(client, {**bodies, "grid": params_of(grid, "grid"), "gap": {"array": gap}, "Fn": 1.0}, grid)
        gains = punch.pressure / punch.approach
    x, y = np.meshgrid(grid.x, grid.y)
    size = grid.dx, grid.dy
    return ContactWeights(x[touching], y[touching], gains[touching], size, float(gains[touching].sum()) * grid.dx * grid.dy)


def _solved(client: Client, params: Mapping[str, Any], grid: Grid) -> ContactSolution:
    return read_solution(grid, ["pressure"], client.call("contact.solve", {**params, "fields": ["pressure"]}))
