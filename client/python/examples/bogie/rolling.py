"""Moves the wheels of a vehicle on a line: their positions on the rails, and the contact forces on the wheelsets."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from line import Line
from railway.motion import Array, Motion, axes
from railway.track import Track
from railway.wheels import SIDES, Wheels, wheel_state
from vehicle import Vehicle

from contactd import InvalidArgument
from contactd.wheel_rail import WheelRailState

#: Indices in the state of a body: position (mm), roll, pitch and yaw (rad), velocity (mm/s), and rates about its own
#: axes, which do not rotate with its pitch (rad/s).
PLACE, ANGLES, VELOCITY, RATES = slice(0, 3), slice(3, 6), slice(6, 9), slice(9, 12)
ROLL, PITCH, YAW = 3, 4, 5


class OnBodies(NamedTuple):
    """Holds forces and moments of the rails on the wheelsets.

    Attributes:
        forces: Shape [wheelsets, 3] (N).
        moments: Moments about the centres, shape [wheelsets, 3] (N mm).
        power: Frictional dissipation in all contacts (N mm/s).
    """

    forces: Array
    moments: Array
    power: float


class Rolling:
    """Solves the contacts of all wheels at once."""

    def __init__(self, vehicle: Vehicle, wheels: Wheels, line: Line, track: Track) -> None:
        self.vehicle, self.line = vehicle, line
        self._wheels, self._track = wheels, track
        self._ways = vehicle.places[: vehicle.wheelsets, 0]  # start of the search along the line
        self.solves = 0  # of wheels
        self.derailed = False  # a wheel is outside the range of elastic contact

    def __call__(self, bodies: Array) -> OnBodies:
        """`bodies` are the states of all, shape [bodies, 12]."""
        motions = [self.motion(number, body) for number, body in enumerate(bodies[: self.vehicle.wheelsets])]
        states: list[WheelRailState] = [wheel_state(side, motion, self._track) for motion in motions for side in SIDES]
        try:
            answers = self._wheels(states)
        except InvalidArgument:
            self.derailed = True
            raise
        self.solves += len(answers)
        forces, moments = np.empty((len(motions), 3)), np.empty((len(motions), 3))
        for number, motion in enumerate(motions):
            both = answers[2 * number : 2 * number + 2]
            track = self.line.axes(motion.distance)
            forces[number] = track @ sum(wheel.force for wheel in both)
            moments[number] = track @ axes(motion.roll, motion.yaw) @ sum(wheel.moment for wheel in both)
        return OnBodies(forces, moments, sum(wheel.power for wheel in answers))

    def motion(self, number: int, body: Array) -> Motion:
        """Returns the motion of a wheelset relative to the track at its position, in the axes of the line."""
        way = self._ways[number] = self.line.way_to(body[PLACE], float(self._ways[number]))
        track = self.line.axes(way)
        _, y, z = track.T @ (body[PLACE] - self.line.place(way))
        rotated = axes(body[ROLL], body[YAW])
        along_x, along_y, along_z = track.T @ rotated[:, 1]  # the axle
        roll, yaw = float(np.arcsin(along_z)), float(np.arctan2(-along_x, along_y))
        velocity = track.T @ body[VELOCITY]
        rates = axes(roll, yaw).T @ track.T @ rotated @ body[RATES]
        numbers = [y, z + self.vehicle.radius, roll, yaw, *velocity, *rates]
        return Motion(way, *(float(value) for value in numbers))
