"""The potential contact area of a case of basic contact: its elements, and the undeformed distance on them."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np
import numpy.typing as npt

from ...values.generated.grid import Grid, HalfEllipses, Paraboloid
from ...values.hertz import Ellipse, Load, compliance_of, ellipse_of_axes, ellipse_of_curvatures, ellipse_of_ratio
from .distances import EXCLUDED, distance, excluded, quadratic_of

__all__ = ["PotentialContact", "ellipse_of", "potential_contact"]

Values = Mapping[str, Any]


@dataclass(frozen=True, eq=False)
class PotentialContact:
    """The grid and the gap of a case.

    Attributes:
        grid: The elements.
        gap: The undeformed distance, as for ContactProblem.
        h: The same at the element centres (mm), shape [ny, nx].
        ellipse: The ellipse of Hertzian geometries (IPOTCN < 0).
    """

    grid: Grid
    gap: Paraboloid | HalfEllipses | npt.NDArray[np.float64]
    h: npt.NDArray[np.float64]
    ellipse: Ellipse | None = None


def potential_contact(values: Values, before: Grid | None = None) -> PotentialContact:
    """Returns the area of a case with all values that apply. `before` are the elements of the step that it continues:
    their size is kept, and those of this case are shifted by whole elements.
    """
    if values["IPOTCN"] > 0:
        grid = _continued(_grid(values), before)
        return PotentialContact(grid, *_gap(values, grid))
    ellipse = ellipse_of(values)
    grid = _continued(_hertz_grid(values, ellipse), before)
    h = ellipse.a1 * grid.x[None, :] ** 2 + ellipse.b1 * grid.y[:, None] ** 2
    if values["IPOTCN"] in (-4, -5):
        h[np.abs(grid.y) > ellipse.bb, :] = EXCLUDED
        return PotentialContact(grid, h, h, ellipse)
    if values["IPOTCN"] == -6:
        return PotentialContact(grid, HalfEllipses(values["AA"], values["BNEG"], values["BPOS"]), h, ellipse)
    return PotentialContact(grid, Paraboloid(_radius(ellipse.a1), _radius(ellipse.b1)), h, ellipse)


def ellipse_of(values: Values) -> Ellipse:
    """Returns Hertz's contact under the load of the case."""
    is_force = "FN" in values
    compliance = compliance_of((values["POISS1"], values["POISS2"]), (values["GG1"], values["GG2"]))
    load = Load(values["FN" if is_force else "PEN"], is_force, compliance)
    match values["IPOTCN"]:
        case -1:
            return ellipse_of_curvatures(values["A1"], values["B1"], load)
        case -2:
            return ellipse_of_ratio(values["A1"], values["AOB"], load)
        case -3:
            return ellipse_of_axes(values["AA"], values["BB"], load)
        case -6:
            return ellipse_of_axes(values["AA"], (values["BPOS"] + values["BNEG"]) / 2, load)
        case _:
            return _line(values, load)


def _line(values: Values, load: Load) -> Ellipse:
    """A cylinder of the length 2 BB under P per length: a^2 = 4 P R/(pi E*) (Johnson, 4.2(c)); the approach is
    undefined.
    """
    squared = 4 * load.value / (2 * values["BB"]) * load.compliance / math.pi  # a^2/R
    radius = 1 / (2 * values["A1"]) if values["IPOTCN"] == -4 else values["AA"] ** 2 / squared
    return Ellipse(1 / (2 * radius), 0.0, math.sqrt(squared * radius), values["BB"], 0.0)


def _hertz_grid(values: Values, ellipse: Ellipse) -> Grid:
    nx, ny, scale = values["MX"], values["MY"], values["SCALE"]
    dx = 2 * ellipse.aa * scale / nx
    if values["IPOTCN"] in (-4, -5):
        return Grid(nx, ny, dx, 2 * ellipse.bb / _rows_of_line(ny, scale))
    return Grid(nx, ny, dx, 2 * ellipse.bb * scale / ny)


def _rows_of_line(ny: int, scale: float) -> int:
    """Returns the number of element rows on the line; the others are beyond its ends, equally on both sides."""
    if scale <= 1:
        return ny
    rows = max(1, round(ny / scale))
    return rows if (ny - rows) % 2 == 0 else rows + 1


def _grid(values: Values) -> Grid:
    nx, ny = values["MX"], values["MY"]
    match values["IPOTCN"]:
        case 1:
            return Grid(nx, ny, values["DX"], values["DY"], values["XL"], values["YL"])
        case 2:
            dx, dy = (values["XH"] - values["XL"]) / nx, (values["YH"] - values["YL"]) / ny
            return Grid(nx, ny, dx, dy, values["XL"], values["YL"])
        case 3:
            dx, dy = values["DX"], values["DY"]
        case _:
            dx = (values["XCM"] - values["XC1"]) / max(1, nx - 1)
            dy = (values["YCM"] - values["YC1"]) / max(1, ny - 1)
    return Grid(nx, ny, dx, dy, values["XC1"] - dx / 2, values["YC1"] - dy / 2)


def _gap(values: Values, grid: Grid) -> tuple[Paraboloid | npt.NDArray[np.float64], npt.NDArray[np.float64]]:
    h = distance(values, grid)
    outside = excluded(values, grid)
    if outside is not None:
        h = np.where(outside, EXCLUDED, h)
    elif values["IBASE"] == 1:
        b1, *others, b5, b6 = quadratic_of(values)
        b2, b3, b4 = others
        if b2 == b4 == b5 == b6 == 0 and (b1, b3) != (0, 0):
            return Paraboloid(_radius(b1), _radius(b3)), h
    return h, h


def _radius(curvature: float) -> float | None:
    return None if curvature == 0 else 1 / (2 * curvature)


def _continued(requested: Grid, before: Grid | None) -> Grid:
    if before is None:
        return requested
    x0, y0 = requested.x[0] - requested.dx / 2, requested.y[0] - requested.dy / 2
    old_x0, old_y0 = before.x[0] - before.dx / 2, before.y[0] - before.dy / 2
    moved_x = old_x0 + round((x0 - old_x0) / before.dx) * before.dx
    moved_y = old_y0 + round((y0 - old_y0) / before.dy) * before.dy
    return Grid(requested.nx, requested.ny, before.dx, before.dy, float(moved_x), float(moved_y))
