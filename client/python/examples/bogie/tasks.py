"""Runs further tasks: a curve, the energy balance, and the search for the critical speed."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

import numpy as np
from energy import balance
from equations import Equations
from hunting import simulated, small_motions
from line import Line
from railway.motion import Array
from railway.track import Track
from railway.wheels import OnWheelset, SessionWheels
from rolling import Rolling
from runs import Integrate, Run, simulate, wheel_setups
from vehicle import bogie

from contactd import Client
from contactd.wheel_rail import WheelRailState

CURVE = Line(curvature=1 / 600e3, cant=100.0, begin=10e3, transition=40e3, length=400e3)
CURVE_SPEED, CURVE_SECONDS = 30.0, 5.0  # m/s: lateral acceleration of 0.85 m/s^2 after cant


def run_curve(client: Client, contact: str, integrate: Integrate, output: Path | None) -> Run:
    """Runs into a curve of 600 m without irregularities; prints and draws the forces on the rails."""
    run = simulate(client, contact, CURVE_SPEED, CURVE_SECONDS, integrate=integrate, line=CURVE)
    ways, forces = forces_on_rails(client, run, 300)
    for name, (left, right) in zip(("leading", "trailing"), forces[-30:].mean(axis=0).reshape(2, 2, 3) / 1000):
        print(
            f"  {name}, in the curve: left {left[1]:+.1f} kN across and {left[2]:.1f} kN down, "
            f"right {right[1]:+.1f} kN across and {right[2]:.1f} kN down"
        )
    if output is not None:
        from pictures import draw_curve

        draw_curve(run, ways, forces, output / "bogie-curve.png")
    return run


def forces_on_rails(client: Client, run: Run, count: int) -> tuple[Array, Array]:
    """Returns the forces of a run without irregularities: positions of the frame (m), and the forces of its wheels in
    track coordinates (N), shape [count, 4, 3].
    """
    found: list[list[Array]] = []
    with SessionWheels(client, wheel_setups(run.contact, bogie())) as wheels:

        def kept(states: Sequence[WheelRailState]) -> list[OnWheelset]:
            answers = wheels(states)
            found.append([-wheel.force for wheel in answers])
            return answers

        rolling = Rolling(bogie(), kept, run.line, Track())
        ways = []
        for bodies in run.states[np.linspace(0, len(run.times) - 1, count).round().astype(int)]:
            rolling(bodies)
            ways.append(run.line.way_to(bodies[2, :3], 1000 * ways[-1] if ways else 0.0) / 1000)
    return np.array(ways), np.array(found)


def tell_energy(client: Client, contact: str, speed: float, integrate: Integrate, output: Path | None) -> None:
    """Prints the energy balance of a second of straight running, from 3 mm off the middle."""
    run = simulate(client, contact, speed, 1.0, integrate=integrate, y=3.0)
    with SessionWheels(client, wheel_setups(contact, bogie())) as wheels:
        found = balance(Equations(Rolling(bogie(), wheels, run.line, Track())), run.times, run.states)
    lost = found.stored[0] - found.stored[-1]
    print(
        f"{contact:8} {speed:g} m/s: loses {lost / 1e6:.3f} kJ in {run.times[-1]:g} s, {found.damped[-1] / 1e6:.3f} kJ to "
        f"dampers, {found.to_rails[-1] / 1e6:.3f} kJ to rails; friction by slip takes {found.friction[-1] / 1e6:.3f} kJ; "
        f"missing at most {np.abs(found.error).max() / 1e3:.3g} J",
        flush=True,
    )
    if output is not None:
        from pictures import draw_energy

        draw_energy(run.times, found, output / "bogie-energy.png")


def search(
    client: Client, contacts: Sequence[str], between: tuple[float, float], seconds: float, integrate: Integrate,
    output: Path | None,
) -> None:  # fmt: skip
    """Prints critical speeds from simulations and eigenvalues. Raises ValueError if they are not between both
    speeds.
    """
    critical, curves = {}, {}
    for contact in contacts:
        critical[contact] = simulated(client, contact, *between, seconds, integrate, lambda text: print(text, flush=True))
        print(f"{contact}: critical speed {critical[contact]:.1f} m/s, from 3 mm on straight track", flush=True)
        growth = small_motions(client, contact)
        curves[contact] = [(float(speed), growth(speed).real) for speed in np.linspace(*between, 9)]
        of_small_motions = ", ".join(f"{value:+.2f}/s at {speed:g} m/s" for speed, value in curves[contact][::2])
        print(f"{contact}: small motions grow by {of_small_motions}", flush=True)
    if output is not None:
        from railway.pictures import draw_growth

        draw_growth(curves, critical, output / "bogie-critical.png")
