"""Computes forces of the rails on the wheelset, by contactd or by the linear theory of textbooks."""

from __future__ import annotations

from dataclasses import dataclass, field

import numpy as np
from railway.motion import Array, Motion, axes, cross
from railway.track import Track
from railway.wheels import SIDES, height_under, on_wheelset, wheel_state

from contactd import Client, InvalidArgument
from contactd.wheel_rail import WheelRailSetup


class WheelRailContact:
    """Represents both wheels, solved by contactd at the given height of the wheelset."""

    def __init__(self, client: Client, setup: WheelRailSetup, track: Track | None = None) -> None:
        self._client, self._track = client, track or Track()
        self._setups = {side: setup.replace(side=side) for side in SIDES}
        self.solves = 0
        self.derailed = False  # a wheel is outside the range of elastic contact

    def __call__(self, motion: Motion) -> tuple[Array, Array]:
        """Returns the force on the wheelset in track coordinates (N), and the moment about its centre along its own
        axes (N mm).
        """
        force, moment = np.zeros(3), np.zeros(3)
        for side, setup in self._setups.items():
            try:
                solution = self._client.wheel_rail(setup, wheel_state(side, motion, self._track), fields=[])
            except InvalidArgument:
                self.derailed = True
                raise
            self.solves += 1
            wheel = on_wheelset(solution)
            force += wheel.force
            moment += wheel.moment
        return force, moment

    def rest(self, axle_load: float) -> float:
        """Returns z of the centred wheelset under its load (mm)."""
        return height_under(self._client, list(self._setups.values()), axle_load)


@dataclass(frozen=True)
class LinearContact:
    """Models wheels whose radius and normal force are linear in the position, and whose creep forces are linear in the
    creepages, as in textbooks: no flanges, no slip. The ellipse grows with the normal force by Hertz's theory.

    Attributes:
        load: Load of one wheel at rest (N).
        normal_stiffness: dFn/dz (N/mm).
        half_distance: Half the distance of the contact points at rest (mm).
        radius: Rolling radius at rest (mm).
        conicity: Increase of the right wheel's rolling radius per mm to the right.
        angle: Angle of the right contact's plane to the horizontal (rad), > 0 if it rises to the field side.
        creep: Forces (N) and moment (N mm) about the normal on a rail for xi, eta and phi (1/mm) of the contact: -G ab
            times Kalker's coefficients under `load`, shape [3, 3].
        rest: z of the wheelset with both wheels under their load (mm).
    """

    load: float
    normal_stiffness: float
    half_distance: float
    radius: float
    conicity: float
    angle: float
    creep: Array
    rest: float = 0.0
    track: Track = field(default_factory=Track)

    def __call__(self, motion: Motion) -> tuple[Array, Array]:
        """Returns the force on the wheelset in track coordinates (N), and the moment about its centre along its own
        axes (N mm).
        """
        force, moment = np.zeros(3), np.zeros(3)
        rotated = axes(motion.roll, motion.yaw)
        rates = rotated @ (motion.roll_rate, motion.pitch_rate, motion.yaw_rate)
        for side in SIDES:
            sign = 1 if side == "right" else -1
            rail_y, rail_z, y_slope, z_slope = self.track.deviation(side, motion.distance)
            larger = sign * self.conicity * (motion.y - rail_y)
            lower = motion.z - self.rest + sign * self.half_distance * np.sin(motion.roll) + larger - rail_z
            fn = max(self.load / np.cos(self.angle) + self.normal_stiffness * lower, 0.0)

            forwards, across = np.array([1.0, 0, 0]), np.array([0, np.cos(self.angle), -sign * np.sin(self.angle)])
            normal = cross(forwards, across)
            arm = rotated @ (0.0, sign * self.half_distance, self.radius + larger)
            wheel = np.array([motion.vx, motion.vy, motion.vz]) + cross(rates, arm)
            rail = motion.vx * np.array([0.0, y_slope, z_slope])
            rolling = abs(motion.vx)
            creepages = np.array([(rail - wheel) @ forwards, (rail - wheel) @ across, -rates @ normal]) / rolling
            length = (fn / self.load) ** (1 / 3)  # mean of the ellipse's axes; spin forces follow its cube
            fx, fy, mz = (length, length, length**2) * (self.creep @ ((length, length, length**2) * creepages))
            on_rail = fx * forwards + fy * across + fn * normal
            force -= on_rail
            moment -= rotated.T @ (cross(arm, on_rail) + mz * normal)
        return force, moment
