"""What bodies are made of. Any consistent system of units works; the docstrings name N and mm."""

from __future__ import annotations

import math
from collections.abc import Iterable
from dataclasses import dataclass
from numbers import Real
from typing import Any

from ..errors import invalid
from ..refusals import check_type, public
from .params import plain

__all__ = ["Layer", "LayeredBody", "Material", "RigidBody"]


@dataclass(frozen=True, init=False)
class Material:
    """A homogeneous, isotropic, linearly elastic material, given by its shear modulus or by Young's.

    ::

        Material(G=82000, nu=0.28)
        Material(E=210000, nu=0.28)  # G = E / (2 (1 + nu))

    Attributes:
        G: Shear modulus (N/mm^2), > 0.
        nu: Poisson's ratio, 0 to 0.5; 0.5 itself only with closed-form influence coefficients.
    """

    G: float
    nu: float

    @public
    def __init__(self, G: float | None = None, nu: float | None = None, *, E: float | None = None) -> None:
        if nu is None:
            raise TypeError("Material() lacks nu")
        if (G is None) == (E is None):
            raise TypeError("Material() takes either G, the shear modulus, or E, Young's modulus")
        object.__setattr__(self, "G", _shear_modulus(E, nu) if E is not None else G)
        object.__setattr__(self, "nu", nu)

    @property
    def E(self) -> float:
        """Young's modulus 2 G (1 + nu) (N/mm^2)."""
        return 2 * self.G * (1 + self.nu)


def _shear_modulus(E: float, nu: float) -> float:
    """Says of Young's modulus what the daemon, which gets G only, would say of that."""
    for name, value in (("E", E), ("nu", nu)):
        if not isinstance(value, Real) or isinstance(value, bool):
            raise TypeError(f"{name} is {value!r}; it must be a number")
    if not 0 < E < math.inf:
        raise invalid("E", f"is {E}; it must be a positive, finite number")
    if not 0 <= nu <= 0.5:
        raise invalid("nu", f"is {nu}; it must lie in [0, 0.5]")
    return float(E / (2 * (1 + nu)))


@dataclass(frozen=True)
class RigidBody:
    """A body that does not deform; the other one must be elastic. Influence coefficients mean nothing to it."""

    @staticmethod
    def _is_told(told: dict[str, Any]) -> bool:
        return "rigid" in told

    @staticmethod
    def _on_wire(_field: str) -> dict[str, Any]:
        return {"rigid": True}


@dataclass(frozen=True)
class Layer:
    """A layer of a LayeredBody.

    Attributes:
        thickness: mm, > 0.
        G: Shear modulus (N/mm^2), > 0.
        nu: Poisson's ratio, 0 to 0.5; 0.5 is meant exactly.
    """

    thickness: float
    G: float
    nu: float


@dataclass(frozen=True)
class LayeredBody:
    """Layers that are bonded to each other and to what they lie on, uniform along x and y: rubber, coatings, films.

    ::

        LayeredBody([Layer(thickness=2, G=1, nu=0.5)], base=RigidBody())
        LayeredBody([Layer(0.01, G=120000, nu=0.25), Layer(0.5, G=30000, nu=0.3)], base=Material(G=82000, nu=0.28))

    Their coefficients are computed in milliseconds, exactly but for rounding; evidence states the error
    (docs/layers.md). Of `ics` only load_shape means something to such a body.

    Attributes:
        layers: From the surface down; at most 20, whose shear moduli differ by a factor of at most 1e9.
        base: The half-space below them, or a RigidBody, which does not move.
    """

    layers: tuple[Layer, ...]
    base: Material | RigidBody

    @public
    def __init__(self, layers: Iterable[Layer], base: Material | RigidBody) -> None:
        found = tuple(layers)
        for i, layer in enumerate(found):
            check_type(f"layers[{i}]", layer, Layer)
        check_type("base", base, Material, RigidBody)
        object.__setattr__(self, "layers", found)
        object.__setattr__(self, "base", base)

    @property
    def G(self) -> float:
        """Shear modulus at the surface (N/mm^2)."""
        return self.layers[0].G

    @property
    def nu(self) -> float:
        """Poisson's ratio at the surface."""
        return self.layers[0].nu

    @staticmethod
    def _is_told(told: dict[str, Any]) -> bool:
        return "layers" in told

    def params(self) -> dict[str, Any]:
        """What `ics` of the body say of it."""
        base = {"rigid": True} if isinstance(self.base, RigidBody) else plain(self.base)
        return {"body": "layered", "layers": [plain(layer) for layer in self.layers], "base": base}
