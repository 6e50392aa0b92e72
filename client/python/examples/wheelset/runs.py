"""Simulations of the wheelset, with what they cost."""

from __future__ import annotations

import time
from collections.abc import Callable
from dataclasses import dataclass

from contact import SETUPS, WheelRailContact
from runge_kutta import Wheelset
from track import Track
from vehicle import Array, Vehicle

from contactd import Client

#: `integrate` of runge_kutta or of multibody: wheelset, state, duration and step (s) -> times and states
Integrate = Callable[[Wheelset, Array, float, float], tuple[Array, Array]]

#: s. The stiffest mode, the roll of the wheelset between the wheels' contacts, has 1.3 rad in it at most.
STEP = 1e-3


@dataclass(frozen=True)
class Run:
    """One simulation: y of the wheelset (mm) over the time (s), the speed (m/s), solves, and the seconds that it took."""

    contact: str
    speed: float
    times: Array
    y: Array
    solves: int
    seconds: float

    @property
    def cost(self) -> float:
        """Seconds by simulated second."""
        return self.seconds / float(self.times[-1])


def simulate(
    client: Client,
    contact: str,
    speed: float,
    duration: float,
    *,
    integrate: Integrate,
    track: Track | None = None,
    y: float = 0.0,
    vehicle: Vehicle | None = None,
    step: float = STEP,
) -> Run:
    """The wheelset at a speed (m/s), from y (mm) on. contact is one of SETUPS."""
    vehicle = vehicle or Vehicle()
    law = WheelRailContact(client, SETUPS[contact], track)
    wheelset = Wheelset(vehicle, law, 1000 * speed, law.rest(vehicle.axle_load))
    began = time.perf_counter()
    times, states = integrate(wheelset, wheelset.start(y=y), duration, step)
    return Run(contact, speed, times, states[:, 1], law.solves, time.perf_counter() - began)
