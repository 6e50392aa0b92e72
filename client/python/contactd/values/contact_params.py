"""A contact problem in the words of the wire: the parameters of contact.solve, and what sessions have of them."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

from ..transport.frames import array_of, plain
from .gaps import gap_params
from .grid import Grid
from .ics import AnalyticIcs, Ics, ics_params, layered_params
from .materials import LayeredBody, Material, RigidBody
from .problem import ContactProblem, Estimate
from .table_ics import TableIcs

if TYPE_CHECKING:
    from .solution import ContactSolution

__all__ = ["body_params", "coefficient_params", "opening_params", "problem_params", "traction_params"]

def problem_params(problem: ContactProblem, fields: list[str] | None = None) -> dict[str, Any]:
    """The parameters of contact.solve; `fields` are the arrays wanted back, None: all."""
    params = opening_params(vars(problem))
    return params if fields is None else {**params, "fields": fields}


def opening_params(fields: Mapping[str, Any]) -> dict[str, Any]:
    """The same of fields of a problem, of which gap and load may be missing: steps of a session bring them."""
    given = {name: value for name, value in fields.items() if value is not None}
    params = {"grid": plain(given["grid"]), **_influence_params(given)}
    if "gap" in given:
        params["gap"] = gap_params(given["gap"])
    params.update({name: given[name] for name in ("approach", "Fn", "model") if name in given})
    if "friction" in given:
        params["friction"] = given["friction"].params()
    if settings := {name: plain(given[name]) for name in ("normal", "tangential", "outer") if name in given}:
        params["settings"] = settings
    params.update({name: traction_params(given[name], name) for name in ("initial", "previous") if name in given})
    if given.get("derivatives"):
        params["derivatives"] = True
    if "columns" in given:
        params["columns"] = given["columns"].params()
    return params


def _influence_params(given: Mapping[str, Any]) -> dict[str, Any]:
    grid, ics = given["grid"], given.get("ics", AnalyticIcs())
    own = {body: given.get(f"{body}_ics") for body in ("upper", "lower")}
    is_full = given.get("model", "full") == "full"
    if isinstance(ics, TableIcs) and is_full and not any(own.values()):
        return {"ics": coefficient_params(ics, grid)}
    bodies = {name: given[name] for name in ("upper", "lower") if name in given}
    if own["lower"] is not None and "lower" not in bodies and "upper" in bodies:
        bodies["lower"] = bodies["upper"]
    params: dict[str, Any] = {}
    if bodies:
        params["bodies"] = {name: body_params(body, own[name], grid, ics) for name, body in bodies.items()}
    if not isinstance(ics, TableIcs) or (is_full and any(own.values())):
        params["ics"] = coefficient_params(ics, grid)
    return params


def body_params(
    body: Material | RigidBody | LayeredBody, ics: Ics | TableIcs | None, grid: Grid, both: Ics | TableIcs
) -> dict[str, Any]:
    """`bodies.upper` or `bodies.lower`; `ics` is the body's own, where it is not that of both."""
    if isinstance(body, LayeredBody):
        return {"ics": layered_params(body, both if ics is None else ics)}
    params = {"rigid": True} if isinstance(body, RigidBody) else plain(body)
    return params if ics is None else {**params, "ics": coefficient_params(ics, grid)}


def coefficient_params(ics: Ics | TableIcs, grid: Grid) -> dict[str, Any]:
    """`ics` of contact.solve, of both bodies or of one."""
    if not isinstance(ics, TableIcs):
        return ics_params(ics)
    ny, nx = grid.shape
    return {"source": "table", "table": ics.array[:, :, :ny, :nx], "dx": ics.dx, "dy": ics.dy}


def traction_params(tractions: Estimate | ContactSolution, field: str) -> dict[str, Any]:
    """The arrays of `previous`, `initial` and contact.subsurface that are there; of a solution all must be."""
    arrays = {name: getattr(tractions, name) for name in ("pressure", "traction_x", "traction_y")}
    missing = [name for name, array in arrays.items() if array is None]
    if missing and not isinstance(tractions, Estimate):
        raise TypeError(
            f"{field} has no {', '.join(missing)}: name them in `fields` when you ask for it, or make an Estimate, in "
            "which they are zero"
        )
    return {name: array_of(array) for name, array in arrays.items() if array is not None}
