"""Friction, and how the bodies move: a shift or rolling.

Slip is that of the upper body over the lower one; in slip the traction on the upper body opposes it.
"""

from __future__ import annotations

import reprlib
from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from typing import Any, Literal

import numpy as np
import numpy.typing as npt

from ..refusals import public
from .params import array_of, plain

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

    Attributes:
        mu: Kinetic coefficient, from 0 to the static one.
        slip_velocity: Slip velocity of the fall (mm/s), > 0.
        law: Shape of the fall, "linear" or "exponential" (default).
    """

    mu: float
    slip_velocity: float
    law: SlipLaw | None = None


@dataclass(frozen=True, kw_only=True)
class Rolling:
    """Rolling along (cos chi, sin chi); positive creepage is that of the upper body over the lower one.

    The rigid slip over a step is dq (xi - phi y, eta + phi x), x and y those of the point `spin_offset` dq ahead.

    Attributes:
        xi: Longitudinal creepage, along x; where `force` prescribes Fx, an estimate.
        eta: Lateral creepage, along y; where `force` prescribes Fy, an estimate.
        phi: Spin creepage (rad/mm).
        chi: Rolling direction, angle from the x axis (rad).
        dq: Distance rolled in one step (mm); None: the size of an element along chi. Not that of a time step: see
            docs/contact.md.
        spin_offset: Where the rigid slip of spin is evaluated, in steps dq ahead of the element's centre, 0 to 1; None: 0,
            at the centre. With much spin 1/6 errs half as much on coarse grids.
        kind: "steady": the state that does not change any more; "transient": step by step from ContactProblem.previous.
        steps: Number of steps of transient rolling, 1 (default) to 100000.
        velocity: Rolling velocity (mm/s), default 1: of slip velocities and the frictional power.
        force: Prescribed (N), within the bound of friction; xi, eta are found then.
    """

    xi: float = 0.0
    eta: float = 0.0
    phi: float = 0.0
    chi: float = 0.0
    dq: float | None = None
    spin_offset: float | None = None
    kind: RollingKind = "steady"
    steps: int | None = None
    velocity: float | None = None
    force: Force | None = None


@dataclass(frozen=True, kw_only=True)
class Shift:
    """The shift of a solution, as asked for, with what a prescribed force made of it.

    Attributes:
        rigid_shift: (w_x, w_y) of the upper body over the lower, at the origin (mm).
        rotation: About z, positive from x to y (rad).
        duration: That of the step (s).
        force: What was prescribed (N).
    """

    rigid_shift: tuple[float, float]
    rotation: float = 0.0
    duration: float = 1.0
    force: Force | None = None

    @staticmethod
    def _is_told(told: dict[str, Any]) -> bool:
        return "rigid_shift" in told


Motion = Shift | Rolling


@public
@dataclass(frozen=True, eq=False)
class Friction:
    """Coulomb friction and a motion: a shift (by `rigid_shift`, `force` or both), or `rolling`.

    ::

        Friction(mu=0.4, rigid_shift=(0.00817, 0))
        Friction(mu=0.4, force=(-3.2, None))  # the rigid shift along x is found, along y it is zero
        Friction(mu=0.3, rolling=Rolling(xi=1e-3, phi=1e-4))

    Attributes:
        mu: (Static) coefficient, >= 0: one for all elements, or an array [ny, nx].
        rigid_shift: (w_x, w_y) of the upper body (mm); where `force` prescribes a component, an estimate. None: zero.
        rotation: Of a shift: about z, positive from x to y (rad); default 0.
        force: Of a shift: on the upper body (N), within the bound of friction.
        duration: Of a shift (s), default 1; slip velocity = slip / duration, for kinetic friction.
        kinetic: How it falls with the slip velocity; None: it does not.
        rolling: Rolling instead of a shift, whose fields it excludes.
        rigid_slip: (along x, along y) of each element, each of shape [ny, nx], beside that of the motion, where the
            surfaces do not move like a plane: of a shift over the step (mm), of rolling over the distance rolled, as
            creepages are. None: none.
    """

    mu: float | npt.ArrayLike
    rigid_shift: tuple[float, float] | None = None
    rotation: float | None = None
    force: Force | None = None
    duration: float | None = None
    kinetic: KineticFriction | None = None
    rolling: Rolling | None = None
    rigid_slip: tuple[npt.ArrayLike, npt.ArrayLike] | None = None

    def __post_init__(self) -> None:
        if all(motion is None for motion in (self.rigid_shift, self.force, self.rolling, self.rigid_slip)):
            raise TypeError("Friction() takes a motion: rigid_shift, force, rolling or rigid_slip")

    def params(self) -> dict[str, Any]:
        """`friction` of contact.solve."""
        given = _motion(plain(self))
        given["mu"] = coefficient_param(self.mu)
        if self.kinetic is not None:
            given["kinetic"] = plain(self.kinetic)
        if self.rolling is not None:
            given["rolling"] = _motion(plain(self.rolling))
        if self.rigid_slip is not None:
            given["rigid_slip"] = slip_param(self.rigid_slip)
        return given


def slip_param(slip: tuple[npt.ArrayLike, npt.ArrayLike]) -> dict[str, Any]:
    """`friction.rigid_slip` of contact.solve."""
    if not isinstance(slip, Sequence) or len(slip) != 2:
        raise TypeError(f"rigid_slip is {reprlib.repr(slip)}; it must be a pair of arrays, along x and along y")
    x, y = slip
    return {"x": array_of(x), "y": array_of(y)}


def coefficient_param(mu: float | npt.ArrayLike) -> Any:
    """`friction.mu` of contact.solve."""
    coefficient = array_of(mu)
    return coefficient if coefficient.ndim or np.ma.is_masked(coefficient) else coefficient.item()


def _motion(given: dict[str, Any]) -> dict[str, Any]:
    """With pairs as lists, whatever sequence they were given as. What is no sequence is the daemon's to refuse."""
    pairs = {name: given[name] for name in ("rigid_shift", "force") if isinstance(given.get(name), Iterable)}
    return {**given, **{name: list(pair) for name, pair in pairs.items()}}
