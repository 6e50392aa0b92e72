"""Moves a wheelset across the track: both wheels, compared with the Manchester contact benchmark."""

from __future__ import annotations

import time
from pathlib import Path

from manchester import FZ, KNOWN, MU, POSITIONS, SETUPS, Known, state_at
from terminal import ProgressBar, say, section, styled, table
from wheelrail_picture import draw_wheelset

from contactd import Client, Progress
from contactd.wheel_rail import WheelRailSolution

Check = tuple[bool, str]
Sweep = dict[str, list[WheelRailSolution]]


def show_wheelset(client: Client, output: Path) -> list[Check]:
    section(
        2,
        "A wheelset across the track",
        "The Manchester contact benchmark, case A-2.2: S1002 wheels on 60E1 rails at 1/40, gauge 1435 mm,",
        f"{FZ / 1000:g} kN a wheel, mu = {MU}, elements of 0.2 x 0.2 mm. The wheelset moves to the right and yaws",
        "by 2.4 mrad/mm. Brackets contain results of an established program. Forces act on the rails.",
    )
    start = time.perf_counter()
    sweep = solved(client)
    seconds = time.perf_counter() - start
    for side, solutions in sweep.items():
        show_wheel(side, solutions)
    say(f"{2 * len(POSITIONS)} wheels, each at the height of its force, in {seconds:.1f} s.")
    draw_wheelset(output, sweep)
    say(f"The picture: {styled(str(output), 'bold')}")
    return comparison(sweep)


def solved(client: Client) -> Sweep:
    sweep: Sweep = {side: [] for side in SETUPS}
    with ProgressBar() as progress:
        for count, (y, roll, pitch) in enumerate(POSITIONS):
            progress(Progress(f"both wheels at y = {y:g} mm", count / len(POSITIONS)))
            for side, setup in SETUPS.items():
                sweep[side].append(client.wheel_rail(setup, state_at(y, roll, pitch)))
    return sweep


def show_wheel(side: str, solutions: list[WheelRailSolution]) -> None:
    body = []
    for (y, _, _), solution, known in zip(POSITIONS, solutions, KNOWN[side], strict=True):
        found = figures_of(solution)
        body.append([f"{y:g}", *(f"{getattr(found, n):.{d}f} ({getattr(known, n):.{d}f})" for n, d in DIGITS)])
    table([f"{side}: y (mm)", "z (mm)", "Fx (N)", "Fy (N)", "contact y (mm)", "angle (rad)", "pmax"], body)
    say()


DIGITS = [("z", 3), ("Fx", 0), ("Fy", 0), ("y_contact", 2), ("angle", 4), ("pmax", 0)]


def figures_of(solution: WheelRailSolution) -> Known:
    """Returns the printed quantities for the first patch, which is the only one in these positions."""
    patch, track = solution.patches[0], solution.forces.track
    at = patch.place.reference
    return Known(solution.z, track.Fx, track.Fy, at.y, at.angle, patch.solution.forces.Fn, patch.solution.pmax)


def comparison(sweep: Sweep) -> list[Check]:
    """Returns the largest differences, and the bounds due to exact surfaces and printed digits."""
    pairs = [
        (figures_of(solution), known)
        for side, solutions in sweep.items()
        for solution, known in zip(solutions, KNOWN[side], strict=True)
    ]

    def check(name: str, bound: float, differences: list[float]) -> Check:
        largest = max(differences)
        return largest <= bound, f"{name:42} {largest:8.1e}, at most {bound:g}"

    converged = all(solution.converged for solutions in sweep.values() for solution in solutions)
    return [
        check("height of the wheelset (mm)", 1e-3, [abs(a.z - b.z) for a, b in pairs]),
        check("Fn, relative", 1e-3, [abs(a.Fn / b.Fn - 1) for a, b in pairs]),
        check("Fx, of mu Fn", 1e-3, [abs(a.Fx - b.Fx) / (MU * b.Fn) for a, b in pairs]),
        check("Fy, of Fn", 1e-3, [abs(a.Fy - b.Fy) / b.Fn for a, b in pairs]),
        check("place of the contact (mm)", 1e-2, [abs(a.y_contact - b.y_contact) for a, b in pairs]),
        check("contact angle (rad)", 2e-4, [abs(a.angle - b.angle) for a, b in pairs]),
        check("largest pressure, relative", 4e-3, [abs(a.pmax / b.pmax - 1) for a, b in pairs]),
        (converged, f"{'solvers converged':42} {converged!s:>8}"),
    ]
