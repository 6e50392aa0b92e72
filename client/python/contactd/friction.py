"""Friction, and how the bodies move: a shift or rolling.

Slip is that of the upper body over the lower one; in slip the traction on the upper body opposes it.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from typing import Any, Literal

import numpy as np
import numpy.typing as npt

from .arrays import plain

__all__ = ["Force", "Friction", "KineticFriction", "Motion", "Rolling", "RollingKind", "Shift", "SlipLaw"]

SlipLaw = Literal["linear", "exponential"]
RollingKind = Literal["steady", "transient"]
#: (Fx, Fy) on the upper body (N); None where the motion is prescribed instead
Force = tuple[float | None, float | None]


@dataclass(frozen=True)
class KineticFriction:
    """How friction falls from the static coefficient mu_s = Friction.mu with the slip velocity v.

    "linear": max(mu, mu_s - (mu_s - mu) v / slip_velocity);
    "exponential": mu + (mu_s - mu) exp(-v / slip_velocity).
    """

    mu: float  #: kinetic coefficient, from 0 to the static one
    slip_velocity: float  #: of the fall (mm/s), > 0
    law: SlipLaw | None = None  #: the daemon's default is "exponential"


@dataclass(frozen=True, kw_only=True)
class Rolling:
    """Rolling along (cos chi, sin chi); positive creepage is that of the upper body over the lower one.

    The rigid slip over a step is dq (xi - phi y, eta + phi x).
    """

    xi: float = 0.0  #: longitudinal creepage, along x; where `force` prescribes Fx, an estimate
    eta: float = 0.0  #: lateral creepage, along y; where `force` prescribes Fy, an estimate
    phi: float = 0.0  #: spin creepage (rad/mm)
    chi: float = 0.0  #: rolling direction, angle from the x axis (rad)
    dq: float | None = None  #: distance rolled in one step (mm); None: grid.dx
    #: "steady": the state that does not change any more; "transient": step by step from ContactProblem.previous
    kind: RollingKind = "steady"
    steps: int | None = None  #: number of steps of transient rolling, 1 (default) to 100000
    velocity: float | None = None  #: rolling velocity (mm/s), default 1: of slip velocities and the frictional power
    force: Force | None = None  #: prescribed (N), within the bound of friction; xi, eta are found then


@dataclass(frozen=True, kw_only=True)
class Shift:
    """The shift of a solution, as asked for, with what a prescribed force made of it."""

    rigid_shift: tuple[float, float]  #: at the origin, of the upper body (mm)
    rotation: float = 0.0  #: about z, positive from x to y (rad)
    duration: float = 1.0  #: of the step (s)
    force: Force | None = None  #: what was prescribed (N)


Motion = Shift | Rolling


@dataclass(frozen=True, eq=False)
class Friction:
    """Coulomb friction and a motion: a shift (by `rigid_shift`, `force` or both), or `rolling`.

    ::

        Friction(mu=0.4, rigid_shift=(0.00817, 0))
        Friction(mu=0.4, force=(-3.2, None))  # the rigid shift along x is found, along y it is zero
        Friction(mu=0.3, rolling=Rolling(xi=1e-3, phi=1e-4))
    """

    mu: float | npt.ArrayLike  #: (static) coefficient, >= 0: one for all elements, or an array [ny, nx]
    #: (w_x, w_y) of the upper body (mm); where `force` prescribes a component, an estimate. None: zero
    rigid_shift: tuple[float, float] | None = None
    rotation: float | None = None  #: of a shift: about z, positive from x to y (rad); default 0
    force: Force | None = None  #: of a shift: on the upper body (N), within the bound of friction
    duration: float | None = None  #: of a shift (s), default 1; slip velocity = slip / duration, for kinetic friction
    kinetic: KineticFriction | None = None  #: None: the coefficient does not depend on the slip
    rolling: Rolling | None = None  #: excludes the fields of a shift

    def __post_init__(self) -> None:
        if self.rigid_shift is None and self.force is None and self.rolling is None:
            raise TypeError("Friction() takes a motion: rigid_shift, force or rolling")

    def params(self) -> dict[str, Any]:
        """`friction` of contact.solve."""
        coefficient = np.asarray(self.mu)
        given = _motion(plain(self))
        given["mu"] = coefficient if coefficient.ndim else coefficient.item()
        if self.kinetic is not None:
            given["kinetic"] = plain(self.kinetic)
        if self.rolling is not None:
            given["rolling"] = _motion(plain(self.rolling))
        return given


def _motion(given: dict[str, Any]) -> dict[str, Any]:
    """With pairs as lists, whatever sequence they were given as. What is no sequence is the daemon's to refuse."""
    pairs = {name: given[name] for name in ("rigid_shift", "force") if isinstance(given.get(name), Iterable)}
    return {**given, **{name: list(pair) for name, pair in pairs.items()}}
