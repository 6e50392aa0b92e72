"""Measures the cost of a simulated second: one wheelset with linear creep forces, and the bogie of the examples with
each kind of contact, in process, with a daemon and with FMUs. Pieces of the runs alternate. Times are wall-clock
seconds and processor seconds, including those of the daemon.

    python3 bench/bogie_cost.py [--seconds 0.1] [--rounds 3] [--integrator exudyn] [--fmu FILE]    (CONTACTD_BIN names contactd;
                                                           contactd_local on PYTHONPATH, exudyn and fmpy for the latter two)
"""

from __future__ import annotations

import argparse
import os
import sys
import time
from collections.abc import Callable
from contextlib import ExitStack
from pathlib import Path
from statistics import median

from daemon_program import daemon_program

EXAMPLES = Path(__file__).resolve().parent.parent / "client" / "python" / "examples"
TICKS = os.sysconf("SC_CLK_TCK")


def processor_seconds(pid: int) -> float:
    fields = Path(f"/proc/{pid}/stat").read_text().rpartition(")")[2].split()
    return (int(fields[11]) + int(fields[12])) / TICKS


def one_wheelset(integrator: str, seconds: float) -> Callable[[], None]:
    """Returns a simulation of one wheelset by Kalker's linear theory in numpy, as in textbooks, without requests."""
    sys.path.insert(0, str(EXAMPLES / "wheelset"))
    import numpy as np
    from contact import LinearContact
    from runge_kutta import Wheelset, integrate
    from vehicle import Vehicle

    if integrator == "exudyn":
        from multibody import integrate
    ellipse = -82000 * 30 * np.array([[4.2, 0, 0], [0, 3.7, 1.5 * 30**0.5], [0, -1.5 * 30**0.5, 1.2 * 30]])
    law = LinearContact(
        load=54500, normal_stiffness=1.4e6, half_distance=750, radius=460, conicity=0.15, angle=0.05, creep=ellipse
    )  # fmt: skip
    wheelset = Wheelset(Vehicle(), law, 40e3, 0.0)
    # The other example has modules with the same names.
    sys.path.remove(str(EXAMPLES / "wheelset"))
    for name in [name for name, found in sys.modules.items() if str(getattr(found, "__file__", "")).startswith(str(EXAMPLES / "wheelset"))]:
        del sys.modules[name]
    return lambda: integrate(wheelset, wheelset.start(y=1.0), seconds, 1e-3) and None


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--seconds", type=float, default=0.1, help="simulated seconds per piece (default %(default)s)")
    parser.add_argument("--rounds", type=int, default=3, help="default %(default)s")
    parser.add_argument("--integrator", choices=("runge-kutta", "exudyn"), default="runge-kutta", help="default %(default)s")
    parser.add_argument("--fmu", type=Path, help="contactd_wheel of ./dev fmu")
    options = parser.parse_args()
    sys.path.insert(0, str(EXAMPLES))
    rows: dict[str, Callable[[], None]] = {"one wheelset, linear theory": one_wheelset(options.integrator, options.seconds)}
    sys.path.insert(0, str(EXAMPLES / "bogie"))
    from railway.wheels import SessionWheels
    from runs import OpenWheels, by_numpy, simulate

    import contactd

    integrate = by_numpy
    if options.integrator == "exudyn":
        from multibody import integrate
    program = daemon_program()
    with ExitStack() as stack:
        daemon = stack.enter_context(contactd.LocalDaemon(program, config={"log": {"level": "warn"}}))
        here = stack.enter_context(contactd.local(in_process=True))
        ways: dict[str, tuple[contactd.Client, OpenWheels]] = {
            "in process": (here, SessionWheels), "daemon": (stack.enter_context(daemon.client()), SessionWheels)
        }  # fmt: skip
        if options.fmu:
            from fmu_wheels import FmuWheels

            ways["FMUs"] = here, lambda _, setups: FmuWheels(options.fmu, setups)
        for contact, element in (("linear", 1.0), ("fastsim", 1.0), ("full", 1.0), ("full", 0.5)):
            for way, (client, wheels) in ways.items():

                def piece(
                    client: contactd.Client = client, wheels: OpenWheels = wheels, contact: str = contact, element: float = element
                ) -> None:
                    simulate(client, contact, 50, options.seconds, y=1.0, element=element, integrate=integrate, open_wheels=wheels)

                rows[f"bogie, {contact}, {element:g} mm, {way}"] = piece
        found: dict[str, list[tuple[float, float]]] = {name: [] for name in rows}
        for _ in range(options.rounds + 1):
            for name, run in rows.items():
                began, worked, served = time.perf_counter(), time.process_time(), processor_seconds(daemon.pid)
                run()
                used = time.process_time() - worked + processor_seconds(daemon.pid) - served
                found[name].append((time.perf_counter() - began, used))
    print(f"{'a simulated second':38} {'clock (s)':>10} {'processors (s)':>15}")
    for name, taken in found.items():
        clock, processors = (median(values[1:]) / options.seconds for values in zip(*taken))  # the first round warms up
        print(f"{name:38} {clock:10.2f} {processors:15.2f}")


if __name__ == "__main__":
    main()
