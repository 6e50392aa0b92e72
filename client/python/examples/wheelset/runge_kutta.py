"""Implements the wheelset's equations of motion and the classical Runge-Kutta method in numpy; an alternative to
Exudyn.

The state is (x, y, z, roll, yaw, vx, vy, vz, roll rate, pitch rate, yaw rate). x and vx are relative to the frame, and
the pitch rate is relative to that of pure rolling, so they are zero in straight running.
"""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
from railway import runge_kutta
from railway.motion import GRAVITY, Array, Motion, cross
from vehicle import Vehicle, suspension

#: Force on the wheelset in track coordinates (N), moment about its centre along its own axes (N mm)
Contact = Callable[[Motion], tuple[Array, Array]]


class Wheelset:
    """Newton-Euler equations of a body of revolution, in axes that do not rotate with its pitch."""

    def __init__(self, vehicle: Vehicle, contact: Contact, speed: float, rest: float) -> None:
        """Takes the speed of the frame (mm/s), and z of the wheelset under the axle load, `rest` (mm)."""
        self.vehicle, self.contact, self.speed, self.rest = vehicle, contact, speed, rest
        self.gone = 0.0  # mm, position of the frame at time 0, where an integration continues

    def start(self, y: float = 0.0, yaw: float = 0.0) -> Array:
        """Returns the state of pure rolling, shifted by y to the right (mm)."""
        state = np.zeros(11)
        state[[1, 2, 4]] = y, self.rest, yaw
        return state

    def motion(self, time: float, state: Array) -> Motion:
        x, y, z, roll, yaw, vx, vy, vz, roll_rate, pitch_rate, yaw_rate = (float(value) for value in state)
        pitch_rate -= self.speed / self.vehicle.radius
        distance = self.gone + self.speed * time + x
        return Motion(distance, y, z, roll, yaw, vx + self.speed, vy, vz, roll_rate, pitch_rate, yaw_rate)

    def rates(self, time: float, state: Array) -> Array:
        """Returns the time derivative of the state."""
        motion = self.motion(time, state)
        on_rails, moment_on_rails = self.contact(motion)
        force_of_springs, moment_of_springs = suspension(self.vehicle, state[0], self.rest, motion, self.speed)
        acceleration = (on_rails + force_of_springs) / self.vehicle.mass + (0, 0, GRAVITY)

        inertia = np.array([self.vehicle.inertia, self.vehicle.inertia_axle, self.vehicle.inertia])
        angular_velocity = np.array([motion.roll_rate, motion.pitch_rate, motion.yaw_rate])
        of_axes = np.array([motion.roll_rate, motion.yaw_rate * np.tan(motion.roll), motion.yaw_rate])
        momentum = inertia * angular_velocity
        angular = (moment_on_rails + moment_of_springs - cross(of_axes, momentum)) / inertia
        angles = (motion.roll_rate, motion.yaw_rate / np.cos(motion.roll))
        return np.concatenate([state[5:8], angles, acceleration, angular])


def integrate(wheelset: Wheelset, state: Array, duration: float, step: float) -> tuple[Array, Array]:
    """Returns times (s), shape [n], and states, shape [n, 11], from `state` on. The contact is evaluated four times per
    step.
    """
    return runge_kutta.integrate(wheelset.rates, state, duration, step)
