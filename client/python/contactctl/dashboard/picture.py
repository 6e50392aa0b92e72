"""The picture of a solve: pressures, and the borders of contact and adhesion."""

from __future__ import annotations

import base64
import io
from collections.abc import Sequence

import numpy as np
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.figure import Figure

from contactd import RecentPatch
from contactd.pictures.canvas import ADHESION, INK, edges, legend_below, map_over

__all__ = ["picture_of"]


def picture_of(patches: Sequence[RecentPatch]) -> str:
    """Returns a PNG as a data URL, with patches side by side, from the right to the left of the rail."""
    figure = Figure(figsize=(5.6 * len(patches), 4.6), layout="constrained")
    FigureCanvasAgg(figure)
    for axes, patch in zip(figure.subplots(1, len(patches), squeeze=False)[0], patches):
        map_over(axes, patch.grid, np.ma.masked_equal(patch.pressure, 0), "pressure (N/mm$^2$)")
        contact, adhesion = patch.element_division != 0, patch.element_division == 1
        axes.add_collection(edges(contact, patch.grid, color=INK, linewidth=0.9, label="edge of contact"))
        if adhesion.any():
            axes.add_collection(edges(adhesion, patch.grid, color=ADHESION, linewidth=2.0, label="edge of adhesion"))
        legend_below(axes, ncols=2)
    content = io.BytesIO()
    figure.savefig(content, format="png", dpi=90)
    return "data:image/png;base64," + base64.b64encode(content.getvalue()).decode()
