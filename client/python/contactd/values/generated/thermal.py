"""Thermal properties of the bodies.

Written by ./dev generate from proto/schema: edit it there.
"""

from __future__ import annotations

from dataclasses import dataclass

from ..params import HasParams

__all__ = ["ThermalBodies", "ThermalBody"]


@dataclass(frozen=True)
class ThermalBody(HasParams):
    """Thermal properties of a body, independent of its temperature. Defaults are those of steel.

    Attributes:
        bulk_temperature: Temperature of the surface before contact (degC), >= -273.15. Default 0.
        conductivity: Thermal conductivity (W/(m K)), >= 0; a body with zero conductivity takes no heat. Default 50.
        heat_capacity: Specific heat capacity (J/(kg K)), >= 1e-12. Default 450.
        density: Density (kg/m^3), >= 1e-12. Default 7850.
    """

    bulk_temperature: float | None = None
    conductivity: float | None = None
    heat_capacity: float | None = None
    density: float | None = None


@dataclass(frozen=True)
class ThermalBodies(HasParams):
    """Thermal properties of both bodies. With them, solutions of steady rolling along x contain surface temperatures.

    ::

        ThermalBodies()  # of steel
        ThermalBodies(upper=ThermalBody(bulk_temperature=120), lower=ThermalBody(bulk_temperature=20))

    Attributes:
        upper: The upper body; None: steel at 0 degrees.
        lower: The lower body; None: equal to the upper one.
        plastic_share: Fraction of the plastic work of an interfacial layer that becomes heat (0 to 1). The rest stays
            in the layer. Default 1.
    """

    upper: ThermalBody | None = None
    lower: ThermalBody | None = None
    plastic_share: float | None = None
