"""Who solves the wheels of a vehicle on their rails: all of them at one instant, by contactd in process or by a daemon, or
by whatever else has this face."""

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

#: The kinds of contact, from the simplest on. "linear" is Kalker's simplified theory with friction that knows no bound:
#: without slip it is his linear theory, on the true profiles.
SETUPS = {
    "linear": WheelRailSetup(model="fastsim", friction=WheelRailFriction(1000.0), dx=ELEMENT, dy=ELEMENT),
    "fastsim": WheelRailSetup(model="fastsim", friction=WheelRailFriction(0.3), dx=ELEMENT, dy=ELEMENT),
    "full": WheelRailSetup(model="full", friction=WheelRailFriction(0.3), dx=ELEMENT, dy=ELEMENT),
}


class OnWheelset(NamedTuple):
    """Force and moment of one wheel's rail on its wheelset.

    Attributes:
        force: In track coordinates (N).
        moment: About the wheelset's centre, along its own axes, which do not turn with its pitch (N mm).
        power: What friction dissipates in the contact (N mm/s).
    """

    force: Array
    moment: Array
    power: float


class Wheels(Protocol):
    """The seam between a vehicle and its contacts: states of all wheels in, in an order that does not change, and forces out.

    Steady rolling has no history. So an integrator may ask for any state at any time, and as often as it likes. Raises
    InvalidArgument where a wheel is told to be where no elastic contact is: it is off its rail.
    """

    def __call__(self, states: Sequence[WheelRailState]) -> list[OnWheelset]: ...


class SessionWheels:
    """A session for each wheel, stepped together in one message. The client is contactd.local()'s or one of a daemon: it is
    all the same here.
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
    """Forces on the wheelset by an answer: its forces act on the rail."""
    track, wheelset = answer.forces.track, answer.forces.wheelset
    force, moment = -np.array([track.Fx, track.Fy, track.Fz]), -np.array([wheelset.Mx, wheelset.My, wheelset.Mz])
    return OnWheelset(force, moment, answer.frictional_power or 0.0)


def wheel_state(side: Side, motion: Motion, track: Track) -> WheelRailState:
    """State of a wheel whose height is given, on a rail that is where the track has it."""
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
    """The z at which a wheelset in the middle of the track bears a load (mm): the mean of its wheels."""
    state = WheelRailState(velocity=WheelsetVelocity(x=1000, pitch=-1000 / 460), Fz=load / len(setups))
    return float(np.mean([client.wheel_rail(setup, state, fields=[]).z for setup in setups]))
