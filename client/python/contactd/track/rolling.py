"""Rolls a wheel over a track in time."""

from __future__ import annotations

import math
import os
import time
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Literal

import numpy as np

from ..calls.answer_warnings import collected, give
from ..values.generated.service import Progress
from .checks import Array, check_number, refused
from .irregularities import Irregularity, Record
from .laws import Law
from .motion import Motion
from .ring import Ring
from .run import Output, Run
from .schemes import Scheme
from .wheel import Wheel

__all__ = ["Start", "roll"]

Start = Literal["rolled", "static"]

_LINEAR_RATE = 20e3  #: Lowest rate (Hz) of the scheme "linear", which diverges at larger steps.
_LEAST_ROLLED, _MOST_ROLLED, _MOST_STEPS_ROLLED = 4, 60, 200_000  #: Bays rolled before the start; steps of these.
_LEAST_STEPS = 24  #: Steps of a bay.
_REPEATS = 1e-3  #: Change of the force from bay to bay, over the load.
_FAST, _FASTEST = 100.0, 170.0  #: Speeds (m/s) above which km/h are likely or certain.
_MOST_STEPS = 10_000_000  #: Without a file.
_MISSED = 5e-7  #: Height (m) between the positions of steps that gives a warning.
_MOST_FORCE = 10.0  #: Largest force over the load without a warning.
_MOST_WARNINGS = 5  #: Number of different warnings of contact solves in a run.
_REPORTS = 0.2  #: Seconds between reports of progress.


def roll(
    ring: Ring,
    wheel: Wheel,
    law: Law,
    *,
    speed: float,
    duration: float,
    irregularities: Sequence[Irregularity] = (),
    position: float = 0.0,
    rate: float = 40e3,
    scheme: Scheme = "mean",
    start: Start = "rolled",
    path: str | os.PathLike[str] | None = None,
    on_progress: Callable[[Progress], None] | None = None,
) -> Run:
    """Rolls a wheel over a track, and returns the force in time.

    Args:
        ring: The track. Its ends are joined, so that a run may be longer than the ring.
        wheel: The wheel.
        law: The law of the contact: Hertz, ContactLaw or WheelRailLaw.
        speed: Speed (m/s); 0 for a wheel at one place.
        duration: Duration of the run (s).
        irregularities: Heights along the rail, which are added.
        position: Position of the wheel at the start (m).
        rate: Steps per second (Hz).
        scheme: "mean": the force of a step is the mean of both ends. "linear": it varies linearly; more accurate, but
            refused below 20 kHz. "gradient": it is the discrete gradient of the energy, which conserves energy at any
            rate; for laws with energy.
        start: "rolled": the wheel has rolled up to `position` on a smooth rail, with the height of the irregularities at
            `position`, until the force repeats from bay to bay. "static": equilibrium of wheel and track at rest.
        path: A file that gets the steps as they are solved, as comma-separated text; read_run reads it, also if the
            program is killed. The returned run then has no arrays.
        on_progress: Called a few times a second. An exception that it raises ends the run; the file keeps all steps
            so far.

    Raises InvalidArgument naming an invalid argument, and Aborted if a step does not converge.
    """
    if not isinstance(ring, Ring):
        raise refused("ring", ring, "it must be a Ring. Create one from the track: Ring(track).")
    _check(wheel, law, speed, duration, position, rate, scheme, start, irregularities)
    if speed >= (critical := ring.track.critical_speed):
        raise refused("speed", float(speed), f"the critical speed of the track is {critical:.0f} m/s. Use a lower speed, or check the track.")
    step, distance = _step_of(ring, speed, rate)
    steps = math.ceil(duration / step - 1e-6)
    _check_steps(irregularities, distance, steps, path, position)
    motion = Motion(ring, wheel, law, irregularities, position, distance, step, scheme)
    reports = _Reports(on_progress)
    with Output(path) as output:
        with collected() as sentences:
            rolled, change = _roll_in(motion, wheel, reports) if start == "rolled" and speed > 0 else (0, 0.0)
            motion.begin()
            largest = 0.0
            for block in motion.blocks(steps):
                output.add(block)
                largest = max(largest, float(block[:, 2].max()))
                reports.give("rolling", motion.steps / steps)
        run = output.end(motion.evidence(rolled * ring.track.spacing, change))
    if largest > _MOST_FORCE * wheel.load:
        sentences.insert(0, f"The force reaches {largest / wheel.load:.0f} times the load, where steel yields. Check the unit and the sign of the heights, and the speed.")
    if change > _REPEATS:
        sentences.insert(0, f"The force still changes by {change:.2g} of the load from bay to bay after {rolled} bays. The start is not periodic.")
    if len(sentences) > _MOST_WARNINGS:
        sentences[_MOST_WARNINGS:] = [f"{len(sentences) - _MOST_WARNINGS} more warnings of contacts are similar."]
    give(sentences)
    return run


def _step_of(ring: Ring, speed: float, rate: float) -> tuple[float, float]:
    """Returns duration (s) and distance (m) of a step: a bay has a whole number of steps."""
    if speed == 0:
        return 1 / rate, 0.0
    spacing = ring.track.spacing
    steps = math.ceil(rate * spacing / speed * (1 - 1e-12))
    if steps < _LEAST_STEPS:
        raise refused("rate", float(rate), f"a bay must have at least {_LEAST_STEPS} steps. Use at least {_LEAST_STEPS * speed / spacing:.0f} Hz.")
    return spacing / speed / steps, spacing / steps


def _roll_in(motion: Motion, wheel: Wheel, reports: _Reports) -> tuple[int, float]:
    """Rolls until the force repeats from bay to bay. Returns the number of bays and the last relative change."""
    most = min(_MOST_ROLLED, max(_LEAST_ROLLED, _MOST_STEPS_ROLLED // motion.steps_of_bay))
    motion.go_before(most)
    change, bays = math.inf, 0
    previous: Array = np.zeros(0)
    while bays < most and (bays < _LEAST_ROLLED or change > 0.1 * _REPEATS):
        forces = np.concatenate([block[:, 2] for block in motion.blocks(motion.steps_of_bay)])
        change = float(np.abs(forces - previous).max()) / wheel.load if previous.size else math.inf
        previous, bays = forces, bays + 1
        reports.give("rolling in", 0.0)
    return bays, change


@dataclass
class _Reports:
    """Reports progress from time to time."""

    callback: Callable[[Progress], None] | None
    last: float = -math.inf

    def give(self, stage: str, fraction: float) -> None:
        now = time.monotonic()
        if self.callback is not None and (now - self.last >= _REPORTS or fraction >= 1):
            self.last = now
            self.callback(Progress(stage=stage, fraction=fraction))


def _check(wheel: Wheel, law: Law, speed: float, duration: float, position: float, rate: float, scheme: str, start: str,
           irregularities: Sequence[Irregularity]) -> None:  # fmt: skip
    if not isinstance(wheel, Wheel):
        raise refused("wheel", wheel, "it must be a Wheel.")
    if not hasattr(law, "force"):
        raise refused("law", law, "it must be Hertz, ContactLaw or WheelRailLaw.")
    check_number("speed", speed, "m/s", 0, _FASTEST, "Did you give km/h?")
    if speed > _FAST:
        give([f"speed = {speed:g} m/s is {3.6 * speed:.0f} km/h. Speeds are in m/s."])
    check_number("duration", duration, "s", 1e-6, 1e6)
    check_number("position", position, "m", -1e6, 1e6)
    check_number("rate", rate, "Hz", 1000, 1e7)
    for name, given, words in (("scheme", scheme, ("mean", "linear", "gradient")), ("start", start, ("rolled", "static"))):
        if given not in words:
            raise refused(name, given, f"give one of {', '.join(words)}.")
    if scheme == "linear" and rate < _LINEAR_RATE:
        raise refused("rate", float(rate), f"the scheme linear diverges at such steps; it requires {_LINEAR_RATE:g} Hz. Use scheme mean, or a higher rate.")
    if scheme == "gradient" and not law.has_energy:
        raise refused("scheme", scheme, "it requires a law with energy, such as Hertz. Use mean.")
    for i, one in enumerate(irregularities):
        if not hasattr(one, "height"):
            raise refused(f"irregularities[{i}]", one, "it must be a Record, a Flat or a DippedJoint.")


def _check_steps(irregularities: Sequence[Irregularity], distance: float, steps: int, path: object, position: float) -> None:
    if path is None and steps > _MOST_STEPS:
        raise refused("duration", steps, f"more than {_MOST_STEPS} steps do not fit into memory. Give a path.")
    end = position + steps * distance
    for i, one in enumerate(irregularities):
        if distance and (missed := one.unresolved(distance)) > _MISSED:
            give([f"irregularities[{i}]: steps of {1000 * distance:.3g} mm miss {1e6 * missed:.2g} um of the height. Use a higher rate, or filter the record by the contact."])
        if isinstance(one, Record) and (position < one.x[0] - 1e-9 or end > one.x[-1] + 1e-9):
            give([f"irregularities[{i}] covers {one.x[0]:g} to {one.x[-1]:g} m, but the run {position:g} to {end:g} m. Its end values apply outside."])
