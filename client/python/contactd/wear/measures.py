"""What gauges tell of worn profiles: flange height, thickness and qR of wheels (EN 15313), W1 to W3 of rails, conicity."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
import numpy.typing as npt

from ..errors import invalid
from .placed import StudyPlace, WheelRailClient
from .points import check_gauge_side, check_run, crossing, ordered
from .steps import WornStep
from .study import WearStudy

__all__ = ["RailWear", "WheelGauge", "conicities", "rail_wear", "wheel_gauge"]

Array = npt.NDArray[np.float64]

_BACK = -70.0  #: y of the flange's back from the tape circle, where a set-up names none (mm)
_BELOW_TREAD = 10.0  #: from the tape circle down to where the flange is measured (mm)
_BELOW_TIP = 2.0  #: from the flange's tip up to where qR ends (mm)
_GAUGE = 14.0  #: from the top of a rail down to where its side is measured (mm)


@dataclass(frozen=True)
class WheelGauge:
    """Flange of a wheel (mm).

    Attributes:
        Sh: Height, from the tape circle to the tip.
        Sd: Thickness, from the back to the face, 10 mm below the tape circle.
        qR: Across, from there to the face 2 mm above the tip; below 6.5 a flange is taken for worn steep.
    """

    Sh: float
    Sd: float
    qR: float


@dataclass(frozen=True)
class RailWear:
    """What a rail's head has lost (mm).

    Attributes:
        W1: Downwards, in the middle of the head.
        W2: Sidewards, of the gauge face 14 mm below the top that is left.
        W3: Across the gauge corner, at 45 degrees.
    """

    W1: float
    W2: float
    W3: float


def wheel_gauge(points: npt.ArrayLike, back: float = _BACK) -> WheelGauge:
    """By (y, z) of a profile from either end to the other, whose tape circle is at y = 0, the flange at negative y, z down (mm);
    `back` is y of the flange's back. Raises InvalidArgument for points in no order, or with the flange at positive y."""
    y, z = ordered(points, "points").T
    if not y.min() < 0 < y.max():
        raise invalid("points", f"reach from y = {y.min():.4g} to {y.max():.4g} mm; the tape circle, y = 0, must be among them")
    tread, tip = float(np.interp(0.0, y, z)), int(z.argmax())
    if y[tip] > 0 and z[tip] - tread > _BELOW_TREAD:
        raise invalid("points", f"have the flange at y = {y[tip]:.4g} mm; y grows to the field side: give y with the other sign")
    check_run(np.column_stack([y, z])[tip:], "points")
    below, above = tread + _BELOW_TREAD, float(z[tip]) - _BELOW_TIP
    if not above > below:
        raise invalid("points", f"have a flange of {z[tip] - tread:.4g} mm; its thickness is measured {_BELOW_TREAD:g} mm below the tape circle")
    face = crossing(y[tip:], z[tip:], below, "points")
    return WheelGauge(float(z[tip]) - tread, face - back, face - crossing(y[tip:], z[tip:], above, "points"))


def rail_wear(new: npt.ArrayLike, worn: npt.ArrayLike) -> RailWear:
    """By (y, z) of both profiles, each from either end to the other, the gauge side at negative y, z down (mm). Raises
    InvalidArgument for points in no order, and for rails that lean, or have worn, as if their gauge side were at positive y."""
    before, after = ordered(new, "new"), ordered(worn, "worn")
    for name, points in (("new", before), ("worn", after)):
        check_run(points[points[:, 1] <= points[:, 1].min() + _GAUGE], name)
    check_gauge_side(before, after, _GAUGE)
    top = float(before[:, 1].min())
    middle = float(before[before[:, 1] <= top + 0.01, 0].mean())
    W1 = float(np.interp(middle, *after.T) - np.interp(middle, *before.T))
    sides = []
    for points in (before, after):
        gauge = points[points[:, 0] <= middle][::-1]  # from the top down
        sides.append(crossing(gauge[:, 0], 0 - gauge[:, 1], 0 - (points[:, 1].min() + _GAUGE), "points"))
    # Where its normal is at 45 degrees the gauge corner is farthest out, y + z least.
    gauge = before[before[:, 0] <= middle]
    corner = gauge[gauge.sum(axis=1).argmin()]
    across = float(corner[0] - corner[1])
    return RailWear(W1, sides[1] - sides[0], _outwards(after, across) - _outwards(before, across))


def conicities(
    client: WheelRailClient, study: WearStudy, place: StudyPlace, step: WornStep, amplitudes: tuple[float, ...] = (3.0, 5.0)
) -> tuple[float, ...]:
    """The equivalent conicities (EN 15302), asked of a client, of a wheelset whose wheels, or on rails that, are worn alike; NaN where it does not
    swing."""
    setup = {**study.setup_params(), **place.profiles({part: step.of(part).points for part in study.parts})}
    found = client.equivalent_conicity(setup, amplitudes)
    return tuple(float("nan") if one.integrated is None else one.integrated for one in found)


def _outwards(points: Array, across: float) -> float:
    """(y + z)/sqrt 2 of the outermost place with this y - z."""
    along, out = points[:, 0] - points[:, 1] - across, points.sum(axis=1) / np.sqrt(2)
    crossed = np.flatnonzero((along[:-1] <= 0) & (along[1:] > 0))
    found = [out[i] + along[i] / (along[i] - along[i + 1]) * (out[i + 1] - out[i]) for i in crossed]
    return float(min(found)) if found else float("nan")
