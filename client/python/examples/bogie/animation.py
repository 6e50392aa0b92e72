"""Draws the moving bogie from above as a GIF. Needs matplotlib and Pillow."""

from __future__ import annotations

from pathlib import Path

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np
from matplotlib.animation import FuncAnimation, PillowWriter
from railway.motion import Array
from rolling import PLACE, YAW
from runs import Run

STRETCH = 30.0  # scale of lengths across the track
SLOWER = 8.0  # than in truth
PICTURES = 12  # a second
HALF_GAUGE, HALF_AXLE, WHEEL = 750.0, 900.0, 460.0  # mm
FRAME = np.array([(1300, -500), (1300, 500), (-1300, 500), (-1300, -500), (1300, -500)])


def animate(run: Run, path: Path) -> None:
    """Draws the bogie from above, with forwards to the right; lateral motions are magnified by STRETCH."""
    every = max(1, round(1 / (SLOWER * PICTURES * float(run.times[1] - run.times[0]))))
    frames = range(0, len(run.times), every)
    figure, (above, over_time) = plt.subplots(2, 1, figsize=(6.4, 5.2), height_ratios=[3, 2], layout="constrained")
    for side in (-1, 1):
        above.axhline(side * HALF_GAUGE, color="0.6", lw=4)
    above.set(xlim=(-2200, 2200), ylim=(1250, -1250), xticks=[], yticks=[], title=f"{run.speed:g} m/s, {run.contact}")
    above.set_ylabel(f"across the track, x {STRETCH:g}")
    shapes = [above.plot([], [], color=colour, lw=width)[0] for colour, width in (("C0", 2), ("C1", 2), ("0.2", 1.5))]
    wheels = [above.plot([], [], color=f"C{axle}", lw=7, solid_capstyle="butt")[0] for axle in (0, 0, 1, 1)]
    for axle, name in enumerate(("leading", "trailing")):
        over_time.plot(run.times, run.places[:, axle], label=f"{name} wheelset")
    over_time.set(xlabel="time (s)", ylabel="y (mm)")
    over_time.legend(loc="lower left", ncols=2)
    over_time.grid(alpha=0.3)
    now = over_time.axvline(0, color="black")

    figure.draw_without_rendering()
    figure.set_layout_engine("none")  # done once, because it takes most of the time

    def draw(number: int) -> None:
        middle = run.states[number, 2, PLACE][:2]
        for axle in (0, 1):
            x, y, yaw = _place(run, number, axle, middle)
            across = np.array([-yaw * STRETCH, 1.0])
            ends = [np.array([x, y * STRETCH]) + side * HALF_AXLE * across for side in (-1, 1)]
            shapes[axle].set_data(*np.transpose(ends))
            for side in (0, 1):
                centre = np.array([x, y * STRETCH]) + (2 * side - 1) * HALF_GAUGE * across
                along = np.array([1.0, yaw * STRETCH])
                wheels[2 * axle + side].set_data(*np.transpose([centre - WHEEL * along / 2, centre + WHEEL * along / 2]))
        x, y, yaw = _place(run, number, 2, middle)
        shapes[2].set_data(FRAME[:, 0] - yaw * STRETCH * FRAME[:, 1], y * STRETCH + FRAME[:, 1] + yaw * STRETCH * FRAME[:, 0])
        now.set_xdata([run.times[number]] * 2)

    FuncAnimation(figure, draw, frames=frames, blit=False).save(path, PillowWriter(fps=PICTURES), dpi=70)
    plt.close(figure)


def _place(run: Run, number: int, body: int, middle: Array) -> tuple[float, float, float]:
    """Returns the position in front of the frame, across the track (mm), and the yaw (rad), on straight track."""
    x, y, _ = run.states[number, body, PLACE]
    return x - middle[0], y, run.states[number, body, YAW]
