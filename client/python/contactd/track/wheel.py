"""Describes a wheel with its suspension and its own modes, and advances its linear states in time."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from ..calls.answer_warnings import give
from .checks import Array, check_number, refused

__all__ = ["LinearWheel", "SuspendedMass", "Wheel", "WheelMode"]

_HEAVY, _HIGH = 1500.0, 2e5  #: Mass (kg) and load (N) that are those of a wheelset rather than of a wheel.
_GRAVITY = 9.81  #: m/s^2
_GAUSS = 8  #: Points of the quadrature of dissipation in a step.


@dataclass(frozen=True)
class SuspendedMass:
    """A mass above the wheel, on a spring and a damper.

    Attributes:
        stiffness: Stiffness below the mass (N/m).
        damping: Damping below the mass (N s/m).
        mass: Share of one wheel (kg).
    """

    stiffness: float
    damping: float
    mass: float


@dataclass(frozen=True)
class WheelMode:
    """An elastic mode of the wheelset, excited by the vertical force on the tread.

    Attributes:
        frequency: Frequency without damping (Hz).
        damping: Ratio to critical damping.
        mass: Modal mass (kg), for a shape of 1 at the contact.
    """

    frequency: float
    damping: float
    mass: float


@dataclass(frozen=True)
class Wheel:
    """One wheel of a vehicle, in N, m, kg, s.

    Attributes:
        mass: Unsprung mass on one rail (kg), that is half of a wheelset.
        load: Static force between wheel and rail (N), including the weight of `mass`.
        suspension: Masses above the wheel, upwards; each one stands on the one before it. None: a constant force.
        modes: Elastic modes of the wheelset.
    """

    mass: float
    load: float
    suspension: Sequence[SuspendedMass] = ()
    modes: Sequence[WheelMode] = ()

    def __post_init__(self) -> None:
        """Raises InvalidArgument naming an invalid field."""
        check_number("wheel.mass", self.mass, "kg", 1, 1e5, "It is half the mass of a wheelset.")
        check_number("wheel.load", self.load, "N", 100, 1e7, "Did you give kN?")
        for i, part in enumerate(self.suspension):
            if not isinstance(part, SuspendedMass):
                raise refused(f"wheel.suspension[{i}]", part, "it must be a SuspendedMass.")
            check_number(f"wheel.suspension[{i}].stiffness", part.stiffness, "N/m", 0, 1e10)
            check_number(f"wheel.suspension[{i}].damping", part.damping, "N s/m", 0, 1e8)
            check_number(f"wheel.suspension[{i}].mass", part.mass, "kg", 1, 1e6)
        for i, mode in enumerate(self.modes):
            if not isinstance(mode, WheelMode):
                raise refused(f"wheel.modes[{i}]", mode, "it must be a WheelMode.")
            check_number(f"wheel.modes[{i}].frequency", mode.frequency, "Hz", 1, 2e4)
            check_number(f"wheel.modes[{i}].damping", mode.damping, "", 0, 0.99, "Give it as a ratio, not in percent.")
            check_number(f"wheel.modes[{i}].mass", mode.mass, "kg", 0.1, 1e6)
        if self.mass > _HEAVY or self.load > _HIGH:
            give([f"wheel: mass {self.mass:g} kg, load {self.load:g} N. These are those of one wheel, on one rail; did you give those of the wheelset?"])
        if self.load < _GRAVITY * self.mass:
            give([f"wheel.load = {self.load:g} N is less than the weight of wheel.mass = {self.mass:g} kg, which it includes. Give it in N; is it in kN?"])


class LinearWheel:
    """The linear states of a wheel: positions (m, downwards, from equilibrium), then speeds, advanced by a fixed step.

    The force on the states is `load` less the contact force, at the wheel and on all its modes.
    """

    def __init__(self, wheel: Wheel, step: float) -> None:
        parts, modes = list(wheel.suspension), list(wheel.modes)
        chain = 1 + len(parts)
        self.count = chain + len(modes)
        mass = np.array([wheel.mass, *(part.mass for part in parts), *(mode.mass for mode in modes)])
        stiffness, damping = np.zeros((self.count, self.count)), np.zeros((self.count, self.count))
        for i, part in enumerate(parts):
            between = np.zeros(self.count)
            between[i], between[i + 1] = 1.0, -1.0
            stiffness += part.stiffness * np.outer(between, between)
            damping += part.damping * np.outer(between, between)
        for i, mode in enumerate(modes, chain):
            omega = 2 * math.pi * mode.frequency
            stiffness[i, i], damping[i, i] = mode.mass * omega**2, 2 * mode.damping * omega * mode.mass
        #: The wheel and its modes at the contact.
        self.at_contact: Array = np.zeros(2 * self.count)
        self.at_contact[0] = 1.0
        self.at_contact[chain : self.count] = 1.0
        self.rigid: Array = np.zeros(2 * self.count)
        self.rigid[:chain] = 1.0
        self._mass, self._stiffness, self._damping = np.diag(mass), stiffness, damping
        self.step = step
        self._rates = np.zeros((2 * self.count + 2, 2 * self.count + 2))
        n = self.count
        self._rates[:n, n : 2 * n] = np.eye(n)
        self._rates[n : 2 * n, :n], self._rates[n : 2 * n, n : 2 * n] = -stiffness / mass[:, None], -damping / mass[:, None]
        self._rates[n : 2 * n, 2 * n] = self.at_contact[:n] / mass
        self._rates[2 * n, 2 * n + 1] = 1 / step
        advance = _exponential(self._rates * step)
        self.advance: Array = np.ascontiguousarray(advance[: 2 * n, : 2 * n])
        #: States by a constant unit force, and by a force that grows from 0 to 1 in the step.
        self.constant, self.growing = advance[: 2 * n, 2 * n].copy(), advance[: 2 * n, 2 * n + 1].copy()
        self._lost = self._dissipation_matrix() if damping.any() else None

    def energy(self, states: Array, load: float) -> float:
        """Returns kinetic and elastic energy, less the work of the load (J)."""
        x, v = states[: self.count], states[self.count :]
        return float(0.5 * (v @ self._mass @ v + x @ self._stiffness @ x) - load * (self.at_contact @ states))

    def dissipation(self, states: Array, forces: Array) -> Array:
        """Returns the energy (J) dissipated in steps from the states [step, state] with constant forces."""
        if self._lost is None:
            return np.zeros(len(states))
        both = np.column_stack([states, forces])
        lost: Array = np.einsum("sk,kl,sl->s", both, self._lost, both)
        return lost

    def _dissipation_matrix(self) -> Array:
        n = self.count
        found = np.zeros((2 * n + 1, 2 * n + 1))
        at, weights = np.polynomial.legendre.leggauss(_GAUSS)
        for share, weight in zip((at + 1) / 2, weights / 2):
            speeds = _exponential(self._rates * (share * self.step))[n : 2 * n, : 2 * n + 1]
            found += weight * self.step * speeds.T @ self._damping @ speeds
        return found


def _exponential(matrix: Array) -> Array:
    """Returns the matrix exponential by scaling, a series, and squaring."""
    halvings = max(0, math.ceil(math.log2(max(float(np.abs(matrix).sum(axis=1).max()), 1e-300))) + 2)
    scaled, term = matrix / 2.0**halvings, np.eye(len(matrix))
    found = term.copy()
    for i in range(1, 18):
        term = term @ scaled / i
        found += term
    for _ in range(halvings):
        found = found @ found
    return found
