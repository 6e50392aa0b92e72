"""Describes a bogie of two wheelsets under one end of a coach: rigid bodies, and springs along lines between them.

Coordinates are those of the track at the start: x forwards, y to the right, z down, with the origin on the plane of the
rail tops, below the middle of the bogie. Units: mm, s, N, and t for masses. Angles are those of contactd: a body is
rotated by yaw about z, then by roll about its own x, then by pitch about its own y.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from railway.motion import GRAVITY, Array

Point = tuple[float, float, float]


@dataclass(frozen=True)
class Body:
    """A rigid body.

    Attributes:
        name: Its name in pictures.
        mass: Mass (t).
        inertia: Moments of inertia about its own axes x, y, z through its centre (t mm^2).
        place: Position of the centre at rest (mm).
    """

    name: str
    mass: float
    inertia: Point
    place: Point


@dataclass(frozen=True)
class Spring:
    """Describes a spring and a damper along the line between two points, each fixed to a body.

    Such a spring conserves momentum and energy for any rotation of the bodies. Its force has a lateral part that
    depends on its length: a hanging spring is laterally stiffer, a standing one softer.

    Attributes:
        ends: Indices of the bodies.
        points: Attachment points along the axes of each body from its centre (mm).
        stiffness: Stiffness (N/mm).
        damping: Damping (N s/mm).
        preload: Tension at rest (N); < 0 for compression.
    """

    ends: tuple[int, int]
    points: tuple[Point, Point]
    stiffness: float
    damping: float
    preload: float = 0.0


@dataclass(frozen=True)
class Vehicle:
    """Holds bodies and springs; the first bodies are the wheelsets, from the front.

    Attributes:
        bodies: All of them.
        springs: Springs between them.
        wheelsets: Number of wheelsets among the bodies.
        radius: Radius of the wheels (mm).
        axle_load: Force of both wheels of a wheelset on the rails (N).
    """

    bodies: tuple[Body, ...]
    springs: tuple[Spring, ...]
    wheelsets: int
    radius: float
    axle_load: float

    @property
    def places(self) -> Array:
        """Returns the positions of the centres at rest (mm), shape [bodies, 3]."""
        return np.array([body.place for body in self.bodies])

    def length_at_rest(self, spring: Spring) -> float:
        ends = [self.places[body] + point for body, point in zip(spring.ends, spring.points)]
        return float(np.linalg.norm(ends[1] - ends[0]))


FRAME, COACH = 2, 3

#: Masses, wheel base and springs of vehicle 1 of the Manchester benchmarks (Iwnicki 1998: a passenger coach). The coach
#: is half of it, as compact as it is wide, because there is no second bogie at the other end.
WHEELSET_MASS, FRAME_MASS, COACH_MASS = 1.813, 2.615, 16.0  # t
RADIUS, WHEEL_BASE, HALF_BASE = 460.0, 2560.0, 1000.0  # mm
PRIMARY = (31391.0, 3884.0, 1220.0)  # N/mm, of an axle box along x, y, z
PRIMARY_DAMPING = (15.0, 2.0, 4.0)  # N s/mm
ARM, COLUMN, HANGER = 500.0, 500.0, 600.0  # mm: lengths of springs that lie, stand and hang


def bogie(primary: Point = PRIMARY) -> Vehicle:
    """Returns the bogie on its wheels at rest. `primary` is the stiffness of an axle box along x, y, z (N/mm)."""
    bodies = (
        Body("leading wheelset", WHEELSET_MASS, (1120e3, 112e3, 1120e3), (WHEEL_BASE / 2, 0, -RADIUS)),
        Body("trailing wheelset", WHEELSET_MASS, (1120e3, 112e3, 1120e3), (-WHEEL_BASE / 2, 0, -RADIUS)),
        Body("frame", FRAME_MASS, (1722e3, 1476e3, 3067e3), (0, 0, -600)),
        Body("coach", COACH_MASS, (28400e3, 28400e3, 28400e3), (0, 0, -1800)),
    )
    axle_load = GRAVITY * (sum(body.mass for body in bodies)) / 2
    springs: list[Spring] = []

    def add(
        ends: tuple[int, int], start: Point, end: Point, stiffness: float, damping: float, preload: float = 0.0
    ) -> None:
        """Adds a spring between two points at rest."""
        points = [tuple(np.subtract(place, bodies[body].place)) for body, place in zip(ends, (start, end))]
        springs.append(Spring(ends, (points[0], points[1]), stiffness, damping, preload))

    on_box = (axle_load - WHEELSET_MASS * GRAVITY) / 2
    for wheelset, x in enumerate((WHEEL_BASE / 2, -WHEEL_BASE / 2)):
        for side in (-1, 1):
            box = (x, side * HALF_BASE, -RADIUS)
            inwards = (x - np.sign(x) * ARM, side * HALF_BASE, -RADIUS)
            across = (x, side * (HALF_BASE - ARM), -RADIUS)
            above = (x, side * HALF_BASE, -RADIUS - COLUMN)
            add((wheelset, FRAME), box, inwards, primary[0], PRIMARY_DAMPING[0])
            add((wheelset, FRAME), box, across, primary[1], PRIMARY_DAMPING[1])
            add((wheelset, FRAME), box, above, primary[2], PRIMARY_DAMPING[2], -on_box)
    # The coach hangs on the frame by four springs with the stiffness of the benchmark, including its roll bar. They
    # provide most of the lateral stiffness, too: 65 N/mm each.
    for x in (-800, 800):
        for side in (-1, 1):
            top, foot = (x, side * HALF_BASE, -1000), (x, side * HALF_BASE, -1000 + HANGER)
            add((FRAME, COACH), top, foot, 430.0, 20.0, COACH_MASS * GRAVITY / 4)
    for side in (-1, 1):
        add((FRAME, COACH), (0, side * 500, -600), (0, 0, -600), 30.0, 25.0)
        add((FRAME, COACH), (0, side * HALF_BASE, -600), (ARM, side * HALF_BASE, -600), 0.0, 20.0)  # against its yaw
    add((FRAME, COACH), (0, 0, -600), (ARM, 0, -600), 5000.0, 25.0)  # traction of the coach
    return Vehicle(bodies, tuple(springs), 2, RADIUS, axle_load)
