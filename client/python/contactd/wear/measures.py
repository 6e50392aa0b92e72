"""Computes gauge dimensions of worn profiles: flange height, thickness and qR of wheels (EN 15313), W1 to W3 of rails,
conicity.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np
import numpy.typing as npt

from ..calls.answer_warnings import give
from ..errors import invalid
from .placed import StudyPlace, WheelRailClient
from .points import check_gauge_side, check_head, check_run, crossing, ordered
from .steps import WornStep
from .study import WearStudy

__all__ = ["RailWear", "WheelGauge", "conicities", "rail_wear", "wheel_gauge"]

Array = npt.NDArray[np.float64]

_BACK = -70.0  #: Default y of the flange's back from the tape circle (mm).
_BELOW_TREAD = 10.0  #: Depth below the tape circle at which the flange is measured (mm).
_BELOW_TIP = 2.0  #: Height above the flange's tip at which qR ends (mm).
_GAUGE = 14.0  #: Depth below the top of a rail at which its side is measured (mm).
_HEAD = 40.0  #: Height of a head (mm), more than any vertical wear.
_GAINED = 0.5  #: Negative wear (mm) that errors of measurement do not explain.


@dataclass(frozen=True)
class WheelGauge:
    """Flange of a wheel (mm).

    Attributes:
        Sh: Height, from the tape circle to the tip.
        Sd: Thickness, from the back to the face, 10 mm below the tape circle.
        qR: Lateral distance from there to the face 2 mm above the tip; below 6.5 a flange counts as worn too steep.
    """

    Sh: float
    Sd: float
    qR: float


@dataclass(frozen=True)
class RailWear:
    """The wear of a rail's head (mm).

    Attributes:
        W1: Vertical wear in the middle of the head.
        W2: Lateral wear of the gauge face, 14 mm below the worn top.
        W3: Wear of the gauge corner at 45 degrees.
    """

    W1: float
    W2: float
    W3: float


def wheel_gauge(points: npt.ArrayLike, back: float = _BACK) -> WheelGauge:
    """Measures (y, z) of a profile from either end to the other, with the tape circle at y = 0, the flange at negative
    y, z down (mm); `back` is y of the flange's back. Raises InvalidArgument for unordered points, or a flange at
    positive y.
    """
    y, z = ordered(points, "points").T
    if not y.min() < 0 < y.max():
        raise invalid("points", f"reach from y = {y.min():.4g} to {y.max():.4g} mm; the tape circle, y = 0, must be among them")
    tread, tip = float(np.interp(0.0, y, z)), int(z.argmax())
    if y[tip] > 0 and z[tip] - tread > _BELOW_TREAD:
        raise invalid("points", f"have the flange at y = {y[tip]:.4g} mm, but y points to the field side: reverse the sign of y")
    check_run(np.column_stack([y, z])[tip:], "points")
    if z[tip] - tread < _BELOW_TREAD < tread - z.min():
        raise invalid("points", f"rise to z = {z.min():.4g} mm at y = {y[z.argmin()]:.4g}, but z points downwards, to the tip of the flange: reverse the sign of z")
    below, above = tread + _BELOW_TREAD, float(z[tip]) - _BELOW_TIP
    if not above > below:
        raise invalid("points", f"have a flange of {z[tip] - tread:.4g} mm, but its thickness is measured {_BELOW_TREAD:g} mm below the tape circle")
    face = crossing(y[tip:], z[tip:], below, "points")
    return WheelGauge(float(z[tip]) - tread, face - back, face - crossing(y[tip:], z[tip:], above, "points"))


def rail_wear(new: npt.ArrayLike, worn: npt.ArrayLike) -> RailWear:
    """Measures (y, z) of both profiles, each from either end to the other, with the gauge side at negative y, z down
    (mm). Raises InvalidArgument for unordered points, and for rails whose inclination or wear shows a gauge side at
    positive y, upside down, in other units or in different coordinates. Warns of rails that have grown.
    """
    before, after = ordered(new, "new"), ordered(worn, "worn")
    for name, points in (("new", before), ("worn", after)):
        check_head(points, name)
        check_run(points[points[:, 1] <= points[:, 1].min() + _GAUGE], name)
    check_gauge_side(before, after, _GAUGE)
    top = float(before[:, 1].min())
    middle = float(before[before[:, 1] <= top + 0.01, 0].mean())
    W1 = float(np.interp(middle, *after.T) - np.interp(middle, *before.T))
    if not abs(W1) <= _HEAD:
        raise invalid("worn", f"lies {abs(W1):.4g} mm {'below' if W1 > 0 else 'above'} new; give both profiles with the same origin")
    sides = []
    for points in (before, after):
        gauge = points[points[:, 0] <= middle][::-1]  # from the top down
        sides.append(crossing(gauge[:, 0], 0 - gauge[:, 1], 0 - (points[:, 1].min() + _GAUGE), "points"))
    # At the normal of 45 degrees, y + z of the gauge corner is smallest.
    gauge = before[before[:, 0] <= middle]
    corner = gauge[gauge.sum(axis=1).argmin()]
    across = float(corner[0] - corner[1])
    found = RailWear(W1, sides[1] - sides[0], _outwards(after, across) - _outwards(before, across))
    if not np.isfinite(found.W3):
        raise invalid("worn", "does not cross the line at 45 degrees through the gauge corner of new; give both profiles in the same coordinates")
    give(_grown(found))
    return found


def _grown(wear: RailWear) -> Iterator[str]:
    """Returns a sentence about a rail that has more steel than before."""
    if (least := min(wear.W1, wear.W2)) < -_GAINED:
        yield f"worn has gained {-least:.3g} mm in comparison with new. Check whether the profiles are exchanged or displaced."


def conicities(
    client: WheelRailClient, study: WearStudy, place: StudyPlace, step: WornStep, amplitudes: tuple[float, ...] = (3.0, 5.0)
) -> tuple[float, ...]:
    """Returns the equivalent conicities (EN 15302), computed by a client, of a wheelset with two wheels, or rails, worn
    equally; NaN if it does not oscillate.
    """
    setup = {**study.setup_params(), **place.profiles({part: step.of(part).points for part in study.parts})}
    found = client.equivalent_conicity(setup, amplitudes)
    return tuple(float("nan") if one.integrated is None else one.integrated for one in found)


def _outwards(points: Array, across: float) -> float:
    """Returns (y + z)/sqrt 2 of the outermost point with this y - z."""
    along, out = points[:, 0] - points[:, 1] - across, points.sum(axis=1) / np.sqrt(2)
    crossed = np.flatnonzero((along[:-1] <= 0) & (along[1:] > 0))
    found = [out[i] + along[i] / (along[i] - along[i + 1]) * (out[i + 1] - out[i]) for i in crossed]
    return float(min(found)) if found else float("nan")
