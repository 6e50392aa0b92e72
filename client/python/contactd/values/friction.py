"""Friction, and how the bodies move: a shift or rolling.

Slip is that of the upper body over the lower one; in slip the traction on the upper body opposes it.
"""

from __future__ import annotations

import reprlib
from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
import numpy.typing as npt

from ..refusals import public
from .motion import KineticFriction, Rolling, RollingKind, SlipLaw
from .params import array_of, plain
from .solution_methods import Shift

__all__ = ["Force", "Friction", "KineticFriction", "Rolling", "RollingKind", "Shift", "SlipLaw"]

#: (Fx, Fy) on the upper body (N); None where the motion is prescribed instead
Force = tuple[float | None, float | None]


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
