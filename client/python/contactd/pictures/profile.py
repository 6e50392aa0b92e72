"""Draws a profile and its curvature on the caller's matplotlib axes; used by contactd.wheel_rail_pictures."""

from __future__ import annotations

from typing import Any

import numpy as np
import numpy.typing as npt

from ..errors import invalid
from ..values.arrays import Array
from ..values.generated.wheel_rail.rigid_wheelset import ProfileEvidence
from .canvas import COLOURS, INK, bare

__all__ = ["curvature_of", "draw_curvature", "draw_profile"]

_SHOWN = 0.12  #: 1/mm, for throats and gauge corners with radii of 13 mm.


def curvature_of(points: npt.ArrayLike) -> tuple[Array, Array]:
    """Returns y (mm) of the inner points of a profile, and its curvature (1/mm) by the circle through three points:
    positive on the head of a rail and in the throat of a wheel.
    """
    at = np.asarray(points, dtype=float)
    if at.ndim != 2 or at.shape[1] != 2 or len(at) < 3:
        raise invalid("points", f"has shape {list(at.shape)}; it must be [n, 2], n at least 3")
    before, behind = at[1:-1] - at[:-2], at[2:] - at[1:-1]
    across = at[2:] - at[:-2]
    twice_area = before[:, 0] * behind[:, 1] - before[:, 1] * behind[:, 0]
    return at[1:-1, 0], 2 * twice_area / (np.hypot(*before.T) * np.hypot(*behind.T) * np.hypot(*across.T))


def draw_profile(
    axes: Any, points: npt.ArrayLike, evidence: ProfileEvidence | None = None, measured: npt.ArrayLike | None = None
) -> None:
    """Draws a profile, y to the field side and z downwards (mm), with its kinks; `measured` are its points before
    smoothing.
    """
    at = np.asarray(points, dtype=float)
    if measured is not None:
        axes.plot(*np.asarray(measured).T, ".", ms=2.5, color=COLOURS[1], label="measured", zorder=2)
    axes.plot(*at.T, color=INK, lw=1.2, label="curve" if measured is not None else None, zorder=3)
    if evidence is not None and evidence.kinks:
        y = np.array(evidence.kinks)
        z = [at[np.argmin(np.abs(at[:, 0] - one)), 1] for one in y]
        axes.plot(y, z, "D", ms=4, mfc="white", color=COLOURS[0], label="kinks", zorder=4)
    if evidence is not None and evidence.wheel is not None:
        for name in ("tip", "throat", "tread"):
            place = getattr(evidence.wheel, name)
            axes.annotate(name, (place.y, place.z), (4, 6), textcoords="offset points", fontsize="small", color=COLOURS[2])
            axes.plot(place.y, place.z, "o", ms=4, color=COLOURS[2], zorder=4)
    axes.set_aspect("equal")
    axes.set(ylabel="z, down (mm)")
    if not axes.yaxis_inverted():
        axes.invert_yaxis()
    bare(axes)
    if axes.get_legend_handles_labels()[0]:
        axes.legend(fontsize="small", frameon=False)


def draw_curvature(axes: Any, points: npt.ArrayLike, measured: npt.ArrayLike | None = None) -> None:
    """Draws the curvature against y, limited to radii of at least 8 mm, and behind it that of the points before
    smoothing.
    """
    for given, style in ((measured, {"color": COLOURS[1], "lw": 0.6, "alpha": 0.6}), (points, {"color": INK, "lw": 1})):
        if given is not None:
            axes.plot(*curvature_of(given), **style)
    low, high = axes.get_ylim()
    axes.set_ylim(max(low, -_SHOWN), min(high, _SHOWN))
    axes.axhline(0, color="#9a978f", lw=0.6)
    axes.set(xlabel="y, to the field side (mm)", ylabel="curvature (1/mm)")
    bare(axes)
