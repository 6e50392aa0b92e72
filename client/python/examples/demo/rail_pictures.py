"""Draws pictures familiar to railway engineers: standard profiles, contact locus, equivalent conicity, patches on their
profiles, creep forces.
"""

from __future__ import annotations

from pathlib import Path
from typing import Any

import matplotlib

matplotlib.use("Agg")

import matplotlib.pyplot as plt
import numpy as np

from contactd import Client
from contactd.standard_profiles import STANDARDS
from contactd.wheel_rail import (
    EquivalentConicity,
    Rail60E1,
    StandardName,
    StandardProfile,
    Track,
    WheelRailSetup,
    WheelRailState,
    WheelsetPosition,
    WheelsetState,
    WheelsetVelocity,
)
from contactd.wheel_rail_pictures import draw_conicity, draw_contact_locus, draw_patches, draw_profile

FZ, SPEED, RADIUS, MU = 80e3, 20e3, 460.0, 0.3  # N, mm/s, mm
INCLINATIONS = {"1/40": 1 / 40, "1/20": 1 / 20}
ROLLING = WheelsetVelocity(x=SPEED, pitch=-SPEED / RADIUS)


def draw_standards(client: Client, path: Path) -> None:
    """Draws each standard profile, and the heads of all rails in one plot."""
    figure, all_axes = plt.subplots(2, 4, figsize=(13, 5.6), layout="constrained")
    *panels, together = all_axes.flat
    for axes, (name, of) in zip(panels, STANDARDS.items(), strict=True):
        points = _points_of(client, name)
        draw_profile(axes, points)
        axes.set(xlabel="y (mm)", xlim=(-80, 65) if of.of == "wheel" else (-40, 40))
        axes.set_title(f"{name}, {of.standard}\n{of.shape}", fontsize="small")
        if of.of == "rail":
            together.plot(*points.T, lw=1, label=name)
    together.set(xlabel="y (mm)", xlim=(-38, 38), ylim=(16, -1))
    together.set_title("top of the rails, z enlarged", fontsize="small")
    together.legend(frameon=False, fontsize="x-small", loc="lower center")
    figure.savefig(path, dpi=110)


def _points_of(client: Client, name: StandardName) -> Any:
    track = Track(rail_origin=(750.0, 0.0))
    if STANDARDS[name].of == "wheel":
        return client.placed_profiles(WheelRailSetup(wheel=StandardProfile(name), track=track)).right.wheel
    return client.placed_profiles(WheelRailSetup(rail=StandardProfile(name), track=track)).right.rail


def draw_loci(client: Client, path: Path) -> None:
    figure, all_axes = plt.subplots(2, 2, figsize=(12, 6.9), sharey=True, layout="constrained")
    for row, (name, inclination) in zip(all_axes, INCLINATIONS.items(), strict=True):
        setup = WheelRailSetup(rail=Rail60E1(inclination))
        profiles, contacts = client.placed_profiles(setup), client.wheelset_contacts(setup, np.arange(-8, 8.1, 0.5))
        for axes, side in zip(row, ("left", "right"), strict=True):
            colours = draw_contact_locus(axes, profiles, contacts, side)
            middle = 750 if side == "right" else -750
            axes.set(xlim=(middle - 48, middle + 48), ylim=(23, -24), title=f"{side} wheel, rail inclined by {name}")
    figure.colorbar(colours, ax=all_axes, label="lateral shift of the wheelset, to the right (mm)", shrink=0.7)
    figure.suptitle("Contact points of S1002 on 60E1, gauge 1435 mm; wheels lifted by 12 mm")
    figure.savefig(path, dpi=110)


def draw_conicities(conicities: dict[str, list[EquivalentConicity]], path: Path) -> None:
    figure, axes = plt.subplots(figsize=(8, 4.8), layout="constrained")
    for color, (name, of_rail) in zip(("C0", "C1"), conicities.items(), strict=True):
        draw_conicity(axes, of_rail, name, color)
    axes.set(title="S1002 on 60E1, gauge 1435 mm, flange backs 1360 mm apart, $r_0$ = 460 mm", xlim=(0.8, 8.2))
    axes.set_yscale("log")
    axes.grid(True, which="both", color="0.92")
    axes.legend(frameon=False, title="inclination of the rails")
    figure.savefig(path, dpi=110)


def draw_contacts(client: Client, path: Path) -> None:
    """Draws a wheelset with free roll at three lateral shifts."""
    setup = WheelRailSetup(rail=Rail60E1(INCLINATIONS["1/20"]), dx=0.4, dy=0.4)
    profiles = client.placed_profiles(setup).right
    shifts = (0.0, 6.0, 7.0)
    figure, all_axes = plt.subplots(1, len(shifts), figsize=(13.5, 3.7), sharey=True, layout="constrained")
    for axes, shift in zip(all_axes, shifts, strict=True):
        wheelset = WheelsetState(Fz_left=FZ, Fz_right=FZ, position=WheelsetPosition(y=shift), velocity=ROLLING)
        solution = client.wheelset(setup, wheelset, fields=["pressure"])
        state = WheelRailState(position=WheelsetPosition(y=shift, roll=solution.roll))
        draw_patches(axes, profiles, state, solution.right, nominal_radius=RADIUS)
        axes.set(xlim=(705, 790), ylim=(30, -14), title=f"y = {shift:g} mm, roll {1e3 * solution.roll:.2f} mrad")
    figure.suptitle(f"S1002 on 60E1 at 1/20, right wheel, $F_z$ = {FZ / 1e3:.0f} kN; red: pressure along the normal")
    figure.savefig(path, dpi=110)


def draw_creep_forces(client: Client, path: Path) -> None:
    """Draws creep forces of the centred wheel against its pitch rate and yaw."""
    setup = WheelRailSetup(model="fastsim", dx=0.4, dy=0.4)
    slips, yaws = np.linspace(-5e-3, 5e-3, 17), np.linspace(-5e-3, 5e-3, 17)
    forces = np.array([[_creep_force(client, setup, slip, yaw) for slip in slips] for yaw in yaws]) / (MU * FZ)
    figure, all_axes = plt.subplots(1, 2, figsize=(12, 5), sharey=True, layout="constrained")
    for axes, component, name in zip(all_axes, (0, 1), ("longitudinal, $F_x$", "lateral, $F_s$"), strict=True):
        levels, values = np.linspace(-1, 1, 21), forces[..., component]
        filled = axes.contourf(1e3 * slips, 1e3 * yaws, values, levels, cmap="RdBu_r", extend="both")
        lines = axes.contour(1e3 * slips, 1e3 * yaws, values, levels[::4], colors="0.25", linewidths=0.8)
        axes.clabel(lines, fmt="%.1f", fontsize=9)
        axes.set(title=f"{name} / ($\\mu F_z$)", xlabel="rim faster than the axle travels (1e-3)")
    all_axes[0].set_ylabel("yaw of the wheelset (mrad)")
    figure.colorbar(filled, ax=all_axes, label="force on the rail / ($\\mu F_z$)")
    figure.suptitle(f"Creep forces by fastsim: S1002 on 60E1 at 1/40, centred, {FZ / 1e3:.0f} kN, $\\mu$ = {MU:g}")
    figure.savefig(path, dpi=110)


def _creep_force(client: Client, setup: WheelRailSetup, slip: float, yaw: float) -> Any:
    state = WheelRailState(
        position=WheelsetPosition(yaw=yaw),
        velocity=WheelsetVelocity(x=SPEED, pitch=-SPEED / RADIUS * (1 + slip)),
        Fz=FZ,
    )
    forces = client.wheel_rail(setup, state, fields=[]).patches[0].solution.forces
    return forces.Fx, forces.Fy
