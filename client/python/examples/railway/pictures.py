"""Draws common pictures of the wheel-rail examples. Needs matplotlib."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np

COLOURS = {"linear": "tab:orange", "fastsim": "tab:blue", "full": "black"}
WIDTHS = {"linear": 1.0, "fastsim": 2.2, "full": 1.0}


def draw_growth(curves: Mapping[str, Sequence[tuple[float, float]]], critical: Mapping[str, float], path: Path) -> None:
    """Plots the growth (1/s) of small motions against the speed (m/s) from eigenvalues, and critical speeds from
    simulations.
    """
    figure, panel = plt.subplots(figsize=(6.5, 3.8), layout="constrained")
    for contact, curve in curves.items():
        style: dict[str, Any] = {"color": COLOURS[contact], "lw": WIDTHS[contact]}
        panel.plot(*np.transpose(curve), marker=".", label=f"{contact}, small motions", **style)
        if contact in critical:
            panel.axvline(critical[contact], ls="--", label=f"{contact}, simulated: {critical[contact]:.1f} m/s", **style)
    panel.axhline(0, color="0.4", lw=0.8)
    panel.set(xlabel="speed (m/s)", ylabel="growth of hunting (1/s)")
    panel.grid(alpha=0.3)
    panel.legend(fontsize="small")
    figure.savefig(path, dpi=110)
    plt.close(figure)
