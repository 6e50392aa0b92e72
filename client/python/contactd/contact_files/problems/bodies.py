"""The two bodies of a case, and the constants of the pair that the CONTACT program prints and uses for decisions."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from ...values.generated.materials import Material, ViscoelasticBody

if TYPE_CHECKING:
    from ...values.generated.contact_files import ContactCase as Case

__all__ = ["Pair", "bodies_of", "combined", "is_viscoelastic", "pair_of", "sheet_of"]

Body = Material | ViscoelasticBody

_SHEET = 1
_VISCOELASTIC = 1
_ALIKE = 1e-4  #: Difference below which the program treats bodies as quasi-identical.


@dataclass(frozen=True)
class Pair:
    """Bodies and their combined constants.

    Attributes:
        upper: Body 1.
        lower: Body 2; None: equal to the upper one.
        nu: Combined Poisson's ratio: nu/G is the mean of both.
        G: Combined shear modulus (N/mm^2): 1/G is the mean of both.
        difference: G/4 ((1 - 2 nu1)/G1 - (1 - 2 nu2)/G2), of dissimilar bodies (AK).
    """

    upper: Material
    lower: Material | None
    nu: float
    G: float
    difference: float

    @property
    def is_quasi_identical(self) -> bool:
        """Returns whether normal and tangential contact are independent."""
        return self.lower is None


def pair_of(values: Mapping[str, Any]) -> Pair:
    """Returns the bodies of a case. If they hardly differ, both have the combined material, as in the program."""
    nu1, nu2, g1, g2 = (values[name] for name in ("POISS1", "POISS2", "GG1", "GG2"))
    if nu1 == nu2 and g1 == g2:
        return Pair(Material(G=g1, nu=nu1), None, nu1, g1, 0.0)
    nu, G, difference = combined(nu1, nu2, g1, g2)
    if abs(difference) < _ALIKE:
        return Pair(Material(G=G, nu=nu), None, nu, G, difference)
    return Pair(Material(G=g1, nu=nu1), Material(G=g2, nu=nu2), nu, G, difference)


def combined(nu1: float, nu2: float, g1: float, g2: float) -> tuple[float, float, float]:
    """Returns Poisson's ratio, shear modulus and difference of two materials, as in Pair."""
    G = 2 / (1 / g1 + 1 / g2)
    return G * (nu1 / g1 + nu2 / g2) / 2, G, G / 4 * ((1 - 2 * nu1) / g1 - (1 - 2 * nu2) / g2)


def is_viscoelastic(case: Case) -> bool:
    """Returns whether the bodies are viscoelastic."""
    return case.digits["M"] == _VISCOELASTIC


def bodies_of(case: Case, pair: Pair) -> tuple[Body, Body | None]:
    """Returns the upper and the lower body of basic contact; without the lower one, both are equal."""
    if not is_viscoelastic(case):
        return pair.upper, pair.lower
    (f1, f2), (tau1, tau2) = ((case.values[f"{name}1"], case.values[f"{name}2"]) for name in ("FG", "TC"))
    lower = pair.lower if (f1, tau1) == (f2, tau2) else pair.lower or pair.upper
    creeps = ViscoelasticBody(G=pair.upper.G, nu=pair.upper.nu, f=f1, tau=tau1)
    return creeps, None if lower is None else ViscoelasticBody(G=lower.G, nu=lower.nu, f=f2, tau=tau2)


def sheet_of(case: Case) -> float:
    """Returns the flexibility of the thin sheet between the bodies (mm^3/N); 0 if there is none."""
    return float(case.values["FLXZ"]) if case.digits["B"] == _SHEET else 0.0
