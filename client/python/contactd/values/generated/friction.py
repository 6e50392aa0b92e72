"""Friction and the motion of the bodies. Slip is that of the upper body relative to the lower one, and is opposite to
the traction on the upper body.

Written by ./dev generate from proto/schema: edit it there.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy.typing as npt

from ...refusals import public
from ..friction_methods import Force, FrictionMethods
from .motion import KineticFriction, Rolling, TemperatureFriction

__all__ = ["Friction", "InterfacialLayer"]


@dataclass(frozen=True)
class InterfacialLayer:
    """A layer of a third body between the surfaces, for model full. Its shear deformation is flexibility times the
    traction. Where its yield stress is below the friction bound, it flows before the surfaces slip. The layer does not
    affect the normal problem.

    Attributes:
        flexibility: Thickness of the layer over its shear modulus, h3/G3 (mm^3/N), >= 0; 0 leaves flow only. Default 0.
        yield_stress: Initial yield stress tau_c0 (N/mm^2), > 0: the shear stress at which a particle yields when it
            enters the contact. If None, the layer never yields.
        hardening: Slope k_tau of the yield stress over the accumulated plastic flow of a particle (N/mm^3); negative
            for softening. Default 0.
        residual: Part of yield_stress that softening leaves (0 to 1). Default 0.1.
    """

    flexibility: float | None = None
    yield_stress: float | None = None
    hardening: float | None = None
    residual: float | None = None


@public
@dataclass(frozen=True, eq=False)
class Friction(FrictionMethods):
    """Coulomb friction and a motion: a shift (by `rigid_shift`, `force` or both), or `rolling`. Without a motion the
    shift is zero.

    ::

        Friction(mu=0.4, rigid_shift=(0.00817, 0))
        Friction(mu=0.4)  # no motion: the rigid shift is zero
        Friction(mu=0.4, force=(-3.2, None))  # the rigid shift along x is found, along y it is zero
        Friction(mu=0.3, rolling=Rolling(xi=1e-3, phi=1e-4))

    Attributes:
        mu: (Static) coefficient of friction, zero or positive (>= 0): a number for all elements, or an array of shape
            [ny, nx].
        rigid_shift: Rigid shift along x and y (mm) in a shift, default 0. A component for which force is prescribed is
            an initial estimate.
        rotation: Rotation about z of a shift, positive from x to y (rad). Default 0.
        force: Fx and Fy of a shift on the upper body (N). The rigid shift along that axis is then computed. None:
            prescribed by rigid_shift.
        duration: Duration of a shift (s), > 0: slip velocity = slip / duration. Only kinetic friction depends on it.
            Default 1.
        kinetic: Velocity-weakening (falling) friction, by the slip velocity v. If None, the coefficient is constant.
            linear: mu_k + m max(0, 1 - v / v_c); rational: mu_k + m / (1 + v / v_c); exponential: mu_k + m exp(-v /
            v_c). Here m = friction.mu - mu_k, minus the share of a second term.
        rolling: Rolling instead of a shift.
        rigid_slip: Rigid slip (along x, along y) of each element, each of shape [ny, nx], in addition to that of the
            motion, for surfaces that do not move like a plane. For a shift, the distance in the step (mm); for rolling,
            the slip per distance rolled, like creepages. None: zero.
        layer: A layer of a third body between the surfaces, for model full. Its shear deformation is flexibility times
            the traction. Where its yield stress is below the friction bound, it flows before the surfaces slip. The
            layer does not affect the normal problem.
        temperature: Temperature-dependent friction: mu + change min(1, max(0, (T - reference)/range)), where T is the
            surface temperature and mu is friction.mu. Requires temperature in the problem and model full. If None, the
            coefficient does not depend on temperature.
    """

    mu: float | npt.ArrayLike
    rigid_shift: tuple[float, float] | None = None
    rotation: float | None = None
    force: Force | None = None
    duration: float | None = None
    kinetic: KineticFriction | None = None
    rolling: Rolling | None = None
    rigid_slip: tuple[npt.ArrayLike, npt.ArrayLike] | None = None
    layer: InterfacialLayer | None = None
    temperature: TemperatureFriction | None = None
