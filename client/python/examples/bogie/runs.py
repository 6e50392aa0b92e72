"""Simulations of the bogie, and their computing times."""

from __future__ import annotations

import time
from collections.abc import Callable, Sequence
from contextlib import AbstractContextManager
from dataclasses import dataclass

import numpy as np
from equations import Equations
from line import Line
from railway import runge_kutta
from railway.motion import Array
from railway.track import Track
from railway.wheels import SETUPS, SIDES, SessionWheels, Wheels
from rolling import Rolling
from vehicle import Vehicle, bogie

from contactd import Client
from contactd.wheel_rail import WheelRailSetup, WheelsetPosition, WheelsetState, WheelsetVelocity

#: `by_numpy` or that of multibody: equations, state, duration and step (s) -> times and states
Integrate = Callable[[Equations, Array, float, float], tuple[Array, Array]]

#: Creates the solver of the wheels of these set-ups, which need not use the client.
OpenWheels = Callable[[Client, Sequence[WheelRailSetup]], AbstractContextManager[Wheels]]

STEP = 1e-3  # s: a wheelset bounces on its contacts by 1.3 rad per step; the method is stable up to 2.8
PIECE = 0.1  # s
OFF_TRACK = 15.0  # mm: a flange is on top of its rail


#: Integrators of the equations of motion.
INTEGRATORS = ("exudyn", "runge-kutta")


def integrator(name: str) -> Integrate:
    """Returns one of INTEGRATORS; raises SystemExit if Exudyn is not installed."""
    if name == "runge-kutta":
        return by_numpy
    try:
        import exudyn  # noqa: F401
    except ModuleNotFoundError:
        raise SystemExit(
            "exudyn is not installed: pip install './client/python[wheelset]' (or pip install exudyn). "
            "--integrator runge-kutta needs no Exudyn."
        ) from None
    from multibody import integrate

    return integrate


def by_numpy(equations: Equations, state: Array, duration: float, step: float) -> tuple[Array, Array]:
    return runge_kutta.integrate(equations.rates, state, duration, step)


@dataclass(frozen=True)
class Run:
    """One simulation.

    Attributes:
        contact: Kind of contact.
        speed: Initial speed (m/s).
        line: The line.
        times: Times (s), shape [n].
        states: States of all bodies, shape [n, bodies, 12].
        places: y of the wheelsets from the middle of the track (mm), shape [n, wheelsets].
        solves: Number of solved wheels.
        seconds: Wall-clock time (s).
        processor_seconds: Processor time of this process: everything in process, only the client's part with a daemon.
        derailed: Whether it ended with a derailment.
    """

    contact: str
    speed: float
    line: Line
    times: Array
    states: Array
    places: Array
    solves: int
    seconds: float
    processor_seconds: float
    derailed: bool

    @property
    def cost(self) -> tuple[float, float]:
        """Seconds, and processor seconds, per simulated second."""
        duration = max(float(self.times[-1]), STEP)
        return self.seconds / duration, self.processor_seconds / duration


def wheel_setups(contact: str, vehicle: Vehicle, element: float | None = None) -> list[WheelRailSetup]:
    """Returns the set-ups of all wheels: the leading wheelset first, left before right. `element` is another element
    size (mm).
    """
    setup = SETUPS[contact] if element is None else SETUPS[contact].replace(dx=element, dy=element)
    return [setup.replace(side=side) for _ in range(vehicle.wheelsets) for side in SIDES]


def simulate(
    client: Client,
    contact: str,
    speed: float,
    duration: float,
    *,
    integrate: Integrate = by_numpy,
    line: Line | None = None,
    track: Track | None = None,
    y: float = 0.0,
    vehicle: Vehicle | None = None,
    step: float = STEP,
    element: float | None = None,
    open_wheels: OpenWheels = SessionWheels,
) -> Run:
    """Simulates the bogie at a speed (m/s) from y (mm), without traction. contact is one of SETUPS. A derailment ends
    the run.

    The client computes the initial height, and solves the wheels unless `open_wheels` returns another solver.
    """
    vehicle, line = vehicle or bogie(), line or Line()
    setups = wheel_setups(contact, vehicle, element)
    began, worked = time.perf_counter(), time.process_time()
    with open_wheels(client, setups) as wheels:
        rolling = Rolling(vehicle, wheels, line, track or Track())
        equations = Equations(rolling)
        times: Array = np.zeros(1)
        states: Array = start(client, equations, setups[0], speed, y)[np.newaxis]
        places = places_of(rolling, states)
        while times[-1] < duration - step / 2 and not rolling.derailed:
            # in parts, so that the time before a derailment is kept
            piece = min(PIECE, duration - float(times[-1]))
            try:
                later, more = integrate(equations, states[-1], piece, step)
            except Exception:  # Exudyn raises its own exception for errors in a user function
                if not rolling.derailed:
                    raise
            else:
                times, states = np.append(times, times[-1] + later[1:]), np.vstack([states, more[1:]])
                places = np.vstack([places, places_of(rolling, more[1:])])
                rolling.derailed |= bool(np.abs(places).max() > OFF_TRACK)
    return Run(
        contact, speed, line, times, states.reshape(len(times), -1, 12), places, rolling.solves,
        time.perf_counter() - began, time.process_time() - worked, rolling.derailed,
    )  # fmt: skip


def start(client: Client, equations: Equations, setup: WheelRailSetup, speed: float, y: float = 0.0) -> Array:
    """Returns the state of a bogie running straight at a speed (m/s), shifted by y to the right (mm), on loaded
    wheels.
    """
    vehicle = equations.vehicle
    rolling = WheelsetVelocity(x=1000 * speed, pitch=-1000 * speed / vehicle.radius)
    load = vehicle.axle_load / 2
    carried = client.wheelset(
        setup.replace(side="right"),
        WheelsetState(Fz_left=load, Fz_right=load, position=WheelsetPosition(y=y), velocity=rolling), fields=[],
    )  # fmt: skip
    return equations.start(1000 * speed, carried.z, y, carried.roll)


def places_of(rolling: Rolling, states: Array) -> Array:
    """Returns y of the wheelsets from the middle of the track (mm), shape [n, wheelsets]."""
    bodies = states.reshape(len(states), -1, 12)[:, : rolling.vehicle.wheelsets]
    return np.array([[rolling.motion(i, body).y for i, body in enumerate(row)] for row in bodies])
