"""Simulates hunting of a railway wheelset: a multibody model with S1002 wheels on 60E1 rails by contactd. See
docs/wheelset.md.

Run: python3 client/python/examples/wheelset [--endpoint ENDPOINT] [--integrator runge-kutta] [--output FOLDER] ...

Without an endpoint it starts its own daemon (`contactd` on PATH). It needs Exudyn and matplotlib: pip install
'./client/python[wheelset]'. --integrator runge-kutta does not need Exudyn. Without --output it does not need
matplotlib.
"""

from __future__ import annotations

import argparse
import math
import sys
from contextlib import ExitStack
from pathlib import Path

sys.path.append(str(Path(__file__).parents[1]))  # for railway, which the examples share

from contact import WheelRailContact
from railway.stability import critical_speed, growth_of_swing
from railway.track import IrregularTrack
from railway.wheels import SETUPS
from runge_kutta import Wheelset
from runs import Integrate, Run, simulate
from stability import hunting
from vehicle import Vehicle

from contactd import Client, LocalDaemon

DISTURBANCE = 3.0  # mm, initial displacement in the search for the critical speed


def main() -> None:
    options = _options()
    integrate = _integrator(options.integrator)
    if options.output is not None:
        _need("matplotlib")
    with ExitStack() as stack:
        endpoint = options.endpoint or stack.enter_context(LocalDaemon()).endpoint
        client = stack.enter_context(Client(endpoint))
        track = IrregularTrack(seed=options.seed)
        runs = []
        for speed in options.speeds:
            for contact in options.contacts:
                run = simulate(client, contact, speed, options.seconds, integrate=integrate, track=track)
                runs.append(run)
                _tell(run)
        _compare(runs)
        if runs and options.output is not None:
            from pictures import draw_motion

            draw_motion(runs, track, options.output / "wheelset-hunting.png")
        if options.search:
            try:
                _search(client, options, integrate)
            except ValueError as error:
                raise SystemExit(f"--search: {error}") from None


def _search(client: Client, options: argparse.Namespace, integrate: Integrate) -> None:
    """Prints the critical speed of each contact from simulations, and the growth of small motions from eigenvalues."""
    low, high = options.search
    critical = {}
    for contact in options.contacts:

        def growth(speed: float, contact: str = contact) -> float:
            run = simulate(client, contact, speed, options.seconds, integrate=integrate, y=DISTURBANCE)
            value = math.inf if run.derailed else growth_of_swing(run.times, run.y)
            print(f"  {contact:8} {speed:6.2f} m/s: swing changes by {value:+.2f}/s", flush=True)
            return value

        critical[contact] = critical_speed(growth, low, high, tolerance=0.5)
        print(f"{contact}: critical speed {critical[contact]:.1f} m/s, from {DISTURBANCE:g} mm on straight track")

    curves: dict[str, list[tuple[float, float]]] = {}
    for contact in options.contacts:
        # Differences of small motions would show elements that come into contact; use finer ones.
        law, vehicle = WheelRailContact(client, SETUPS[contact].replace(dx=0.5, dy=0.5)), Vehicle()
        rest = law.rest(vehicle.axle_load)
        speeds = [low + (high - low) * i / 8 for i in range(9)]
        curves[contact] = [(speed, hunting(Wheelset(vehicle, law, 1000 * speed, rest)).real) for speed in speeds]
        of_small_motions = ", ".join(f"{value:+.2f}/s at {speed:g} m/s" for speed, value in curves[contact][::4])
        print(f"{contact}: small motions grow by {of_small_motions}", flush=True)
    if options.output is not None:
        from railway.pictures import draw_growth

        draw_growth(curves, critical, options.output / "wheelset-critical.png")


def _tell(run: Run) -> None:
    late = run.y[run.times >= 0.6 * run.times[-1]]
    print(
        f"{run.contact:8} {run.speed:g} m/s: y from {late.min():.2f} to {late.max():.2f} mm at the end, "
        f"{f'off the track after {run.times[-1]:.1f} s, ' if run.derailed else ''}"
        f"{run.solves} solves, {1000 * run.seconds / run.solves:.2f} ms each",
        flush=True,
    )


def _compare(runs: list[Run]) -> None:
    """Prints the mean computing time of each contact, and its ratio to the first one."""
    costs: dict[str, list[float]] = {}
    for run in runs:
        costs.setdefault(run.contact, []).append(run.cost)
    for contact, cost in costs.items():
        ratio = sum(cost) / sum(costs[runs[0].contact])
        print(f"{contact}: {sum(cost) / len(cost):.1f} s for a simulated second, {ratio:.2f} times {runs[0].contact}")


def _integrator(name: str) -> Integrate:
    if name == "runge-kutta":
        from runge_kutta import integrate as by_numpy

        return by_numpy
    _need("exudyn")
    from multibody import integrate as by_exudyn

    return by_exudyn


def _need(module: str) -> None:
    try:
        __import__(module)
    except ModuleNotFoundError:
        raise SystemExit(
            f"{module} is not installed: pip install './client/python[wheelset]' (or pip install {module}). "
            "--integrator runge-kutta needs no Exudyn, and without --output nothing is drawn."
        ) from None


def _options() -> argparse.Namespace:
    parser = argparse.ArgumentParser(prog="wheelset", description=(__doc__ or "").split("\n")[0])
    parser.add_argument("--endpoint", help="endpoint of a running daemon; default: start one")
    parser.add_argument(
        "--integrator", choices=("exudyn", "runge-kutta"), default="exudyn", help="default: %(default)s"
    )
    parser.add_argument("--contacts", nargs="+", choices=SETUPS, default=list(SETUPS), help="default: all")
    parser.add_argument("--speeds", nargs="*", type=float, default=[40.0, 70.0], help="speeds (m/s); default: 40 70")
    parser.add_argument("--seconds", type=float, default=2.0, help="simulated time (s); default: %(default)g")
    parser.add_argument("--seed", type=int, default=1, help="seed of the track's irregularities; default: %(default)s")
    parser.add_argument(
        "--search", nargs=2, type=float, metavar=("LOW", "HIGH"), help="search for critical speeds between these (m/s)"
    )
    parser.add_argument("--output", type=Path, help="folder of the pictures; default: no pictures")
    options = parser.parse_args()
    if options.seconds <= 0 or min([*options.speeds, *(options.search or ())], default=30) < 30:
        parser.error("--seconds must be positive, and --speeds at least 30 m/s: slower ones need a smaller step")
    if options.output is not None and not options.output.is_dir():
        parser.error(f"--output: {options.output} is not a folder")
    return options


if __name__ == "__main__":
    main()
