"""Draws spectra of roughness, and contact filters."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING

import numpy as np

from ..roughness.spectra import Spectrum
from .canvas import COLOURS, INK, bare

if TYPE_CHECKING:
    from matplotlib.axes import Axes

__all__ = ["draw_levels"]

_MARKED = (200, 100, 50, 20, 10, 5)  #: Wavelengths at ticks (mm).


def draw_levels(axes: Axes, spectra: Mapping[str, Spectrum], limit: Spectrum | None = None, label: str = "level (dB re 1 um)") -> None:
    """Draws levels over the wavelength, long waves on the left, and optionally a limit as a dashed line."""
    for (name, spectrum), colour in zip(spectra.items(), COLOURS):
        seen = np.isfinite(spectrum.levels)
        axes.plot(spectrum.wavelengths[seen], spectrum.levels[seen], "o-", color=colour, ms=3, lw=1.2, label=name)
    if limit is not None:
        axes.plot(limit.wavelengths, limit.levels, color=INK, lw=0.9, ls="--", label="limit of ISO 3095:2013")
    ends = np.concatenate([spectrum.wavelengths for spectrum in spectra.values()])
    axes.set_xscale("log")
    axes.set(xlim=(1.1 * ends.max(), ends.min() / 1.1), xlabel="wavelength (mm)", ylabel=label)
    axes.set_xticks(_MARKED, [f"{wave:g}" for wave in _MARKED])
    axes.minorticks_off()
    bare(axes)
    axes.legend(fontsize="small", frameon=False)
