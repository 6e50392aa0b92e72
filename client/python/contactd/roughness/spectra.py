"""Spectra of roughness: mean squares in base-ten third octaves of the wavelength, in dB relative to 1 um."""

from __future__ import annotations

import math
import warnings
from dataclasses import dataclass

import numpy as np

from ..calls.answer_warnings import ContactWarning
from ..errors import invalid
from ..values.arrays import Array
from ..values.periodogram import mean_squares
from .records import Record

__all__ = ["ISO_3095_2013", "Lines", "Spectrum", "lines_of", "nominal", "spectrum_of"]

_R10 = (1.0, 1.25, 1.6, 2.0, 2.5, 3.15, 4.0, 5.0, 6.3, 8.0)
_REFERENCE = 1e-3  #: mm, 1 um
SEGMENT = 1000.0  #: Length of a segment (mm).
_COARSE = 1.0  #: Largest spacing by EN 15610 (mm).


@dataclass(frozen=True, eq=False)
class Spectrum:
    """Levels of third octaves, from long to short waves.

    Attributes:
        wavelengths: Nominal wavelengths (mm), shape [bands].
        levels: Levels of the mean square in dB relative to 1 um, shape [bands]; -inf where there is no roughness.
    """

    wavelengths: Array
    levels: Array

    def at(self, wavelength: float) -> float:
        """Returns the level at a nominal wavelength (mm). Raises InvalidArgument if the spectrum lacks it."""
        found = np.flatnonzero(np.isclose(self.wavelengths, wavelength, rtol=0.01))
        if not len(found):
            raise invalid("wavelength", f"= {wavelength:g} mm: the spectrum has {self.wavelengths[-1]:g} to {self.wavelengths[0]:g} mm. Use a nominal wavelength in this range.")
        return float(self.levels[found[0]])


#: Limit of the roughness of test tracks. One source: the public package phonometry; the standard was not read. Class E of
#: table G-1b of Directive 2002/49/EC, as amended by (EU) 2021/1226, has the same values in that package.
ISO_3095_2013 = Spectrum(
    np.array([400, 315, 250, 200, 160, 125, 100, 80, 63, 50, 40, 31.5, 25, 20, 16, 12.5, 10, 8, 6.3, 5, 4, 3.15]),
    np.array([17.1, 15, 13, 11, 9, 7, 4.9, 2.9, 0.9, -1.1, -3.2, -5, -5.6, -6.2, -6.8, -7.4, -8, -8.6, -9.2, -9.8, -10.4, -11]),
)  # fmt: skip


@dataclass(frozen=True, eq=False)
class Lines:
    """A spectrum of equidistant lines, the mean over all segments and all lines of a record.

    Attributes:
        step: Distance of the lines in cycles per mm; the first one is at this wavenumber.
        squares: Mean square of each line (mm^2), shape [lines].
        segments: Number of segments.
    """

    step: float
    squares: Array
    segments: int

    @property
    def wavelengths(self) -> Array:
        """Wavelengths of the lines (mm), shape [lines]."""
        return np.asarray(1 / (self.step * np.arange(1, len(self.squares) + 1)))

    def bands(self) -> tuple[Array, Array]:
        """Returns the nominal wavelengths of the resolved bands (mm), and the fraction of each line that lies in each
        band, shape [bands, lines]. Bands reach from a quarter of the segment down to twice the spacing.
        """
        # The band k contains 10^(k/10 -+ 1/20) waves per m.
        longest, shortest = 1 / (4 * self.step), 1 / (self.step * len(self.squares))
        numbers = np.arange(math.floor(-10 * math.log10(longest * 1e-3)) - 1, math.ceil(-10 * math.log10(shortest * 1e-3)) + 2)
        edges = 1e-3 * 10 ** (np.subtract.outer(numbers, [0.5, -0.5]) / 10) / self.step
        names = np.array([nominal(int(k)) for k in numbers])
        kept = (names <= longest * (1 + 1e-9)) & (edges[:, 1] <= len(self.squares) * (1 + 1e-9))
        places = np.arange(1, len(self.squares) + 1)
        inside = np.minimum(edges[:, 1:], places + 0.5) - np.maximum(edges[:, :1], places - 0.5)
        return names[kept], np.clip(inside[kept], 0, None)

    def third_octaves(self) -> Spectrum:
        """Returns the levels of the resolved bands."""
        names, shares = self.bands()
        return Spectrum(names, level_of(shares @ self.squares))


def nominal(band: int) -> float:
    """Returns the nominal wavelength (mm) of the base-ten band with 10^(band/10) waves per m."""
    exponent, place = divmod(-band, 10)
    return float(f"{_R10[place]}e{exponent + 3}")


def level_of(squares: Array) -> Array:
    """Returns levels in dB relative to 1 um of mean squares (mm^2)."""
    with np.errstate(divide="ignore"):
        return np.asarray(10 * np.log10(squares / _REFERENCE**2))


def lines_of(record: Record, *, segment: float = SEGMENT) -> Lines:
    """Returns the mean spectrum of segments that overlap by half: each without its mean and linear trend, times a Hann
    window, with squares scaled so that their sum is the mean square of the heights (EN 15610, 7.4.2).

    The rest of the record beyond the last whole segment is not used. Raises InvalidArgument if the record is shorter
    than a segment (mm). Warns (ContactWarning) if samples are more than 1 mm apart.
    """
    size = math.ceil(segment / record.spacing * (1 - 1e-9))
    if size < 8:
        raise invalid("segment", f"= {segment:g} mm: a segment must have at least 8 samples, {8 * record.spacing:g} mm. Use {SEGMENT:g} mm.")
    if size > record.heights.shape[1]:
        raise invalid("record", f"= {record.length:g} mm long: it is shorter than a segment of {segment:g} mm. Check x_unit, measure a longer record, or give a shorter segment.")
    if record.spacing > _COARSE * (1 + 1e-9):
        warnings.warn(ContactWarning(f"spacing = {record.spacing:g} mm: EN 15610 requires samples at most {_COARSE:g} mm apart. Short waves are missing."), stacklevel=3)
    starts = range(0, record.heights.shape[1] - size + 1, max(1, size // 2))
    pieces = np.concatenate([record.heights[:, start : start + size] for start in starts])
    place = np.arange(size) - (size - 1) / 2
    pieces = pieces - pieces.mean(axis=1, keepdims=True)
    pieces = pieces - np.outer(pieces @ place / (place @ place), place)
    return Lines(1 / (size * record.spacing), mean_squares(pieces)[1:], len(starts))


def spectrum_of(record: Record, *, segment: float = SEGMENT) -> Spectrum:
    """Returns the third octaves of a record, from a quarter of the segment (mm) down to twice the spacing. See
    lines_of for the segments, and for errors and warnings.
    """
    return lines_of(record, segment=segment).third_octaves()
