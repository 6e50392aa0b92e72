"""Describes rails and tracks, and contains their closed forms."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Literal

from .checks import check_number, refused

__all__ = ["Rail", "Track", "named_track"]

_LOSS_FREQUENCY = 1000.0  #: Frequency (Hz) of Rail.loss_factor.


@dataclass(frozen=True)
class Rail:
    """A rail as Timoshenko's beam, in N, m, kg.

    Attributes:
        E: Young's modulus (N/m^2).
        G: Shear modulus (N/m^2).
        density: Density (kg/m^3).
        area: Area of the section (m^2).
        inertia: Second moment of area about the lateral axis (m^4).
        kappa: Shear coefficient: kappa G A is the shear stiffness.
        loss_factor: Loss factor of E and G at 1 kHz. The damping is viscous, E (1 + i omega tau), because constant loss
            factors are not causal; so the loss factor is proportional to the frequency.
    """

    E: float
    G: float
    density: float
    area: float
    inertia: float
    kappa: float
    loss_factor: float = 0.0

    def __post_init__(self) -> None:
        """Raises InvalidArgument naming an invalid field."""
        check_number("rail.E", self.E, "N/m^2", 1e8, 1e12, "Steel has 2.1e11; did you give GPa or N/mm^2?")
        check_number("rail.G", self.G, "N/m^2", 1e7, 1e12, "Steel has 7.7e10; did you give GPa or N/mm^2?")
        check_number("rail.density", self.density, "kg/m^3", 100, 30_000)
        check_number("rail.area", self.area, "m^2", 1e-5, 1, "A rail 60E1 has 7.67e-3; did you give cm^2?")
        check_number("rail.inertia", self.inertia, "m^4", 1e-10, 0.1, "A rail 60E1 has 3.04e-5; did you give cm^4?")
        check_number("rail.kappa", self.kappa, "", 0.01, 1)
        check_number("rail.loss_factor", self.loss_factor, "", 0, 0.5, "Give it as a ratio, not in percent.")

    @property
    def bending_stiffness(self) -> float:
        """EI (N m^2)."""
        return self.E * self.inertia

    @property
    def shear_stiffness(self) -> float:
        """S = kappa G A (N)."""
        return self.kappa * self.G * self.area

    @property
    def mass(self) -> float:
        """Mass per length (kg/m)."""
        return self.density * self.area

    @property
    def rotary_inertia(self) -> float:
        """Rotary inertia per length (kg m)."""
        return self.density * self.inertia

    @property
    def loss_time(self) -> float:
        """tau (s): the damping of the rail is tau times its stiffness."""
        return self.loss_factor / (2 * math.pi * _LOSS_FREQUENCY)


@dataclass(frozen=True)
class Track:
    """One rail on equally spaced supports: pad, half a sleeper, ballast. In N, m, kg, s.

    Attributes:
        rail: The rail.
        spacing: Distance of the supports (m).
        pad_stiffness: Dynamic stiffness of a pad (N/m).
        pad_damping: Viscous damping of a pad (N s/m).
        sleeper_mass: Half the mass of a sleeper (kg).
        ballast_stiffness: Stiffness under half a sleeper (N/m).
        ballast_damping: Viscous damping under half a sleeper (N s/m).
    """

    rail: Rail
    spacing: float
    pad_stiffness: float
    pad_damping: float
    sleeper_mass: float
    ballast_stiffness: float
    ballast_damping: float

    def __post_init__(self) -> None:
        """Raises InvalidArgument naming an invalid field."""
        if not isinstance(self.rail, Rail):
            raise refused("track.rail", self.rail, "it must be a Rail.")
        check_number("track.spacing", self.spacing, "m", 0.1, 5, "Supports are about 0.6 m apart; did you give mm?")
        stiffness = "Pads have about 1e8, ballast 4e7; did you give kN/mm or MN/m?"
        check_number("track.pad_stiffness", self.pad_stiffness, "N/m", 1e5, 1e12, stiffness)
        check_number("track.ballast_stiffness", self.ballast_stiffness, "N/m", 1e5, 1e12, stiffness)
        damping = "Supports have about 1e4 to 1e5; did you give kN s/m?"
        for name in ("pad_damping", "ballast_damping"):
            value = getattr(self, name)
            check_number(f"track.{name}", value, "N s/m", 0, 1e9)
            if 0 < value < 100:
                raise refused(f"track.{name}", float(value), f"it must be 0 or at least 100 N s/m. {damping}")
        cure = "Half a sleeper has about 140 kg. For a slab without sleepers, give a small mass."
        check_number("track.sleeper_mass", self.sleeper_mass, "kg", 1, 1e5, cure)

    @property
    def foundation_stiffness(self) -> float:
        """Stiffness of the supports per length (N/m^2): pad and ballast in series over the spacing."""
        return 1 / (1 / self.pad_stiffness + 1 / self.ballast_stiffness) / self.spacing

    @property
    def critical_speed(self) -> float:
        """Speed (m/s) at which a moving force on Euler's beam on a Winkler foundation has no steady response,
        (4 k EI/m^2)^(1/4), with the mass of the rail (Fryba, Vibration of Solids and Structures under Moving Loads).
        """
        return float((4 * self.foundation_stiffness * self.rail.bending_stiffness / self.rail.mass**2) ** 0.25)

    def winkler_deflection(self, beam: Literal["euler", "timoshenko"] = "timoshenko") -> float:
        """Returns the static deflection per force (m/N) on a continuous foundation. Euler: beta/(2 k), beta^4 =
        k/(4 EI). Timoshenko: the integral of (1 + EI q^2/S)/(EI q^4 + k EI/S q^2 + k) over wave numbers q.
        """
        k, bending = self.foundation_stiffness, self.rail.bending_stiffness
        if beam == "euler":
            return float((k / (4 * bending)) ** 0.25 / (2 * k))
        shear, root = self.rail.shear_stiffness, math.sqrt(k / bending)
        return (1 / root + bending / shear) / (2 * bending * math.sqrt(k / shear + 2 * root))

    def pinned_pinned_frequency(self, beam: Literal["euler", "timoshenko"] = "timoshenko") -> float:
        """Returns the frequency (Hz) at which half a wave of the rail, pinned at the supports, spans a bay. Timoshenko:
        the lower root omega^2 of rho I m/S x^2 - (m + (rho I + EI m/S) q^2) x + EI q^4, q = pi/spacing.
        """
        q, m = math.pi / self.spacing, self.rail.mass
        bending, shear, rotary = self.rail.bending_stiffness, self.rail.shear_stiffness, self.rail.rotary_inertia
        if beam == "euler":
            return q**2 * math.sqrt(bending / m) / (2 * math.pi)
        a, b, c = rotary * m / shear, m + (rotary + bending * m / shear) * q**2, bending * q**4
        return math.sqrt(2 * c / (b + math.sqrt(b**2 - 4 * a * c))) / (2 * math.pi)


#: Parameters of published tracks. See named_track.
_TRACKS = {
    "R1": Track(
        rail=Rail(E=210e9, G=77e9, density=7850, area=76.9e-4, inertia=3055e-8, kappa=0.40, loss_factor=0.01),
        spacing=0.6, pad_stiffness=200e6, pad_damping=28e3, sleeper_mass=140, ballast_stiffness=40e6, ballast_damping=47e3,
    ),
}  # fmt: skip


def named_track(name: Literal["R1"]) -> Track:
    """Returns an example track. Its values are examples, not recommendations: measure or choose those of your track.

    R1 is a UIC 60 rail on half sleepers B70 with medium pads. E, G, density, area, inertia, supports: the defaults of
    railFE (MIT licence), a published finite element program; these are the values of one source. EN 13674 gives 76.70
    cm^2 and 3038.3 cm^4 for 60E1. kappa 0.40: railFE has 0.38, and values up to 0.53 are in use for other rails. The loss
    factor of the rail is assumed: without it, the pinned-pinned peak has hardly any damping.

    Raises InvalidArgument for an unknown name. To change values, use dataclasses.replace.
    """
    if name not in _TRACKS:
        raise refused("name", name, f"the named tracks are {', '.join(_TRACKS)}. For another track, create a Track.")
    return _TRACKS[name]
