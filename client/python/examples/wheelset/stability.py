"""Computes the hunting of the wheelset from eigenvalues."""

from __future__ import annotations

from railway.stability import least_damped
from runge_kutta import Wheelset

#: Indices of lateral motion in the state, and steps of difference quotients: small compared with nonlinearities of
#: friction and profiles, large compared with rounding (mm, rad, mm/s, rad/s).
ACROSS = {1: 0.05, 3: 1e-5, 4: 2e-5, 6: 2.0, 8: 1e-3, 10: 1e-3}


def hunting(wheelset: Wheelset) -> complex:
    """Returns the least damped eigenvalue of lateral motion around straight running: growth (1/s), and angular
    frequency (1/s).
    """
    return least_damped(lambda state: wheelset.rates(0, state), wheelset.start(), ACROSS)
