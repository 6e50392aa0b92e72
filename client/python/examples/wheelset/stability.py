"""Hunting of the wheelset, by eigenvalues."""

from __future__ import annotations

from railway.stability import least_damped
from runge_kutta import Wheelset

#: Place in the state of what takes part in motion across the track, and the step of its difference quotient: small against
#: what friction and the profiles' curvature bend, large against rounding (mm, rad, mm/s, rad/s).
ACROSS = {1: 0.05, 3: 1e-5, 4: 2e-5, 6: 2.0, 8: 1e-3, 10: 1e-3}


def hunting(wheelset: Wheelset) -> complex:
    """The eigenvalue that is damped least of all motion across the track, around running straight: growth (1/s), and angular
    frequency (1/s)."""
    return least_damped(lambda state: wheelset.rates(0, state), wheelset.start(), ACROSS)
