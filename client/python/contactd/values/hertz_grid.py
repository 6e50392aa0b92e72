"""Computes default grids from the ellipse of Hertz's contact, corrected once from the computed contact."""

from __future__ import annotations

import math
from collections.abc import Mapping
from numbers import Real
from typing import Any

from .generated.grid import Grid, Paraboloid, SemiAxes
from .generated.ics import AnalyticIcs
from .generated.materials import Material, RigidBody, ViscoelasticBody
from .hertz import Ellipse, Load, ellipse_of_curvatures
from .solution import ContactSolution

__all__ = ["corrected_grid", "grid_of"]

ACROSS = 32  #: Number of elements across the ellipse in each direction.
MARGIN = 1.25  #: Size of the grid relative to the ellipse.
_SIDE = round(ACROSS * MARGIN)
_EXPECTED = math.pi / 4 * ACROSS**2  #: Number of elements inside the ellipse.
_LARGER = 2.0
_FEWEST = 0.25  #: Fraction of the expected elements below which the grid is too coarse.
_ARRAYS = ("columns", "previous", "initial", "upper_ics", "lower_ics", "regions")
_NO_CONTACT = Grid.centred(_SIDE, _SIDE, 1.0, 1.0)  #: Semi-axis for invalid loads and bodies, or without contact.


def grid_of(fields: Mapping[str, Any]) -> Grid:
    """Returns the grid for the fields of a ContactProblem: 40 x 40 elements, 32 across the ellipse each way.

    Invalid values get an arbitrary grid, so that the daemon can refuse them by name. Raises TypeError if the ellipse of
    the contact is unknown.
    """
    if why := _why_unknown(fields):
        raise TypeError(f"grid is missing: {why}, so no grid can be chosen. Give grid=Grid.centred(nx, ny, width, height).")
    axes = _semi_axes(fields)
    if axes is None or not all(_is_positive(axis) for axis in axes):
        return _NO_CONTACT
    return Grid.centred(_SIDE, _SIDE, *(2 * MARGIN * axis for axis in axes))


def corrected_grid(grid: Grid, solution: ContactSolution) -> Grid | None:
    """Returns a better grid: a larger one if the contact reaches the border, a smaller one if the contact has few
    elements; None if the grid is adequate.
    """
    counts = solution.elements
    if counts.border:
        size, elements = _LARGER, round(_SIDE * 1.5)
    elif 0 < counts.contact < _FEWEST * _EXPECTED:
        size, elements = 1.5 * math.sqrt(counts.contact / _EXPECTED), _SIDE
    else:
        return None
    return Grid.centred(elements, elements, size * grid.nx * grid.dx, size * grid.ny * grid.dy)


def _why_unknown(fields: Mapping[str, Any]) -> str:
    """Returns the reason why the ellipse is unknown; empty if it is known."""
    gap, ics = fields.get("gap"), fields.get("ics", AnalyticIcs())
    if not isinstance(gap, Paraboloid | SemiAxes):
        return "gap is neither a Paraboloid nor SemiAxes"
    if isinstance(gap, Paraboloid) and (gap.Rx is None or gap.Ry is None):
        return f"gap.{'Rx' if gap.Rx is None else 'Ry'} is None, and a flat direction has no contact ellipse"
    if isinstance(gap, Paraboloid) and any(_is_number(radius) and radius < 0 for radius in vars(gap).values()):
        return "gap has a negative radius, and a saddle has no contact ellipse"
    if not isinstance(ics, AnalyticIcs) or ics.line_contact is not None or ics.section is not None:
        return "ics is not that of half-spaces in closed form"
    for body in ("upper", "lower"):
        if not isinstance(fields.get(body), Material | RigidBody | ViscoelasticBody | None):
            return f"{body} is a {type(fields[body]).__name__}, not a half-space"
    named = [name for name in _ARRAYS if fields.get(name) is not None]
    return f"{named[0]} is given for the elements of a grid" if named else ""


def _semi_axes(fields: Mapping[str, Any]) -> tuple[float, float] | None:
    gap: Any = fields["gap"]
    if isinstance(gap, SemiAxes):
        return (gap.a, gap.b) if _is_positive(gap.a) and _is_positive(gap.b) else None
    force, approach = fields.get("Fn"), fields.get("approach")
    load: Any = approach if force is None else force
    upper = fields.get("upper")
    lower = fields.get("lower")
    compliance = _compliance_of(upper) + _compliance_of(upper if lower is None else lower)
    numbers = (gap.Rx, gap.Ry, load, compliance)
    if not all(_is_positive(value) for value in numbers):
        return None
    try:
        found: Ellipse = ellipse_of_curvatures(0.5 / gap.Rx, 0.5 / gap.Ry, Load(load, force is not None, compliance))
    except (ArithmeticError, ValueError):
        return None
    return found.aa, found.bb


def _compliance_of(body: Any) -> float:
    """Returns (1 - nu)/(2 G) (mm^2/N), the long-term value of a viscoelastic body; 0 for a rigid body, NaN for invalid
    values.
    """
    if not isinstance(body, Material | ViscoelasticBody):
        return 0.0
    if not all(_is_number(value) for value in vars(body).values()) or body.G <= 0:
        return math.nan
    creep = 1 + body.f if isinstance(body, ViscoelasticBody) else 1.0
    return float(creep * (1 - body.nu) / (2 * body.G))


def _is_positive(value: Any) -> bool:
    return _is_number(value) and math.isfinite(value) and value > 0


def _is_number(value: Any) -> bool:
    return isinstance(value, Real) and not isinstance(value, bool)
