"""Materials, layers and bodies. Any consistent system of units works; the docstrings assume N and mm.

Written by ./dev generate from proto/schema: edit it there.
"""

from __future__ import annotations

from dataclasses import dataclass

from ..material_methods import LayeredBodyMethods, MaterialMethods, SingleLayerMethods, ViscoelasticBodyMethods
from ..params import Checked, HasParams

__all__ = ["Layer", "LayeredBody", "Material", "RigidBody", "ViscoelasticBody"]


@dataclass(frozen=True, init=False)
class Material(MaterialMethods):
    """A homogeneous, isotropic, linearly elastic material, with its shear modulus or Young's modulus.

    ::

        Material(G=82000, nu=0.28)
        Material(E=210000, nu=0.28)  # G = E / (2 (1 + nu))

    Attributes:
        G: Shear modulus (N/mm^2), > 0.
        nu: Poisson's ratio (0 to 0.5); 0.5 only with closed-form coefficients.
    """

    G: float
    nu: float


@dataclass(frozen=True)
class RigidBody:
    """A body that does not deform. The other body must be elastic. It has no influence coefficients."""

    _fixed = ("rigid", True)


@dataclass(frozen=True, init=False)
class ViscoelasticBody(ViscoelasticBodyMethods, Checked):
    """A half-space of a standard linear solid in steady rolling along x (docs/viscoelastic.md).

    Its creep compliance is J(t) = (1 + f (1 - exp(-t/tau)))/G. The solution depends on the distance rolled in the time
    tau, so the velocity of Rolling has an effect.

    ::

        ViscoelasticBody(G=1143, nu=0.4, f=1, tau=0.009)
        ViscoelasticBody(E=3200, nu=0.4, f=1, tau=0.009)  # G = E / (2 (1 + nu))

    Attributes:
        G: Instantaneous shear modulus (N/mm^2), > 0; the long-term modulus is G/(1 + f).
        nu: Poisson's ratio (0 to 0.5), constant in time.
        f: Delayed compliance divided by the instantaneous one (>= 0); 0 is elastic with modulus G.
        tau: Retardation time of creep (s), >= 0; 0 is elastic with modulus G/(1 + f). Stress relaxes in tau/(1 + f).
    """

    G: float
    nu: float
    f: float
    tau: float


@dataclass(frozen=True, init=False)
class Layer(SingleLayerMethods):
    """A layer of a LayeredBody, with its shear modulus or Young's modulus.

    ::

        Layer(thickness=2, G=1, nu=0.5)
        Layer(thickness=2, E=3, nu=0.5)  # G = E / (2 (1 + nu))

    Attributes:
        thickness: Thickness, 1e-6 to 1e6 times dx (mm), > 0.
        G: Shear modulus (N/mm^2), > 0; those of a body differ by a factor of at most 1e9.
        nu: Poisson's ratio (0 to 0.5). The value 0.5 is exact incompressibility.
    """

    thickness: float
    G: float
    nu: float


@dataclass(frozen=True, init=False)
class LayeredBody(LayeredBodyMethods[Layer, Material | RigidBody], Checked, HasParams):
    """Layers bonded to each other and to their base, uniform along x and y: rubber, coatings, films.

    Their coefficients are computed in milliseconds and are exact to rounding; evidence states the error
    (docs/layers.md). Only load_shape of `ics` applies to such a body.

    ::

        LayeredBody([Layer(thickness=2, G=1, nu=0.5)], base=RigidBody())
        LayeredBody([Layer(0.01, G=120000, nu=0.25), Layer(0.5, G=30000, nu=0.3)], base=Material(G=82000, nu=0.28))

    Attributes:
        layers: Layers from the surface down, at most 20. Their shear moduli differ by a factor of at most 1e9.
        base: The half-space below them, or a fixed RigidBody.
    """

    _fixed = ("body", "layered")

    layers: tuple[Layer, ...]
    base: Material | RigidBody
