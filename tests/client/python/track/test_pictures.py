"""Tests pictures of runs and receptances."""

from __future__ import annotations

import numpy as np
import pytest

pytest.importorskip("matplotlib")

from matplotlib.figure import Figure

from contactd import InvalidArgument
from contactd.pictures.track import plot_forces, plot_peaks, plot_receptances, plot_spectra
from contactd.track import Ring, Run, named_track

TIME = np.arange(4000) / 1e4
RUN = Run(TIME, 30 * TIME, 5e4 + 2e3 * np.sin(2 * np.pi * 100 * TIME), TIME, TIME, TIME)
EMPTY = Run(*[np.zeros(0)] * 6)


def test_pictures_show_runs_and_receptances():
    forces, spectra, receptances, peaks = Figure().subplots(2, 2).flat
    assert plot_forces({"a $x_{$": RUN}, forces) is forces
    assert forces.lines[0].get_ydata().max() == pytest.approx(52, rel=1e-4)
    plot_spectra({"a": RUN}, spectra, high=1000, segment=0.2)
    assert spectra.lines[0].get_ydata().max() == pytest.approx(20 * np.log10(2e3 / 2**0.5), abs=0.1)
    plot_receptances(Ring(named_track("R1")), {"over a sleeper": 0.0, "mid-span": 0.3}, [50, 1000], receptances)
    assert receptances.lines[1].get_ydata()[0] == pytest.approx(1.516e-8, rel=1e-3)
    plot_peaks([10, 20], {"50 mm": [1e5, 2e5]}, peaks)
    assert list(peaks.lines[0].get_xdata()) == [36, 72]


def test_a_run_in_a_file_must_be_read_first():
    with pytest.raises(InvalidArgument, match="read_run"):
        plot_forces({"a": EMPTY}, Figure().subplots())
