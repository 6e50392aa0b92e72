"""The contact filter: the ratio of effective to measured roughness by wavelength, to first order."""

from __future__ import annotations

import math
import warnings
from dataclasses import dataclass
from typing import Literal

import numpy as np
import numpy.typing as npt

from ..calls.answer_warnings import ContactWarning
from ..errors import invalid
from ..values.arrays import Array
from .records import Record
from .spectra import Lines, Spectrum
from .weights import ContactWeights, EllipseWeights

__all__ = ["ContactFilter", "Weights", "effective"]

Weights = ContactWeights | EllipseWeights

_NODES = 400  #: Number of wave directions.
_BAND_NODES = 24  #: Number of wavelengths in a band.
_PIECE = 1 << 22  #: Largest number of values of an array.
_LOBES = 8.0  #: Half the length of a kernel in reaches of the contact.
_FEWEST = 32  #: Number of elements across a contact below which filters err by 0.1 dB and more at 16 mm.


@dataclass(frozen=True)
class ContactFilter:
    """The filter of a contact under an assumption about the roughness across.

    Attributes:
        weights: Weights of the contact.
        across: "isotropic": waves have all directions, with a spectrum S(K) ~ K^-exponent of the surface. "alike": heights
            do not depend on y.
        exponent: Exponent of the isotropic surface, 2 to 8. The spectrum along a line is then ~ k^(1 - exponent).
    """

    weights: Weights
    across: Literal["isotropic", "alike"] = "isotropic"
    exponent: float = 3.0

    def __post_init__(self) -> None:
        """Raises InvalidArgument naming an invalid field. Warns (ContactWarning) if the contact has few elements."""
        if self.across not in ("isotropic", "alike"):
            raise invalid("across", f"= {self.across!r}: it must be isotropic or alike. With several measured lines, use effective().")
        if not 2 <= self.exponent <= 8:
            raise invalid("exponent", f"= {self.exponent}: the exponent must lie between 2 and 8. Measured surfaces have 2.5 to 4.")
        warn_of_few_elements(self.weights)

    def power(self, wavelengths: npt.ArrayLike) -> Array:
        """Returns |H|^2 at wavelengths along the track (mm), which is 1 for long waves."""
        waves = np.asarray(wavelengths, dtype=float)
        if waves.size and not (waves > 0).all():
            raise invalid("wavelengths", f"= {float(waves.min())} mm: wavelengths must be positive. Give them in mm.")
        return np.asarray(self._power(2 * np.pi / waves.ravel()).reshape(waves.shape))

    def levels(self, wavelengths: npt.ArrayLike) -> Array:
        """Returns 10 lg |H|^2 in dB at wavelengths (mm)."""
        return np.asarray(10 * np.log10(self.power(wavelengths)))

    def band_levels(self, wavelengths: npt.ArrayLike) -> Array:
        """Returns the filter in dB in the third octave around each wavelength (mm): the mean of |H|^2 for the spectrum
        k^(1 - exponent) along a line. Use third_octaves for that of a record.
        """
        waves = np.asarray(wavelengths, dtype=float)
        nodes, weights = np.polynomial.legendre.leggauss(_BAND_NODES)
        ratios = 10 ** (nodes / 20)
        parts = weights * ratios ** (self.exponent - 2)  # k^(1 - exponent) dk in the logarithm of the wavelength
        return np.asarray(10 * np.log10(self.power(waves[..., None] * ratios) @ parts / parts.sum()))

    def filtered(self, lines: Lines) -> Lines:
        """Returns the spectrum of the effective roughness."""
        return Lines(lines.step, lines.squares * self.power(lines.wavelengths), lines.segments)

    def third_octaves(self, lines: Lines) -> Spectrum:
        """Returns the filter in third octaves in dB: the mean of |H|^2 over the lines of each band, weighted with the
        spectrum of a record. It differs by up to 1.1 dB from the value at the centre.
        """
        names, shares = lines.bands()
        before, after = shares @ lines.squares, shares @ self.filtered(lines).squares
        plain = shares @ self.power(lines.wavelengths) / shares.sum(axis=1)
        with np.errstate(divide="ignore", invalid="ignore"):
            return Spectrum(names, np.asarray(10 * np.log10(np.where(before > 0, after / before, plain))))

    def applied(self, record: Record) -> Record:
        """Returns the effective roughness along each line of a record. The ends of the record, where the kernel has no
        data, are cut off.
        """
        waves = _waves_of(record, self.weights)
        if self.across == "alike":
            kernel = _kernel(self.weights.transform(waves, np.zeros((len(waves), 1)))[:, 0], record, self.weights)
        else:
            kernel = _kernel(np.sqrt(self._power(waves)).astype(complex), record, self.weights)
        return _convolved(record, [(i, kernel) for i in range(len(record.y))], record.y)

    def _power(self, kx: Array) -> Array:
        if self.across == "alike":
            return np.abs(self.weights.transform(kx, np.zeros((len(kx), 1)))[:, 0]) ** 2
        nodes, weights = np.polynomial.legendre.leggauss(_NODES)
        angle = np.pi / 2 * nodes
        parts = weights * np.cos(angle) ** (self.exponent - 2)
        rows = len(np.unique(self.weights.y)) if isinstance(self.weights, ContactWeights) else 1
        found = np.empty(len(kx))
        for part in np.array_split(np.arange(len(kx)), math.ceil(len(kx) * _NODES * rows / _PIECE) or 1):
            transform = self.weights.transform(kx[part], np.outer(kx[part], np.tan(angle)))
            found[part] = np.abs(transform) ** 2 @ parts / parts.sum()
        return found


def effective(weights: Weights, record: Record) -> Record:
    """Returns the effective roughness of a contact on lines measured at several y, or on a map: one line at y = 0.

    Heights are linear between the lines, and constant beyond the outer ones, of which it warns (ContactWarning). y = 0
    of the record is that of the weights. The ends of the record are cut off as in ContactFilter.applied. Raises
    InvalidArgument for one line, which requires an assumption: use ContactFilter.
    """
    if len(record.y) < 2:
        raise invalid("record", "= one line: the heights beside it are unknown. Use ContactFilter with isotropic or alike roughness.")
    warn_of_few_elements(weights)
    points = weights.points()
    outside = float(points.values[(points.y < record.y[0]) | (points.y > record.y[-1])].sum())
    if outside > 1e-3:
        warnings.warn(ContactWarning(f"record.y = {record.y[0]:g} to {record.y[-1]:g} mm: {outside:.0%} of the contact's weight lies beyond the lines."), stacklevel=2)
    waves = _waves_of(record, points)
    shares = np.stack([np.interp(points.y, record.y, line) for line in np.eye(len(record.y))])
    phases = np.exp(1j * np.outer(waves, points.x)) * points.values
    kernels = [(i, _kernel(phases @ share, record, points)) for i, share in enumerate(shares) if share.any()]
    return _convolved(record, kernels, None)


def warn_of_few_elements(weights: Weights) -> None:
    """Warns if a computed contact has fewer than 32 elements across, along x or y."""
    if isinstance(weights, ContactWeights) and min(weights.size) > 0:
        counts = [round(float(np.ptp(part)) / size) + 1 for part, size in zip((weights.x, weights.y), weights.size)]
        if min(counts) < _FEWEST:
            warnings.warn(ContactWarning(f"weights: the contact has {counts[0]} x {counts[1]} elements. Use {_FEWEST} across or more: filters of short waves follow the staircase of its outline."), stacklevel=4)


def _waves_of(record: Record, weights: Weights) -> Array:
    """Returns the wavenumbers (rad/mm) that determine a kernel."""
    size = 1 << math.ceil(math.log2(4 * _half(record, weights) + 2))
    return np.asarray(2 * np.pi * np.fft.rfftfreq(size, record.spacing))


def _half(record: Record, weights: Weights) -> int:
    """Returns the number of samples on each side of a kernel."""
    half = math.ceil(_LOBES * weights.reach / record.spacing) + 8
    if 2 * half >= record.heights.shape[1]:
        raise invalid("record", f"= {record.length:g} mm long: the kernel of the contact is {2 * half * record.spacing:g} mm long. Give a longer record.")
    return half


def _kernel(transform: Array, record: Record, weights: Weights) -> Array:
    """Returns the kernel with a transform, which ends smoothly."""
    half = _half(record, weights)
    whole = np.fft.irfft(transform, 2 * (len(transform) - 1))
    places = np.arange(-half, half + 1)
    return np.asarray(whole[places] * np.clip(2 - 2 * np.abs(places) / (half + 1), 0, 1))


def _convolved(record: Record, kernels: list[tuple[int, Array]], y: Array | None) -> Record:
    """Returns the lines convolved each with its kernel; without `y`, their sum."""
    lines = np.stack([np.convolve(record.heights[i], kernel, "valid") for i, kernel in kernels])
    start = record.start + record.spacing * (len(kernels[0][1]) // 2)
    total = sum(float(kernel.sum()) for _, kernel in kernels) / (1 if y is None else len(kernels))
    return Record(record.spacing, (lines if y is not None else lines.sum(axis=0)) / total, np.zeros(1) if y is None else y, start)
