"""Prepares points of profiles for gauges: in order, and on the right side."""

from __future__ import annotations

import numpy as np
import numpy.typing as npt

from ..errors import InvalidArgument, invalid

__all__ = ["check_gauge_side", "check_head", "check_run", "crossing", "ordered"]

Array = npt.NDArray[np.float64]

_BACKWARDS = 0.1  #: Fraction of the width by which y may decrease.
_LEAN = 2.5  #: Distance from the top to the middle of the head (mm); 3.6 to 5.4 at 1/40, to the field side.
_WORN = 0.2  #: Apparent wear of the field side (mm) due to the errors of two measurements.
_GAINED = 5.0  #: Most by which the flow of steel moves a side outwards (mm).
_WIDTHS = 15.0, 1000.0  #: Of profiles that show a flange or a gauge side (mm).
_CLOSED = 1e-3  #: mm
_SIDES = 10.0  #: Least height of the sides of a rail (mm).


def ordered(points: npt.ArrayLike, name: str) -> Array:
    """Returns the points as an array [n, 2] in ascending order of y of their ends."""
    array = np.asarray(points, dtype=np.float64)
    if array.ndim != 2 or array.shape[1] != 2 or len(array) < 3:
        raise invalid(name, f"have the shape {array.shape}; give (y, z) of at least three points")
    if not np.isfinite(array).all():
        raise invalid(name, "are not all finite; omit points that were not measured")
    if not _WIDTHS[0] <= (width := float(np.ptp(array[:, 0]))) <= _WIDTHS[1]:
        raise invalid(name, f"span {width:.4g} mm laterally, but wheels and rails are {_WIDTHS[0]:g} to {_WIDTHS[1]:g} mm wide; give lengths in mm")
    if np.hypot(*(array[0] - array[-1])) < _CLOSED:
        raise invalid(name, "end at their first point; give an open profile, from one end to the other")
    return array[::-1] if array[0, 0] > array[-1, 0] else array


def check_run(points: Array, name: str) -> None:
    """Raises InvalidArgument if y decreases in total by more than upright faces and seams of scans cause."""
    across = np.diff(points[:, 0])
    if -across[across < 0].sum() > _BACKWARDS * np.ptp(points[:, 0]):
        i = int(across.argmin())
        raise invalid(name, f"go back from y = {points[i, 0]:.4g} to {points[i + 1, 0]:.4g} mm; order them along the profile, from one end to the other")


def check_head(points: Array, name: str) -> None:
    """Raises InvalidArgument for a rail upside down, whose ends are near its top and whose other points are below."""
    z = points[:, 1]
    half = (z.min() + z.max()) / 2
    if max(z[0], z[-1]) < half < np.median(z) and np.ptp(z) > _SIDES:
        raise invalid(name, "have both ends near the top and the others below, but z points downwards: reverse the sign of z")


def check_gauge_side(new: Array, worn: Array, depth: float) -> None:
    """Raises InvalidArgument for a rail with its gauge side at positive y: its top is at negative y of the middle of
    its head, or it is worn on the other side, `depth` below its top (mm). Raises it, too, for sides that gain more than
    the flow of steel explains.
    """
    beside = _top_beside_middle(new)
    if beside is not None and beside < -_LEAN:
        raise invalid("new", f"leans to y > 0, its top {-beside:.3g} mm from the middle, but the gauge side must lie at y < 0: reverse the sign of y")
    lost = [_side(worn, depth, sign) - _side(new, depth, sign) for sign in (1, -1)]
    if lost[1] > max(lost[0], 0.0) + _WORN:
        raise invalid(
            "worn", f"has lost {lost[1]:.3g} mm at y > 0 and {lost[0]:.3g} mm at y < 0, the gauge side; reverse the sign of y"
        )
    if min(lost) < -_GAINED:
        raise invalid(
            "worn",
            f"has gained {-min(lost):.3g} mm at y {'> 0' if lost[1] < lost[0] else '< 0'}, {depth:g} mm below its top; reverse the sign of y, or give "
            "both profiles in the same coordinates",
        )


def crossing(y: Array, z: Array, level: float, name: str) -> float:
    """Returns y of the first point where z falls below a level."""
    falls = np.flatnonzero((z[:-1] >= level) & (z[1:] < level))
    if not len(falls):
        raise invalid(name, f"never pass z = {level:.4g} mm on the measured side; give a longer profile")
    i = int(falls[0])
    return float(y[i] + (level - z[i]) / (z[i + 1] - z[i]) * (y[i + 1] - y[i]))


def _side(points: Array, depth: float, sign: int) -> float:
    """Returns y of a side, below the top, times the sign, so that it increases inwards. NaN if that side is too
    short.
    """
    mirrored = points if sign > 0 else (points * (-1.0, 1.0))[::-1]
    outwards = mirrored[: int(mirrored[:, 1].argmin()) + 1][::-1]
    try:
        return crossing(outwards[:, 0], 0 - outwards[:, 1], 0 - (points[:, 1].min() + depth), "points")
    except InvalidArgument:
        return float("nan")


def _top_beside_middle(rail: Array) -> float | None:
    """Returns the distance of the top from the middle of the head (mm); None for a head of less than 2 mm on either
    side.
    """
    top, least = int(rail[:, 1].argmin()), float(rail[:, 1].min())
    depth = min(10.0, float(rail[: top + 1, 1].max()) - least, float(rail[top:, 1].max()) - least)
    if depth < 2:
        return None

    def middle(level: float) -> float:
        return 0.5 * (_side(rail, level, 1) - _side(rail, level, -1))

    return middle(0.2) - middle(depth * (1 - 1e-9))
