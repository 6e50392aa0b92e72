"""Draws wheels rolling over tracks, and receptances, on the caller's matplotlib axes."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np
import numpy.typing as npt

from ..errors import invalid
from ..track import Ring, Run, third_octaves
from .canvas import COLOURS, axes_or_new, bare, plain

__all__ = ["plot_forces", "plot_peaks", "plot_receptances", "plot_spectra"]


def plot_forces(runs: Mapping[str, Run], axes: Any = None) -> Any:
    """Plots the forces (kN) of named runs over the distance rolled (m). Returns the Axes."""
    axes = axes_or_new(axes)
    for i, (name, run) in enumerate(_filled(runs).items()):
        axes.plot(run.x - run.x[0], run.force / 1e3, color=COLOURS[i % len(COLOURS)], linewidth=1, label=plain(name))
    axes.set(xlabel="distance (m)", ylabel="force (kN)")
    return _named(axes)


def plot_spectra(runs: Mapping[str, Run], axes: Any = None, low: float = 31.5, high: float = 5000.0, segment: float = 0.5) -> Any:
    """Plots third octaves of the forces of named runs (dB, relative to 1 N). Returns the Axes."""
    axes = axes_or_new(axes)
    for i, (name, run) in enumerate(_filled(runs).items()):
        centres, values = third_octaves(run.force, run.rate, low, high, segment)
        axes.semilogx(centres, 20 * np.log10(np.maximum(values, 1e-12)), ".-", color=COLOURS[i % len(COLOURS)], label=plain(name))
    axes.set(xlabel="centre of the third octave (Hz)", ylabel="force (dB, 1 N)")
    return _named(axes)


def plot_receptances(ring: Ring, places: Mapping[str, float], frequencies: npt.ArrayLike | None = None, axes: Any = None) -> Any:
    """Plots the size of driving-point receptances (m/N) at named positions (m). Returns the Axes."""
    axes = axes_or_new(axes)
    hertz = np.geomspace(20, 3000, 300) if frequencies is None else np.asarray(frequencies, dtype=np.float64)
    for i, (name, x) in enumerate(places.items()):
        axes.loglog(hertz, np.abs(ring.receptance(hertz, x)), color=COLOURS[i % len(COLOURS)], label=plain(name))
    axes.set(xlabel="frequency (Hz)", ylabel="receptance (m/N)")
    return _named(axes)


def plot_peaks(speeds: Sequence[float], peaks: Mapping[str, Sequence[float]], axes: Any = None) -> Any:
    """Plots the largest forces (N) of named series over the speed (m/s), in kN over km/h. Returns the Axes."""
    axes = axes_or_new(axes)
    for i, (name, values) in enumerate(peaks.items()):
        axes.plot(3.6 * np.asarray(speeds), np.asarray(values) / 1e3, ".-", color=COLOURS[i % len(COLOURS)], label=plain(name))
    axes.set(xlabel="speed (km/h)", ylabel="largest force (kN)")
    return _named(axes)


def _filled(runs: Mapping[str, Run]) -> Mapping[str, Run]:
    for name, run in runs.items():
        if run.force.size < 2:
            raise invalid(f"runs[{name!r}]", "has no steps. Read the run from its file by read_run.")
    return runs


def _named(axes: Any) -> Any:
    axes.legend(frameon=False)
    bare(axes)
    return axes
