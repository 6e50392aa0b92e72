"""Friction, and how the bodies move. Slip is that of the upper body over the lower one; in slip the traction on the
upper body opposes it.

Written by ./dev generate from proto/schema: edit it there.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy.typing as npt

from ..refusals import public
from .friction_methods import Force, FrictionMethods
from .motion import KineticFriction, Rolling

__all__ = ["Friction"]


@public
@dataclass(frozen=True, eq=False)
class Friction(FrictionMethods):
    """Coulomb friction and a motion: a shift (by `rigid_shift`, `force` or both), or `rolling`.

    ::

        Friction(mu=0.4, rigid_shift=(0.00817, 0))
        Friction(mu=0.4, force=(-3.2, None))  # the rigid shift along x is found, along y it is zero
        Friction(mu=0.3, rolling=Rolling(xi=1e-3, phi=1e-4))

    Attributes:
        mu: (Static) coefficient of friction, zero or positive (>= 0): one for all elements, or an array of shape [ny,
            nx].
        rigid_shift: Rigid shift along x and y (mm) of a step that is a shift, default 0; where force prescribes a
            component, an estimate.
        rotation: Rotation about z of a shift, positive from x to y (rad). Default 0.
        force: Fx and Fy of a shift, on the upper body (N), None where rigid_shift holds instead; the rigid shift is
            found then.
        duration: Duration of a shift (s), > 0: slip velocity = slip / duration; only kinetic friction depends on it.
            Default 1.
        kinetic: Velocity-weakening (falling) friction, by the slip velocity v; None, the coefficient is constant.
            linear: max(mu_k, mu_s - (mu_s - mu_k) v / v_c); exponential: mu_k + (mu_s - mu_k) exp(-v / v_c).
        rolling: Rolling instead of a shift.
        rigid_slip: Rigid slip (along x, along y) of each element, each of shape [ny, nx], beside that of the motion,
            where the surfaces do not move like a plane: of a shift over the step (mm), of rolling over the distance
            rolled, as creepages are. None: none.
    """

    mu: float | npt.ArrayLike
    rigid_shift: tuple[float, float] | None = None
    rotation: float | None = None
    force: Force | None = None
    duration: float | None = None
    kinetic: KineticFriction | None = None
    rolling: Rolling | None = None
    rigid_slip: tuple[npt.ArrayLike, npt.ArrayLike] | None = None
