"""Solves the wheels of a vehicle on their rails at one instant: with contactd in process or with a daemon, or with
another implementation of this interface.
"""

from __future__ import annotations

from collections.abc import Sequence
from contextlib import ExitStack
from types import TracebackType
from typing import NamedTuple, Protocol

import numpy as np

from contactd import Client
from contactd.wheel_rail import (
    RailDeviation,
    Side,
    WheelRailFriction,
    WheelRailSetup,
    WheelRailSolution,
    WheelRailState,
    WheelsetPosition,
    WheelsetVelocity,
)

from .motion import Array, Motion
from .track import Track

SIDES: tuple[Side, Side] = ("left", "right")
ELEMENT = 1.0  # mm: some 200 elements in contact

#: The kinds of contact, the simplest first. "linear" is Kalker's simplified theory with unlimited friction: without
#: slip it is his linear theory, on the true profiles.
SETUPS = {
    "linear": WheelRailSetup(model="fastsim", friction=WheelRailFriction(1000.0), dx=ELEMENT, dy=ELEMENT),
    "fastsim": WheelRailSetup(model="fastsim", friction=WheelRailFriction(0.3), dx=ELEMENT, dy=ELEMENT),
    "full": WheelRailSetup(model="full", friction=WheelRailFriction(0.3), dx=ELEMENT, dy=ELEMENT),
}


class OnWheelset(NamedTuple):
    """Holds the force and moment of one wheel's rail on its wheelset.

    Attributes:
        force: Force in track coordinates (N).
        moment: Moment about the wheelset's centre, along its own axes, which do not rotate with its pitch (N mm).
        power: Frictional dissipation in the contact (N mm/s).
    """

    force: Array
    moment: Array
    power: float


class Wheels(Protocol):
    """Defines the interface between a vehicle and its contacts: returns forces for the states of all wheels, in a
    fixed order.

    Steady rolling has no history, so an integrator may evaluate any state at any time, any number of times. Raises
    InvalidArgument if a wheel is outside the range of elastic contact, off its rail.
    """

    def __call__(self, states: Sequence[WheelRailState]) -> list[OnWheelset]: ...


class SessionWheels:
    """Uses a session for each wheel; all are stepped in one message. The client may be that of contactd.local() or of
    a daemon.
    """

    def __init__(self, client: Client, setups: Sequence[WheelRailSetup]) -> None:
        self._client = client
        with ExitStack() as stack:
            self._sessions = [
                stack.enter_context(client.wheel_rail_session(setup, accept_unconverged=True)) for setup in setups
            ]
            self._open = stack.pop_all()

    def __call__(self, states: Sequence[WheelRailState]) -> list[OnWheelset]:
        steps = zip(self._sessions, [{"state": state, "patches": False} for state in states], strict=True)
        answers = self._client.step_many(steps)
        for answer in answers:
            if isinstance(answer, Exception):
                raise answer
        return [on_wheelset(answer) for answer in answers]

    def __enter__(self) -> SessionWheels:
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        self._open.close()


def on_wheelset(answer: WheelRailSolution) -> OnWheelset:
    """Returns the forces on the wheelset; those of an answer act on the rail."""
    track, wheelset = answer.forces.track, answer.forces.wheelset
    force, moment = -np.array([track.Fx, track.Fy, track.Fz]), -np.array([wheelset.Mx, wheelset.My, wheelset.Mz])
    return OnWheelset(force, moment, answer.frictional_power or 0.0)


def wheel_state(side: Side, motion: Motion, track: Track) -> WheelRailState:
    """Returns the state of a wheel with a given height, on a rail without deviation."""
    y, z, y_slope, z_slope = track.deviation(side, motion.distance)
    return WheelRailState(
        position=WheelsetPosition(y=motion.y, z=motion.z, roll=motion.roll, yaw=motion.yaw),
        velocity=WheelsetVelocity(
            x=motion.vx, y=motion.vy, z=motion.vz,
            roll=motion.roll_rate, pitch=motion.pitch_rate, yaw=motion.yaw_rate,
        ),
        rail=RailDeviation(y=y, z=z, y_velocity=y_slope * motion.vx, z_velocity=z_slope * motion.vx),
    )  # fmt: skip


def height_under(client: Client, setups: Sequence[WheelRailSetup], load: float) -> float:
    """Returns z of a centred wheelset under a load (mm): the mean of its wheels."""
    state = WheelRailState(velocity=WheelsetVelocity(x=1000, pitch=-1000 / 460), Fz=load / len(setups))
    return float(np.mean([client.wheel_rail(setup, state, fields=[]).z for setup in setups]))
