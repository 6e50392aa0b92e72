"""The energy balance of a run, which checks the simulation independently."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from equations import Equations, about_y, along
from railway.motion import GRAVITY, Array, axes
from rolling import PITCH, PLACE, RATES, ROLL, VELOCITY, YAW


@dataclass(frozen=True)
class Balance:
    """Energies (N mm) against time, shape [n] each.

    Attributes:
        stored: Kinetic energy, and potential energy of height and springs.
        damped: Energy dissipated in the dampers.
        to_rails: Energy transferred from wheels to rails: friction, deformation, and work on irregular rails.
        friction: Frictional dissipation computed by contactd from slip and tractions. It equals to_rails except for the
            energy stored in contacts, and discretisation errors.
    """

    stored: Array
    damped: Array
    to_rails: Array
    friction: Array

    @property
    def error(self) -> Array:
        """Missing energy (N mm), due to the finite step size only."""
        return self.stored + self.damped + self.to_rails - self.stored[0]


def balance(equations: Equations, times: Array, states: Array) -> Balance:
    """Returns the balance of a run with equal steps, states of shape [n, bodies, 12]. Solves the contacts of each state
    again.

    Powers are integrated with cubics, so that the balance is accurate to fourth order in the step, like the motion.
    """
    stored = np.array([energy(equations, bodies) for bodies in states])
    powers = np.array([_powers(equations, bodies) for bodies in states])
    damped, to_rails, friction = (summed(power, float(times[1] - times[0])) for power in powers.T)
    return Balance(stored, damped, to_rails, friction)


def energy(equations: Equations, bodies: Array) -> float:
    """Returns the energy of motion, height and springs (N mm)."""
    found = 0.0
    spins = along(about_y(bodies[:, PITCH]).transpose(0, 2, 1), bodies[:, RATES])
    for body, state, spin in zip(equations.vehicle.bodies, bodies, spins):
        found += (body.mass * state[VELOCITY] @ state[VELOCITY] + spin @ (np.array(body.inertia) * spin)) / 2
        found -= body.mass * GRAVITY * state[PLACE][2]
    pull, _, _ = equations.springs(bodies)
    springs = equations.springs
    return float(found + ((springs.preload + springs.stiffness * pull.extension / 2) * pull.extension).sum())


def _powers(equations: Equations, bodies: Array) -> tuple[float, float, float]:
    """Returns the power into dampers, into rails, and its frictional part (N mm/s)."""
    pull, _, _ = equations.springs(bodies)
    rails = equations.rolling(bodies)
    given = 0.0
    for force, moment, body in zip(rails.forces, rails.moments, bodies):
        given -= force @ body[VELOCITY] + moment @ axes(body[ROLL], body[YAW]) @ body[RATES]
    return float(equations.springs.damping @ pull.lengthening**2), float(given), rails.power


def summed(values: Array, step: float) -> Array:
    """Returns the integral from the first value to each, by cubics through four neighbours, to fourth order."""
    cubic = np.empty(len(values) - 1)
    cubic[1:-1] = (-values[:-3] + 13 * values[1:-2] + 13 * values[2:-1] - values[3:]) / 24
    cubic[0] = (9 * values[0] + 19 * values[1] - 5 * values[2] + values[3]) / 24
    cubic[-1] = (9 * values[-1] + 19 * values[-2] - 5 * values[-3] + values[-4]) / 24
    return np.concatenate([[0.0], step * np.cumsum(cubic)])
