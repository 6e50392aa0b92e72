"""Draws conicities with their tolerances, forces of a run with their limits, and contact filters with those given."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np

from contactd.pictures.canvas import COLOURS, INK, bare, plain

from .conicities import Curve, Row
from .contact_filters import FilterColumn
from .run_quantities import Assessment

__all__ = ["draw_conicities", "draw_filters", "draw_run"]

_OUTSIDE = "#c0392b"
_COLUMNS = 3
_LONGEST = 250.0  #: Longest drawn wavelength (mm).


def draw_conicities(rows: Sequence[Row], curves: Mapping[str, Curve]) -> Any:
    """Returns a figure with one plot per combination."""
    from matplotlib.figure import Figure

    count = len(curves)
    columns = min(_COLUMNS, count)
    lines = math.ceil(count / columns)
    figure = Figure(figsize=(3.2 * columns, 2.6 * lines), layout="constrained")
    plots = figure.subplots(lines, columns, squeeze=False, sharex=True, sharey=True)
    for axes in plots.flat[count:]:
        axes.set_visible(False)
    for axes, (name, curve) in zip(plots.flat, curves.items()):
        given = sorted((row for row in rows if row.combination == name), key=lambda row: row.amplitude)
        amplitudes = [row.amplitude for row in given]
        axes.vlines(amplitudes, [row.low for row in given], [row.high for row in given], color=COLOURS[1], lw=3, alpha=0.3, label="tolerance")
        conicities = [np.nan if value is None else value for value in curve.conicities]
        axes.plot(curve.amplitudes, conicities, color=COLOURS[0], lw=1.2, label="computed")
        if outside := [row for row in given if not row.is_inside and row.conicity is not None]:
            axes.plot([row.amplitude for row in outside], [row.conicity for row in outside], "x", color=_OUTSIDE, label="outside")
        axes.set_title(f"{name}: {given[0].wheels}", fontsize="small")
        axes.set_ylim(bottom=0)
        bare(axes)
    for axes in plots[:, 0]:
        axes.set_ylabel("equivalent conicity")
    for axes in plots.flat[max(0, count - columns) : count]:
        axes.set_xlabel("amplitude (mm)")
        axes.tick_params(labelbottom=True)
    plots[0, 0].legend(fontsize="x-small", frameon=False)
    return figure


def draw_run(found: Sequence[Assessment]) -> Any:
    """Returns a figure with the sums of lateral forces above and Y/Q below."""
    from matplotlib.figure import Figure

    figure = Figure(figsize=(7.2, 5.6), layout="constrained")
    above, below = figure.subplots(2, 1, sharex=True)
    for one, colour in zip(found, COLOURS * len(found)):
        axes, scale = (above, 1e-3) if one.is_force else (below, 1.0)
        axes.plot(one.places / 1e3, one.means * scale, color=colour, lw=1, label=plain(one.name, 60))
        for limit in (one.limit, -one.limit) if one.is_force else (one.limit,):
            axes.axhline(limit * scale, color=INK, lw=0.8, ls="--")
    above.set_ylabel("sum of lateral forces (kN)")
    below.set(ylabel="Y/Q", xlabel="distance (m)")
    for axes in (above, below):
        bare(axes)
        axes.legend(fontsize="x-small", frameon=False, loc="lower right", bbox_to_anchor=(1, 1), ncols=2)
    return figure


def draw_filters(found: Sequence[FilterColumn]) -> Any:
    """Returns a figure with the computed filters as lines, and those of the directive as dots."""
    from matplotlib.figure import Figure

    figure = Figure(figsize=(7.2, 4.6), layout="constrained")
    axes = figure.subplots()
    for one, colour in zip(found, COLOURS):
        seen = one.given.wavelengths <= _LONGEST
        axes.plot(one.given.wavelengths[seen], one.computed.levels[seen], color=colour, lw=1.2, label=one.name)
        axes.plot(one.given.wavelengths[seen], one.given.levels[seen], "o", color=colour, ms=3)
    axes.set_xscale("log")
    axes.set(xlim=(_LONGEST, 0.7), ylim=(-45, 2), xlabel="wavelength (mm)", ylabel="contact filter (dB); dots: 2002/49/EC")
    axes.set_xticks([200, 100, 50, 20, 10, 5, 2, 1], ["200", "100", "50", "20", "10", "5", "2", "1"])
    axes.minorticks_off()
    bare(axes)
    axes.legend(fontsize="small", frameon=False)
    return figure
