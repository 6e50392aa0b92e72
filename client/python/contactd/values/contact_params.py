"""Writes contact problems on the wire: the parameters of contact.solve and their parts in sessions, tables and
stresses."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import fields as dataclass_fields
from dataclasses import replace
from typing import Any, Literal

import numpy as np
import numpy.typing as npt

from ..errors import invalid
from ..refusals import check_either, check_type
from .arrays import array_of
from .generated.fem_ics import FemIcs
from .generated.grid import Grid
from .generated.ics import AnalyticIcs, Ics
from .generated.materials import LayeredBody, Material, RigidBody, ViscoelasticBody
from .generated.problem import ContactProblem, Estimate
from .generated.subsurface import StressBlock
from .params import fields_of, params_of
from .profiles import profile_params
from .solution import OPTIONAL_ARRAYS, ContactSolution
from .tables import TableIcs

__all__ = [
    "body_params",
    "coefficient_params",
    "ics_params",
    "layered_params",
    "opening_params",
    "problem_params",
    "subsurface_params",
    "table_params",
    "table_shape",
    "traction_params",
]


#: Fields of a ContactProblem that depend on each other on the wire, and fields that may be solutions.
_OF_BODIES = ("upper", "lower", "ics", "upper_ics", "lower_ics")
_TRACTIONS = ("initial", "previous")


def problem_params(problem: ContactProblem, fields: list[str] | None = None) -> dict[str, Any]:
    """Returns the parameters of contact.solve; `fields` are the arrays to return, None requests all."""
    params = opening_params(vars(problem))
    return params if fields is None else {**params, "fields": fields}


def opening_params(fields: Mapping[str, Any]) -> dict[str, Any]:
    """Returns the parameters of session.open: fields of a problem. Gap and load may be missing, because steps provide
    them.
    """
    given = {name: value for name, value in fields.items() if value is not None}
    others = {name: value for name, value in given.items() if name not in (*_OF_BODIES, *_TRACTIONS)}
    params = {**fields_of(ContactProblem, others), **_influence_params(given)}
    return params | {name: traction_params(given[name], name) for name in _TRACTIONS if name in given}


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
    body: Material | RigidBody | LayeredBody | ViscoelasticBody, ics: Ics | TableIcs | None, grid: Grid, both: Ics | TableIcs
) -> dict[str, Any]:
    """Returns `bodies.upper` or `bodies.lower`; `ics` is that of the body if it differs from the common one."""
    if isinstance(body, LayeredBody):
        return {"ics": layered_params(body, both if ics is None else ics)}
    params: dict[str, Any] = viscoelastic_params(body) if isinstance(body, ViscoelasticBody) else params_of(body)
    return params if ics is None else {**params, "ics": coefficient_params(ics, grid)}


def coefficient_params(ics: Ics | TableIcs, grid: Grid) -> dict[str, Any]:
    """Returns `ics` of contact.solve, for both bodies or for one."""
    if not isinstance(ics, TableIcs):
        return ics_params(ics)
    ny, nx = grid.shape
    return {"source": "table", "table": ics.array[:, :, :ny, :nx], "dx": ics.dx, "dy": ics.dy}


def traction_params(tractions: Estimate | ContactSolution, field: str) -> dict[str, Any]:
    """Returns the existing arrays for `previous`, `initial` and contact.subsurface; a solution must have all
    tractions.
    """
    names = [one.name for one in dataclass_fields(Estimate) if field == "previous" or one.name not in OPTIONAL_ARRAYS]
    arrays = {name: getattr(tractions, name, None) for name in names}
    missing = [name for name, array in arrays.items() if array is None and name not in OPTIONAL_ARRAYS]
    if missing and not isinstance(tractions, Estimate):
        raise TypeError(
            f"{field} has no {', '.join(missing)}: include them in `fields` when you request it, or use an Estimate, in " "which they are zero"
        )
    return {name: array_of(array) for name, array in arrays.items() if array is not None}


def ics_params(ics: Ics) -> dict[str, Any]:
    """Returns `ics` of ic.get, ic.export and contact.solve."""
    if isinstance(ics, AnalyticIcs) and ics.body == "layered":
        raise TypeError("the ics of layers may contain load_shape only; give the layers as a LayeredBody")
    given: dict[str, Any] = params_of(ics)
    return given if ics.section is None else {**given, "section": _section_params(ics.section)}


def _section_params(section: Mapping[str, Any]) -> Mapping[str, Any]:
    """Returns the section; the profile of a `profile_section` may be a value of contactd.wheel_rail."""
    check_type("ics.section", section, Mapping)
    inputs = section.get("profile_section")
    if not isinstance(inputs, Mapping) or "profile" not in inputs or isinstance(inputs["profile"], Mapping):
        return section
    profile = profile_params(inputs["profile"], "ics.section.profile_section.profile")
    return {**section, "profile_section": {**inputs, "profile": profile}}


def layered_params(body: LayeredBody, ics: Ics | TableIcs) -> dict[str, Any]:
    """Returns `ics` of a layered body. Layers take the load shape of the other body's coefficients, and refuse closed
    forms.
    """
    if isinstance(ics, TableIcs):
        raise TypeError("a table describes a body completely; give it with a Material instead of a LayeredBody")
    kept: dict[str, Any] = params_of(AnalyticIcs(load_shape=ics.load_shape, line_contact=getattr(ics, "line_contact", None)))
    return {**kept, **body.params()}


def viscoelastic_params(body: ViscoelasticBody) -> dict[str, Any]:
    """Returns a standard linear solid: its instantaneous material and its creep."""
    return {"G": body.G, "nu": body.nu, "viscoelastic": {"f": body.f, "tau": body.tau}}


def table_shape(grid: Grid, ics: Ics) -> tuple[int, ...]:
    """Returns the shape of one component: [ny, nx]; for a longitudinally uniform body [ny, ny, nx] (observed column,
    loaded column, x offset).
    """
    return grid.shape if ics.section is None else (grid.ny, *grid.shape)


def table_params(material: Material | LayeredBody, grid: Grid, ics: Ics) -> dict[str, Any]:
    """Returns the parameters of ic.get; the position of the grid does not affect a table."""
    check_type("material", material, Material, LayeredBody)
    check_type("grid", grid, Grid)
    check_type("ics", ics, AnalyticIcs, FemIcs)
    extent = params_of(replace(grid, x0=None, y0=None))
    if isinstance(material, LayeredBody):
        return {"grid": extent, "ics": layered_params(material, ics)}
    return {"material": params_of(material), "grid": extent, "ics": ics_params(ics)}


def subsurface_params(
    problem: ContactProblem,
    solution: ContactSolution | Estimate,
    body: Literal["lower", "upper"],
    points: npt.ArrayLike | None,
    block: StressBlock | None,
    nu: float | None,
) -> tuple[dict[str, Any], tuple[int, ...]]:
    """Returns the parameters of contact.subsurface and the shape of its stresses."""
    tractions = traction_params(solution, "solution")
    if "pressure" not in tractions:
        raise invalid("pressure", "is missing; it must be that of a solution")
    params = {"grid": params_of(problem.grid), **_ics_of(problem, body), "body": body, **tractions}
    if nu is not None and isinstance(_material_of(problem, body), LayeredBody):
        raise invalid("nu", f"is {nu}, but body {body!r} has layers with their own values; remove it")
    params["nu"] = _nu_of(problem, body) if nu is None else nu
    if problem.columns is not None:  # Angles are those of normals, from z towards y.
        angles = np.asarray(problem.columns.frames, dtype=np.float64)[:, 2]
        params["angles"] = [float(angle) for angle in (angles if body == "upper" else 0.0 - angles)]
    check_either("Client.subsurface", "points or block", points=points, block=block)
    if block is not None:
        check_type("block", block, StressBlock)
        axes = {name: np.atleast_1d(array_of(getattr(block, name))) for name in "xyz"}
        for name, values in axes.items():
            if values.ndim != 1:
                raise invalid(f"block.{name}", f"has shape {list(values.shape)}; it must be one axis", "ARRAY_INVALID")
        return {**params, "block": axes}, block.shape
    array = array_of(points)
    if array.ndim != 2 or array.shape[1] != 3:
        raise invalid("points", f"has shape {list(array.shape)}; it must be [n, 3]", "ARRAY_INVALID")
    return {**params, "points": array}, array.shape[:1]


def shear_modulus_of(problem: ContactProblem, body: Literal["lower", "upper"]) -> float:
    """Returns the shear modulus of a half-space, for which displacements are available."""
    material = _material_of(problem, body)
    if isinstance(material, ViscoelasticBody):
        raise invalid(
            "displacements", f"are requested, but body {body!r} is viscoelastic, for which only stresses are available below the surface"
        )
    if not isinstance(material, Material):
        raise invalid("displacements", f"are requested, but body {body!r} is not a half-space, so its displacements are not available")
    return material.G


def _ics_of(problem: ContactProblem, body: str) -> dict[str, Any]:
    """Returns the parts of `ics` that identify bodies other than half-spaces."""
    own = problem.upper_ics if body == "upper" else problem.lower_ics
    name, ics = ("ics", problem.ics) if own is None else (f"{body}_ics", own)
    if problem.model not in (None, "full"):  # simplified models use the theory of half-spaces
        line = getattr(ics, "line_contact", None)
        return {} if line is None else {"ics": params_of(AnalyticIcs(line_contact=line))}
    if isinstance(ics, TableIcs):
        raise invalid(
            name,
            "is a table, which may be that of any body, but the closed form of the stresses is that of the " "half-space. If it is one, use problem.replace(ics=AnalyticIcs(), upper=..., lower=...)",
        )
    material = _material_of(problem, body)
    params = layered_params(material, ics) if isinstance(material, LayeredBody) else ics_params(ics)
    return {} if params == params_of(AnalyticIcs()) else {"ics": params}


def _material_of(problem: ContactProblem, body: str) -> Material | RigidBody | LayeredBody | ViscoelasticBody | None:
    return problem.upper if body == "upper" or problem.lower is None else problem.lower


def _nu_of(problem: ContactProblem, body: Literal["lower", "upper"]) -> float:
    if body not in ("lower", "upper"):
        raise invalid("body", f'is {body!r}; it must be "lower" or "upper"')
    material = _material_of(problem, body)
    if isinstance(material, RigidBody):
        raise invalid("body", f"is {body!r}, which is rigid; only an elastic body has stresses")
    assert material is not None  # only with a table, which is refused
    return material.layers[0].nu if isinstance(material, LayeredBody) else material.nu
