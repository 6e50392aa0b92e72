"""Models a track as a ring of equal bays, one wave number at a time.

With the wave number mu, the unknowns at the right end of a bay are exp(i mu) times those at its left end. Each bay is one
spectral element, so a wave number has 2 ORDER + 1 unknowns: w and t at the points of the bay, and the sleeper at its left
end. The modes without damping of each wave number are kept up to a frequency; the others act as springs. The deflection
also contains the local compliance, which is the kink under the load that polynomials miss.
"""

from __future__ import annotations

import math
from functools import cached_property

import numpy as np
import numpy.typing as npt

from ..calls.answer_warnings import give
from .checks import Array, check_number, checked_array, refused
from .element import ORDER, beam_matrices, clamped_compliance, values_at
from .parameters import Track

__all__ = ["Complex", "Ring"]

Complex = npt.NDArray[np.complex128]

_LEAST_BAYS, _MOST_BAYS = 8, 2048
_LEAST_FREQUENCY = 2000.0  #: Lowest limit of kept modes (Hz).
_MOST_AROUND = 5e-3  #: Largest part of the response at the load that has gone around the ring.
_CHECKED = np.concatenate([[0.0], np.geomspace(20.0, 3000.0, 60)])  #: Frequencies of that check (Hz).


class Ring:
    """A ring of `bays` equal bays. Positions (m) count along the rail; supports are at multiples of the spacing.

    Attributes:
        track: The track.
        bays: Number of bays. 128 represent an endless track; fewer bays give a warning if waves come around.
        highest: Modes with frequencies (Hz, without damping) above it act as springs; None keeps all modes.
    """

    def __init__(self, track: Track, bays: int = 128, highest: float | None = 12e3) -> None:
        check_number("bays", bays, "", _LEAST_BAYS, _MOST_BAYS)
        if highest is not None:
            check_number("highest", highest, "Hz", _LEAST_FREQUENCY, 1e9)
        self.track, self.bays, self.highest = track, 2 * math.ceil(bays / 2), highest
        self._prepare()
        self._warn_of_waves_around()

    @property
    def length(self) -> float:
        """The length of the ring (m)."""
        return self.bays * self.track.spacing

    def _prepare(self) -> None:
        track, half = self.track, self.bays // 2
        self.phases: Array = 2 * math.pi * np.arange(half + 1) / self.bays
        #: Weight of a wave number in real quantities: the others are conjugates.
        self.weights: Array = np.where(np.isin(np.arange(half + 1), (0, half)), 1.0, 2.0) / self.bays
        count = 2 * ORDER + 1
        joined: Complex = np.zeros((half + 1, 2 * (ORDER + 1), count), dtype=np.complex128)
        for first, column in ((0, 0), (ORDER + 1, ORDER)):
            joined[:, first : first + ORDER, column : column + ORDER] = np.eye(ORDER)
            joined[:, first + ORDER, column] = np.exp(1j * self.phases)
        mass, stiffness = beam_matrices(track.rail, track.spacing)
        turned = joined.conj().swapaxes(1, 2)
        m, of_rail = turned @ mass @ joined, turned @ stiffness @ joined
        m[:, -1, -1] += track.sleeper_mass
        k, c = of_rail.copy(), track.rail.loss_time * of_rail
        for matrix, pad, ballast in ((k, track.pad_stiffness, track.ballast_stiffness), (c, track.pad_damping, track.ballast_damping)):
            matrix[:, 0, 0] += pad
            matrix[:, -1, -1] += pad + ballast
            matrix[:, 0, -1] -= pad
            matrix[:, -1, 0] -= pad
        # Generalised eigenvalues by the inverse Cholesky factor of the mass.
        inverse = np.linalg.inv(np.linalg.cholesky(m)).conj().swapaxes(1, 2)
        squares, vectors = np.linalg.eigh(inverse.conj().swapaxes(1, 2) @ k @ inverse)
        kept, vectors = self._kept(squares, inverse @ vectors, k)
        self.squares: Array = kept  #: omega^2 of the modes [wave number, mode].
        self._shapes: Complex = vectors
        self.damping: Complex = vectors.conj().swapaxes(1, 2) @ c @ vectors
        self._rest: Complex = np.linalg.inv(k) - (vectors / kept[:, None, :]) @ vectors.conj().swapaxes(1, 2)
        self._joined = joined
        #: The rail's deflection by mode [wave number, point of a bay, mode].
        self.deflections: Complex = joined[:, : ORDER + 1] @ self._shapes
        # The flexibility of a clamped bay, of the polynomials that vanish at its ends.
        inner = [*range(1, ORDER), *range(ORDER + 2, 2 * ORDER + 1)]
        clamped = np.zeros((ORDER + 1, ORDER + 1))
        clamped[1:ORDER, 1:ORDER] = np.linalg.inv(stiffness[np.ix_(inner, inner)])[: ORDER - 1, : ORDER - 1]
        self._clamped: Array = clamped

    def _kept(self, squares: Array, shapes: Complex, stiffness: Complex) -> tuple[Array, Complex]:
        """Returns squares and shapes of the kept modes, and of one more: the deflection of the cut modes by the force of
        a pad. Without it, dampers of pads would not act on the cut modes.
        """
        count = shapes.shape[2]
        kept = count if self.highest is None else max(1, int((squares < (2 * math.pi * self.highest) ** 2).sum(axis=1).max()))
        if kept >= count - 1:
            return squares, shapes
        rest = shapes[:, :, kept:]
        of_pad = rest[:, 0] - rest[:, -1]
        extra = np.einsum("jkm,jm->jk", rest / squares[:, None, kept:], of_pad.conj())
        mass = np.einsum("jm,jm->j", np.abs(of_pad) ** 2, 1 / squares[:, kept:] ** 2)
        extra /= np.sqrt(mass)[:, None]
        of_extra = np.einsum("jm,jm->j", np.abs(of_pad) ** 2, 1 / squares[:, kept:]) / mass
        both: Complex = np.concatenate([shapes[:, :, :kept], extra[:, :, None]], axis=2)
        return np.concatenate([squares[:, :kept], of_extra[:, None]], axis=1), both

    @cached_property
    def _static(self) -> Array:
        """The flexibility of cut modes within a bay, less that of the inner polynomials [point, point]."""
        of_w = self._joined[:, : ORDER + 1]
        cut = np.einsum("j,jak,jkl,jbl->ab", self.weights, of_w, self._rest, of_w.conj(), optimize=True).real
        found: Array = cut - self._clamped
        return found

    def local_compliance(self, x: Array) -> Array:
        """Returns the deflection (m/N) at the load that the kept modes miss: the kink, and the springs of cut modes."""
        shares = np.asarray(x) / self.track.spacing % 1.0
        values, s = values_at(shares), shares * self.track.spacing
        found: Array = clamped_compliance(self.track.rail, self.track.spacing, s, s)
        found += np.einsum("xa,ab,xb->x", values, self._static, values)
        return found

    def receptance(self, frequencies: npt.ArrayLike, x: float, y: float | None = None) -> Complex:
        """Returns the deflection (m/N, downwards) at `x` by a unit harmonic force at `y`, exp(i omega t). None: at x.

        Args:
            frequencies: Frequencies (Hz), at least 0; 0 is the static deflection.
            x: Position (m).
            y: Position of the force (m).
        """
        hertz = checked_array("frequencies", np.atleast_1d(np.asarray(frequencies, dtype=object)), 1)
        if (hertz < 0).any():
            raise refused("frequencies", float(hertz.min()), "frequencies must be at least 0 Hz.")
        check_number("x", x, "m", -1e6, 1e6)
        y = x if y is None else y
        check_number("y", y, "m", -1e6, 1e6)
        ax, ay = self._rows_at(x), self._rows_at(y)
        at_x, at_y = np.einsum("jk,jkm->jm", ax, self._shapes), np.einsum("jk,jkm->jm", ay, self._shapes)
        found = np.empty(len(hertz), dtype=np.complex128)
        diagonal = np.arange(self.squares.shape[1])
        for i, omega in enumerate(2 * math.pi * hertz):
            matrix = 1j * omega * self.damping
            matrix[:, diagonal, diagonal] += self.squares - omega**2
            # The wave numbers mu and -mu exchange the positions.
            right = np.stack([at_y.conj(), at_x.conj()], axis=2)
            solved = np.linalg.solve(matrix, right)
            found[i] = 0.5 * (self.weights @ (np.einsum("jm,jm->j", at_x, solved[:, :, 0]) + np.einsum("jm,jm->j", at_y, solved[:, :, 1])))
        found += (self.weights @ np.einsum("jk,jkl,jl->j", ax, self._rest, ay.conj())).real
        return found + self._within_a_bay(x, y)

    def static_deflection(self, x: float) -> float:
        """Returns the deflection (m/N) at `x` under a constant force there."""
        return float(self.receptance([0.0], x)[0].real)

    def _rows_at(self, x: float) -> Complex:
        """Returns the deflection at a position by the unknowns of each wave number."""
        bay, share = divmod(x / self.track.spacing, 1.0)
        rows = np.einsum("a,jak->jk", values_at(np.array([share]))[0], self._joined[:, : ORDER + 1])
        found: Complex = rows * np.exp(1j * self.phases * bay)[:, None]
        return found

    def _within_a_bay(self, x: float, y: float) -> float:
        """Returns the part of the deflection that polynomials miss, if both positions are in one bay."""
        (bay, s), (of_load, loaded) = divmod(x, self.track.spacing), divmod(y, self.track.spacing)
        if (bay - of_load) % self.bays:
            return 0.0
        exact = clamped_compliance(self.track.rail, self.track.spacing, np.array([loaded]), np.array([s]))[0]
        at = values_at(np.array([s, loaded]) / self.track.spacing)
        return float(exact - at[0] @ self._clamped @ at[1])

    def part_around(self) -> tuple[float, float]:
        """Returns the largest part of the response at a load that has gone around the ring, and its frequency (Hz).

        It is estimated up to 3 kHz at mid-span: waves that reach the opposite place from both sides with the amplitude A
        return with A^2 relative to the response at the load.
        """
        x = 0.5 * self.track.spacing
        near, far = np.abs(self.receptance(_CHECKED, x)), np.abs(self.receptance(_CHECKED, x + self.length / 2, x))
        around = 2 * (0.5 * far / near) ** 2
        worst = int(np.argmax(around))
        return float(around[worst]), float(_CHECKED[worst])

    def _warn_of_waves_around(self) -> None:
        around, frequency = self.part_around()
        if not around <= _MOST_AROUND:
            give([f"Waves of {frequency:.0f} Hz come around the ring of {self.bays} bays with {around:.2g} of the response at the load. Use more bays, or more damping."])

