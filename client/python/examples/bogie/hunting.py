"""Finds the critical speed of the bogie, from eigenvalues of small motions, and from simulations with a
disturbance."""

from __future__ import annotations

import math
from collections.abc import Callable

from equations import Equations
from line import Line
from railway.motion import Array
from railway.stability import critical_speed, growth_of_swing, least_damped
from railway.track import Track
from railway.wheels import SessionWheels
from rolling import Rolling
from runs import Integrate, simulate, start, wheel_setups
from vehicle import bogie

from contactd import Client
from contactd.wheel_rail import ProfileFile

DISTURBANCE = 3.0  # mm, initial displacement in the search for the critical speed

#: Indices of lateral motion in the state of a body, and steps of difference quotients: small compared with
#: nonlinearities of friction and profiles, large compared with rounding (mm, rad, mm/s, rad/s).
ACROSS = {1: 0.05, 3: 1e-5, 5: 2e-5, 7: 2.0, 9: 1e-3, 11: 1e-3}
FASTER = 12.0  # 1/s: the sway of the coach is slower at any speed
ELEMENT = 0.5  # mm: differences of small motions would show elements that come into contact


def small_motions(client: Client, contact: str, wheel: ProfileFile | None = None) -> Callable[[float], complex]:
    """Returns a function of the speed (m/s): growth (1/s) and angular frequency (1/s) of the least damped lateral
    motion. All wheels have the profile of the set-ups, or `wheel`.
    """
    vehicle = bogie()
    setups = wheel_setups(contact, vehicle, ELEMENT)
    if wheel is not None:
        setups = [setup.replace(wheel=wheel) for setup in setups]
    steps = {12 * body + place: step for body in range(len(vehicle.bodies)) for place, step in ACROSS.items()}

    def of_speed(speed: float) -> complex:
        with SessionWheels(client, setups) as wheels:
            equations = Equations(Rolling(vehicle, wheels, Line(), Track()))

            def rates(state: Array) -> Array:
                return equations.rates(0, state)

            return least_damped(rates, start(client, equations, setups[0], speed), steps, above=FASTER)

    return of_speed


def simulated(
    client: Client, contact: str, low: float, high: float, seconds: float, integrate: Integrate,
    tell: Callable[[str], None], tolerance: float = 0.5,
) -> float:  # fmt: skip
    """Returns the speed (m/s) above which oscillations of the leading wheelset grow, from DISTURBANCE on straight
    track.

    Raises ValueError where it is not between `low` and `high`.
    """

    def growth(speed: float) -> float:
        run = simulate(client, contact, speed, seconds, integrate=integrate, y=DISTURBANCE)
        value = math.inf if run.derailed else growth_of_swing(run.times, run.places[:, 0])
        tell(f"  {contact:8} {speed:6.2f} m/s: swing changes by {value:+.2f}/s")
        return value

    return critical_speed(growth, low, high, tolerance)
