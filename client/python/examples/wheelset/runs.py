"""Simulations of the wheelset, and their computing times."""

from __future__ import annotations

import time
from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from contact import WheelRailContact
from railway.motion import Array
from railway.track import Track
from railway.wheels import SETUPS
from runge_kutta import Wheelset
from vehicle import Vehicle

from contactd import Client

#: `integrate` of runge_kutta or of multibody: wheelset, state, duration and step (s) -> times and states
Integrate = Callable[[Wheelset, Array, float, float], tuple[Array, Array]]

#: s. The wheelset bounces on its contacts by 1.3 rad per step, and its pitch decays by 67/speed; the method is stable
#: up to 2.8.
STEP = 1e-3
PIECE = 0.1  # s
OFF_TRACK = 15.0  # mm: a flange is on top of its rail


@dataclass(frozen=True)
class Run:
    """Holds one simulation: y of the wheelset (mm) against time (s), the speed (m/s), the number of solves, the
    computing time (s), and whether it ended with a derailment.
    """

    contact: str
    speed: float
    times: Array
    y: Array
    solves: int
    seconds: float
    derailed: bool = False

    @property
    def cost(self) -> float:
        """Seconds per simulated second."""
        return self.seconds / max(float(self.times[-1]), PIECE)


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
    """Simulates the wheelset at a speed (m/s), from y (mm). contact is one of SETUPS. A derailment ends the run."""
    vehicle = vehicle or Vehicle()
    law = WheelRailContact(client, SETUPS[contact], track)
    wheelset = Wheelset(vehicle, law, 1000 * speed, law.rest(vehicle.axle_load))
    began = time.perf_counter()
    times: Array = np.zeros(1)
    states: Array = wheelset.start(y=y)[np.newaxis]
    while times[-1] < duration - step / 2 and not law.derailed:
        # in parts, so that the time before a derailment is kept
        piece = min(PIECE, duration - float(times[-1]))
        wheelset.gone = wheelset.speed * float(times[-1])
        try:
            later, more = integrate(wheelset, states[-1], piece, step)
        except Exception:  # Exudyn raises its own exception for errors in a user function
            if not law.derailed:
                raise
        else:
            times, states = np.append(times, times[-1] + later[1:]), np.vstack([states, more[1:]])
        if np.abs(states[:, 1]).max() > OFF_TRACK:
            law.derailed = True
    return Run(contact, speed, times, states[:, 1], law.solves, time.perf_counter() - began, law.derailed)
