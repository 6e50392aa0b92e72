"""Below which speed hunting dies down: by eigenvalues, and by simulations from a disturbance."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
from runge_kutta import Wheelset
from vehicle import Array

#: Place in the state of what takes part in motion across the track, and the step of its difference quotient: small against
#: what friction and the profiles' curvature bend, large against rounding (mm, rad, mm/s, rad/s).
ACROSS = {1: 0.05, 3: 1e-5, 4: 2e-5, 6: 2.0, 8: 1e-3, 10: 1e-3}


def hunting(wheelset: Wheelset) -> complex:
    """The eigenvalue that is damped least of all motion across the track, around running straight: growth (1/s), and angular
    frequency (1/s)."""
    rest = wheelset.start()
    columns = []
    for place, step in ACROSS.items():
        moved = np.zeros(len(rest))
        moved[place] = step
        columns.append((wheelset.rates(0, rest + moved) - wheelset.rates(0, rest - moved))[list(ACROSS)] / (2 * step))
    values = np.linalg.eigvals(np.array(columns).T)
    return complex(max((value for value in values if value.imag > 0), key=lambda value: value.real))


def critical_speed(growth: Callable[[float], float], low: float, high: float, tolerance: float) -> float:
    """Where `growth` of a speed (m/s) changes its sign, by bisection. Raises ValueError where it does not between both."""
    if not growth(low) <= 0 < growth(high):
        raise ValueError(f"Hunting does not begin between {low:g} and {high:g} m/s; give speeds further apart.")
    while high - low > 2 * tolerance:
        middle = (low + high) / 2
        low, high = (low, middle) if growth(middle) > 0 else (middle, high)
    return (low + high) / 2


def growth_of_swing(times: Array, y: Array) -> float:
    """How the swing of y changes from the second to the last third of the time: the logarithm of the ratio, by the time
    between (1/s). The first third is left to the start."""
    end = times[-1]
    swings = [float(np.ptp(y[(times >= begin) & (times <= begin + end / 3)])) for begin in (end / 3, 2 * end / 3)]
    return float(np.log(swings[1] / swings[0]) / (end / 3))
