"""Implements methods of solutions of contacts; `result` declares the fields."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from ..refusals import public
from .registry import extra
from .representation import Rows

if TYPE_CHECKING:
    import xarray
    from matplotlib.axes import Axes

__all__ = ["SolutionMethods"]


class SolutionMethods:
    """Methods of a ContactSolution."""

    @public
    def plot(self, axes: Axes | None = None) -> Axes:
        """Plots pressures on the grid, the borders of contact and adhesion, and arrows of the tractions on the upper
        body.

        Draws into `axes` or a new figure, and returns the axes. Needs matplotlib ("contactd[pictures]").
        """
        drawn: Axes = extra("ContactSolution.plot")(self, axes)
        return drawn

    @public
    def plot_section(self, y: float = 0.0, axes: Axes | None = None) -> Axes:
        """Plots pressure and tractions along x, in the row of elements nearest to `y` (mm); otherwise like `plot`."""
        drawn: Axes = extra("ContactSolution.plot_section")(self, y, axes)
        return drawn

    @public
    def to_xarray(self) -> xarray.Dataset:
        """Returns arrays against x and y, forces, pmax and the approach, with their units. Needs xarray
        ("contactd[xarray]").
        """
        dataset: xarray.Dataset = extra("ContactSolution.to_xarray")(self)
        return dataset

    def _rows(self: Any) -> Rows:
        division = f"{self.elements.contact} elements: {self.elements.adhesion} in adhesion, {self.elements.slip} in slip"
        forces: Rows = [(name, getattr(self, name)) for name in ("Fn", "Fx", "Fy", "Mz")]
        rows: Rows = [*forces, ("pmax", self.pmax), ("approach", self.approach), ("contact", division)]
        if self.motion is not None:
            rows.append(("motion", self.motion))
        return [*rows, ("converged", "yes" if self.converged else "NO")]

    def _remarks(self: Any) -> tuple[str, ...]:
        return (*self.warnings,)

    @property
    def Fn(self: Any) -> float:
        """Normal force (N), > 0 in compression."""
        return float(self.forces.Fn)

    @property
    def Fx(self: Any) -> float:
        """Tangential force along x on the upper body (N)."""
        return float(self.forces.Fx)

    @property
    def Fy(self: Any) -> float:
        """Tangential force along y on the upper body (N)."""
        return float(self.forces.Fy)

    @property
    def Mz(self: Any) -> float:
        """Moment of the tractions on the upper body about z at the origin (N mm)."""
        return float(self.forces.Mz)
