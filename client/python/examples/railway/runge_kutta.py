"""Implements the classical fourth-order Runge-Kutta method, in numpy, like the integrator of a multibody program."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from .motion import Array


def integrate(rates: Callable[[float, Array], Array], state: Array, duration: float, step: float) -> tuple[Array, Array]:
    """Returns times (s), shape [n], and states, shape [n, ...], from `state` on. `rates` returns the derivative for
    time and state; it is called four times per step.
    """
    count = round(duration / step)
    states = np.empty((count + 1, len(state)))
    states[0] = state
    for i in range(count):
        time = i * step
        k1 = rates(time, state)
        k2 = rates(time + step / 2, state + step / 2 * k1)
        k3 = rates(time + step / 2, state + step / 2 * k2)
        k4 = rates(time + step, state + step * k3)
        states[i + 1] = state = state + step / 6 * (k1 + 2 * k2 + 2 * k3 + k4)
    return step * np.arange(count + 1, dtype=float), states
