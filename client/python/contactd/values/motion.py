"""How bodies move, a shift or rolling, and how friction follows the slip velocity and the temperature.

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
    """Rolling along (cos chi, sin chi): a particle now at x was dq further along that direction one step ago. Positive
    creepage is that of the upper body over the lower one; the rigid slip over a step is dq (xi - phi y, eta + phi x), x
    and y those of the point spin_offset dq ahead.

    Attributes:
        xi: Longitudinal creepage, along x; where force prescribes Fx, an estimate.
        eta: Lateral creepage, along y; where force prescribes Fy, an estimate.
        phi: Spin creepage (rad/mm).
        chi: Rolling direction, angle from the x axis (rad).
        dq: Distance rolled in one step (mm), > 0; None: the size of an element along chi, dx dy / sqrt((dy cos chi)^2 +
            (dx sin chi)^2). Not the distance of a time step: from three elements or a tenth of the contact on, forces
            are wrong by several per cent, and the answer warns.
        spin_offset: Where the rigid slip of spin is evaluated, in steps dq ahead of the element's centre (0 to 1); 0:
            at the centre. The limit for small elements is the same; with much spin 1/6 errs half as much on coarse
            grids. Default 0.
        kind: steady: the state that does not change any more; transient: step by step from the previous tractions.
        steps: Number of steps of transient rolling; steady has no steps. Default 1.
        velocity: Rolling velocity, of slip velocities and the frictional power (mm/s), > 0. Default 1.
        force: Fx and Fy on the upper body (N), None where the creepage holds instead; xi and eta are found then.
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
    """The shift of a solution, as asked for, with what a prescribed force made of it.

    Attributes:
        rigid_shift: (w_x, w_y) of the upper body over the lower, at the origin (mm).
        rotation: Rotation about z, positive from x to y (rad).
        duration: Duration of the step (s).
        force: What was prescribed (N).
    """

    rigid_shift: tuple[float, float]
    rotation: float = 0.0
    duration: float = 1.0
    force: tuple[float | None, float | None] | None = None


@dataclass(frozen=True)
class SecondTerm:
    """A second term of the law, of another scale: a part of the fall from the static to the kinetic coefficient with a
    slip velocity of its own. Of rational the second term is m / (1 + (v / v_c)^2).

    Attributes:
        fall: Part m of the fall, at most all of it (>= 0).
        slip_velocity: Slip velocity v_c of this term (mm/s), > 0.
    """

    fall: float
    slip_velocity: float


@dataclass(frozen=True)
class FrictionMemory:
    """Friction with memory: the coefficient of a particle follows the law over a distance that it slips, d mu/dt =
    -max(v, v_0) / d (mu - mu(v)), from the static one where it enters the contact. None, it follows at once.

    Attributes:
        distance: Distance d of slip (mm), > 0.
        least_velocity: Slip velocity v_0 from which on the coefficient follows slower slip, and adhesion (mm/s), >= 0.
    """

    distance: float
    least_velocity: float


@dataclass(frozen=True)
class KineticFriction:
    """Velocity-weakening (falling) friction, by the slip velocity v; None, the coefficient is constant. linear: mu_k +
    m max(0, 1 - v / v_c); rational: mu_k + m / (1 + v / v_c); exponential: mu_k + m exp(-v / v_c), with m = friction.mu
    - mu_k, less what a second term takes of it.

    Attributes:
        mu: Kinetic coefficient mu_k, at most the static one (>= 0).
        slip_velocity: Slip velocity v_c of the fall (mm/s), > 0.
        law: Shape of the fall from the static coefficient friction.mu to this one. Default "exponential".
        start: Where the iterations begin with which coefficients follow the slip: in adhesion, with the static
            coefficient, or in full slip, with the kinetic one. A law that falls steeply may have several solutions;
            this tells which one is found. Default "adhesion".
        second: A second term of the law, of another scale: a part of the fall from the static to the kinetic
            coefficient with a slip velocity of its own. Of rational the second term is m / (1 + (v / v_c)^2).
        memory: Friction with memory: the coefficient of a particle follows the law over a distance that it slips, d
            mu/dt = -max(v, v_0) / d (mu - mu(v)), from the static one where it enters the contact. None, it follows at
            once.
    """

    mu: float
    slip_velocity: float
    law: SlipLaw | None = None
    start: SlipStart | None = None
    second: SecondTerm | None = None
    memory: FrictionMemory | None = None


@dataclass(frozen=True)
class TemperatureFriction:
    """Friction by the temperature T of the surfaces, mu + change min(1, max(0, (T - reference)/range)), mu that of
    friction; where the problem has temperature, and in model full.

    Attributes:
        change: Change of the coefficient from the temperature reference to reference + range; negative where friction
            falls.
        reference: Temperature up to which the coefficient is that of friction (degC).
        range: Rise of the temperature over which the coefficient changes (K), > 0.
        memory: Friction with memory: the coefficient of a particle follows that of the temperature over a distance that
            it slips, d mu/dt = -max(v, v_0) / d (mu - mu(T)), from that of surfaces without friction where it enters
            the contact. None, it follows at once.
    """

    change: float
    reference: float
    range: float
    memory: FrictionMemory | None = None
