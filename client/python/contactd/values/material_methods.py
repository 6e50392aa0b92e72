"""Implements construction of materials, layered bodies and viscoelastic bodies; `materials` declares the fields."""

from __future__ import annotations

import math
from collections.abc import Iterable
from numbers import Real
from typing import Any, Generic, TypeVar

from ..errors import invalid
from ..refusals import check_either, public

__all__ = ["LayeredBodyMethods", "MaterialMethods", "SingleLayerMethods", "ViscoelasticBodyMethods"]


L = TypeVar("L")  #: A layer.
B = TypeVar("B")  #: The base below the layers.


class MaterialMethods:
    """Creates a Material from its shear modulus or Young's modulus."""

    @public
    def __init__(self, G: float | None = None, nu: float | None = None, *, E: float | None = None) -> None:
        if nu is None:
            raise TypeError("Material() lacks nu")
        check_either("Material", "G, the shear modulus, or E, Young's modulus", G=G, E=E)
        object.__setattr__(self, "G", _shear_modulus(E, nu) if E is not None else G)
        object.__setattr__(self, "nu", nu)

    @property
    def E(self: Any) -> float:
        """Young's modulus 2 G (1 + nu) (N/mm^2)."""
        modulus: float = 2 * self.G * (1 + self.nu)
        return modulus


class ViscoelasticBodyMethods:
    """Creates a ViscoelasticBody from its instantaneous shear modulus or Young's modulus."""

    @public
    def __init__(
        self: Any,
        G: float | None = None,
        nu: float | None = None,
        f: float | None = None,
        tau: float | None = None,
        *,
        E: float | None = None,
    ) -> None:
        for name, value in (("nu", nu), ("f", f), ("tau", tau)):
            if value is None:
                raise TypeError(f"ViscoelasticBody() lacks {name}")
        check_either("ViscoelasticBody", "G, the shear modulus at once, or E, Young's modulus", G=G, E=E)
        assert nu is not None
        values = {"G": _shear_modulus(E, nu) if E is not None else G, "nu": nu, "f": f, "tau": tau}
        for name, value in values.items():
            object.__setattr__(self, name, value)
        self.__post_init__()

    @property
    def E(self: Any) -> float:
        """Instantaneous Young's modulus, 2 G (1 + nu) (N/mm^2)."""
        modulus: float = 2 * self.G * (1 + self.nu)
        return modulus


def _shear_modulus(E: float, nu: float) -> float:
    """Converts Young's modulus; refuses it with the daemon's message for the shear modulus."""
    for name, value in (("E", E), ("nu", nu)):
        if not isinstance(value, Real) or isinstance(value, bool):
            raise TypeError(f"{name} is {value!r}; it must be a number")
    if not 0 < E < math.inf:
        raise invalid("E", f"is {E}; it must be a positive, finite number")
    if not 0 <= nu <= 0.5:
        raise invalid("nu", f"is {nu}; it must lie in [0, 0.5]")
    return float(E / (2 * (1 + nu)))


class SingleLayerMethods:
    """Creates a Layer from its shear modulus or Young's modulus."""

    @public
    def __init__(self, thickness: float, G: float | None = None, nu: float | None = None, *, E: float | None = None) -> None:
        if nu is None:
            raise TypeError("Layer() lacks nu")
        check_either("Layer", "G, the shear modulus, or E, Young's modulus", G=G, E=E)
        object.__setattr__(self, "thickness", thickness)
        object.__setattr__(self, "G", _shear_modulus(E, nu) if E is not None else G)
        object.__setattr__(self, "nu", nu)

    @property
    def E(self: Any) -> float:
        """Young's modulus 2 G (1 + nu) (N/mm^2)."""
        modulus: float = 2 * self.G * (1 + self.nu)
        return modulus


class LayeredBodyMethods(Generic[L, B]):
    """Creates a LayeredBody from any sequence of layers."""

    @public
    def __init__(self: Any, layers: Iterable[L], base: B) -> None:
        object.__setattr__(self, "layers", tuple(layers))
        object.__setattr__(self, "base", base)
        self.__post_init__()

    @property
    def G(self: Any) -> float:
        """Shear modulus at the surface (N/mm^2)."""
        modulus: float = self.layers[0].G
        return modulus

    @property
    def nu(self: Any) -> float:
        """Poisson's ratio at the surface."""
        ratio: float = self.layers[0].nu
        return ratio
