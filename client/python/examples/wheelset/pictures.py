"""Draws the pictures of docs/wheelset.md. Needs matplotlib."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np
from railway.pictures import COLOURS, WIDTHS
from railway.track import Track
from runs import Run


def draw_motion(runs: Sequence[Run], track: Track, path: Path) -> None:
    """Plots y of the wheelset against time, with a panel for each speed."""
    speeds = sorted({run.speed for run in runs})
    figure, panels = plt.subplots(len(speeds), 1, figsize=(8, 3.0 * len(speeds)), squeeze=False, layout="constrained")
    for panel, speed in zip(panels[:, 0], speeds):
        shown = [run for run in runs if run.speed == speed]
        times = max((run.times for run in shown), key=len)
        rails = [track.deviation("right", 1000 * speed * time)[0] for time in times]
        panel.plot(times, rails, color="0.6", label="track")
        for run in shown:
            panel.plot(run.times, run.y, color=COLOURS[run.contact], lw=WIDTHS[run.contact], label=run.contact)
            if run.derailed:
                panel.plot(run.times[-1], run.y[-1], "x", color=COLOURS[run.contact], ms=10, mew=2)
        bound = max(float(np.abs(run.y).max()) for run in shown if run.contact != "linear" or len(shown) == 1)
        panel.set(title=f"{speed:g} m/s", ylabel="y (mm)", xlim=(0, times[-1]), ylim=(-1.3 * bound, 1.3 * bound))
        panel.grid(alpha=0.3)
    panels[0, 0].legend(loc="upper right", ncols=4)
    panels[-1, 0].set_xlabel("time (s)")
    figure.savefig(path, dpi=110)
    plt.close(figure)
