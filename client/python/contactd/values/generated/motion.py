"""Motion of the bodies, a shift or rolling, and the dependence of friction on slip velocity and temperature.

Written by ./dev generate from proto/schema: edit it there.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

__all__ = [
    "FrictionMemory",
    "KineticFriction",
    "Rolling",
    "RollingKind",
    "SecondTerm",
    "Shift",
    "SlipLaw",
    "SlipStart",
    "TemperatureFriction",
]

RollingKind = Literal["steady", "transient"]
SlipLaw = Literal["linear", "exponential", "rational"]
SlipStart = Literal["adhesion", "full_slip"]


@dataclass(frozen=True, kw_only=True)
class Rolling:
    """Rolling along (cos chi, sin chi): one step ago, a particle now at x was dq further along that direction. Creepage
    is positive if the upper body moves over the lower one along the axis. The rigid slip over a step is dq (xi - phi y,
    eta + phi x), where x and y are those of the point spin_offset dq ahead.

    Attributes:
        xi: Longitudinal creepage, along x. If force prescribes Fx, an initial estimate.
        eta: Lateral creepage, along y. If force prescribes Fy, an initial estimate.
        phi: Spin creepage (rad/mm).
        chi: Rolling direction, angle from the x axis (rad).
        dq: Distance rolled in one step (mm), > 0. If None, the size of an element along chi, dx dy / sqrt((dy cos
            chi)^2 + (dx sin chi)^2). It is not the distance travelled in a time step: from three elements or a tenth of
            the contact on, forces are wrong by several per cent, and the answer contains a warning.
        spin_offset: Point where the rigid slip of spin is evaluated, in steps dq ahead of the element's centre (0 to
            1); 0 is the centre. The limit for small elements is the same. With much spin, 1/6 halves the error on
            coarse grids. Default 0.
        kind: steady: the steady state; transient: step by step from the previous tractions.
        steps: Number of steps of transient rolling; steady has no steps. Default 1.
        velocity: Rolling velocity, of slip velocities and the frictional power (mm/s), > 0. Default 1.
        force: Fx and Fy on the upper body (N). None for a component with a prescribed creepage. xi and eta of
            prescribed components are computed.
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
    force: tuple[float | None, float | None] | None = None


@dataclass(frozen=True, kw_only=True)
class Shift:
    """The shift of the solution: as requested, with the components that a prescribed force determined.

    Attributes:
        rigid_shift: (w_x, w_y) of the upper body over the lower, at the origin (mm).
        rotation: Rotation about z, positive from x to y (rad).
        duration: Duration of the step (s).
        force: Prescribed force (N).
    """

    rigid_shift: tuple[float, float]
    rotation: float = 0.0
    duration: float = 1.0
    force: tuple[float | None, float | None] | None = None


@dataclass(frozen=True)
class SecondTerm:
    """A second term of the law with another scale: part of the decrease from the static to the kinetic coefficient,
    with its own slip velocity. For a rational law the second term is m / (1 + (v / v_c)^2).

    Attributes:
        fall: Part m of the decrease, at most the total decrease (>= 0).
        slip_velocity: Slip velocity v_c of this term (mm/s), > 0.
    """

    fall: float
    slip_velocity: float


@dataclass(frozen=True)
class FrictionMemory:
    """Friction with memory. The coefficient of a particle follows the law over a slip distance, d mu/dt = -max(v, v_0)
    / d (mu - mu(v)), and starts from the static coefficient where the particle enters the contact. If None, it follows
    at once.

    Attributes:
        distance: Distance d of slip (mm), > 0.
        least_velocity: Lower bound v_0 of the slip velocity in this law, which also applies in adhesion (mm/s), >= 0.
    """

    distance: float
    least_velocity: float


@dataclass(frozen=True)
class KineticFriction:
    """Velocity-weakening (falling) friction, by the slip velocity v. If None, the coefficient is constant. linear: mu_k
    + m max(0, 1 - v / v_c); rational: mu_k + m / (1 + v / v_c); exponential: mu_k + m exp(-v / v_c). Here m =
    friction.mu - mu_k, minus the share of a second term.

    Attributes:
        mu: Kinetic coefficient mu_k, at most the static coefficient (>= 0).
        slip_velocity: Slip velocity v_c of the law (mm/s), > 0.
        law: Shape of the decrease from the static coefficient friction.mu to the kinetic one. Default "exponential".
        start: Initial state of the iterations in which coefficients follow the slip: adhesion, with the static
            coefficient, or full slip, with the kinetic one. A steep law may have several solutions; this choice selects
            one. Default "adhesion".
        second: A second term of the law with another scale: part of the decrease from the static to the kinetic
            coefficient, with its own slip velocity. For a rational law the second term is m / (1 + (v / v_c)^2).
        memory: Friction with memory. The coefficient of a particle follows the law over a slip distance, d mu/dt =
            -max(v, v_0) / d (mu - mu(v)), and starts from the static coefficient where the particle enters the contact.
            If None, it follows at once.
    """

    mu: float
    slip_velocity: float
    law: SlipLaw | None = None
    start: SlipStart | None = None
    second: SecondTerm | None = None
    memory: FrictionMemory | None = None


@dataclass(frozen=True)
class TemperatureFriction:
    """Temperature-dependent friction: mu + change min(1, max(0, (T - reference)/range)), where T is the surface
    temperature and mu is friction.mu. Requires temperature in the problem and model full. If None, the coefficient does
    not depend on temperature.

    Attributes:
        change: Change of the coefficient from the temperature reference to reference + range; negative for falling
            friction.
        reference: Temperature below which the coefficient is friction.mu (degC).
        range: Rise of the temperature above reference over which the coefficient changes (K), > 0.
        memory: Friction with memory. The coefficient of a particle follows the temperature law over a slip distance, d
            mu/dt = -max(v, v_0) / d (mu - mu(T)), and starts from that of unheated surfaces where the particle enters
            the contact. If None, it follows at once.
    """

    change: float
    reference: float
    range: float
    memory: FrictionMemory | None = None
