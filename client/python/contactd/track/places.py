"""Holds the modes of a track at the positions of steps. They repeat from bay to bay, and are computed once."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from .checks import Array
from .modes import TrackModes
from .ring import Complex

__all__ = ["PlaceTable", "Places", "rows_of"]

_MOST_BYTES = 200e6  #: Memory for the positions of a bay.


@dataclass(frozen=True)
class Places:
    """Modes at the positions after the steps of a block.

    Attributes:
        shapes: Conjugate shapes [step, mode].
        moves: Change of the modes by a constant unit force in a step [step, mode].
        grows: The same for a force that grows from 0 to 1; None unless the scheme is linear.
        deflected: Deflection by `moves` [step].
        of_growth: Deflection by `grows` [step].
        compliance: Local compliance [step].
    """

    shapes: Complex
    moves: Complex
    grows: Complex | None
    deflected: Array
    of_growth: Array
    compliance: Array

    def first(self, count: int) -> Places:
        """Returns those of the first steps."""
        arrays = (self.shapes, self.moves, self.grows, self.deflected, self.of_growth, self.compliance)
        return Places(*(None if array is None else array[:count] for array in arrays))  # type: ignore[arg-type]


class PlaceTable:
    """Computes the modes at positions, and keeps those of a bay if they fit into memory.

    Args:
        track: The modes.
        step: Duration of a step (s).
        advance: Factors of the modes in a step.
        grows: Whether forces vary linearly in a step.
        steps_of_bay: Steps in a bay; 0 at standstill.
    """

    def __init__(self, track: TrackModes, step: float, advance: Complex, grows: bool, steps_of_bay: int) -> None:
        self._track, self._step, self._grows, self._steps_of_bay = track, step, grows, steps_of_bay
        self._part = (advance - 1) / track.rates
        self._kept: dict[int, Places] = {}

    def at(self, step: int, positions: Array, frame: int) -> Places:
        """Returns the modes at the positions (m) after a step, in the frame of that bay."""
        in_bay = step % self._steps_of_bay if self._steps_of_bay else 0
        known = self._kept.get(in_bay)
        if known is None or len(known.compliance) < len(positions):
            known = self.made(positions, frame)
            if 3 * known.shapes.nbytes * self._steps_of_bay / len(positions) < _MOST_BYTES:
                self._kept[in_bay] = known
        return known.first(len(positions))

    def made(self, positions: Array, frame: int) -> Places:
        """Computes the modes at positions."""
        ring, rates, step = self._track.ring, self._track.rates, self._step
        shapes, loads = self._track.at(np.maximum(positions / ring.track.spacing - frame, 0.0))
        moves, grows = loads * self._part, None
        of_growth: Array = np.zeros(len(positions))
        if self._grows:
            grows = loads * ((self._part - step) / (rates * step))
            of_growth = rows_of(shapes, grows)
        return Places(shapes, moves, grows, rows_of(shapes, moves), of_growth, ring.local_compliance(positions))


def rows_of(conjugates: Complex, etas: Complex) -> Array:
    """Returns the deflection of each row."""
    found: Array = np.einsum("sm,sm->s", conjugates.real, etas.real) + np.einsum("sm,sm->s", conjugates.imag, etas.imag)
    return found
