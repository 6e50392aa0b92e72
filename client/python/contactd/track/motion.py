"""Advances wheel and track together, step by step, with the energy balance."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence

import numpy as np

from ..errors import Aborted, status_error
from .checks import Array
from .irregularities import Irregularity, height_at
from .laws import Law
from .modes import TrackModes
from .places import Places, PlaceTable, rows_of
from .ring import Complex, Ring
from .run import Evidence
from .schemes import Scheme, StepEquation
from .wheel import LinearWheel, Wheel

__all__ = ["Motion"]

#: Largest error of a step's force, over the load: of closed forms, and of contact solves with their tolerances.
_TOLERANCE, _TOLERANCE_OF_SOLVES = 1e-12, 1e-6
_BLOCK = 128
_MOST_TRIALS = 200


class Motion:
    """The state of wheel and track, and its steps.

    The geometry of a step is that of its end: first the wheel moves on over the unmoved rail, which is the work of the
    moving geometry, then forces act for the duration of the step. A bay has a whole number of steps.

    Attributes:
        steps: Steps since `begin`.
        steps_of_bay: Steps in a bay; 0 at standstill.
    """

    def __init__(self, ring: Ring, wheel: Wheel, law: Law, irregularities: Sequence[Irregularity], start: float,
                 distance: float, step: float, scheme: Scheme) -> None:  # fmt: skip
        self._ring, self._wheel, self._law, self._scheme = ring, wheel, law, scheme
        self._heights = tuple(irregularities)
        self._start, self._distance, self._step = start, distance, step
        self.steps_of_bay = round(ring.track.spacing / distance) if distance else 0
        self._track, self._linear = TrackModes(ring), LinearWheel(wheel, step)
        self._advance = np.exp(self._track.rates * step)
        self._statics = 1 / (1 - self._advance)  #: Static values over `moves`.
        self._tolerance = wheel.load * (_TOLERANCE if law.has_energy else _TOLERANCE_OF_SOLVES)
        self._equation = StepEquation(law, self._tolerance)
        self._table = PlaceTable(self._track, step, self._advance, scheme == "linear", self.steps_of_bay)
        self._eta: Complex = np.zeros(0, dtype=np.complex128)
        self._at, self._frame, self._accounts = 0, 0, False
        self._rest(0)

    def go_before(self, bays: int) -> None:
        """Places the resting wheel that number of bays before the start."""
        self._rest(-bays * self.steps_of_bay)

    def begin(self) -> None:
        """Moves by whole bays to the start, with unchanged motion, and starts the records of energy and trials."""
        if self._at:
            bays = -(self._at // self.steps_of_bay)
            self._at, self._frame = self._at + bays * self.steps_of_bay, self._frame + bays
        self._accounts = True
        self.steps, self._losses, self._work, self._lost, self._of_contact = 0, 0, 0.0, 0.0, 0.0
        self._energy = self._stored()
        self._equation.trials = self._equation.most_trials = 0
        self._equation.residual = 0.0

    def evidence(self, rolled: float, start_error: float) -> Evidence:
        """Returns the evidence of the steps since `begin`."""
        change, equation = self._stored() - self._energy + self._of_contact, self._equation
        error = self._work - self._lost - change if self._law.has_energy else math.nan
        return Evidence(self.steps, rolled, start_error, equation.trials / max(self.steps, 1), equation.most_trials,
                        equation.residual, self._losses, self._work, self._lost, change, error)  # fmt: skip

    def blocks(self, count: int) -> Iterator[Array]:
        """Solves `count` steps, and yields rows [step, column] as in Run."""
        while count > 0:
            number = min(count, _BLOCK, self.steps_of_bay - self._at % self.steps_of_bay if self.steps_of_bay else _BLOCK)
            frame = self._frame_of(self._at)
            for _ in range(frame - self._frame):
                self._eta = self._eta * self._track.turns
            self._frame = frame
            steps = self._at + 1 + np.arange(number, dtype=np.float64)
            yield self._solve(number, self._table.at(self._at, self._position(steps if self._distance else np.zeros(1)), frame))
            count -= number

    def _position(self, step: int | Array) -> Array:
        return np.asarray(self._start + step * self._distance)

    def _frame_of(self, step: int) -> int:
        return math.floor(float(self._position(step)) / self._ring.track.spacing + 1e-9)

    def _rest(self, step: int) -> None:
        """Sets the equilibrium of wheel and track at rest."""
        self._at, self._frame = step, self._frame_of(step)
        load, height = self._wheel.load, self._height_after(np.array([step]))[0]
        places = self._table.made(self._position(np.array([float(step)])), self._frame)
        self._approach, self._force = self._equilibrium(load)
        self._eta = places.moves[0] * self._statics * load
        self._compliance = float(places.compliance[0])
        deflection = _real(places.shapes[0], self._eta) + self._compliance * load
        self._states = self._linear.rigid * (self._approach + deflection - height)
        self.steps, self._losses, self._work, self._lost, self._of_contact = 0, 0, 0.0, 0.0, 0.0
        self._energy = self._stored()

    def _equilibrium(self, load: float) -> tuple[float, float]:
        """Returns the approach under the load, and the force there."""
        d, low, high = (load / 9e10) ** (2 / 3), -math.inf, math.inf
        last: tuple[float, float] | None = None
        for trial in range(_MOST_TRIALS):
            force, slope = self._law.force(d, self._start, trial > 0)
            if abs(force - load) <= self._tolerance or high - low <= 1e-15:
                return d, force
            low, high = (d, high) if force < load else (low, d)
            if slope is None and last is not None and d != last[0]:
                slope = (force - last[1]) / (d - last[0])
            last = (d, force)
            change = (load - force) / slope if slope else math.copysign(0.1 * abs(d) + 1e-6, load - force)
            wanted = d + min(max(change, -1e-3), 1e-3)
            d = wanted if low < wanted < high else 0.5 * (low + high)
        raise status_error(Aborted.code, f"The law of the contact does not reach the load of {load:g} N.", reason="NOT_CONVERGED")

    def _stored(self) -> float:
        contact = self._law.energy(self._approach) if self._law.has_energy else 0.0
        of_track = self._track.energy(self._eta) + 0.5 * self._compliance * self._force**2
        return contact + of_track + self._linear.energy(self._states, self._wheel.load)

    def _height_after(self, steps: Array) -> Array:
        return height_at(self._heights, self._position(np.maximum(steps, 0)))

    def _solve(self, number: int, places: Places) -> Array:
        """Solves the steps of a block, and returns its rows."""
        is_linear, is_gradient = self._scheme == "linear", self._scheme == "gradient"
        wheel, equation, load, advance = self._linear, self._equation, self._wheel.load, self._advance
        share = 0.5 if self._scheme == "mean" else 1.0
        by_load, at_contact = wheel.constant * load, wheel.at_contact
        by_force = wheel.growing if is_linear else wheel.constant
        of_wheel = float(at_contact @ by_force)
        heights = self._height_after(self._at + 1 + np.arange(number, dtype=np.float64))
        positions = self._position(self._at + 1 + np.arange(number, dtype=np.float64))
        etas = np.empty((number + 1, len(advance)), dtype=np.complex128)
        states = np.empty((number + 1, len(self._states)))
        approaches, forces, means, after = np.empty(number + 1), np.empty(number + 1), np.empty(number), np.empty(number)
        etas[0], states[0], approaches[0], forces[0] = self._eta, self._states, self._approach, self._force
        before_all = self._compliance
        d, force, previous_change = self._approach, self._force, 0.0
        for i in range(number):
            row = i if self._distance else 0
            shapes, c = places.shapes[row], float(places.compliance[row])
            free = np.multiply(etas[i], advance, out=etas[i + 1])
            moved = wheel.advance @ states[i] + by_load
            deflected = float(places.deflected[row])
            rail, b = _real(shapes, free), deflected
            before: tuple[float, float] | None = (d, force)
            if is_linear and places.grows is not None:
                b = float(places.of_growth[row])
                rail += (deflected - b) * force
                free += (places.moves[row] - places.grows[row]) * force
                moved -= (wheel.constant - wheel.growing) * force
                before = None
            elif is_gradient:
                height = float(at_contact @ states[i]) - _real(shapes, etas[i]) + float(heights[i])
                before = self._in_series(height, c, d)
                self._work += self._contact_energy(before, c) - self._contact_energy((d, force), before_all)
                before_all = c
            a = float(at_contact @ moved) - rail + float(heights[i])
            first = min(d + previous_change, a) if a > 0 else a
            new, force, mean = equation.solve(a, b + of_wheel, c, float(positions[i]), first, share, before)
            previous_change, d = new - d, new
            moved -= by_force * mean
            free += (places.grows if is_linear and places.grows is not None else places.moves)[row] * mean
            states[i + 1], approaches[i + 1], forces[i + 1] = moved, new, force
            means[i], after[i] = (0.5 * (forces[i] + force) if is_linear else mean), rail + b * mean
        if self._accounts:
            self._account(places, etas, states, approaches, forces, means, after, is_gradient)
        self._eta, self._states, self._approach, self._force = etas[-1].copy(), states[-1].copy(), d, force
        self._compliance = float(places.compliance[-1])
        self._at, self.steps = self._at + number if self._distance else self._at, self.steps + number
        times = self._step * (self.steps - number + 1 + np.arange(number))
        shown = means if is_gradient else forces[1:]
        return np.column_stack([times, positions, shown, states[1:] @ at_contact, after + places.compliance * forces[1:], approaches[1:]])

    def _account(self, places: Places, etas: Complex, states: Array, approaches: Array, forces: Array, means: Array, after: Array, is_gradient: bool) -> None:
        """Adds the block to losses of contact, work and dissipation."""
        self._losses += int(((forces[:-1] > 0) & (forces[1:] <= 0)).sum())
        compliance = np.broadcast_to(places.compliance, means.shape)
        before = np.concatenate([[self._compliance], compliance[:-1]])
        total = approaches[1:] + compliance * forces[1:] - approaches[:-1] - before * forces[:-1]
        if not is_gradient:
            unmoved = after - rows_of(np.broadcast_to(places.shapes, etas[:-1].shape), etas[:-1])
            by_states = np.diff(states @ self._linear.at_contact) - unmoved
            self._work += float((means * (total - by_states) - 0.5 * means**2 * (compliance - before)).sum())
        if not self._law.has_energy:
            stored = np.diff(0.5 * np.concatenate([[self._compliance], compliance]) * forces**2)
            self._of_contact += float((means * total - 0.5 * means**2 * (compliance - before) - stored).sum())
        free = etas[:-1] - places.moves * self._statics * means[:, None]
        self._lost += float(self._track.dissipation(free, self._step).sum())
        self._lost += float(self._linear.dissipation(states[:-1], self._wheel.load - means).sum())

    def _contact_energy(self, state: tuple[float, float], c: float) -> float:
        return self._law.energy(state[0]) + 0.5 * c * state[1] ** 2

    def _in_series(self, total: float, c: float, start: float) -> tuple[float, float]:
        """Returns approach and force of contact and local compliance in series, under a total approach."""
        if total <= 0:
            return total, 0.0
        d = min(max(start, 0.0), total) or total
        for _ in range(50):
            force, slope = self._law.force(d, 0.0, True)
            change = (total - d - c * force) / (1 + c * (slope or 0.0))
            d += change
            if abs(change) <= 1e-15 * abs(total):
                break
        return d, self._law.force(d, 0.0, True)[0]


def _real(conjugates: Complex, eta: Complex) -> float:
    return float(conjugates.view(np.float64) @ eta.view(np.float64))
