"""Draws the pictures of docs/bogie.md. Needs matplotlib."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np
from energy import Balance
from railway.motion import Array
from railway.pictures import COLOURS, WIDTHS
from runs import OFF_TRACK, Run

AXLES = ("leading", "trailing")


def draw_motion(runs: Sequence[Run], path: Path) -> None:
    """Plots y of both wheelsets against time: a row for each speed, a column for each wheelset."""
    speeds = sorted({run.speed for run in runs})
    figure, panels = plt.subplots(
        len(speeds), 2, figsize=(10, 2.8 * len(speeds)), squeeze=False, sharex=True, sharey="row", layout="constrained"
    )
    for row, speed in zip(panels, speeds):
        for axle, panel in enumerate(row):
            for run in (run for run in runs if run.speed == speed):
                style = {"color": COLOURS[run.contact], "lw": WIDTHS[run.contact]}
                panel.plot(run.times, run.places[:, axle], label=run.contact, **style)
                if run.derailed:
                    panel.plot(run.times[-1], run.places[-1, axle], "x", color=COLOURS[run.contact], ms=10, mew=2)
            panel.set(title=f"{speed:g} m/s, {AXLES[axle]} wheelset")
            panel.grid(alpha=0.3)
        bound = min(OFF_TRACK, max(float(np.abs(run.places).max()) for run in runs if run.speed == speed))
        row[0].set(ylabel="y (mm)", ylim=(-1.3 * bound, 1.3 * bound))
    panels[-1, 0].legend(loc="upper left", ncols=3)
    for panel in panels[-1]:
        panel.set_xlabel("time (s)")
    figure.savefig(path, dpi=110)
    plt.close(figure)


def draw_curve(run: Run, ways: Array, forces: Array, path: Path) -> None:
    """Plots curving: the line, the lateral positions of the wheelsets, and the forces of the wheels on their rails.
    `forces` are in track coordinates (N), shape [n, 4 wheels, 3], at the positions of the bogie (m), shape [n].
    """
    figure, panels = plt.subplots(3, 1, figsize=(8, 8), sharex=True, layout="constrained")
    line = run.line
    share = [line.share(1000 * way) for way in ways]
    panels[0].plot(ways, np.multiply(share, 1e6 * line.curvature), color="black", label="curvature (1/km)")
    panels[0].plot(ways, np.multiply(share, line.cant / 10), color="tab:green", label="cant (cm)")
    every = np.linspace(0, len(run.times) - 1, len(ways)).round().astype(int)
    for axle, name in enumerate(AXLES):
        panels[1].plot(ways, run.places[every, axle], label=f"{name} wheelset")
        for side, dashes in ((0, "--"), (1, "-")):
            panels[2].plot(
                ways, forces[:, 2 * axle + side, 1] / 1000, dashes, color=f"C{axle}", label=f"{name}, {('left', 'right')[side]}"
            )
    panels[1].set(ylabel="y (mm)")
    panels[2].set(ylabel="lateral force on the rail (kN)", xlabel="way of the frame (m)")
    for panel in panels:
        panel.grid(alpha=0.3)
        panel.legend(fontsize="small", ncols=2)
    figure.savefig(path, dpi=110)
    plt.close(figure)


def draw_energy(times: Array, balance: Balance, path: Path) -> None:
    """Plots the parts of the energy, and the missing energy."""
    figure, (parts, error) = plt.subplots(2, 1, figsize=(7, 5), sharex=True, height_ratios=[2, 1], layout="constrained")
    for name, values in (
        ("lost by the vehicle", balance.stored[0] - balance.stored), ("taken by dampers", balance.damped),
        ("given to rails", balance.to_rails), ("friction, by slip", balance.friction),
    ):  # fmt: skip
        parts.plot(times, values / 1e6, "--" if name == "friction, by slip" else "-", label=name)
    error.plot(times, balance.error, color="black")
    parts.set(ylabel="energy (kJ)")
    error.set(ylabel="missing (mJ)", xlabel="time (s)")
    parts.legend()
    for panel in (parts, error):
        panel.grid(alpha=0.3)
    figure.savefig(path, dpi=110)
    plt.close(figure)
