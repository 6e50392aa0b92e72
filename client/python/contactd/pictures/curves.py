"""Forces against creepages."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING

import numpy as np
import numpy.typing as npt

from ..refusals import public
from ..values.arrays import Array
from ..values.creep_curves import CreepCurve
from ..values.generated.motion import Rolling
from ..values.solution import ContactSolution
from .canvas import COLOURS, axes_or_new, bare

if TYPE_CHECKING:
    from matplotlib.axes import Axes

__all__ = ["draw_creep_curve", "plot_creep_curves"]

_CREEPAGES = {"xi": "longitudinal creepage", "eta": "lateral creepage", "phi": "spin creepage (rad/mm)"}
_STYLES = ("o-", "s--", "^:", "d-.")
_ROUNDING = 1e-9  #: Fraction of the normal force.
Solutions = Sequence[ContactSolution]


@public
def plot_creep_curves(
    solutions: Solutions | Mapping[str, Solutions],
    by: str = "xi",
    *,
    creepages: npt.ArrayLike | None = None,
    axes: Axes | None = None,
) -> Axes:
    """Plots -Fx/Fn and -Fy/Fn of rolling against a creepage, for one series of solutions or several named ones.

    `by` is "xi", "eta" or "phi" in the `motion` of the solutions. Use `creepages` for solutions without it.
    """
    if by not in _CREEPAGES:
        raise ValueError(f'by is {by!r}; it must be "xi", "eta" or "phi"')
    series = solutions if isinstance(solutions, Mapping) else {"": solutions}
    axes = axes_or_new(axes)
    for (name, one), style in zip(series.items(), _STYLES * len(series)):
        one = list(one)
        x = [_creepage(solution, by, i) for i, solution in enumerate(one)] if creepages is None else creepages
        for force, color in (("Fx", COLOURS[0]), ("Fy", COLOURS[1])):
            values = [-getattr(solution, force) / solution.Fn for solution in one]
            if any(values):
                label = f"$-F_{force[1]}/F_n${', ' + name if name else ''}"
                axes.plot(x, values, style, ms=4, mfc="none", color=color, label=label)
    axes.set(xlabel=_CREEPAGES[by], ylabel="force over normal force", title=f"Creep forces over the {_CREEPAGES[by].partition(' (')[0]}")
    bare(axes)
    axes.legend(fontsize="small", frameon=False)
    return axes


def draw_creep_curve(curve: CreepCurve, axes: Axes | None = None) -> Axes:
    """Implements CreepCurve.plot."""
    if curve.xi.ndim != 1:
        raise ValueError(f"the curve has shape {list(curve.xi.shape)}; only a curve of one dimension can be drawn")
    by = max(_CREEPAGES, key=lambda name: _extent(getattr(curve, name)))
    axes = axes_or_new(axes)
    for (force, color), style in zip((("Fx", COLOURS[0]), ("Fy", COLOURS[1])), _STYLES):
        shares = -getattr(curve, force) / curve.Fn
        if np.any(np.abs(np.nan_to_num(shares)) > _ROUNDING):
            axes.plot(getattr(curve, by), shares, style, ms=4, mfc="none", color=color, label=f"$-F_{force[1]}/F_n$")
    axes.set(xlabel=_CREEPAGES[by], ylabel="force over normal force", title=f"Creep forces over the {_CREEPAGES[by].partition(' (')[0]}")
    bare(axes)
    if axes.get_lines():
        axes.legend(fontsize="small", frameon=False)
    return axes


def _extent(values: Array) -> float:
    there = values[np.isfinite(values)]
    return float(np.ptp(there)) if there.size else 0.0


def _creepage(solution: ContactSolution, by: str, index: int) -> float:
    if not isinstance(solution.motion, Rolling):
        raise ValueError(f"solutions[{index}] has no creepage because it does not roll; give the creepages")
    value: float = getattr(solution.motion, by)
    return value
