"""Advances the ring in time: damped modes of each wave number, in the frame of the bay under the wheel.

With u = (omega q, q') of the undamped modes q, the energy of a wave number is u* u/2, and u' = A u + b F. The eigenvectors
of A give eta' = lambda eta + beta F, which a step with constant or linear force solves exactly. Dampers couple the
undamped modes; so eta is complex, and its energy has mixed terms.
"""

from __future__ import annotations

import numpy as np

from .checks import Array, refused
from .element import values_at
from .ring import Complex, Ring

__all__ = ["TrackModes"]

_MOST_ERROR = 1e-6  #: Largest relative error of the eigenvectors, which are dependent at critical damping.


class TrackModes:
    """The damped modes of a ring, as flat arrays [mode] over all wave numbers.

    Attributes:
        ring: The ring.
        rates: lambda (1/s).
        turns: Factors of a mode from one bay to the next.
    """

    def __init__(self, ring: Ring) -> None:
        self.ring = ring
        waves, count = ring.squares.shape
        omega = np.sqrt(ring.squares)
        matrix = np.zeros((waves, 2 * count, 2 * count), dtype=np.complex128)
        diagonal = np.arange(count)
        matrix[:, diagonal, count + diagonal], matrix[:, count + diagonal, diagonal] = omega, -omega
        matrix[:, count:, count:] = -ring.damping
        rates, vectors = np.linalg.eig(matrix)
        left = np.linalg.inv(vectors)
        error = np.abs((vectors * rates[:, None, :]) @ left - matrix).max(axis=(1, 2)) / np.abs(rates).max(axis=1)
        if error.max() > _MOST_ERROR:
            raise refused("track.pad_damping", ring.track.pad_damping, "the track is damped critically, where it has too few modes. Change a damping by a thousandth.")
        self.rates: Complex = np.minimum(rates.real, 0).ravel() + 1j * rates.imag.ravel()
        self.turns: Complex = np.repeat(np.exp(1j * ring.phases), 2 * count)
        shapes = ring.deflections @ (vectors[:, :count] / omega[:, :, None]) * ring.weights[:, None, None]
        loads = left[:, :, count:] @ ring.deflections.conj().swapaxes(1, 2)
        #: Conjugates of shapes, so that a real product of the parts is the deflection.
        self._shapes: Array = _parts(np.moveaxis(shapes.conj(), 1, 0))
        self._loads: Array = _parts(np.moveaxis(loads, 2, 0))
        weights = ring.weights[:, None, None]
        self._energy: Complex = weights * (vectors.conj().swapaxes(1, 2) @ vectors)
        slow = vectors[:, count:]
        self._damping: Complex = weights * (slow.conj().swapaxes(1, 2) @ ring.damping @ slow)
        self._split = (waves, 2 * count)
        self._lost: dict[float, Complex] = {}

    def at(self, shares: Array) -> tuple[Complex, Complex]:
        """Returns conjugate shapes and loads [position, mode] at shares of the bay of the frame, from 0 to 2."""
        values = values_at(shares % 1.0)
        shapes, loads = (values @ self._shapes).view(np.complex128), (values @ self._loads).view(np.complex128)
        for row in np.flatnonzero(shares >= 1):  # in the next bay
            shapes[row] *= self.turns.conj()
            loads[row] *= self.turns.conj()
        return shapes, loads

    def energy(self, eta: Complex) -> float:
        """Returns kinetic and elastic energy (J) of the modes."""
        of_waves = eta.reshape(self._split)
        return 0.5 * float(np.einsum("jk,jkl,jl->", of_waves.conj(), self._energy, of_waves, optimize=True).real)

    def dissipation(self, free: Complex, step: float) -> Array:
        """Returns the energy (J) dissipated in steps with constant forces. `free` [step, mode] is the difference between
        the modes and their static values under the force, at the beginning of each step.
        """
        of_waves = np.ascontiguousarray(np.moveaxis(free.reshape(-1, *self._split), 1, 0))
        lost: Array = np.einsum("jsk,jsk->s", of_waves.conj(), of_waves @ self._lost_in(step)).real
        return lost

    def _lost_in(self, step: float) -> Complex:
        """Returns the quadratic form of the dissipation in a step [wave number, mode, conjugate mode]."""
        if step not in self._lost:
            rates = self.rates.reshape(self._split)
            sums = (rates.conj()[:, :, None] + rates[:, None, :]) * step
            still = np.abs(sums) < 1e-12
            mean = np.where(still, 1.0, np.expm1(sums) / np.where(still, 1.0, sums))
            self._lost = {step: np.ascontiguousarray((self._damping * mean * step).swapaxes(1, 2))}
        return self._lost[step]


def _parts(values: Complex) -> Array:
    """Returns real and imaginary parts side by side [point, 2 modes]."""
    flat: Array = np.ascontiguousarray(values.reshape(len(values), -1)).view(np.float64)
    return flat
