"""Where the energy of a run goes: the balance of a simulation, which nothing in it was told to keep."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from equations import Equations, about_y, along
from railway.motion import GRAVITY, Array, axes
from rolling import PITCH, PLACE, RATES, ROLL, VELOCITY, YAW


@dataclass(frozen=True)
class Balance:
    """Energies (N mm) over the time, shape [n] each.

    Attributes:
        stored: Of motion, height and springs.
        damped: What the dampers have taken.
        to_rails: What the wheels have given to their rails: friction, deformation, and the work on rails that rise and sway.
        friction: What contactd says that friction has dissipated, by slip and tractions: another way to the same, but for
            what contacts store, and what finite elements leave.
    """

    stored: Array
    damped: Array
    to_rails: Array
    friction: Array

    @property
    def error(self) -> Array:
        """Energy that is missing (N mm): only steps of a finite size leave something."""
        return self.stored + self.damped + self.to_rails - self.stored[0]


def balance(equations: Equations, times: Array, states: Array) -> Balance:
    """Balances the energy of a run with equal steps, states of shape [n, bodies, 12]. Asks for the contacts of each state once more.

    Powers are summed by cubics, so that the balance closes to the fourth order of the step, as the motion does.
    """
    stored = np.array([energy(equations, bodies) for bodies in states])
    powers = np.array([_powers(equations, bodies) for bodies in states])
    damped, to_rails, friction = (summed(power, float(times[1] - times[0])) for power in powers.T)
    return Balance(stored, damped, to_rails, friction)


def energy(equations: Equations, bodies: Array) -> float:
    """Energy of motion, height and springs (N mm)."""
    found = 0.0
    spins = along(about_y(bodies[:, PITCH]).transpose(0, 2, 1), bodies[:, RATES])
    for body, state, spin in zip(equations.vehicle.bodies, bodies, spins):
        found += (body.mass * state[VELOCITY] @ state[VELOCITY] + spin @ (np.array(body.inertia) * spin)) / 2
        found -= body.mass * GRAVITY * state[PLACE][2]
    pull, _, _ = equations.springs(bodies)
    springs = equations.springs
    return float(found + ((springs.preload + springs.stiffness * pull.extension / 2) * pull.extension).sum())


def _powers(equations: Equations, bodies: Array) -> tuple[float, float, float]:
    """Power that goes to dampers, to rails, and of this to friction (N mm/s)."""
    pull, _, _ = equations.springs(bodies)
    rails = equations.rolling(bodies)
    given = 0.0
    for force, moment, body in zip(rails.forces, rails.moments, bodies):
        given -= force @ body[VELOCITY] + moment @ axes(body[ROLL], body[YAW]) @ body[RATES]
    return float(equations.springs.damping @ pull.lengthening**2), float(given), rails.power


def summed(values: Array, step: float) -> Array:
    """The integral from the first value on, to each: of cubics through four neighbours, exact to the fourth order."""
    cubic = np.empty(len(values) - 1)
    cubic[1:-1] = (-values[:-3] + 13 * values[1:-2] + 13 * values[2:-1] - values[3:]) / 24
    cubic[0] = (9 * values[0] + 19 * values[1] - 5 * values[2] + values[3]) / 24
    cubic[-1] = (9 * values[-1] + 19 * values[-2] - 5 * values[-3] + values[-4]) / 24
    return np.concatenate([[0.0], step * np.cumsum(cubic)])
