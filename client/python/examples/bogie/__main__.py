"""Simulates a bogie on a track: a multibody model of two wheelsets, with four wheels on rails by contactd. See
docs/bogie.md.

Run: python3 client/python/examples/bogie [--daemon] [--integrator runge-kutta] [--output FOLDER] [--curve] [--search 60 100]
     python3 client/python/examples/bogie --fmu build/fmu/contactd_wheel_fmi3.fmu

It solves in its own process if the extension contactd_local is installed, and otherwise starts a daemon. It needs
Exudyn and matplotlib: pip install './client/python[wheelset]'. --integrator runge-kutta does not need Exudyn. Without
--output it does not need matplotlib.
"""

from __future__ import annotations

import argparse
import sys
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

sys.path.append(str(Path(__file__).parents[1]))  # for railway, which the examples share

from railway.track import IrregularTrack
from railway.wheels import SETUPS, SessionWheels
from runs import INTEGRATORS, OpenWheels, Run, integrator, simulate
from tasks import run_curve, search, tell_energy

import contactd
from contactd import Client


def main() -> None:
    options = _options()
    integrate, open_wheels = integrator(options.integrator), _opener(options.fmu)
    with _client(options) as client:
        track = IrregularTrack(seed=options.seed)
        runs = []
        for speed in options.speeds:
            for contact in options.contacts:
                run = simulate(
                    client, contact, speed, options.seconds,
                    integrate=integrate, track=track, element=options.element, open_wheels=open_wheels,
                )  # fmt: skip
                _tell(run)
                runs.append(run)
        if runs and options.output is not None:
            from animation import animate
            from pictures import draw_motion

            draw_motion(runs, options.output / "bogie-hunting.png")
            animate(max(runs, key=lambda run: (run.times[-1], run.speed)), options.output / "bogie.gif")
        for contact in options.contacts:
            if options.curve:
                _tell(run_curve(client, contact, integrate, options.output))
            if options.energy:
                tell_energy(client, contact, (*options.speeds, 50.0)[0], integrate, options.output)
        if options.search:
            try:
                search(client, options.contacts, options.search, options.seconds, integrate, options.output)
            except ValueError as error:
                raise SystemExit(f"--search: {error}") from None


def _tell(run: Run) -> None:
    late = run.places[run.times >= 0.6 * run.times[-1]]
    wall, processor = run.cost
    print(
        f"{run.contact:8} {run.speed:g} m/s: y from {late.min():.2f} to {late.max():.2f} mm at the end, "
        f"{f'off the track after {run.times[-1]:.1f} s, ' if run.derailed else ''}{run.solves} solves; "
        f"{wall:.1f} s for a simulated second, {processor:.1f} s of this process' processors",
        flush=True,
    )


@contextmanager
def _client(options: argparse.Namespace) -> Iterator[Client]:
    if options.endpoint:
        with Client(options.endpoint) as client:
            yield client
        return
    with contactd.local(in_process=False if options.daemon else None) as client:
        yield client


def _opener(fmu: Path | None) -> OpenWheels:
    if fmu is None:
        return SessionWheels
    try:
        from fmu_wheels import FmuWheels, described
    except ModuleNotFoundError as error:
        if error.name != "fmpy":
            raise
        raise SystemExit("--fmu needs FMPy: pip install fmpy") from None
    try:
        described(fmu)
    except ValueError as error:
        raise SystemExit(f"--fmu: {error}") from None
    return lambda _, setups: FmuWheels(fmu, setups)


def _options() -> argparse.Namespace:
    parser = argparse.ArgumentParser(prog="bogie", description=(__doc__ or "").split("\n")[0])
    parser.add_argument("--endpoint", help="endpoint of a running daemon; default: solve in this process, or start a daemon")
    parser.add_argument("--daemon", action="store_true", help="start a daemon even if this process can solve")
    parser.add_argument(
        "--fmu", type=Path, metavar="FILE", help="FMU contactd_wheel of ./dev fmu, which solves the wheels at --speeds"
    )
    parser.add_argument("--integrator", choices=INTEGRATORS, default="exudyn", help="default: %(default)s")
    parser.add_argument("--contacts", nargs="+", choices=SETUPS, default=list(SETUPS), help="default: all")
    parser.add_argument("--speeds", nargs="*", type=float, default=[50.0, 90.0], help="speeds (m/s); default: 50 90")
    parser.add_argument("--seconds", type=float, default=2.0, help="simulated time (s); default: %(default)g")
    parser.add_argument("--element", type=float, help="size of the elements (mm); default: 1")
    parser.add_argument("--seed", type=int, default=1, help="seed of the track's irregularities; default: %(default)s")
    parser.add_argument("--curve", action="store_true", help="run into a curve of 600 m at 30 m/s")
    parser.add_argument("--energy", action="store_true", help="compute the balance of energy over a second")
    parser.add_argument(
        "--search", nargs=2, type=float, metavar=("LOW", "HIGH"), help="search for critical speeds between these (m/s)"
    )
    parser.add_argument("--output", type=Path, help="folder of the pictures; default: no pictures")
    options = parser.parse_args()
    if not options.seconds > 0 or not all(speed >= 30 for speed in [*options.speeds, *(options.search or ())]):
        parser.error("--seconds must be positive, and --speeds at least 30 m/s: slower ones need a smaller step")
    if options.element is not None and not 0.1 <= options.element <= 2:
        parser.error("--element must be 0.1 to 2 mm")
    if options.fmu is not None and not options.fmu.is_file():
        parser.error(f"--fmu: {options.fmu} is not a file; ./dev fmu makes build/fmu/contactd_wheel_fmi3.fmu")
    if options.fmu is not None and (options.curve or options.energy or options.search):
        parser.error("--fmu requires --speeds, and cannot be combined with --curve, --energy or --search")
    if options.output is not None and not options.output.is_dir():
        parser.error(f"--output: {options.output} is not a folder")
    return options


if __name__ == "__main__":
    main()
