"""Plots a measured creep curve and the fitted one."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from ..values.fit import Fit
from .canvas import COLOURS, axes_or_new, bare

if TYPE_CHECKING:
    from matplotlib.axes import Axes

__all__ = ["draw_fit"]

_CREEPAGES = {"xi": "longitudinal creepage", "eta": "lateral creepage", "phi": "spin creepage (rad/mm)"}


def draw_fit(fit: Fit, axes: Axes | None = None) -> Axes:
    """Implements Fit.plot."""
    axes = axes_or_new(axes)
    curve = fit.curve
    if curve is not None:
        if np.all(np.isfinite(curve.low)):
            label = f"{100 * fit.confidence:g} % confidence"
            axes.fill_between(curve.creepage, curve.low, curve.high, color=COLOURS[0], alpha=0.18, lw=0, label=label)
        axes.plot(curve.creepage, curve.value, color=COLOURS[0], label="fitted")
    else:
        order = np.argsort(fit.creepage)
        axes.plot(fit.creepage[order], fit.computed[order], color=COLOURS[0], label="fitted")
    axes.plot(fit.creepage, fit.measured, "o", ms=4, color=COLOURS[1], label="measured")
    name = fit.by.rpartition(".")[2]
    axes.set(
        xlabel=_CREEPAGES.get(name, fit.by), ylabel="coefficient of traction" if fit.quantity == "coefficient" else "force (N)",
        title="" if fit.converged else "NOT CONVERGED",
    )  # fmt: skip
    bare(axes)
    axes.legend(fontsize="small", frameon=False)
    return axes
