"""Finds the speed below which hunting decays, from eigenvalues and from simulations with a disturbance."""

from __future__ import annotations

from collections.abc import Callable, Mapping

import numpy as np

from .motion import Array


def least_damped(
    rates: Callable[[Array], Array], state: Array, steps: Mapping[int, float], above: float = 0.0
) -> complex:
    """Returns the least damped eigenvalue of small motions around a state: growth (1/s), and angular frequency (1/s),
    which is `above` a bound.

    `steps` are the indices of the varied parts of the state, with the steps of their difference quotients.
    """
    columns = []
    for place, step in steps.items():
        moved = np.zeros(len(state))
        moved[place] = step
        columns.append((rates(state + moved) - rates(state - moved))[list(steps)] / (2 * step))
    values = np.linalg.eigvals(np.array(columns).T)
    return complex(max((value for value in values if value.imag > above), key=lambda value: value.real))


def critical_speed(growth: Callable[[float], float], low: float, high: float, tolerance: float) -> float:
    """Returns the zero of `growth` as a function of the speed (m/s), by bisection. Raises ValueError without a change
    of sign.
    """
    if not growth(low) <= 0 < growth(high):
        raise ValueError(f"Hunting does not begin between {low:g} and {high:g} m/s; give speeds further apart.")
    while high - low > 2 * tolerance:
        middle = (low + high) / 2
        low, high = (low, middle) if growth(middle) > 0 else (middle, high)
    return (low + high) / 2


def growth_of_swing(times: Array, y: Array) -> float:
    """Returns the growth of the oscillation of y from the second to the last third of the time: the logarithm of the
    ratio over the time between (1/s). The first third is a transient.
    """
    end = times[-1]
    swings = [float(np.ptp(y[(times >= begin) & (times <= begin + end / 3)])) for begin in (end / 3, 2 * end / 3)]
    return float(np.log(swings[1] / swings[0]) / (end / 3))
