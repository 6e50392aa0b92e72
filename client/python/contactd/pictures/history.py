"""Residuals of iterations."""

from __future__ import annotations

from typing import TYPE_CHECKING

from ..values.generated.service import Progress
from .canvas import COLOURS, axes_or_new, bare

if TYPE_CHECKING:
    from matplotlib.axes import Axes

__all__ = ["ConvergenceHistory"]


class ConvergenceHistory:
    """Records the residuals reported during a call; pass it as `on_progress`.

    Attributes:
        stages: The runs of each stage, such as one for each load case: reported pairs (iteration, residual).
    """

    def __init__(self) -> None:
        self.stages: dict[str, list[list[tuple[int, float]]]] = {}

    def __call__(self, progress: Progress) -> None:
        """Records one report."""
        if not (progress.iteration and progress.residual > 0):
            return
        runs = self.stages.setdefault(progress.stage, [])
        if not runs or progress.iteration < runs[-1][-1][0]:
            runs.append([])
        if not runs[-1] or progress.iteration > runs[-1][-1][0]:
            runs[-1].append((progress.iteration, progress.residual))

    def plot(self, axes: Axes | None = None) -> Axes:
        """Plots residuals against iterations, one line per stage."""
        axes = axes_or_new(axes)
        for (stage, runs), color in zip(self.stages.items(), [*COLOURS] * (len(self.stages) + 1)):
            for number, run in enumerate(runs):
                axes.plot(*zip(*run), "o-", ms=3, color=color, label=None if number else stage, alpha=0.9)
        axes.set(xlabel="iteration", ylabel="relative residual", yscale="log", title="Convergence")
        bare(axes)
        if self.stages:
            axes.legend(fontsize="small", frameon=False)
        return axes
