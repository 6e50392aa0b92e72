"""Pictures of answers, by matplotlib, which is imported when the first one is drawn: ``pip install "contactd[pictures]"``.

`ContactSolution.plot`, `IcTable.plot`, `SubsurfaceStress.plot` and `WheelRailSolution.plot` draw one answer. Here are those of
several::

    from contactd.pictures import ConvergenceHistory, plot_creep_curves

    plot_creep_curves({"full": solutions, "fastsim": quick}).figure.savefig("creep.png")

    history = ConvergenceHistory()
    client.get_ic(material, grid, FemIcs(), on_progress=history)
    history.plot()

Each returns the Axes, or the Figure where there are several; `axes` draws into axes of your own.
"""

from __future__ import annotations

from .curves import plot_creep_curves
from .history import ConvergenceHistory

__all__ = ["ConvergenceHistory", "plot_creep_curves"]
