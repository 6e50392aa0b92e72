"""Plots of answers. Matplotlib is imported for the first plot: ``pip install "contactd[pictures]"``.

`ContactSolution.plot`, `IcTable.plot`, `SubsurfaceStress.plot` and `WheelRailSolution.plot` draw one answer. This
package draws several::

    from contactd.pictures import ConvergenceHistory, plot_creep_curves

    plot_creep_curves({"full": solutions, "fastsim": quick}).figure.savefig("creep.png")

    history = ConvergenceHistory()
    client.get_ic(material, grid, FemIcs(), on_progress=history)
    history.plot()

Each function returns the Axes, or the Figure if there are several Axes. Use `axes` to draw into your own.
"""

from __future__ import annotations

from .curves import plot_creep_curves
from .history import ConvergenceHistory

__all__ = ["ConvergenceHistory", "plot_creep_curves"]
