"""Stresses inside the bodies: what `Client.subsurface` takes and answers."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, Literal

import numpy as np
import numpy.typing as npt

from ..files.saved import Saved
from ..refusals import check_type
from ..transport.frames import array_of, invalid, plain
from .contact_params import traction_params
from .grid import Array
from .ics import ics_params, layered_params
from .materials import LayeredBody, Material, RigidBody
from .problem import ContactProblem, Estimate
from .representation import Rows, Shown
from .solution import ContactSolution
from .table_ics import TableIcs

if TYPE_CHECKING:
    import xarray
    from matplotlib.axes import Axes

    from ..pictures.stresses import Component

__all__ = ["LargestStress", "StressBlock", "SubsurfaceStress"]


@dataclass(frozen=True, eq=False)
class StressBlock:
    """The points (x, y, z) with each of `x`, each of `y` and each of `z` (mm), in any order; a number stands for one.

    Costs less than as many points where coordinates are whole elements apart: ``StressBlock(grid.x, grid.y, z)``.

    Attributes:
        x: Places along x (mm).
        y: Places along y (mm).
        z: Places along z (mm), <= 0 inside the body, for the upper one too.
    """

    x: npt.ArrayLike
    y: npt.ArrayLike
    z: npt.ArrayLike

    @property
    def shape(self) -> tuple[int, int, int]:
        """Shape of the stresses: (nz, ny, nx)."""
        return (np.size(self.z), np.size(self.y), np.size(self.x))


@dataclass(frozen=True)
class LargestStress:
    """The place of the largest von Mises stress among the points asked for.

    Attributes:
        von_mises: N/mm^2.
        x: Mm.
        y: Mm.
        z: Mm, <= 0.
        depth: -z (mm).
    """

    von_mises: float
    x: float
    y: float
    z: float
    depth: float


@dataclass(frozen=True, eq=False, repr=False)
class SubsurfaceStress(Saved, Shown):
    """Stresses inside a body (N/mm^2), tension positive: read-only arrays of shape [n], of a block [nz, ny, nx].

    They are in the frame of the body, in which it is z <= 0 and x and y are those of the grid. The frame of the lower
    body is that of the contact problem; that of the upper one is its mirror image, so that xz and yz of the upper body
    change sign on the way to the frame of the problem.

    Attributes:
        xx: Normal stress along x.
        yy: Normal stress along y.
        zz: Normal stress along z.
        xy: Shear stress.
        xz: Shear stress.
        yz: Shear stress.
        von_mises: Von Mises' equivalent stress.
        largest: Where that is largest; the first place of equals.
        block: Where they are, which the client adds; None of single points.
        points: Where they are, shape [n, 3] (mm); None of a block.
    """

    xx: Array
    yy: Array
    zz: Array
    xy: Array
    xz: Array
    yz: Array
    von_mises: Array
    largest: LargestStress
    block: StressBlock | None = None
    points: Array | None = None

    def plot(
        self,
        component: Component = "von_mises",
        *,
        x: float | None = None,
        y: float | None = None,
        z: float | None = None,
        axes: Axes | None = None,
    ) -> Axes:
        """Draws a stress on a plane through a block, such as that at `y` (mm; the nearest points count), or on a line.

        Left out, the plane is that with the largest von Mises stress. Into `axes`, or a figure of its own; returns the axes.
        Needs matplotlib ("contactd[pictures]").
        """
        from ..pictures.stresses import draw_stress

        return draw_stress(self, component, x=x, y=y, z=z, axes=axes)

    def to_xarray(self) -> xarray.Dataset:
        """Stresses over x, y and z of a block, or over points. Needs xarray ("contactd[xarray]")."""
        from ..xarray_datasets import labelled_stress

        return labelled_stress(self)

    def _title(self) -> str:
        return f"SubsurfaceStress at {self.von_mises.size} points"

    def _rows(self) -> Rows:
        at = self.largest
        return [("largest von Mises", at.von_mises), ("at x", at.x), ("y", at.y), ("z", at.z)]


def subsurface_params(
    problem: ContactProblem,
    solution: ContactSolution | Estimate,
    body: Literal["lower", "upper"],
    points: npt.ArrayLike | None,
    block: StressBlock | None,
    nu: float | None,
) -> tuple[dict[str, Any], tuple[int, ...]]:
    """The parameters of contact.subsurface and the shape of its stresses."""
    tractions = traction_params(solution, "solution")
    if "pressure" not in tractions:
        raise invalid("pressure", "is missing; it must be that of a solution")
    params = {"grid": plain(problem.grid), **_ics(problem, body), "body": body, **tractions}
    if nu is not None and isinstance(_material(problem, body), LayeredBody):
        raise invalid("nu", f"is {nu}, and body {body!r} has layers; layers have their own")
    params["nu"] = _nu(problem, body) if nu is None else nu
    if (points is None) == (block is None):
        raise TypeError("subsurface() takes either points or block")
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


def _ics(problem: ContactProblem, body: str) -> dict[str, Any]:
    """What tells the daemon of bodies that are no half-spaces."""
    if problem.columns is not None:
        raise invalid(
            "columns",
            "are curved; the closed form of the stresses is that of the half-space, under a plane, and says nothing of "
            "what is below them",
        )
    own = problem.upper_ics if body == "upper" else problem.lower_ics
    name, ics = ("ics", problem.ics) if own is None else (f"{body}_ics", own)
    if problem.model not in (None, "full"):  # of half-spaces by their theory
        line = getattr(ics, "line_contact", None)
        return {} if line is None else {"ics": {"source": "analytic", "line_contact": plain(line)}}
    if isinstance(ics, TableIcs):
        raise invalid(
            name,
            "is a table of one's own, which may be of any body; the closed form of the stresses is that of the "
            "half-space. If it is one, ask with problem.replace(ics=AnalyticIcs(), upper=..., lower=...)",
        )
    material = _material(problem, body)
    params = layered_params(material, ics) if isinstance(material, LayeredBody) else ics_params(ics)
    return {} if params == {"source": "analytic"} else {"ics": params}


def _material(problem: ContactProblem, body: str) -> Material | RigidBody | LayeredBody | None:
    return problem.upper if body == "upper" or problem.lower is None else problem.lower


def _nu(problem: ContactProblem, body: Literal["lower", "upper"]) -> float:
    if body not in ("lower", "upper"):
        raise invalid("body", f'is {body!r}; it must be "lower" or "upper"')
    material = _material(problem, body)
    if isinstance(material, RigidBody):
        raise invalid("body", f"is {body!r}, which is rigid; only an elastic body has stresses to be computed")
    assert material is not None  # only with a table, which is refused
    return material.layers[0].nu if isinstance(material, LayeredBody) else material.nu
