"""Contains the forces P1 and P2 of a wheel on a dipped joint, by lumped systems.

P1 is the contact force of the first peak: the wheel and the effective mass of the rail on the contact spring. P2 is the
force of the second peak, of the unsprung mass and the track on the track's spring. The British formula for P2 gives the
force of the track's spring. The contact force is smaller: without damping, mu/(mu + mt) of it.
"""

from __future__ import annotations

import math
from dataclasses import dataclass

from .checks import check_number

__all__ = ["P2Forces", "p1_force", "p1_hertz", "p2_force", "p2_forces"]


def p1_force(load: float, speed: float, stiffness: float, unsprung: float, effective: float) -> float:
    """Returns P1 (N) = P0 + v sqrt(kH me/(1 + me/mu)), which is exact for two masses and a linear spring.

    Args:
        load: Static force P0 (N).
        speed: v (m/s): speed V times the angle 2 alpha of the joint.
        stiffness: Linear stiffness of the contact kH (N/m).
        unsprung: Unsprung mass mu (kg).
        effective: Effective mass of the track me (kg). It is no property of a track alone.
    """
    _check(load=load, speed=speed, stiffness=stiffness, unsprung=unsprung, effective=effective)
    return load + speed * math.sqrt(stiffness * effective / (1 + effective / unsprung))


def p1_hertz(load: float, speed: float, constant: float, unsprung: float, effective: float) -> float:
    """Returns P1 (N) for Hertz's spring F = C d^1.5 by energy: m v^2/2 = U(d1) - U(d0) - P0 (d1 - d0), with the reduced
    mass m of mu and me, which P0 holds in equilibrium before. `constant` is C (N/m^1.5); others as for p1_force.
    """
    _check(load=load, speed=speed, constant=constant, unsprung=unsprung, effective=effective)
    energy = 0.5 * speed**2 * unsprung * effective / (unsprung + effective)
    start = (load / constant) ** (2 / 3)

    def excess(d: float) -> float:
        return float(0.4 * constant * (d**2.5 - start**2.5) - load * (d - start) - energy)

    low, high = start, 2 * start + (2.5 * energy / constant) ** 0.4
    while excess(high) < 0:
        high *= 2
    for _ in range(200):
        middle = 0.5 * (low + high)
        low, high = (middle, high) if excess(middle) < 0 else (low, middle)
    return constant * float(high**1.5)


def p2_force(load: float, speed: float, unsprung: float, track_mass: float, stiffness: float, damping: float) -> float:
    """Returns P2 (N) by the formula of British practice, the force of the track's spring to first order in the damping:
    P0 + v sqrt(mu/(mu + mt)) (1 - pi ct/(4 sqrt(kt (mu + mt)))) sqrt(kt mu).

    Args:
        load: Static force P0 (N).
        speed: v (m/s): speed V times the angle 2 alpha of the joint.
        unsprung: Unsprung mass mu (kg).
        track_mass: Equivalent mass of the track mt (kg).
        stiffness: Equivalent stiffness of the track kt (N/m).
        damping: Equivalent damping of the track ct (N s/m).
    """
    _check(load=load, speed=speed, unsprung=unsprung, track_mass=track_mass, stiffness=stiffness, damping=damping)
    both = unsprung + track_mass
    reduction = 1 - math.pi * damping / (4 * math.sqrt(stiffness * both))
    return load + speed * math.sqrt(unsprung / both) * reduction * math.sqrt(stiffness * unsprung)


@dataclass(frozen=True)
class P2Forces:
    """Largest forces (N) of the second peak, each with the static force.

    Attributes:
        spring: Of the track's spring, which the formula approximates.
        support: Of spring and damper of the track.
        contact: Between wheel and track.
    """

    spring: float
    support: float
    contact: float


def p2_forces(load: float, speed: float, unsprung: float, track_mass: float, stiffness: float, damping: float) -> P2Forces:
    """Returns the exact forces of the system behind the formula: mu strikes mt and stays on it. Arguments as for p2_force."""
    _check(load=load, speed=speed, unsprung=unsprung, track_mass=track_mass, stiffness=stiffness, damping=damping)
    both = unsprung + track_mass
    start = speed * unsprung / both
    half = damping / (2 * both)
    square = stiffness / both - half**2
    omega = math.sqrt(abs(square)) or 1e-9 * half
    if square > 0:
        angle = math.atan2(omega, half)
        at_spring, at_support = angle / omega, max(0.0, 3 * angle - math.pi) / omega
    else:
        at_spring, at_support = math.atanh(omega / half) / omega, 0.0

    def deflection(t: float) -> float:
        return start * math.exp(-half * t) * (math.sin(omega * t) if square > 0 else math.sinh(omega * t)) / omega

    def rate(t: float) -> float:
        return start * math.exp(-half * t) * (math.cos(omega * t) if square > 0 else math.cosh(omega * t)) - half * deflection(t)

    support = stiffness * deflection(at_support) + damping * rate(at_support)
    return P2Forces(load + stiffness * deflection(at_spring), load + support, load + support * unsprung / both)


def _check(**values: float) -> None:
    for name, value in values.items():
        check_number(name, value, "", 0 if name in ("load", "speed", "damping") else 1e-9, 1e15, "Use N, m, kg, s.")
