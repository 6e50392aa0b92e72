"""Creates track irregularities as a smooth function of the distance, reproducible by a seed."""

from __future__ import annotations

from typing import Literal

import numpy as np

Side = Literal["left", "right"]


class Track:
    """Track without irregularities."""

    def deviation(self, side: Side, distance: float) -> tuple[float, float, float, float]:
        """Returns y and z of a rail (mm), and their changes per mm of distance."""
        return 0.0, 0.0, 0.0, 0.0


class IrregularTrack(Track):
    """Describes alignment, level and cross level with the spectra of ERRI B 176, as used by Claus and Schiehlen
    (1998):

        S(w) = A wc^2/((w^2 + wr^2)(w^2 + wc^2)),  A = 2.119e-7 rad m across, 4.032e-7 up and down (good track),

    with an additional factor w^2/(b^2 (w^2 + ws^2)) for the cross level; wr = 0.0206, wc = 0.8246, ws = 0.438 rad/m, b
    = 0.75 m. Each is a sum of cosines sqrt(2 S dw) cos(w s + phase), with wavelengths from 4 to 80 m, and grows from
    zero over the first metres.
    """

    lead_in = 20e3  # mm

    def __init__(self, seed: int = 1, waves: int = 120, scale: float = 1.0) -> None:
        """Multiplies all deviations by `scale`; about 1.7 gives poor track."""
        random = np.random.default_rng(seed)
        edges = np.geomspace(2 * np.pi / 80, 2 * np.pi / 4, waves + 1)  # rad/m
        w, dw = np.sqrt(edges[1:] * edges[:-1]), np.diff(edges)
        shape = 0.8246**2 / ((w**2 + 0.0206**2) * (w**2 + 0.8246**2))
        cross = w**2 / (0.75**2 * (w**2 + 0.438**2))  # an angle; times half the distance of the rails it is a height
        spectra = np.array([2.119e-7 * shape, 4.032e-7 * shape, 4.032e-7 * shape * cross * 0.75**2])
        self._amplitudes = 1000 * scale * np.sqrt(2 * spectra * dw)  # mm: across, level, cross level
        self._phases = random.uniform(0, 2 * np.pi, spectra.shape)
        self._wave_numbers = w / 1000  # rad/mm

    def deviation(self, side: Side, distance: float) -> tuple[float, float, float, float]:
        """Returns y and z of a rail (mm), and their changes per mm of distance."""
        angle = self._wave_numbers * distance + self._phases
        value = (self._amplitudes * np.cos(angle)).sum(axis=1)
        slope = -(self._amplitudes * self._wave_numbers * np.sin(angle)).sum(axis=1)
        part = min(max(distance / self.lead_in, 0.0), 1.0)
        grown, growth = part**2 * (3 - 2 * part), 6 * part * (1 - part) / self.lead_in
        slope = grown * slope + growth * value
        value = grown * value
        sign = 1 if side == "right" else -1
        return value[0], value[1] + sign * value[2], slope[0], slope[1] + sign * slope[2]
