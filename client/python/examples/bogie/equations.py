"""Solves the equations of motion of rigid bodies with springs, in numpy; an alternative to Exudyn."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from railway.motion import GRAVITY, Array, axes, cross
from rolling import PITCH, PLACE, RATES, ROLL, VELOCITY, YAW, Rolling
from vehicle import Vehicle


class Pull(NamedTuple):
    """Holds forces of all springs: tension (N), elongation (mm), and its rate (mm/s)."""

    tension: Array
    extension: Array
    lengthening: Array


class Springs:
    """Computes forces along lines between points of bodies."""

    def __init__(self, vehicle: Vehicle) -> None:
        springs = vehicle.springs
        self._ends = np.array([spring.ends for spring in springs], dtype=int).reshape(-1, 2)
        self._points = np.array([spring.points for spring in springs]).reshape(-1, 2, 3)
        self._lengths = np.array([vehicle.length_at_rest(spring) for spring in springs])
        self.stiffness = np.array([spring.stiffness for spring in springs])
        self.damping = np.array([spring.damping for spring in springs])
        self.preload = np.array([spring.preload for spring in springs])

    def __call__(self, bodies: Array) -> tuple[Pull, Array, Array]:
        """Returns the springs' state, and forces (N) and moments (N mm) about the centres of the bodies, shape [bodies,
        3] each.
        """
        rotated = frames(bodies)
        spins = along(rotated, bodies[:, RATES])
        arms = along((rotated @ about_y(bodies[:, PITCH]))[self._ends], self._points)
        ends = bodies[:, PLACE][self._ends] + arms
        velocities = bodies[:, VELOCITY][self._ends] + cross(spins[self._ends], arms)
        lines = ends[:, 1] - ends[:, 0]
        lengths = np.linalg.norm(lines, axis=1)
        directions = lines / lengths[:, None]
        lengthening = ((velocities[:, 1] - velocities[:, 0]) * directions).sum(axis=1)
        extension = lengths - self._lengths
        tension = self.preload + self.stiffness * extension + self.damping * lengthening
        pulls = tension[:, None] * directions
        forces, moments = np.zeros((len(bodies), 3)), np.zeros((len(bodies), 3))
        for end, sign in ((0, 1), (1, -1)):
            np.add.at(forces, self._ends[:, end], sign * pulls)
            np.add.at(moments, self._ends[:, end], sign * cross(arms[:, end], pulls))
        return Pull(tension, extension, lengthening), forces, moments


class Equations:
    """Newton-Euler equations in axes that do not rotate with a body's pitch, so that a wheelset may spin."""

    def __init__(self, rolling: Rolling) -> None:
        self.vehicle, self.rolling = rolling.vehicle, rolling
        self.springs = Springs(self.vehicle)
        self._masses = np.array([body.mass for body in self.vehicle.bodies])
        self._inertias = np.array([np.diag(body.inertia) for body in self.vehicle.bodies])

    def start(self, speed: float, z: float, y: float = 0.0, roll: float = 0.0) -> Array:
        """Returns the state for straight running at a speed (mm/s), all bodies shifted by y to the right (mm), with the
        height (mm) and roll (rad) at which the wheelsets carry their load; shape [12 bodies].
        """
        bodies = np.zeros((len(self.vehicle.bodies), 12))
        bodies[:, PLACE] = self.vehicle.places + np.array([0, y, z])
        bodies[:, VELOCITY] = speed, 0, 0
        bodies[: self.vehicle.wheelsets, ROLL] = roll
        bodies[: self.vehicle.wheelsets, RATES] = 0, -speed / self.vehicle.radius, 0
        return bodies.ravel()

    def rates(self, time: float, state: Array) -> Array:
        """Returns the time derivative of the state."""
        bodies = state.reshape(-1, 12)
        _, forces, moments = self.springs(bodies)
        rails = self.rolling(bodies)
        forces[: len(rails.forces)] += rails.forces
        moments[: len(rails.moments)] += rails.moments
        change = np.empty_like(bodies)
        change[:, PLACE] = bodies[:, VELOCITY]
        change[:, VELOCITY] = forces / self._masses[:, None] + (0, 0, GRAVITY)
        spins = bodies[:, RATES]
        sine, cosine = np.sin(bodies[:, ROLL]), np.cos(bodies[:, ROLL])
        yaw_rate = spins[:, 2] / cosine
        change[:, ROLL], change[:, PITCH], change[:, YAW] = spins[:, 0], spins[:, 1] - yaw_rate * sine, yaw_rate
        pitched = about_y(bodies[:, PITCH])
        inertias = pitched @ self._inertias @ pitched.transpose(0, 2, 1)
        moments = along(frames(bodies).transpose(0, 2, 1), moments) - cross(spins, along(inertias, spins))
        of_axes = np.stack([spins[:, 0], yaw_rate * sine, spins[:, 2]], axis=1)
        change[:, RATES] = np.linalg.solve(inertias, moments[..., None])[..., 0] - cross(of_axes, spins)
        return change.ravel()


def frames(bodies: Array) -> Array:
    """Returns the axes of all bodies that do not rotate with their pitch, as columns, shape [bodies, 3, 3]."""
    return axes(bodies[:, ROLL], bodies[:, YAW]).transpose(2, 0, 1)


def about_y(angles: Array) -> Array:
    """Returns rotations by the angles, shape [n, 3, 3]."""
    found = np.zeros((len(angles), 3, 3))
    found[:, 0, 0] = found[:, 2, 2] = np.cos(angles)
    found[:, 0, 2] = np.sin(angles)
    found[:, 2, 0] = -found[:, 0, 2]
    found[:, 1, 1] = 1
    return found


def along(matrices: Array, vectors: Array) -> Array:
    """Multiplies each matrix by its vector."""
    return (matrices @ vectors[..., None])[..., 0]
